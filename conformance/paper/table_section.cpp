// The paper's table: instructions and render times of every algorithm in every form, beside what it prints.
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>

#include "base/number.hpp"
#include "base/strings.hpp"
#include "paper/files.hpp"
#include "paper/laboratory.hpp"

namespace hn {
namespace {

struct Size {
  int width;
  int height;
};
constexpr std::array kSizes = {Size{800, 600}, Size{1024, 768}};

struct Printed {
  int instructions;
  double milliseconds[kSizes.size()];
};

// The paper's row: algorithm,dimensions,instructions,ms_800x600,ms_1024x768.
std::optional<Printed> printed_row(std::string_view algorithm, int dimensions) {
  for (const std::string_view line : split(text_of(kPaperFiles, "printed.csv"), '\n')) {
    const auto cells = split(line, ',');
    if (cells.size() != 5 || cells[0] != algorithm || cells[1] != fmt::format("{}", dimensions)) continue;
    const auto number = [](std::string_view text) {
      double value = 0.0;
      std::from_chars(text.data(), text.data() + text.size(), value);
      return value;
    };
    return Printed{static_cast<int>(number(cells[2])), {number(cells[3]), number(cells[4])}};
  }
  return std::nullopt;
}

// A line of the table: an algorithm in a form, or the empty shader.
struct Row {
  Subject subject;
  std::string title;
  std::string form;
  std::string algorithm;
  std::optional<Program> program = {};
  std::string error = {};
  std::array<Timing, kSizes.size()> timing = {};
  std::array<Ratio, kSizes.size()> ratio = {};
  Counts counts = {};
};

std::vector<Row> rows_of(int dimensions) {
  std::vector<Row> rows;
  rows.push_back(Row{empty_subject(dimensions), "(empty shader)", "", "empty"});
  for (const Entry& entry : all_entries()) {
    rows.push_back(Row{subject_of(entry, dimensions), std::string(entry.algorithm->title),
                       std::string(title_of(entry.form)), std::string(entry.algorithm->name)});
  }
  return rows;
}

void build(Laboratory& laboratory, std::vector<Row>& rows) {
  for (Row& row : rows) {
    auto program = laboratory.build(quad_shader(row.subject));
    if (program) {
      row.program = std::move(*program);
    } else {
      row.error = program.error().text();
    }
  }
}

Result<void> time(Laboratory& laboratory, std::vector<Row>& rows) {
  std::vector<Workload> workloads;
  std::vector<Timing*> targets;
  for (Row& row : rows) {
    for (std::size_t size = 0; row.program && size < kSizes.size(); ++size) {
      workloads.push_back({&*row.program, kSizes[size].width, kSizes[size].height});
      targets.push_back(&row.timing[size]);
    }
  }
  HN_TRY(auto timings, laboratory.stopwatch.measure(workloads, laboratory.rounds));
  for (std::size_t i = 0; i < targets.size(); ++i) *targets[i] = std::move(timings[i]);
  return {};
}

const Row& row_named(const std::vector<Row>& rows, std::string_view algorithm, int dimensions) {
  for (const Row& row : rows) {
    if (row.algorithm == algorithm && row.subject.dimensions == dimensions) return row;
  }
  throw std::logic_error(fmt::format("there is no row {} of {} dimensions", algorithm, dimensions));
}

void relate(std::vector<Row>& rows) {
  for (Row& row : rows) {
    const int dimensions = row.subject.dimensions;
    for (std::size_t size = 0; size < kSizes.size(); ++size) {
      row.ratio[size] = ratio(row.timing[size], row_named(rows, "float", dimensions).timing[size],
                              row_named(rows, "empty", dimensions).timing[size]);
    }
  }
}

std::map<std::string, std::string> count(Laboratory& laboratory, std::vector<Row>& rows) {
  std::vector<CountedShader> shaders;
  std::vector<Row*> targets;
  for (Row& row : rows) {
    auto text = expand(laboratory.sources, profile_named("vulkan"), quad_shader(row.subject));
    if (!text || !row.program) continue;
    shaders.push_back({std::move(*text), &*row.program});
    targets.push_back(&row);
  }
  CountReport report = count_instructions(laboratory.context, laboratory.reference, shaders);
  for (std::size_t i = 0; i < targets.size(); ++i) targets[i]->counts = std::move(report.counts[i]);
  return report.absent;
}

constexpr const char* kNotPrinted = "not in it";

nlohmann::json data_of(const Row& row) {
  nlohmann::json json = {{"id", row.subject.id},
                         {"algorithm", row.algorithm},
                         {"title", row.title},
                         {"form", row.form},
                         {"dimensions", row.subject.dimensions}};
  if (!row.error.empty()) {
    json["error"] = row.error;
    return json;
  }
  json["instructions"] = to_json(row.counts);
  for (std::size_t size = 0; size < kSizes.size(); ++size) {
    json["timing"].push_back({{"width", kSizes[size].width},
                              {"height", kSizes[size].height},
                              {"milliseconds", row.timing[size].median() * 1e3},
                              {"ratio", row.ratio[size].value},
                              {"spread", row.ratio[size].spread}});
  }
  if (const auto printed = printed_row(row.algorithm, row.subject.dimensions)) {
    json["paper"] = {{"instructions", printed->instructions}, {"milliseconds", printed->milliseconds}};
  }
  return json;
}

std::vector<std::string> cells_of(const Row& row, const std::map<std::string, std::string>& absent) {
  std::vector<std::string> cells;
  for (const std::string& source : count_sources())
    cells.push_back(row.error.empty() ? count_text(row.counts, source, absent) : "failed");
  const auto printed = printed_row(row.algorithm, row.subject.dimensions);
  const auto of_float = printed_row("float", row.subject.dimensions);
  cells.push_back(printed ? fmt::format("~{}", printed->instructions) : kNotPrinted);
  for (std::size_t size = 0; size < kSizes.size(); ++size) {
    cells.push_back(row.error.empty() ? three_digits(row.timing[size].median() * 1e3) : "failed");
    cells.push_back(printed ? fmt::format("{:.1f}", printed->milliseconds[size]) : kNotPrinted);
    cells.push_back(row.error.empty() ? text_of(row.ratio[size]) : "failed");
    cells.push_back(printed ? fmt::format("{:.2f}", printed->milliseconds[size] / of_float->milliseconds[size])
                            : kNotPrinted);
  }
  return cells;
}

// The table as numbers, for programs; words only where there is no number.
std::vector<std::string> csv_header() {
  std::vector<std::string> header = {"algorithm", "form", "dimensions"};
  for (const std::string& source : count_sources()) header.emplace_back(source);
  header.emplace_back("paper_instructions");
  for (const Size& size : kSizes) {
    for (const std::string_view what : {"ms", "ratio", "spread", "paper_ms"}) {
      header.push_back(fmt::format("{}_{}x{}", what, size.width, size.height));
    }
  }
  return header;
}

std::vector<std::string> csv_of(const Row& row, const std::map<std::string, std::string>& absent) {
  std::vector<std::string> cells = {row.algorithm, row.form, fmt::format("{}", row.subject.dimensions)};
  const bool measured = row.error.empty();
  for (const std::string& source : count_sources()) {
    cells.push_back(measured ? count_text(row.counts, source, absent) : "failed");
  }
  const auto printed = printed_row(row.algorithm, row.subject.dimensions);
  cells.push_back(printed ? fmt::format("{}", printed->instructions) : kNotPrinted);
  for (std::size_t size = 0; size < kSizes.size(); ++size) {
    for (const double number : {row.timing[size].median() * 1e3, row.ratio[size].value, row.ratio[size].spread}) {
      cells.push_back(measured ? fmt::format("{:.6g}", number) : "failed");
    }
    cells.push_back(printed ? fmt::format("{}", printed->milliseconds[size]) : kNotPrinted);
  }
  return cells;
}

// What the paper concludes from its table, beside what this run says.
nlohmann::json claims(const std::vector<Row>& rows) {
  nlohmann::json list = nlohmann::json::array();
  const auto ratios = [&](std::string_view algorithm, Form form) {
    std::string text;
    for (const int dimensions : {2, 3}) {
      for (const Row& row : rows) {
        if (row.algorithm != algorithm || row.form != title_of(form) || row.subject.dimensions != dimensions) continue;
        if (!row.error.empty()) continue;
        const double printed = printed_row(algorithm, dimensions)->milliseconds[0];
        const double of_float = printed_row("float", dimensions)->milliseconds[0];
        text += fmt::format("{}{}D {:.2f} (paper {:.2f})", text.empty() ? "" : ", ", dimensions, row.ratio[0].value,
                            printed / of_float);
      }
    }
    return text;
  };
  for (const std::string_view partial : {"partial_fnv1", "partial_jenkins"}) {
    list.push_back(
        fmt::format("“only Perlin/PartialFNV1 and Perlin/PartialJenkins are close enough to Perlin/Float”: {} as "
                    "published takes, as a multiple of Perlin/Float at 800x600, {}; ours takes {}.",
                    algorithm_named(partial).title, ratios(partial, Form::published), ratios(partial, Form::ours)));
  }
  list.push_back(fmt::format("Perlin/Integer, the slowest of all in the paper: {}.", ratios("integer", Form::table)));
  for (const int dimensions : {2, 3}) {
    std::string text;
    for (const Row& row : rows) {
      const auto count = row.counts.instructions.find(kSpirvSource);
      const bool counted = count != row.counts.instructions.end();
      if (row.form != title_of(Form::published) || row.subject.dimensions != dimensions || !counted) continue;
      text += fmt::format("{}{} {:+d}", text.empty() ? "" : ", ", row.title,
                          count->second - printed_row(row.algorithm, dimensions)->instructions);
    }
    list.push_back(
        fmt::format("Instructions of the listings in {}D, SPIR-V against the paper's column: {}.", dimensions, text));
  }
  return list;
}

Section to_section(const std::vector<Row>& rows, const std::map<std::string, std::string>& absent) {
  Section section;
  section.data = {{"absent_counts", absent}, {"rows", nlohmann::json::array()}};
  section.page = {{"cells", kQuadCells},
                  {"absent", absent_sources(absent)},
                  {"tables", nlohmann::json::array()},
                  {"errors", nlohmann::json::array()}};
  Section::Csv csv{"table.csv", csv_header(), {}};
  for (const int dimensions : {2, 3}) {
    nlohmann::json lines = nlohmann::json::array();
    for (const Row& row : rows) {
      if (row.subject.dimensions != dimensions) continue;
      section.data["rows"].push_back(data_of(row));
      lines.push_back({{"title", row.title}, {"form", row.form}, {"cells", cells_of(row, absent)}});
      csv.rows.push_back(csv_of(row, absent));
      section.complete = section.complete && row.error.empty() && row.counts.problems.empty();
      if (!row.error.empty()) section.page["errors"].push_back({{"id", row.subject.id}, {"text", row.error}});
      for (const std::string& problem : row.counts.problems) {
        section.page["errors"].push_back({{"id", row.subject.id}, {"text", problem}});
      }
    }
    section.page["tables"].push_back({{"dimensions", dimensions}, {"rows", lines}});
  }
  section.page["claims"] = claims(rows);
  section.csv.push_back(std::move(csv));
  return section;
}

}  // namespace

Result<Section> measure_table(Laboratory& laboratory) {
  HN_TRY(auto reference, laboratory.build(loop_shader(float_subject(2))));
  HN_TRY(const auto load, laboratory.stopwatch.sufficient_load(reference));
  laboratory.stopwatch.choose_clock(load);

  std::vector<Row> rows = rows_of(2);
  for (Row& row : rows_of(3)) rows.push_back(std::move(row));
  build(laboratory, rows);
  HN_DO(time(laboratory, rows));
  relate(rows);
  const auto absent = count(laboratory, rows);
  if (laboratory.dump) {
    for (const Row& row : rows) {
      HN_DO(write_spirv(laboratory.out, row.subject.id, row.counts.optimised));
    }
  }
  Section section = to_section(rows, absent);
  section.data["timing"] = to_json(laboratory.stopwatch.gate());
  section.page["clock"] = name_of(laboratory.stopwatch.gate().clock);
  section.page["gate"] = laboratory.stopwatch.gate().reason;
  return section;
}

}  // namespace hn
