// SPDX-License-Identifier: Apache-2.0
#include "lab/experiment.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "core/parallel.hpp"
#include "lab/list.hpp"

namespace thalweg::lab {
namespace {

std::uint64_t parse_count(std::string_view name, std::string_view text, std::uint64_t least) {
  const auto value = parse_integer<std::uint64_t>(text);
  verify(value.has_value(), fmt::format("--{} {}: this is no whole number from 0 on", name, text));
  verify(*value >= least, fmt::format("--{} {}: must be at least {}", name, *value, least));
  return *value;
}

std::int64_t now_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

}  // namespace

double Parameters::number(std::string_view name) const {
  const auto value = parse_number(text(name));
  verify(value.has_value(), fmt::format("--{} {}: this is no number", name, text(name)));
  return *value;
}

std::uint64_t Parameters::count(std::string_view name, std::uint64_t least) const {
  return parse_count(name, text(name), least);
}

std::vector<std::uint64_t> Parameters::list(std::string_view name, std::uint64_t least) const {
  constexpr std::size_t most = 100'000;
  std::vector<std::uint64_t> out;
  for (const std::string_view part : split(text(name), ", ")) {
    const auto dots = part.find("..");
    if (dots == std::string_view::npos) {
      out.push_back(parse_count(name, part, least));
      continue;
    }
    const auto slash = part.find('/', dots);
    const std::uint64_t first = parse_count(name, part.substr(0, dots), least);
    const std::uint64_t last = parse_count(name, part.substr(dots + 2, slash - dots - 2), first);
    const std::uint64_t step =
        slash == std::string_view::npos ? 1 : parse_count(name, part.substr(slash + 1), 1);
    verify((last - first) / step < most, fmt::format("--{} {}: too many values", name, part));
    for (std::uint64_t value = first;; value += step) {
      out.push_back(value);
      if (last - value < step) break;
    }
  }
  verify(!out.empty(), fmt::format("--{}: give at least one number", name));
  return out;
}

void Run::repeat(std::string_view what, const std::function<void(std::size_t, std::size_t)>& work) const {
  std::atomic<std::size_t> done{0};
  parallel_for(repetitions, threads, [&](std::size_t repetition, std::size_t worker) {
    work(repetition, worker);
    say(fmt::format("{}: {} of {}", what, ++done, repetitions));
  });
}

std::string Report::csv() const {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string out;
    for (const auto& cell : cells) {
      if (!out.empty() || &cell != cells.data()) out += ',';
      const bool quoted = cell.find_first_of(",\"\n") != std::string::npos;
      if (quoted) out += '"';
      for (const char c : cell) {
        if (c == '"') out += '"';
        out += c;
      }
      if (quoted) out += '"';
    }
    return out + "\n";
  };
  std::string out = line(header);
  for (const auto& row : rows) out += line(row);
  return out;
}

std::string Report::text() const {
  std::vector<std::size_t> width(header.size());
  const auto widen = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < width.size(); ++i) width[i] = std::max(width[i], cells[i].size());
  };
  widen(header);
  for (const auto& row : rows) widen(row);
  std::string out;
  const auto line = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < width.size(); ++i)
      out += fmt::format("{}{:>{}}", i == 0 ? "" : "  ", cells[i], width[i]);
    out += '\n';
  };
  line(header);
  for (const auto& row : rows) line(row);
  for (const auto& note : notes) out += note + "\n";
  return out;
}

const Experiment& find_experiment(std::string_view name) {
  std::vector<std::string> names;
  for (const Experiment& experiment : experiments()) {
    if (experiment.name == name) return experiment;
    names.push_back(experiment.name);
  }
  throw InputError(fmt::format("there is no experiment '{}'{}; 'thalweg lab' lists them", name,
                               did_you_mean(name, names)));
}

std::string cell(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "";
}

std::string cell(std::uint64_t value) { return std::to_string(value); }

void add_estimate(std::vector<std::string>& row, const Estimate& estimate, int digits) {
  row.push_back(cell(estimate.mean, digits));
  row.push_back(estimate.half_width ? cell(*estimate.half_width, digits) : "");
}

void verify_memory(std::string_view what, double bytes) {
  const double physical =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  verify(bytes < physical, fmt::format("{} would need about {:.1f} GB; this machine has {:.1f} GB", what,
                                       bytes / 1e9, physical / 1e9));
}

void verify_grid(std::uint64_t side, double bytes_per_vertex) {
  verify(side >= 2, fmt::format("a grid of side {}: it takes at least 2 to have two corners", side));
  const auto vertices = static_cast<double>(side) * static_cast<double>(side);
  verify_memory(fmt::format("a grid of side {}", side), vertices * bytes_per_vertex);
  constexpr std::uint64_t largest = 32'768;  // of which 4 arcs a vertex still have 32-bit ids
  verify(side <= largest,
         fmt::format("a grid of side {}: vertices and arcs are numbered up to side {}", side, largest));
}

StopWatch::StopWatch() : start_(now_ns()) {}

double StopWatch::lap_ms() {
  const std::int64_t now = now_ns();
  return static_cast<double>(now - std::exchange(start_, now)) / 1e6;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

}  // namespace thalweg::lab
