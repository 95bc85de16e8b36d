#include "bench/bench_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/number.hpp"
#include "bench/files.hpp"
#include "output/files.hpp"
#include "output/page.hpp"
#include "output/svg.hpp"

namespace hn {
namespace {

using Json = nlohmann::json;

constexpr double kFramePixels = 1920.0 * 1080.0;

// --- Subjects --------------------------------------------------------------------------------------------------------

// What an id says: "noise2d.perlin.lattice+fixed" is a function with knobs; Perlin/Float is "table.float2".
struct Parts {
  std::string_view function;  // empty for what is not the library's
  std::string_view knobs;
};

Parts parts_of(const Measurement& measurement) {
  const std::string_view id = measurement.subject.id;
  const auto dot = id.rfind('.');
  if (dot == std::string_view::npos || id.starts_with("table.")) return {};
  return {id.substr(0, dot), id.substr(dot + 1)};
}

bool is_empty_shader(const Measurement& measurement) { return measurement.subject.id.starts_with("empty"); }
bool is_of_others(const Measurement& measurement) {
  return parts_of(measurement).function.empty() && !is_empty_shader(measurement);
}
bool is_default(const Measurement& measurement) {
  const std::string_view knobs = parts_of(measurement).knobs;
  return knobs == default_configuration().name || knobs == "any";
}

// Milliseconds for a frame with an evaluation per pixel, beyond those of an empty shader; nothing if too few to tell.
std::optional<double> frame_milliseconds(const Measurement& measurement) {
  if (measurement.error || !measurement.evaluations_per_second) return std::nullopt;
  return kFramePixels / *measurement.evaluations_per_second * 1e3;
}

std::string milliseconds_text(const Measurement& measurement) {
  const auto milliseconds = frame_milliseconds(measurement);
  return milliseconds ? three_digits(*milliseconds) : measurement.error ? "failed" : "too fast to tell";
}

using Measurements = std::vector<const Measurement*>;

// Cheapest first; what failed comes last.
void sort_by_cost(Measurements& list) {
  const auto cost = [](const Measurement* measurement) {
    if (measurement->error) return std::numeric_limits<double>::infinity();
    return frame_milliseconds(*measurement).value_or(0.0);
  };
  std::stable_sort(list.begin(), list.end(),
                   [&](const Measurement* a, const Measurement* b) { return cost(a) < cost(b); });
}

void sort_by_ratio(std::vector<Bar>& bars) {
  const auto cost = [](const Bar& bar) {
    return bar.value == bar.value ? bar.value : std::numeric_limits<double>::infinity();
  };
  std::stable_sort(bars.begin(), bars.end(), [&](const Bar& a, const Bar& b) { return cost(a) < cost(b); });
}

// --- A frame ---------------------------------------------------------------------------------------------------------

std::string title_of_others(std::string_view id) {
  if (id.starts_with("table.float")) return "Perlin/Float, tables in textures";
  if (id.starts_with("table.integer")) return "Perlin/Integer, tables in textures";
  return std::string(id);
}

// What people draw with: noises and octave sums as they come, and what is compared with them.
bool is_in_a_frame(const Measurement& measurement) {
  if (measurement.error) return false;
  if (is_of_others(measurement)) return true;
  if (is_empty_shader(measurement) || !is_default(measurement)) return false;
  const std::string_view id = parts_of(measurement).function;
  const auto functions = all_functions();
  return std::any_of(functions.begin(), functions.end(), [&](const Function& function) {
    return function.id == id && (function.is_octave_sum() || (function.is_noise() && !function.takes_cell()));
  });
}

// What the others are compared with. Its time is told from nothing.
struct Yardstick {
  std::string name = {};
  const Measurement* measurement = nullptr;
};

// hn_perlin, or Perlin/Float, which is always measured, if hn_perlin is not.
Yardstick yardstick_of(const BenchReport& report, int dimensions) {
  const Yardstick wanted[] = {
      {fmt::format("noise{}d.perlin.{}", dimensions, default_configuration().name)},
      {fmt::format("table.float{}", dimensions)},
  };
  for (const Yardstick& one : wanted) {
    for (const Measurement& measurement : report.measurements) {
      if (measurement.subject.id != one.name || measurement.error) continue;
      if (!(measurement.ratio.value > measurement.ratio.spread)) continue;
      return {is_of_others(measurement) ? "Perlin/Float" : "hn_perlin", &measurement};
    }
  }
  return {"hn_perlin", nullptr};
}

// Both ratios are to the same shader, in the same rounds.
std::string against(const Measurement& measurement, const Measurement* yardstick) {
  if (&measurement == yardstick) return "1";
  if (yardstick == nullptr || !measurement.ratio.known()) return "cannot be told";
  const Ratio& unit = yardstick->ratio;
  const double quotient = measurement.ratio.value / unit.value;
  const double spread = (measurement.ratio.spread + std::abs(quotient) * unit.spread) / unit.value;
  return text_of(Ratio{quotient, spread});
}

Json page_frames(const BenchReport& report) {
  Json list = Json::array();
  for (const int dimensions : {2, 3}) {
    Measurements subjects;
    for (const Measurement& measurement : report.measurements) {
      if (measurement.subject.dimensions == dimensions && is_in_a_frame(measurement)) subjects.push_back(&measurement);
    }
    if (subjects.empty()) continue;
    sort_by_cost(subjects);
    const Yardstick yardstick = yardstick_of(report, dimensions);
    Json rows = Json::array();
    for (const Measurement* subject : subjects) {
      const bool own = !is_of_others(*subject);
      rows.push_back({{"what", own ? subject->subject.expression : title_of_others(subject->subject.id)},
                      {"class", own ? "own" : ""},
                      {"milliseconds", milliseconds_text(*subject)},
                      {"against", against(*subject, yardstick.measurement)}});
    }
    list.push_back({{"dimensions", dimensions}, {"yardstick", yardstick.name}, {"rows", std::move(rows)}});
  }
  return list;
}

// --- Plots -----------------------------------------------------------------------------------------------------------

Bar bar_of(const Measurement& measurement, std::string_view name, bool marked) {
  return {marked ? fmt::format("{} (default)", name) : std::string(name), measurement.ratio.value,
          measurement.ratio.spread, marked};
}

// Draws a bar for each subject with the prefix, for table noises of as many dimensions and for what is not the
// library's.
std::string bars(const BenchReport& report, std::string_view prefix, int dimensions, const std::string& title) {
  std::vector<Bar> bars;
  for (const Measurement& measurement : report.measurements) {
    const std::string_view id = measurement.subject.id;
    if (measurement.error || measurement.subject.dimensions != dimensions || is_empty_shader(measurement)) continue;
    if (is_of_others(measurement)) {
      bars.push_back(bar_of(measurement, id, false));
    } else if (id.starts_with(prefix)) {
      bars.push_back(bar_of(measurement, id.substr(prefix.size()), is_default(measurement)));
    }
  }
  sort_by_ratio(bars);
  return bar_plot({title, "time, as a multiple of Perlin/Float's", ""}, bars);
}

// Every function with the default knobs.
std::string default_bars(const BenchReport& report) {
  std::vector<Bar> bars;
  for (const Measurement& measurement : report.measurements) {
    if (measurement.error || !is_default(measurement)) continue;
    bars.push_back({std::string(parts_of(measurement).function), measurement.ratio.value, measurement.ratio.spread});
  }
  sort_by_ratio(bars);
  return bar_plot({"every function, default knobs", "time, as a multiple of Perlin/Float's of as many dimensions", ""},
                  bars);
}

// --- Tables ----------------------------------------------------------------------------------------------------------

std::string precise_text(const Ratio& ratio) { return fmt::format("{:.3f} ± {:.3f}", ratio.value, ratio.spread); }

Json page_header() {
  std::vector<std::string> names = {"ms a frame", "ratio", "ms to compile"};
  for (const std::string& source : count_sources()) names.push_back(source);
  return names;
}

std::vector<std::string> cells_of(const Measurement& measurement, const std::map<std::string, std::string>& absent) {
  std::vector<std::string> cells = {milliseconds_text(measurement)};
  if (measurement.error) {
    cells.resize(page_header().size(), "failed");
    return cells;
  }
  cells.push_back(measurement.ratio.known() ? precise_text(measurement.ratio) : "cannot be told");
  cells.push_back(fmt::format("{:.1f}", measurement.compile_seconds * 1e3));
  for (const std::string& source : count_sources()) cells.push_back(count_text(measurement.counts, source, absent));
  return cells;
}

Json page_rows(const BenchReport& report) {
  Measurements subjects;
  for (const Measurement& measurement : report.measurements) subjects.push_back(&measurement);
  sort_by_cost(subjects);
  Json rows = Json::array();
  for (const Measurement* subject : subjects) {
    rows.push_back({{"id", subject->subject.id},
                    {"default", is_default(*subject)},
                    {"numbers", cells_of(*subject, report.absent)}});
  }
  return rows;
}

Json page_errors(const BenchReport& report) {
  Json errors = Json::array();
  for (const Measurement& measurement : report.measurements) {
    if (measurement.error) errors.push_back({{"id", measurement.subject.id}, {"text", measurement.error->text()}});
    for (const std::string& problem : measurement.counts.problems) {
      errors.push_back({{"id", measurement.subject.id}, {"text", problem}});
    }
  }
  return errors;
}

Json page_changes(const std::vector<Change>& changes) {
  Json rows = Json::array();
  for (const Change& change : changes) {
    rows.push_back({{"id", change.id},
                    {"before", precise_text(change.before)},
                    {"now", precise_text(change.now)},
                    {"slower", change.slower}});
  }
  return rows;
}

}  // namespace

Result<std::string> bench_page(const Provenance& provenance, const BenchReport& report,
                               const std::vector<Change>& changes) {
  const Json errors = page_errors(report);
  const Json frames = page_frames(report);
  const Json data = {{"style", text_of(kOutputFiles, "style.mustache")},
                     {"provenance", to_json(provenance)},
                     {"library", library_text(provenance.library)},
                     {"gate", report.gate.reason},
                     {"clock", name_of(report.gate.clock)},
                     {"rounds", report.rounds},
                     {"side", report.side},
                     {"iterations", report.iterations},
                     {"frames", frames},
                     {"has_frames", !frames.empty()},
                     {"header", page_header()},
                     {"rows", page_rows(report)},
                     {"absent", absent_sources(report.absent)},
                     {"errors", errors},
                     {"has_errors", !errors.empty()},
                     {"changes", page_changes(changes)},
                     {"has_changes", !changes.empty()},
                     {"bars_default", default_bars(report)},
                     {"bars2", bars(report, "noise2d.perlin.", 2, "hn_perlin(vec2), by knobs")},
                     {"bars3", bars(report, "noise3d.perlin.", 3, "hn_perlin(vec3), by knobs")}};
  return render_page(text_of(kBenchFiles, "bench.mustache"), data);
}

}  // namespace hn
