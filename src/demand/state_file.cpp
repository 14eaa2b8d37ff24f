// SPDX-License-Identifier: Apache-2.0
#include "demand/state_file.hpp"

#include "xml/node.hpp"

namespace thalweg {

void copy_state_without_flows(const std::filesystem::path& from, const std::filesystem::path& to,
                              std::string_view header) {
  xml::Writer writer(to, header);
  xml::read_nodes(
      from,
      [&](const xml::Element& root) {
        writer.open(root.name());
        for (const auto& a : root.attributes()) writer.attribute(a.name, a.value);
      },
      [&](const xml::Node& node) {
        if (node.name != "flowState") write_node(writer, node);
      });
  writer.commit();
}

}  // namespace thalweg
