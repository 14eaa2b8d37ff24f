// SPDX-License-Identifier: Apache-2.0
#include "cch/order_cache.hpp"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "xml/writer.hpp"

namespace thalweg {
namespace {

namespace fs = std::filesystem;

/// What stands before the vertices, and after them their hash. Numbers as this machine has them: on another
/// one the magic number is a different one.
struct Header {
  std::uint64_t magic = 0x31776c6854726f31ULL;  // changes with the format, or with what an order means
  std::uint64_t fingerprint = 0;
  std::uint64_t count = 0;
  bool operator==(const Header&) const = default;
};

template <class T>
std::string_view bytes_of(const T* items, std::size_t count) {
  return {reinterpret_cast<const char*>(items), count * sizeof(T)};
}

/// nullopt: not what was written for this graph.
std::optional<EliminationOrder> parse_order(std::string_view text, const Header& expected) {
  const std::size_t body = expected.count * sizeof(VertexId);
  if (text.size() != sizeof(Header) + body + sizeof(std::uint64_t)) return std::nullopt;
  Header header;
  std::uint64_t hash = 0;
  std::memcpy(&header, text.data(), sizeof header);
  std::memcpy(&hash, text.data() + sizeof header + body, sizeof hash);
  if (!(header == expected) || hash != stable_hash(text.substr(sizeof header, body))) return std::nullopt;
  EliminationOrder order(expected.count);
  if (body > 0) std::memcpy(order.data(), text.data() + sizeof header, body);
  std::vector<bool> seen(order.size(), false);
  for (const VertexId v : order) {
    if (v.value >= seen.size() || seen[v.value]) return std::nullopt;
    seen[v.value] = true;
  }
  return order;
}

void write_order(const fs::path& file, const Header& header, const EliminationOrder& order) {
  const std::string_view body = bytes_of(order.data(), order.size());
  const std::uint64_t hash = stable_hash(body);
  std::error_code failure;
  fs::create_directories(file.parent_path(), failure);  // what is wrong is said when the file is opened
  OutputFile out(file);
  out.write(bytes_of(&header, 1));
  out.write(body);
  out.write(bytes_of(&hash, 1));
  out.commit();
}

}  // namespace

EliminationOrder cached_dissection(const Digraph& graph, std::uint64_t fingerprint, const OrderCache& cache) {
  if (cache.folder.empty()) return nested_dissection(graph);
  const auto warn = [&](const std::string& text) {
    if (cache.warn) cache.warn(text);
  };
  const Header header{.fingerprint = fingerprint, .count = graph.vertex_count()};
  const fs::path file = cache.folder / fmt::format("order-1-{:016x}", fingerprint);
  if (std::ifstream in{file, std::ios::binary}) {
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    // Postordered once more, so that nothing is taken on trust but that every vertex is there.
    if (const auto order = parse_order(text, header)) return postordered(graph, *order);
    warn(fmt::format("'{}' is damaged or not ours; it is made anew", file.string()));
  }
  EliminationOrder order = nested_dissection(graph);
  try {
    write_order(file, header, order);
  } catch (const InputError& error) {
    warn(fmt::format("the order of the network is not kept: {}", error.what()));
  }
  return order;
}

}  // namespace thalweg
