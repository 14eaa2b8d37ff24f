// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace thalweg {

/// A file that appears whole or not at all: written under a temporary name beside it and renamed by `commit`.
/// A name that ends in ".gz" is written compressed. Without `commit` nothing is left behind.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path file);  ///< InputError when it cannot be opened
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view text);  ///< InputError when it cannot be written (a full disk)
  void commit();

 private:
  struct Stream;
  std::filesystem::path file_;
  std::filesystem::path temporary_;
  std::unique_ptr<Stream> stream_;
};

namespace xml {

/// Writes elements, indented by four blanks as SUMO does. The caller nests them rightly.
class Writer {
 public:
  /// Starts the document; `header` becomes its comment (version, date, configuration).
  Writer(const std::filesystem::path& file, std::string_view header);
  ~Writer();

  Writer& open(std::string_view element);
  Writer& attribute(std::string_view name, std::string_view value);
  Writer& close();
  /// Closes what is open and puts the file in its place.
  void commit();

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

}  // namespace xml
}  // namespace thalweg
