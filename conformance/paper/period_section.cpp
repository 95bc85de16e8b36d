// After how many cells each noise repeats: shown by equal bits, and by the absence of any shorter repeat.
#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "expected/points.hpp"
#include "paper/laboratory.hpp"
#include "paper/period.hpp"

namespace hn {
namespace {

constexpr std::uint32_t kTablePeriod = 256;
constexpr std::size_t kPoints = std::size_t{1} << 16;

// A noise whose period is known beforehand.
struct Claim {
  std::string title;
  std::string form;
  Subject subject;
  std::uint32_t period;
};

void add_claim(std::vector<Claim>& claims, const Entry& entry, std::uint32_t period) {
  const bool chosen = entry.form == AlgorithmForm::ours;  // the others have their periods built in
  for (const int dimensions : {2, 3}) {
    claims.push_back({std::string(entry.algorithm->title),
                      fmt::format("{}{}", title_of(entry.form), chosen ? fmt::format(", period {}", period) : ""),
                      subject_of(entry, dimensions, Picture::noise, chosen ? period : 0), period});
  }
}

std::vector<Claim> all_claims() {
  std::vector<Claim> claims;
  for (const Entry& entry : all_entries()) {
    add_claim(claims, entry, entry.form == AlgorithmForm::table ? kTablePeriod : kPaperPeriod);
  }
  const Entry ours{&algorithm_named("lattice"), AlgorithmForm::ours};
  add_claim(claims, ours, 48);
  add_claim(claims, ours, 999983);  // a prime: nothing divides it
  return claims;
}

float& axis_of(Position& position, int axis) { return axis == 0 ? position.x : axis == 1 ? position.y : position.z; }

// Multiples of 1/8, so that the positions a period on are floats, too.
std::vector<Position> scattered(int dimensions, std::uint32_t period) {
  Random random(0, "period");
  std::vector<Position> points(kPoints);
  for (Position& point : points) {
    for (int axis = 0; axis < dimensions; ++axis) {
      axis_of(point, axis) = static_cast<float>(random.below(8 * period)) / 8.0f - static_cast<float>(period / 2);
    }
  }
  return points;
}

// How many values differ in a bit from those a period on along an axis.
Result<std::size_t> differences(Laboratory& laboratory, const Program& program, const Claim& claim, int axis) {
  std::vector<Position> points = scattered(claim.subject.dimensions, claim.period);
  HN_TRY(const auto here, laboratory.values(program, points));
  for (Position& point : points) axis_of(point, axis) += static_cast<float>(claim.period);
  HN_TRY(const auto there, laboratory.values(program, points));
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::bit_cast<std::uint32_t>(here[i]) != std::bit_cast<std::uint32_t>(there[i])) ++count;
  }
  return count;
}

// The shortest repeat of the values in all cells of a period along an axis, on a line that misses the lattice.
Result<std::size_t> shortest(Laboratory& laboratory, const Program& program, const Claim& claim, int axis) {
  std::vector<Position> points(claim.period);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {5.375f, 7.625f, 3.125f};
    axis_of(points[i], axis) = static_cast<float>(i) + 0.375f;
  }
  HN_TRY(const auto values, laboratory.values(program, points));
  std::vector<std::uint32_t> bits(values.size());
  std::transform(values.begin(), values.end(), bits.begin(), [](float v) { return std::bit_cast<std::uint32_t>(v); });
  return shortest_cyclic_repeat(bits);
}

struct Finding {
  std::size_t differing[3] = {};
  std::size_t repeat[3] = {};
  std::string error;
};

Finding examine(Laboratory& laboratory, const Claim& claim) {
  Finding finding;
  const auto program = laboratory.build(value_shader(claim.subject));
  if (!program) {
    finding.error = program.error().text();
    return finding;
  }
  for (int axis = 0; axis < claim.subject.dimensions; ++axis) {
    const auto differing = differences(laboratory, *program, claim, axis);
    const auto repeat = differing ? shortest(laboratory, *program, claim, axis) : differing;
    if (!repeat) {
      finding.error = repeat.error().text();
      return finding;
    }
    finding.differing[axis] = *differing;
    finding.repeat[axis] = *repeat;
  }
  return finding;
}

}  // namespace

Result<Section> measure_periods(Laboratory& laboratory) {
  Section section{"period",
                  {{"points", fmt::format("{}", kPoints)}},
                  {"algorithm", "form", "dimensions", "period", "differing_values", "shortest_repeat_x",
                   "shortest_repeat_y", "shortest_repeat_z", "verdict", "problem"}};
  for (const Claim& claim : all_claims()) {
    const Finding finding = examine(laboratory, claim);
    section.complete = section.complete && finding.error.empty();
    const auto dimensions = static_cast<std::size_t>(claim.subject.dimensions);
    std::size_t differing = 0;
    bool shorter = false;
    for (std::size_t axis = 0; axis < dimensions; ++axis) {
      differing += finding.differing[axis];
      shorter = shorter || finding.repeat[axis] < claim.period;
    }
    const std::string verdict = !finding.error.empty() ? "failed"
                                : differing > 0        ? "does not repeat"
                                : shorter              ? "repeats sooner along a line"
                                                       : "as stated";
    std::vector<std::string> row = {claim.title, claim.form, fmt::format("{}", dimensions),
                                    fmt::format("{}", claim.period), fmt::format("{}", differing)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      row.push_back(axis < dimensions ? fmt::format("{}", finding.repeat[axis]) : "no axis");
    }
    row.insert(row.end(), {verdict, finding.error});
    section.rows.push_back(std::move(row));
  }
  return section;
}

}  // namespace hn
