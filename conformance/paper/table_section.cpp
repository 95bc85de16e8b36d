// The paper's table: instructions and render times of every algorithm in every form.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <optional>
#include <stdexcept>

#include "paper/laboratory.hpp"

namespace hn {
namespace {

struct Size {
  int width;
  int height;
};
constexpr std::array kSizes = {Size{800, 600}, Size{1024, 768}};

// A line of the table: an algorithm in a form, or the empty shader.
struct Row {
  Subject subject;
  std::string title;
  std::string form;
  std::string_view algorithm;  // its name
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
                       std::string(title_of(entry.form)), entry.algorithm->name});
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

std::vector<std::string> header_of() {
  std::vector<std::string> header = {"id", "algorithm", "form", "dimensions"};
  for (const char* const source : kCountSources) header.emplace_back(source);
  for (const Size& size : kSizes) {
    for (const std::string_view what : {"ms", "ratio", "spread"}) {
      header.push_back(fmt::format("{}_{}x{}", what, size.width, size.height));
    }
  }
  header.emplace_back("problem");
  return header;
}

// Numbers, and words where there is none.
std::vector<std::string> cells_of(const Row& row, const std::map<std::string, std::string>& absent) {
  std::vector<std::string> cells = {row.subject.id, row.title, row.form, fmt::format("{}", row.subject.dimensions)};
  if (!row.error.empty()) {
    cells.resize(header_of().size() - 1, "failed");
    cells.push_back(row.error);
    return cells;
  }
  for (const char* const source : kCountSources) cells.push_back(count_text(row.counts, source, absent));
  for (std::size_t size = 0; size < kSizes.size(); ++size) {
    for (const double number : {row.timing[size].median() * 1e3, row.ratio[size].value, row.ratio[size].spread}) {
      cells.push_back(fmt::format("{:.6g}", number));
    }
  }
  cells.push_back(fmt::format("{}", fmt::join(row.counts.problems, "\n")));
  return cells;
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
  Section section{"table", {{"cells", fmt::format("{}", kQuadCells)}}, header_of()};
  for (const auto& [source, reason] : absent) {
    section.facts.emplace_back(fmt::format("no counts from {} here", source), reason);
  }
  for (const Row& row : rows) {
    section.rows.push_back(cells_of(row, absent));
    section.complete = section.complete && section.rows.back().back().empty();
  }
  return section;
}

}  // namespace hn
