// The paper's table: instructions and render times of every algorithm in every form.
#include <fmt/format.h>

#include <array>
#include <optional>
#include <stdexcept>

#include "bench/counts.hpp"
#include "gpu/spirv.hpp"
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
  std::vector<std::uint32_t> spirv = {};
  std::string problem = {};  // why there is none
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

void count(Laboratory& laboratory, std::vector<Row>& rows) {
  for (Row& row : rows) {
    if (!row.program) continue;
    auto words = optimised_spirv(laboratory.sources, laboratory.reference, row.subject);
    if (words) {
      row.spirv = std::move(*words);
    } else {
      row.problem = fmt::format("SPIR-V: {}", words.error().text());
    }
  }
}

std::vector<std::string> header_of() {
  std::vector<std::string> header = {"id", "algorithm", "form", "dimensions", "spirv"};
  for (const Size& size : kSizes) {
    for (const std::string_view what : {"ms", "ratio", "spread"}) {
      header.push_back(fmt::format("{}_{}x{}", what, size.width, size.height));
    }
  }
  header.emplace_back("problem");
  return header;
}

// Numbers, and words where there is none.
std::vector<std::string> cells_of(const Row& row) {
  std::vector<std::string> cells = {row.subject.id, row.title, row.form, fmt::format("{}", row.subject.dimensions)};
  if (!row.error.empty()) {
    cells.resize(header_of().size() - 1, "failed");
    cells.push_back(row.error);
    return cells;
  }
  cells.push_back(row.problem.empty() ? fmt::format("{}", count_spirv(row.spirv)) : "failed");
  for (std::size_t size = 0; size < kSizes.size(); ++size) {
    for (const double number : {row.timing[size].median() * 1e3, row.ratio[size].value, row.ratio[size].spread}) {
      cells.push_back(fmt::format("{:.6g}", number));
    }
  }
  cells.push_back(row.problem);
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
  count(laboratory, rows);
  if (laboratory.dump) {
    for (const Row& row : rows) {
      HN_DO(write_spirv(laboratory.out, row.subject.id, row.spirv));
    }
  }
  Section section{"table", {{"cells", fmt::format("{}", kQuadCells)}}, header_of()};
  for (const Row& row : rows) {
    section.rows.push_back(cells_of(row));
    section.complete = section.complete && section.rows.back().back().empty();
  }
  return section;
}

}  // namespace hn
