// SPDX-License-Identifier: Apache-2.0
#include "app/options.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <cctype>
#include <cstdio>
#include <ctime>

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "xml/writer.hpp"

namespace thalweg {
namespace {

namespace po = boost::program_options;

/// As SUMO reads them, upper and lower case alike.
std::optional<bool> parse_boolean(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* word : {"true", "1", "yes", "on", "x", "t"}) {
    if (lower == word) return true;
  }
  for (const char* word : {"false", "0", "no", "off", "f"}) {
    if (lower == word) return false;
  }
  return std::nullopt;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

void write_text(const std::string& file, const std::string& text) {
  if (file == "-" || file == "stdout") {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return;
  }
  OutputFile output(file);
  output.write(text);
  output.commit();
}

}  // namespace

Options::Options(std::string command, std::string summary, std::vector<OptionSpec> specs)
    : command_(std::move(command)), summary_(std::move(summary)), specs_(std::move(specs)) {
  specs_.push_back({"report", "verbose", 'v', "BOOL", "false", "Says what is being done"});
  specs_.push_back({"report", "log", 'l', "FILE", "", "Writes all messages to this file (implies verbose)"});
  specs_.push_back({"report", "help", '?', "BOOL", "false", "Prints this screen"});
  specs_.push_back({"report", "version", 'V', "BOOL", "false", "Prints the version"});
  specs_.push_back(
      {"configuration", "save-configuration", 'C', "FILE", "", "Saves these options as a configuration"});
  specs_.push_back(
      {"configuration", "save-template", 0, "FILE", "", "Saves the options there are, with their help"});
  for (const OptionSpec& spec : specs_) values_[spec.name] = {.text = spec.default_value};
}

void Options::parse(std::span<const std::string> arguments) {
  const auto end = std::find(arguments.begin(), arguments.end(), "--");
  if (end != arguments.end()) for_sumo_.assign(end + 1, arguments.end());
  std::vector<std::string> own;
  for (auto argument = arguments.begin(); argument != end; ++argument) {
    // "--verbose false" is SUMO's way; Boost takes an optional value only after '='.
    const bool after_flag = !own.empty() && own.back().starts_with("-") && parse_boolean(*argument);
    const OptionSpec* flag =
        after_flag ? find(std::string_view(own.back()).substr(own.back().starts_with("--") ? 2 : 1))
                   : nullptr;
    if (flag != nullptr && flag->type == "BOOL") {
      own.back() = fmt::format("--{}={}", flag->name, *argument);
    } else {
      own.push_back(*argument == "-h" ? "--help" : *argument);
    }
  }
  po::options_description description;
  std::vector<std::string> names;
  for (const OptionSpec& spec : specs_) {
    auto* value = po::value<std::string>();
    if (spec.type == "BOOL") value->implicit_value("true");
    const std::string name =
        spec.short_name == 0 ? spec.name : fmt::format("{},{}", spec.name, spec.short_name);
    description.add_options()(name.c_str(), value);
    names.push_back(spec.name);
  }
  try {
    const auto parsed =
        po::command_line_parser(own)
            .options(description)
            .style(po::command_line_style::unix_style & ~po::command_line_style::allow_guessing)
            .run();
    for (const auto& option : parsed.options) {
      if (option.position_key >= 0) {
        const std::string& word = option.value.front();
        const bool is_configuration = word.ends_with("cfg") && find("configuration-file") != nullptr;
        throw InputError(fmt::format("'{}' belongs to no option{}; 'thalweg {} --help' lists them", word,
                                     is_configuration ? fmt::format(" (did you mean '-c {}'?)", word) : "",
                                     command_));
      }
      set(*find(option.string_key), option.value.empty() ? "true" : option.value.front(), true);
    }
  } catch (const po::unknown_option& error) {
    const std::string given = error.get_option_name();
    const std::string name = given.substr(0, given.find('='));
    const auto bare = std::string_view(name).substr(std::min(name.find_first_not_of('-'), name.size()));
    throw InputError(fmt::format("there is no option '{}'{}; 'thalweg {} --help' lists them", name,
                                 did_you_mean(bare, names), command_));
  } catch (const po::error& error) {
    throw InputError(error.what());
  }
}

bool Options::take(const Setting& setting) {
  const OptionSpec* spec = find(setting.name);
  if (spec == nullptr) return false;
  if (!values_.find(spec->name)->second.from_command_line) set(*spec, setting.value, false);
  return true;
}

void Options::take_file(const std::filesystem::path& file) {
  verify(std::filesystem::exists(file), fmt::format("the configuration '{}' does not exist", file.string()));
  std::vector<std::string> names;
  for (const OptionSpec& spec : specs_) names.push_back(spec.name);
  for (const Setting& setting : read_configuration(file)) {
    const OptionSpec* spec = find(setting.name);
    verify(spec != nullptr, fmt::format("{}: 'thalweg {}' has no option '{}'{}", file.string(), command_,
                                        setting.name, did_you_mean(setting.name, names)));
    const bool is_file = spec->type == "FILE" && !setting.value.empty();
    const auto folder = std::filesystem::absolute(file).parent_path();
    take({.name = spec->name, .value = is_file ? resolve_files(setting.value, folder) : setting.value});
  }
}

const OptionSpec* Options::find(std::string_view name) const {
  for (const OptionSpec& spec : specs_) {
    if (spec.name == name || (name.size() == 1 && spec.short_name == name.front())) return &spec;
  }
  return nullptr;
}

void Options::set(const OptionSpec& spec, std::string value, bool from_command_line) {
  const auto fail = [&](std::string_view what) {
    throw InputError(fmt::format("--{} {}: this is no {}", spec.name, value, what));
  };
  if (spec.type == "BOOL" && !parse_boolean(value)) fail("boolean (true or false)");
  if (spec.type == "INT" && !parse_integer<std::int64_t>(value)) fail("whole number");
  if (spec.type == "FLOAT" && !parse_number(value)) fail("number");
  if (spec.type == "TIME" && !parse_time(value)) fail("time (seconds or [d:]h:m:s)");
  values_[spec.name] = {.text = std::move(value), .from_command_line = from_command_line};
}

bool Options::is_set(std::string_view name) const {
  const OptionSpec* spec = find(name);
  return spec != nullptr && values_.find(name)->second.text != spec->default_value;
}

bool Options::on_command_line(std::string_view name) const {
  return values_.find(name)->second.from_command_line;
}

const std::string& Options::text(std::string_view name) const { return values_.find(name)->second.text; }

bool Options::flag(std::string_view name) const { return parse_boolean(text(name)).value_or(false); }

double Options::number(std::string_view name) const { return *parse_number(text(name)); }

std::uint64_t Options::count(std::string_view name) const {
  const auto value = parse_integer<std::uint64_t>(text(name));
  if (!value) throw InputError(fmt::format("--{} {}: this is no whole number from 0 on", name, text(name)));
  return *value;
}

Millis Options::time(std::string_view name) const { return *parse_time(text(name)); }

std::string Options::help() const {
  std::string out =
      fmt::format("thalweg {}: {}\n\nUsage: thalweg {} [options]\n", command_, summary_, command_);
  for (const auto& section : sections()) {
    out += fmt::format("\n{}:\n", section);
    for (const OptionSpec& spec : specs_) {
      if (spec.section != section) continue;
      const std::string name = spec.short_name == 0 ? fmt::format("      --{}", spec.name)
                                                    : fmt::format("  -{}, --{}", spec.short_name, spec.name);
      out += fmt::format("{:<36} {}", spec.type == "BOOL" ? name : fmt::format("{} {}", name, spec.type),
                         spec.help);
      if (!spec.default_value.empty() && spec.type != "BOOL") out += fmt::format(" [{}]", spec.default_value);
      out += '\n';
    }
  }
  return out;
}

std::vector<std::string> Options::sections() const {
  std::vector<std::string> sections;
  for (const OptionSpec& spec : specs_) {
    if (std::find(sections.begin(), sections.end(), spec.section) == sections.end())
      sections.push_back(spec.section);
  }
  return sections;
}

std::string Options::to_xml(bool values) const {
  std::string out =
      fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\n<!-- thalweg {} {} -->\n\n<configuration>\n",
                  command_, THALWEG_VERSION);
  for (const auto& section : sections()) {
    std::string body;
    for (const OptionSpec& spec : specs_) {
      const bool is_meta = spec.name == "help" || spec.name == "version" || spec.name.starts_with("save-");
      if (spec.section != section || (values && (is_meta || !is_set(spec.name)))) continue;
      body += fmt::format("        <{} value=\"{}\"", spec.name,
                          escaped(values ? text(spec.name) : spec.default_value));
      if (!values) {
        if (spec.short_name != 0) body += fmt::format(" synonymes=\"{}\"", spec.short_name);
        body += fmt::format(" type=\"{}\" help=\"{}\"", spec.type, escaped(spec.help));
      }
      body += "/>\n";
    }
    if (!body.empty()) out += fmt::format("    <{0}>\n{1}    </{0}>\n", section, body);
  }
  return out + "</configuration>\n";
}

std::string Options::header() const {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::string text = to_xml(true);
  text.erase(0, text.find("<configuration>"));
  return fmt::format("generated on {:%Y-%m-%dT%H:%M:%S} by thalweg {} {}\n{}", local, command_,
                     THALWEG_VERSION, text);
}

bool Options::answered() const {
  if (flag("version")) {
    fmt::print("thalweg {}\n", THALWEG_VERSION);
    return true;
  }
  if (flag("help")) {
    const std::string screen = help();
    std::fwrite(screen.data(), 1, screen.size(), stdout);
    return true;
  }
  if (!text("save-template").empty()) {
    write_text(text("save-template"), to_xml(false));
    return true;
  }
  if (text("save-configuration").empty()) return false;
  Options saved = *this;  // which may be read from anywhere
  for (const OptionSpec& spec : specs_) {
    if (spec.type != "FILE" || !is_set(spec.name)) continue;
    saved.values_[spec.name].text = resolve_files(text(spec.name), std::filesystem::current_path());
  }
  write_text(text("save-configuration"), saved.to_xml(true));
  return true;
}

}  // namespace thalweg
