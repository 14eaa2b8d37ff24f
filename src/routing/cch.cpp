// SPDX-License-Identifier: Apache-2.0
#include "cch/sweep.hpp"
#include "core/parallel.hpp"
#include "graph/fingerprint.hpp"
#include "routing/legs.hpp"
#include "routing/list.hpp"
#include "routing/next_hops.hpp"

namespace thalweg {
namespace {

/// A sweep looks at every edge for 16 destinations at once; alone, a destination looks at those that its
/// vehicles need, at this many times the price an edge (measured: bench/, docs/performance.md).
constexpr double price_of_lazy_edge = 3.0;

/// The search of one worker with weights of one width.
template <CchWeight W>
class Searches {
 public:
  /// Serves groups of one class, each of one destination.
  void serve(const ClassTraffic& seen, const CchTopology& topology, const CchMetric<W>& metric, Legs& legs,
             std::size_t first_group, std::size_t last_group) {
    destinations_.clear();
    for (std::size_t g = first_group; g < last_group; ++g) {
      destinations_.push_back(legs.group(g).front().destination);
    }
    if (sweep_pays(topology, destinations_.size())) {
      sweep_.run(topology, metric, destinations_);
      for (std::size_t i = 0; i < destinations_.size(); ++i) {
        walk(seen, legs.group(first_group + i),
             [&](VertexId v) { return from_label(sweep_.cost(topology, v, i)); });
      }
      return;
    }
    for (std::size_t i = 0; i < destinations_.size(); ++i) {
      lazy_.start(topology, metric, destinations_[i]);
      walk(seen, legs.group(first_group + i),
           [&](VertexId v) { return from_label(lazy_.cost(topology, metric, v)); });
      work_ += (static_cast<double>(lazy_.work()) - work_) / 16;
    }
  }

 private:
  static Millis from_label(W label) {
    return label >= cch_infinity<W> ? infinity : static_cast<Millis>(label);
  }

  [[nodiscard]] bool sweep_pays(const CchTopology& topology, std::size_t destinations) const {
    return static_cast<double>(destinations) * work_ * price_of_lazy_edge >
           static_cast<double>(topology.edge_count());
  }

  template <class Label>
  static void walk(const ClassTraffic& seen, std::span<Leg> legs, const Label& label) {
    for (Leg& leg : legs) {
      leg.cost = label(leg.origin);
      if (leg.cost >= infinity) continue;
      walk_next_hops(seen.graph->turns(), seen.turn_costs, leg.origin, leg.destination, label, leg.roads);
    }
  }

  CchSweep<W> sweep_;
  CchLazyCosts<W> lazy_;
  std::vector<VertexId> destinations_;
  double work_ = 500;  ///< edges that a lone destination takes, as seen lately
};

/// Exact ways by a customizable contraction hierarchy: the order once for a class, the metric whenever the
/// costs are new, then sweeps for 16 destinations at a time.
class CchStrategy : public Strategy {
 public:
  explicit CchStrategy(const StrategyOptions& options)
      : rule_(options.rule), narrow_(std::max<std::size_t>(1, options.threads)), wide_(narrow_.size()) {}

  void decide(std::span<const ClassTraffic> traffic, std::span<const Traveller> due,
              std::vector<Decision>& decisions) override {
    legs_.collect(due);
    plan_batches();
    hierarchies_.resize(traffic.size());
    for (const Batch& batch : batches_)
      refresh(traffic[batch.vehicle_class], hierarchies_[batch.vehicle_class]);
    parallel_for(batches_.size(), narrow_.size(), [&](std::size_t i, std::size_t worker) {
      const Batch& batch = batches_[i];
      const Hierarchy& own = hierarchies_[batch.vehicle_class];
      const ClassTraffic& seen = traffic[batch.vehicle_class];
      if (own.is_narrow) {
        narrow_[worker].serve(seen, *own.topology, own.narrow, legs_, batch.first, batch.last);
      } else {
        wide_[worker].serve(seen, *own.topology, own.wide, legs_, batch.first, batch.last);
      }
    });
    legs_.decide(traffic, due, rule_, decisions);
  }

 private:
  struct Hierarchy {
    std::uint64_t graph = 0;  ///< its fingerprint: another one may come to stand at the same address
    std::unique_ptr<CchTopology> topology;
    bool is_narrow = true;
    CchMetric<std::uint32_t> narrow;
    CchMetric<std::uint64_t> wide;
    std::vector<Millis> costs;  ///< that the metric was customised for
  };
  struct Batch {
    std::size_t vehicle_class;
    std::size_t first;  ///< groups of legs
    std::size_t last;
  };

  /// Up to 16 destinations of one class each.
  void plan_batches() {
    batches_.clear();
    for (std::size_t g = 0; g < legs_.group_count(); ++g) {
      const std::size_t vehicle_class = legs_.group(g).front().vehicle_class;
      const bool fits = !batches_.empty() && batches_.back().vehicle_class == vehicle_class &&
                        g - batches_.back().first < CchSweep<std::uint32_t>::width;
      if (!fits) batches_.push_back({.vehicle_class = vehicle_class, .first = g, .last = g});
      batches_.back().last = g + 1;
    }
  }

  void refresh(const ClassTraffic& seen, Hierarchy& own) const {
    const Digraph& turns = seen.graph->turns();
    const std::uint64_t graph = fingerprint(turns);
    const bool same_graph = own.topology && own.graph == graph;
    if (same_graph && own.costs == seen.turn_costs) return;
    if (!same_graph) own.topology = std::make_unique<CchTopology>(turns, nested_dissection(turns));
    own.graph = graph;
    own.costs = seen.turn_costs;
    own.is_narrow = fits_32_bits(turns, seen.turn_costs);
    if (own.is_narrow) {
      own.narrow.customise(*own.topology, seen.turn_costs, narrow_.size());
    } else {
      own.wide.customise(*own.topology, seen.turn_costs, narrow_.size());
    }
  }

  ChoiceRule rule_;
  std::vector<Searches<std::uint32_t>> narrow_;
  std::vector<Searches<std::uint64_t>> wide_;
  std::vector<Hierarchy> hierarchies_;  ///< by vehicle class
  std::vector<Batch> batches_;
  Legs legs_;
};

}  // namespace

std::unique_ptr<Strategy> make_cch(const StrategyOptions& options) {
  return std::make_unique<CchStrategy>(options);
}

}  // namespace thalweg
