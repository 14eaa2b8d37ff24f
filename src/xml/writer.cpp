// SPDX-License-Identifier: Apache-2.0
#include "xml/writer.hpp"

#include <fmt/format.h>
#include <libxml/xmlwriter.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>

#include "core/error.hpp"

namespace thalweg {

struct OutputFile::Stream {
  gzFile file;
};

OutputFile::OutputFile(std::filesystem::path file)
    : file_(std::move(file)), temporary_(fmt::format("{}.{}.tmp", file_.string(), getpid())) {
  errno = 0;
  const bool compressed = file_.extension() == ".gz";
  gzFile stream = gzopen(temporary_.c_str(), compressed ? "wb" : "wbT");
  if (stream == nullptr) {
    throw InputError(
        fmt::format("cannot write '{}': {}", file_.string(), std::strerror(errno != 0 ? errno : ENOMEM)));
  }
  stream_ = std::make_unique<Stream>(Stream{stream});
}

OutputFile::~OutputFile() {
  if (!stream_) return;
  gzclose(stream_->file);
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void OutputFile::write(std::string_view text) {
  if (text.empty()) return;
  if (gzwrite(stream_->file, text.data(), static_cast<unsigned>(text.size())) <= 0) {
    throw InputError(fmt::format("cannot write '{}': {}", file_.string(), std::strerror(errno)));
  }
}

void OutputFile::commit() {
  const int closed = gzclose(stream_->file);
  stream_.reset();
  std::error_code error;
  if (closed == Z_OK) std::filesystem::rename(temporary_, file_, error);
  if (closed == Z_OK && !error) return;
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
  throw InputError(fmt::format("cannot write '{}': {}", file_.string(),
                               error ? error.message() : std::string(std::strerror(errno))));
}

namespace xml {

struct Writer::Stream {
  OutputFile file;
  xmlTextWriterPtr writer = nullptr;
  std::string failure{};

  explicit Stream(const std::filesystem::path& path) : file(path) {}
};

namespace {
const xmlChar* text_of(const std::string& text) { return reinterpret_cast<const xmlChar*>(text.c_str()); }
}  // namespace

Writer::Writer(const std::filesystem::path& file, std::string_view header)
    : stream_(std::make_unique<Stream>(file)) {
  const auto on_write = [](void* stream, const char* text, int size) {
    auto& own = *static_cast<Stream*>(stream);
    try {
      own.file.write({text, static_cast<std::size_t>(size)});
      return size;
    } catch (const InputError& error) {  // no exception may cross libxml2
      own.failure = error.what();
      return -1;
    }
  };
  stream_->writer = xmlNewTextWriter(xmlOutputBufferCreateIO(on_write, nullptr, stream_.get(), nullptr));
  if (stream_->writer == nullptr) throw InputError("out of memory");
  xmlTextWriterSetIndent(stream_->writer, 1);
  const std::string four_blanks = "    ";
  xmlTextWriterSetIndentString(stream_->writer, text_of(four_blanks));
  xmlTextWriterStartDocument(stream_->writer, nullptr, "UTF-8", nullptr);
  std::string comment(header);
  for (auto at = comment.find("--"); at != std::string::npos; at = comment.find("--")) comment[at + 1] = '~';
  xmlTextWriterWriteComment(stream_->writer, text_of(" " + comment + " "));
}

Writer::~Writer() {
  if (stream_->writer != nullptr) xmlFreeTextWriter(stream_->writer);
}

Writer& Writer::open(std::string_view element) {
  xmlTextWriterStartElement(stream_->writer, text_of(std::string(element)));
  return *this;
}

Writer& Writer::attribute(std::string_view name, std::string_view value) {
  xmlTextWriterWriteAttribute(stream_->writer, text_of(std::string(name)), text_of(std::string(value)));
  return *this;
}

Writer& Writer::close() {
  xmlTextWriterEndElement(stream_->writer);
  return *this;
}

void Writer::commit() {
  xmlTextWriterEndDocument(stream_->writer);
  xmlFreeTextWriter(stream_->writer);
  stream_->writer = nullptr;
  if (!stream_->failure.empty()) throw InputError(stream_->failure);
  stream_->file.commit();
}

}  // namespace xml
}  // namespace thalweg
