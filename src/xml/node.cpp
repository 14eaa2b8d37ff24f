// SPDX-License-Identifier: Apache-2.0
#include "xml/node.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace thalweg::xml {

namespace fs = std::filesystem;

const std::string* Node::find(std::string_view attribute) const {
  for (const auto& [key, value] : attributes) {
    if (key == attribute) return &value;
  }
  return nullptr;
}

std::string_view Node::value_or(std::string_view attribute, std::string_view otherwise) const {
  const std::string* value = find(attribute);
  return value == nullptr ? otherwise : *value;
}

const std::string& Node::require(std::string_view attribute) const {
  const std::string* value = find(attribute);
  if (value == nullptr) throw error(fmt::format("the attribute '{}' is missing", attribute));
  return *value;
}

void Node::set(std::string_view attribute, std::string value) {
  for (auto& [key, own] : attributes) {
    if (key != attribute) continue;
    own = std::move(value);
    return;
  }
  attributes.emplace_back(attribute, std::move(value));
}

void Node::erase(std::string_view attribute) {
  std::erase_if(attributes, [&](const auto& own) { return own.first == attribute; });
}

InputError Node::error(std::string_view message) const {
  const std::string* id = find("id");
  return InputError(
      fmt::format("{}: <{}{}>: {}", place, name, id == nullptr ? "" : fmt::format(" id='{}'", *id), message));
}

namespace {

class NodeHandler : public Handler {
 public:
  NodeHandler(const std::function<void(const Element&)>& root, const std::function<void(Node&)>& each)
      : root_(root), each_(each) {}

  void start(const Element& element) override {
    if (!in_root_) {
      in_root_ = true;
      root_(element);
      return;
    }
    Node node;
    node.name = element.name();
    node.place = element.place();
    for (const auto& a : element.attributes()) node.attributes.emplace_back(a.name, a.value);
    open_.push_back(std::move(node));
  }

  void end(std::string_view /*name*/) override {
    if (open_.empty()) return;  // the root
    Node node = std::move(open_.back());
    open_.pop_back();
    if (open_.empty()) {
      each_(node);
    } else {
      open_.back().children.push_back(std::move(node));
    }
  }

 private:
  const std::function<void(const Element&)>& root_;
  const std::function<void(Node&)>& each_;
  bool in_root_ = false;
  std::vector<Node> open_;  ///< from the element below the root down to the innermost
};

class IncludingReader {
 public:
  IncludingReader(const std::function<void(const Element&)>& root,
                  const std::function<void(Node&, const fs::path&)>& each)
      : root_(root), each_(each) {}

  void read(const fs::path& file) {
    chain_.enter(file);
    read_nodes(file, root_, [&](Node& node) {
      if (node.name == "include") {
        read(file.parent_path() / node.require("href"));
      } else {
        each_(node, file);
      }
    });
    chain_.leave();
  }

 private:
  const std::function<void(const Element&)>& root_;
  const std::function<void(Node&, const fs::path&)>& each_;
  IncludeChain chain_;
};

}  // namespace

void read_nodes(const std::filesystem::path& file, const std::function<void(const Element&)>& root,
                const std::function<void(Node&)>& each) {
  NodeHandler handler(root, each);
  read(file, handler);
}

void read_nodes(const std::filesystem::path& file, const std::function<void(Node&)>& each) {
  read_nodes(
      file, [](const Element&) {}, each);
}

void read_nodes_and_included(const fs::path& file, const std::function<void(const Element&)>& root,
                             const std::function<void(Node&, const fs::path&)>& each) {
  IncludingReader(root, each).read(file);
}

void read_nodes_and_included(const fs::path& file, const std::function<void(Node&, const fs::path&)>& each) {
  read_nodes_and_included(
      file, [](const Element&) {}, each);
}

void IncludeChain::enter(const fs::path& file) {
  const fs::path canonical = fs::weakly_canonical(file);
  verify(std::find(files_.begin(), files_.end(), canonical) == files_.end(),
         fmt::format("{} includes itself", file.string()));
  files_.push_back(canonical);
}

void write_node(Writer& writer, const Node& node) {
  writer.open(node.name);
  for (const auto& [name, value] : node.attributes) writer.attribute(name, value);
  for (const Node& child : node.children) write_node(writer, child);
  writer.close();
}

}  // namespace thalweg::xml
