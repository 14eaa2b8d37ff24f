// SPDX-License-Identifier: Apache-2.0
#include "xml/reader.hpp"

#include <fmt/format.h>
#include <libxml/parser.h>
#include <libxml/parserInternals.h>
#include <zlib.h>

#include <cerrno>
#include <climits>
#include <cstring>
#include <exception>
#include <memory>
#include <vector>

#include "core/number.hpp"

namespace thalweg::xml {

std::optional<std::string_view> Element::find(std::string_view attribute) const {
  for (const Attribute& a : attributes_) {
    if (a.name == attribute) return a.value;
  }
  return std::nullopt;
}

std::string_view Element::require(std::string_view attribute) const {
  const auto value = find(attribute);
  if (!value) throw error(fmt::format("the attribute '{}' is missing", attribute));
  return *value;
}

double Element::number(std::string_view attribute) const {
  const auto text = require(attribute);
  const auto value = parse_number(text);
  if (!value) throw error(fmt::format("{}='{}' is not a number", attribute, text.substr(0, 80)));
  return *value;
}

double Element::number_or(std::string_view attribute, double otherwise) const {
  return find(attribute) ? number(attribute) : otherwise;
}

int Element::integer(std::string_view attribute) const {
  const auto text = require(attribute);
  const auto value = parse_integer<int>(text);
  if (!value) throw error(fmt::format("{}='{}' is not a whole number", attribute, text.substr(0, 80)));
  return *value;
}

Millis Element::time(std::string_view attribute) const {
  const auto text = require(attribute);
  const auto value = parse_time(text);
  if (!value) throw error(fmt::format("{}='{}' is not a time", attribute, text.substr(0, 80)));
  return *value;
}

bool Element::boolean_or(std::string_view attribute, bool otherwise) const {
  const auto text = find(attribute);
  if (!text) return otherwise;
  return *text == "true" || *text == "1" || *text == "True" || *text == "yes" || *text == "on" ||
         *text == "t";
}

std::string Element::place() const { return fmt::format("{}:{}", file_, line_); }

InputError Element::error(std::string_view message) const {
  const auto id = find("id");
  return InputError(fmt::format("{}: <{}{}>: {}", place(), name_,
                                id ? fmt::format(" id='{}'", id->substr(0, 80)) : "", message));
}

namespace {

std::string_view view(const xmlChar* text) {
  return text == nullptr ? std::string_view{} : reinterpret_cast<const char*>(text);
}

/// Where the bytes come from: a gzFile (which reads plain files as they are) or a text.
class Source {
 public:
  virtual ~Source() = default;
  /// How many bytes were written to `buffer`; 0 at the end. Throws InputError.
  virtual int read(char* buffer, int size) = 0;
};

class FileSource : public Source {
 public:
  explicit FileSource(const std::filesystem::path& file) : name_(file.string()) {
    errno = 0;
    file_ = gzopen(name_.c_str(), "rb");
    if (file_ == nullptr) {
      throw InputError(
          fmt::format("cannot read '{}': {}", name_, std::strerror(errno != 0 ? errno : ENOMEM)));
    }
    gzbuffer(file_, 1U << 17U);
  }
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;
  ~FileSource() override { gzclose(file_); }

  int read(char* buffer, int size) override {
    const int count = gzread(file_, buffer, static_cast<unsigned>(size));
    int code = Z_OK;
    const char* words = gzerror(file_, &code);
    if (code == Z_ERRNO) throw InputError(fmt::format("cannot read '{}': {}", name_, std::strerror(errno)));
    if (code == Z_BUF_ERROR) throw InputError(fmt::format("'{}' is cut short (gzip ends too early)", name_));
    if (count < 0 || code < 0) throw InputError(fmt::format("'{}' is damaged: {}", name_, words));
    return count;
  }

 private:
  std::string name_;
  gzFile file_ = nullptr;
};

class TextSource : public Source {
 public:
  explicit TextSource(std::string_view text) : text_(text) {}
  int read(char* buffer, int size) override {
    const std::size_t count = text_.copy(buffer, static_cast<std::size_t>(size));
    text_.remove_prefix(count);
    return static_cast<int>(count);
  }

 private:
  std::string_view text_;
};

/// Carries handler and errors through libxml2's C callbacks, which no exception may cross.
struct Session {
  Source& source;
  Handler& handler;
  std::string name;
  xmlParserCtxtPtr context = nullptr;
  std::vector<Attribute> attributes;
  std::exception_ptr failure;
  std::string malformed{};  ///< libxml2's first error, with its line: those after it follow from it

