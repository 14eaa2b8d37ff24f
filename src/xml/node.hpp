// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "xml/reader.hpp"
#include "xml/writer.hpp"

namespace thalweg::xml {

/// An element with its attributes and children, owned: for files that are edited element by element.
struct Node {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<Node> children;
  std::string place;  ///< "file:line", for errors

  [[nodiscard]] const std::string* find(std::string_view attribute) const;
  [[nodiscard]] std::string_view value_or(std::string_view attribute, std::string_view otherwise) const;
  [[nodiscard]] const std::string& require(std::string_view attribute) const;  ///< InputError when missing
  void set(std::string_view attribute, std::string value);
  void erase(std::string_view attribute);
  [[nodiscard]] InputError error(std::string_view message) const;
};

/// Calls `root` with the opening tag of the file's root and `each` with every element below it, one held at a
/// time.
void read_nodes(const std::filesystem::path& file, const std::function<void(const Element&)>& root,
                const std::function<void(Node&)>& each);
/// The same for a file whose root does not matter.
void read_nodes(const std::filesystem::path& file, const std::function<void(Node&)>& each);
/// The same, and in the place of an `<include href="..."/>` the elements of that file, whose path is relative
/// to the one that names it; `each` gets the file that the element stands in. InputError: it includes itself.
void read_nodes_and_included(const std::filesystem::path& file,
                             const std::function<void(const Element&)>& root,
                             const std::function<void(Node&, const std::filesystem::path&)>& each);
void read_nodes_and_included(const std::filesystem::path& file,
                             const std::function<void(Node&, const std::filesystem::path&)>& each);

/// The files that include one another, from the first down to the one at hand.
class IncludeChain {
 public:
  void enter(const std::filesystem::path& file);  ///< InputError: it is in the chain, so it includes itself
  void leave() { files_.pop_back(); }

 private:
  std::vector<std::filesystem::path> files_;
};

void write_node(Writer& writer, const Node& node);

}  // namespace thalweg::xml
