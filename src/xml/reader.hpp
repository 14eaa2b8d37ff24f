// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "core/time.hpp"

namespace thalweg::xml {

struct Attribute {
  std::string_view name;
  std::string_view value;
};

/// An opening tag. Its views live until the handler returns.
class Element {
 public:
  Element(std::string_view name, std::span<const Attribute> attributes, const std::string& file, int line)
      : name_(name), attributes_(attributes), file_(file), line_(line) {}

  [[nodiscard]] std::string_view name() const { return name_; }
  [[nodiscard]] std::span<const Attribute> attributes() const { return attributes_; }

  [[nodiscard]] std::optional<std::string_view> find(std::string_view attribute) const;
  [[nodiscard]] std::string_view value_or(std::string_view attribute, std::string_view otherwise) const {
    return find(attribute).value_or(otherwise);
  }
  /// These throw InputError with file, line and element when the attribute is missing or not of its kind.
  [[nodiscard]] std::string_view require(std::string_view attribute) const;
  [[nodiscard]] double number(std::string_view attribute) const;
  [[nodiscard]] double number_or(std::string_view attribute, double otherwise) const;
  [[nodiscard]] int integer(std::string_view attribute) const;
  [[nodiscard]] Millis time(std::string_view attribute) const;
  [[nodiscard]] bool boolean_or(std::string_view attribute, bool otherwise) const;

  [[nodiscard]] std::string place() const;  ///< "file:line"
  /// "file:line: <element id='x'>: message"
  [[nodiscard]] InputError error(std::string_view message) const;

 private:
  std::string_view name_;
  std::span<const Attribute> attributes_;
  const std::string& file_;
  int line_;
};

class Handler {
 public:
  virtual ~Handler() = default;
  virtual void start(const Element& element) = 0;
  virtual void end(std::string_view /*name*/) {}
};

/// Streams the file, plain or gzipped, through the handler. What the handler throws comes out again.
/// No document type is accepted, so no entity is ever expanded and nothing is read beside the file.
/// InputError: the file cannot be read, is cut short, is no XML, or has an attribute beyond libxml2's 10 MB.
void read(const std::filesystem::path& file, Handler& handler);

/// The same for a text in memory; `name` stands in its errors.
void parse(std::string_view text, const std::string& name, Handler& handler);

}  // namespace thalweg::xml