  template <class Action>
  void guarded(Action action) {
    if (failure) return;
    try {
      action();
    } catch (...) {
      failure = std::current_exception();
    }
  }
  /// The same for what the parser calls between two elements, where it may be stopped. While it fills its
  /// buffer it may not: xmlStopParser would free the buffer under it.
  template <class Action>
  void guarded_and_stopped(Action action) {
    guarded(action);
    if (failure && context != nullptr) xmlStopParser(context);
  }
};

int on_read(void* session, char* buffer, int size) {
  int count = -1;
  static_cast<Session*>(session)->guarded(
      [&] { count = static_cast<Session*>(session)->source.read(buffer, size); });
  return count;
}

void on_start(void* data, const xmlChar* name, const xmlChar* /*prefix*/, const xmlChar* /*uri*/,
              int /*namespaces*/, const xmlChar** /*namespace_list*/, int attribute_count, int /*defaulted*/,
              const xmlChar** values) {
  auto& session = *static_cast<Session*>(data);
  session.guarded_and_stopped([&] {
    session.attributes.clear();
    for (int i = 0; i < attribute_count; ++i) {  // localname, prefix, URI, value, end
      const xmlChar** a = values + static_cast<std::ptrdiff_t>(5) * i;
      const auto* begin = reinterpret_cast<const char*>(a[3]);
      const auto* end = reinterpret_cast<const char*>(a[4]);
      session.attributes.push_back(
          {.name = view(a[0]), .value = {begin, static_cast<std::size_t>(end - begin)}});
    }
    const Element element(view(name), session.attributes, session.name,
                          xmlSAX2GetLineNumber(session.context));
    session.handler.start(element);
  });
}

void on_end(void* data, const xmlChar* name, const xmlChar* /*prefix*/, const xmlChar* /*uri*/) {
  auto& session = *static_cast<Session*>(data);
  session.guarded_and_stopped([&] { session.handler.end(view(name)); });
}

void on_document_type(void* data, const xmlChar* /*name*/, const xmlChar* /*id*/, const xmlChar* /*system*/) {
  auto& session = *static_cast<Session*>(data);
  session.guarded_and_stopped([&] {
    throw InputError(fmt::format("{}:{}: <!DOCTYPE>: document types and entities are not accepted",
                                 session.name, xmlSAX2GetLineNumber(session.context)));
  });
}

void run(Session& session) {
  xmlSAXHandler sax{};
  sax.initialized = XML_SAX2_MAGIC;
  sax.startElementNs = on_start;
  sax.endElementNs = on_end;
  sax.internalSubset = on_document_type;
  sax.serror = [](void* data, auto* error) {  // a const pointer from libxml2 2.12 on
    auto& own = *static_cast<Session*>(data);
    if (error->level < XML_ERR_ERROR || !own.malformed.empty()) return;
    own.guarded([&] {
      const auto words = trimmed(error->message == nullptr ? "" : error->message);
      own.malformed = fmt::format("{}:{}: not well-formed XML: {}", own.name, error->line, words);
    });
  };
  const std::unique_ptr<xmlParserCtxt, decltype(&xmlFreeParserCtxt)> context(
      xmlCreateIOParserCtxt(&sax, &session, on_read, nullptr, &session, XML_CHAR_ENCODING_NONE),
      &xmlFreeParserCtxt);
  if (session.failure) std::rethrow_exception(session.failure);
  if (!context) throw InputError(fmt::format("cannot read '{}': out of memory", session.name));
  session.context = context.get();
  // NOENT: "&amp;" arrives as "&", not as "&#38;". Document types are refused, so that there are no entities
  // but the five of XML itself.
  xmlCtxtUseOptions(context.get(),
                    XML_PARSE_NONET | XML_PARSE_NOENT | XML_PARSE_NOERROR | XML_PARSE_NOWARNING);
  const bool well_formed = xmlParseDocument(context.get()) == 0 && context->wellFormed != 0;
  session.context = nullptr;
  if (context->myDoc != nullptr) xmlFreeDoc(context->myDoc);
  context->myDoc = nullptr;
  if (session.failure) std::rethrow_exception(session.failure);
  if (well_formed) return;
  throw InputError(session.malformed.empty() ? fmt::format("'{}' is not well-formed XML", session.name)
                                             : session.malformed);
}

}  // namespace

void read(const std::filesystem::path& file, Handler& handler) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    throw InputError(fmt::format("cannot read '{}': it is a folder", file.string()));
  }
  FileSource source(file);
  Session session{
      .source = source, .handler = handler, .name = file.string(), .attributes = {}, .failure = {}};
  run(session);
}

void parse(std::string_view text, const std::string& name, Handler& handler) {
  TextSource source(text);
  Session session{.source = source, .handler = handler, .name = name, .attributes = {}, .failure = {}};
  run(session);
}

}  // namespace thalweg::xml
