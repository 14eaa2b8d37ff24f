// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cch/lone_search.hpp"
#include "cch/order_cache.hpp"
#include "cch/sweep.hpp"
#include "routing/legs.hpp"
#include "search/dijkstra.hpp"

namespace thalweg {

/// How a batch is served.
enum class CchMethod : std::uint8_t {
  trees,          ///< Dijkstra's, one a destination
  hierarchy,      ///< either of the following, by price
  sweeps,         ///< of the hierarchy, one for 16 destinations
  lone_searches,  ///< in the hierarchy, one a destination
};

/// What the parts of a round take, in ns of CPU: measured on a city and on a grid (docs/performance.md), and
/// used to pick between methods only.
struct CchPrices {
  double triangle = 1.2;        ///< of a customisation
  double customised_edge = 12;  ///< of the completion
  double swept_edge = 2.5;      ///< of the completion, for up to 16 destinations
  double climbed_edge = 7;      ///< of `mean_climb`, times the root of a lone destination's legs
  double tree_vertex = 110;     ///< of the graph, by Dijkstra's tree to many origins; half of it to one
  double built_vertex = 3'500;  ///< of the graph: its order and completion
};

/// Exact ways on one graph for batches of legs, whatever their costs: by a customizable contraction
/// hierarchy, or by Dijkstra trees where the batch is too small for it or the graph fills in too much. The
/// ways do not depend on the method but where arcs cost nothing, and never on the number of threads.
class CchEngine {
 public:
  CchEngine(std::size_t threads, OrderCache cache);

  /// Finds `cost` and `roads` of every leg in the groups first .. last - 1. A new graph or new costs are
  /// noticed. `forced`: not picked but given, for measurements.
  void serve(const Digraph& graph, const std::vector<Millis>& costs, Legs& legs, std::size_t first,
             std::size_t last, std::optional<CchMethod> forced = std::nullopt);

  /// Null until a batch was worth it.
  [[nodiscard]] const CchTopology* topology() const { return topology_.get(); }

 private:
  struct Worker {
    CchSweep<std::uint32_t> sweep32;
    CchSweep<std::uint64_t> sweep64;
    CchLoneSearch<std::uint32_t> lone32;
    CchLoneSearch<std::uint64_t> lone64;
    Tree tree;
    DijkstraScratch dijkstra;
    std::vector<VertexId> ends;
  };
  struct Batch {
    std::size_t first;  ///< groups
    std::size_t last;
  };

  [[nodiscard]] CchMethod pick(const Digraph& graph, const std::vector<Millis>& costs, Legs& legs,
                               std::size_t first, std::size_t last);
  [[nodiscard]] double sweep_price() const;
  [[nodiscard]] double lone_price(Legs& legs, Batch batch) const;
  void build(const Digraph& graph);
  void customise(const Digraph& graph, const std::vector<Millis>& costs);
  void grow_trees(const Digraph& graph, const std::vector<Millis>& costs, Legs& legs, std::size_t first,
                  std::size_t last);
  template <CchWeight W>
  void serve_batch(CchMethod method, const Digraph& graph, const CchMetric<W>& metric, CchSweep<W>& sweep,
                   CchLoneSearch<W>& lone, std::vector<VertexId>& ends, Legs& legs, Batch batch) const;

  CchPrices prices_;
  OrderCache cache_;
  std::vector<Worker> workers_;
  std::uint64_t graph_ = 0;    ///< its fingerprint: another graph may come to stand at the same address
  double spent_on_trees_ = 0;  ///< ns, since the graph is known
  std::unique_ptr<CchTopology> topology_;
  double climb_ = 0;  ///< mean_climb
  bool is_customised_ = false;
  bool is_narrow_ = true;
  CchMetric<std::uint32_t> narrow_;
  CchMetric<std::uint64_t> wide_;
  std::vector<Millis> costs_;  ///< that the metric was customised for
};

}  // namespace thalweg
