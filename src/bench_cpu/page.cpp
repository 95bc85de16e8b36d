#include "bench_cpu/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/number.hpp"
#include "base/strings.hpp"
#include "base/text.hpp"
#include "base/version.hpp"

namespace hn {
namespace {

constexpr int kSchema = 1;

bool is_missed(const Ratio& ratio, std::optional<double> aim) { return aim && ratio.known() && ratio.value < *aim; }

std::string cell_of(const Ratio& ratio, std::optional<double> aim) {
  return is_missed(ratio, aim) ? fmt::format("**{}** missed", text_of(ratio)) : text_of(ratio);
}

std::vector<hashnoise::InstructionSet> sets_of(const CpuRun& run) {
  std::vector<hashnoise::InstructionSet> sets;
  for (const Measurement& measurement : run.measurements) {
    if (std::ranges::count(sets, measurement.set) == 0) sets.push_back(measurement.set);
  }
  return sets;
}

std::vector<Subject> subjects_of(const CpuRun& run) {
  std::vector<Subject> subjects;
  for (const Measurement& measurement : run.measurements) {
    const bool is_new =
        std::ranges::none_of(subjects, [&](const Subject& s) { return s.id == measurement.subject.id; });
    if (is_new) subjects.push_back(measurement.subject);
  }
  return subjects;
}

const Measurement* measurement_of(const CpuRun& run, const Subject& subject, hashnoise::InstructionSet set) {
  for (const Measurement& measurement : run.measurements) {
    if (measurement.subject.id == subject.id && measurement.set == set) return &measurement;
  }
  return nullptr;
}

std::string row_of(const std::vector<std::string>& cells) { return fmt::format("| {} |\n", fmt::join(cells, " | ")); }

std::string head_of(const std::vector<std::string>& cells) {
  return row_of(cells) + row_of(std::vector<std::string>(cells.size(), "---"));
}

struct Section {
  Comparison comparison;
  std::string_view title;
  std::string_view text;
};
constexpr Section kSections[] = {
    {Comparison::grids, "Grids, beside FastNoise2",
     "How many times as fast as FastNoise2 a grid is filled, both with the same instructions, by one thread, with "
     "HN_FAST. The aim stands behind each noise."},
    {Comparison::points, "Lists of points, beside FastNoise2",
     "The same at a million points that are passed. There is no aim."},
    {Comparison::octaves, "Octaves that are not turned, beside FastNoise2",
     "FastNoise2 does not turn the octaves of a sum. Here they are not turned either: each is a grid of the noise, "
     "twice as dense as the one before and with a seed of its own, and the grids are added up. There is no aim."},
    {Comparison::fixed, "HN_FIXED beside HN_FAST",
     "How many times as fast as with HN_FAST a grid is filled with HN_FIXED. The aim is 0.6."},
    {Comparison::precise, "HN_PRECISE beside HN_FAST", "The same with HN_PRECISE. There is no aim."},
    {Comparison::tiles, "Tiles beside grids without a period",
     "How many times as fast as without a period a grid with one of 1000 cells is filled. There is no aim."},
    {Comparison::lists, "Lists of points beside grids",
     "How many times as fast as a grid a list of the same points is computed. The aim is 0.5."},
    {Comparison::threads, "Two threads beside one",
     "How many times as fast as by one thread a grid is filled by two. There is no aim."},
};

std::string section_of(const CpuRun& run, const Section& section) {
  std::vector<hashnoise::InstructionSet> sets;
  for (const hashnoise::InstructionSet set : sets_of(run)) {
    const bool measured = std::ranges::any_of(
        run.measurements, [&](const Measurement& m) { return m.set == set && m.ratios.contains(section.comparison); });
    if (measured) sets.push_back(set);
  }
  if (sets.empty()) return {};
  const bool own_aims = section.comparison == Comparison::grids;
  std::vector<std::string> head = {"noise"};
  if (own_aims) head.emplace_back("aim");
  for (const hashnoise::InstructionSet set : sets) head.emplace_back(name(set));
  std::string text = fmt::format("## {}\n\n{}\n\n{}", section.title, section.text, head_of(head));
  for (const Subject& subject : subjects_of(run)) {
    const bool is_compared = std::ranges::any_of(run.measurements, [&](const Measurement& m) {
      return m.subject.id == subject.id && m.ratios.contains(section.comparison);
    });
    if (!is_compared) continue;
    const auto aim = aim_of(section.comparison, subject);
    std::vector<std::string> cells = {fmt::format("`{}`", subject.id)};
    if (own_aims) cells.push_back(fmt::format("{}", *aim));
    for (const hashnoise::InstructionSet set : sets) {
      const Measurement* const measurement = measurement_of(run, subject, set);
      const bool is_there = measurement && measurement->ratios.contains(section.comparison);
      cells.push_back(is_there ? cell_of(measurement->ratios.at(section.comparison), aim) : "");
    }
    text += row_of(cells);
  }
  return text + "\n";
}

std::string python_section(const CpuRun& run) {
  if (!run.python) return {};
  return fmt::format(
      "## Python beside C++\n\nHow many times as fast as C++ `hashnoise.perlin` computes a million points in 2D, by "
      "one "
      "thread. The aim is {}.\n\n{}{}{}\n",
      kPythonAim, head_of({"call", "ratio"}),
      row_of({"with an array of the caller (`out=`)", cell_of(run.python->own_array, kPythonAim)}),
      row_of({"with a new array each time", cell_of(run.python->new_array, kPythonAim)}));
}

std::string rates_section(const CpuRun& run) {
  const std::vector<std::string> columns = {"fast",   "fixed",       "precise",    "tiles",
                                            "points", "two threads", "FastNoise2", "FastNoise2 points"};
  std::vector<std::string> head = {"noise", "instructions"};
  head.insert(head.end(), columns.begin(), columns.end());
  std::string text =
      "## Million points a second\n\nThese are of this machine and this run, and nothing is to be compared with "
      "numbers "
      "from elsewhere. `cellular` has two distances at each point, and FastNoise2 one.\n\n" +
      head_of(head);
  for (const Measurement& measurement : run.measurements) {
    std::vector<std::string> cells = {fmt::format("`{}`", measurement.subject.id), std::string(name(measurement.set))};
    for (const std::string& column : columns) {
      const auto found = measurement.millions_a_second.find(column);
      cells.push_back(found == measurement.millions_a_second.end() ? "" : three_digits(found->second));
    }
    text += row_of(cells);
  }
  return text;
}

nlohmann::ordered_json to_json(const Ratio& ratio, std::optional<double> aim) {
  nlohmann::ordered_json json = {{"ratio", ratio.value}, {"spread", ratio.spread}};
  if (!aim) return json;
  json["aim"] = *aim;
  json["met"] = ratio.known() && !is_missed(ratio, aim);
  return json;
}

nlohmann::ordered_json to_json(const Measurement& measurement) {
  nlohmann::ordered_json json = {{"id", measurement.subject.id},
                                 {"instructions", name(measurement.set)},
                                 {"millions_a_second", measurement.millions_a_second},
                                 {"ratios", nlohmann::ordered_json::object()}};
  for (const auto& [comparison, ratio] : measurement.ratios) {
    json["ratios"][std::string(name_of(comparison))] = to_json(ratio, aim_of(comparison, measurement.subject));
  }
  return json;
}

}  // namespace

std::string compiler_name() {
#ifdef __clang__
  return "clang";
#else
  return "gcc";
#endif
}

std::string compiler_version() {
#ifdef __clang__
  return fmt::format("Clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return fmt::format("GCC {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

std::string processor_name() {
  constexpr std::string_view kKey = "model name";
  const std::string text = read_file("/proc/cpuinfo").value_or("");
  for (const std::string_view line : split(text, '\n')) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with(kKey) && colon != std::string_view::npos) return clean_text(line.substr(colon + 2));
  }
  return "an unknown processor";
}

nlohmann::ordered_json to_json(const CpuRun& run) {
  nlohmann::ordered_json json = {{"schema", kSchema},
                                 {"date", run.date},
                                 {"command", run.command},
                                 {"compiler", run.compiler},
                                 {"processor", run.processor},
                                 {"library", library_version()},
                                 {"note", run.note},
                                 {"rounds", run.rounds},
                                 {"points", kPoints},
                                 {"step", 0.0371},
                                 {"measurements", nlohmann::ordered_json::array()}};
  for (const Measurement& measurement : run.measurements) json["measurements"].push_back(to_json(measurement));
  if (run.python) {
    json["python"] = {{"own_array", to_json(run.python->own_array, kPythonAim)},
                      {"new_array", to_json(run.python->new_array, kPythonAim)}};
  }
  return json;
}

std::vector<std::string> missed_aims(const CpuRun& run) {
  std::vector<std::string> missed;
  for (const Measurement& measurement : run.measurements) {
    for (const auto& [comparison, ratio] : measurement.ratios) {
      const auto aim = aim_of(comparison, measurement.subject);
      if (!is_missed(ratio, aim)) continue;
      missed.push_back(fmt::format("{}, {}: {} {}, which is to be {}", measurement.subject.id, name(measurement.set),
                                   name_of(comparison), text_of(ratio), *aim));
    }
  }
  if (!run.python) return missed;
  for (const auto& [what, ratio] :
       {std::pair{"with out=", run.python->own_array}, std::pair{"with a new array", run.python->new_array}}) {
    if (!is_missed(ratio, kPythonAim)) continue;
    missed.push_back(fmt::format("Python {}: {}, which is to be {}", what, text_of(ratio), kPythonAim));
  }
  return missed;
}

std::string page_of(const CpuRun& run) {
  std::string text = fmt::format(
      "# hashnoise::grid on a CPU, compiled by {}\n\n{}, hashnoise {}, {}.{} By `{}`.\n\nEach number is a quotient of "
      "speeds that were measured in the same {} rounds, in turns, and what stands behind ± is half the distance "
      "between "
      "the quartiles of the rounds. A grid has 1024 x 1024 or 128 x 128 x 64 points, {} cells from each other, and "
      "sums "
      "have six octaves. A number that is less than its aim is bold, with \"missed\".\n\n",
      run.compiler, run.processor, library_version(), run.date, run.note.empty() ? "" : " " + run.note, run.command,
      run.rounds, kStep);
  for (const Section& section : kSections) text += section_of(run, section);
  return text + python_section(run) + rates_section(run);
}

}  // namespace hn
