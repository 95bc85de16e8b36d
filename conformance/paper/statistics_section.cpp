// Measures what the paper's section on statistical properties claims.
#include <fmt/format.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <numbers>

#include "base/file.hpp"
#include "base/number.hpp"
#include "output/svg.hpp"
#include "paper/laboratory.hpp"
#include "paper/statistics.hpp"

namespace hn {
namespace {

// 2^20 positions, each more than two cells from the next, so that no two are in neighbouring cells. The steps have odd
// numerators over the number of positions along an axis, so that every place in a cell is visited equally often.
constexpr int kSide2 = 1024;
constexpr std::array kSide3 = {128, 128, 64};
constexpr float kStep2 = 2.0f + 341.0f / 1024.0f;
constexpr std::array kStep3 = {2.0f + 41.0f / 128.0f, 2.0f + 41.0f / 128.0f, 2.0f + 41.0f / 64.0f};
// Half of the finest step between two places in a cell; keeps off the lattice, where the noise is 0.
constexpr std::array kOffset3 = {1.0f / 256.0f, 1.0f / 256.0f, 1.0f / 128.0f};
constexpr float kOffset2 = 1.0f / 2048.0f;
constexpr std::string_view kGrid2 = "value[j * 1024 + i] at (i * s + o, j * s + o), s = 2 + 341/1024, o = 1/2048";
constexpr std::string_view kGrid3 =
    "value[(k * 128 + j) * 128 + i] at (i * s + o, j * s + o, k * t + 2 o), s = 2 + 41/128, t = 2 + 41/64, o = 1/256";

// The sine gradient in space may go up to 3/2.
constexpr double kLow = -1.5;
constexpr double kHigh = 1.5;
constexpr std::size_t kBins = 96;  // of 1/32

std::vector<Position> positions(int dimensions) {
  std::vector<Position> points;
  points.reserve(std::size_t{1} << 20);
  if (dimensions == 2) {
    for (int j = 0; j < kSide2; ++j) {
      for (int i = 0; i < kSide2; ++i) {
        points.push_back({static_cast<float>(i) * kStep2 + kOffset2, static_cast<float>(j) * kStep2 + kOffset2, 0.0f});
      }
    }
    return points;
  }
  for (int k = 0; k < kSide3[2]; ++k) {
    for (int j = 0; j < kSide3[1]; ++j) {
      for (int i = 0; i < kSide3[0]; ++i) {
        points.push_back({static_cast<float>(i) * kStep3[0] + kOffset3[0],
                          static_cast<float>(j) * kStep3[1] + kOffset3[1],
                          static_cast<float>(k) * kStep3[2] + kOffset3[2]});
      }
    }
  }
  return points;
}

struct Sample {
  Entry entry;
  int dimensions;
  std::string error;
  Moments moments;
  NormalityTest normality;
  double zeros = 0.0;  // the share of values that are exactly 0
  std::vector<std::uint64_t> histogram;

  std::string id() const { return fmt::format("{}.{}d", entry.id(), dimensions); }
  std::string title() const {
    return fmt::format("{}, {}, {}D", entry.algorithm->title, title_of(entry.form), dimensions);
  }
};

Sample measure(Laboratory& laboratory, const Entry& entry, int dimensions, std::span<const Position> points) {
  Sample sample{entry, dimensions, {}, {}, {}, 0.0, {}};
  const auto values = laboratory.values(subject_of(entry, dimensions), points);
  if (!values) {
    sample.error = values.error().text();
    return sample;
  }
  if (laboratory.dump) {
    const auto written =
        write_file(laboratory.out / "grids" / fmt::format("{}.f32", sample.id()), bytes_of(std::span(*values)));
    if (!written) sample.error = written.error().text();
  }
  sample.zeros =
      static_cast<double>(std::count(values->begin(), values->end(), 0.0f)) / static_cast<double>(values->size());
  sample.histogram = histogram(*values, kLow, kHigh, kBins);
  const auto found = moments(*values);
  if (!found) {
    sample.error = found.error().text();
    return sample;
  }
  sample.moments = *found;
  const auto tested = normality_test(*found);
  if (tested) {
    sample.normality = *tested;
  } else {
    sample.error = tested.error().text();
  }
  return sample;
}

// Two histograms of as many values: chi-square of the hypothesis that both are of the same distribution.
struct HistogramComparison {
  double statistic = 0.0;
  int degrees = 0;
  double p_value = 1.0;
};

HistogramComparison compare_histograms(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b) {
  // Sparse bins, of fewer than this in both together, are left out: chi-square is an approximation for many.
  constexpr std::uint64_t kFewest = 20;
  HistogramComparison result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] + b[i] < kFewest) continue;
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    result.statistic += difference * difference / static_cast<double>(a[i] + b[i]);
    ++result.degrees;
  }
  --result.degrees;
  if (result.degrees < 1) return result;
  const boost::math::chi_squared distribution(result.degrees);
  result.p_value = boost::math::cdf(boost::math::complement(distribution, result.statistic));
  return result;
}

std::string plot(const Sample& sample) {
  std::vector<double> density;
  const double width = (kHigh - kLow) / static_cast<double>(kBins);
  for (const std::uint64_t count : sample.histogram) {
    density.push_back(static_cast<double>(count) / static_cast<double>(sample.moments.count) / width);
  }
  const double mean = sample.moments.mean;
  const double deviation = std::sqrt(sample.moments.variance);
  const auto normal = [=](double x) {
    const double z = (x - mean) / deviation;
    return std::exp(-0.5 * z * z) / (deviation * std::sqrt(2.0 * std::numbers::pi));
  };
  return histogram_plot({sample.title(), "value", "density"}, kLow, kHigh, density, normal);
}

nlohmann::json data_of(const Sample& sample) {
  nlohmann::json json = {
      {"id", sample.id()}, {"dimensions", sample.dimensions}, {"histogram", sample.histogram}, {"zeros", sample.zeros}};
  if (!sample.error.empty()) json["error"] = sample.error;
  if (sample.moments.count == 0) return json;
  json.update({{"count", sample.moments.count},
               {"minimum", sample.moments.minimum},
               {"maximum", sample.moments.maximum},
               {"mean", sample.moments.mean},
               {"variance", sample.moments.variance},
               {"skewness", sample.moments.skewness},
               {"excess_kurtosis", sample.moments.excess_kurtosis},
               {"normality",
                {{"test", "D'Agostino-Pearson K^2"},
                 {"statistic", sample.normality.statistic},
                 {"p_value", sample.normality.p_value},
                 {"log10_p", sample.normality.log10_p}}}});
  return json;
}

std::string probability(const NormalityTest& test) {
  return test.log10_p < -6.0 ? fmt::format("1e{:.0f}", test.log10_p) : fmt::format("{:.2g}", test.p_value);
}

std::vector<std::string> cells_of(const Sample& sample) {
  if (!sample.error.empty()) return {"failed", "failed", "failed", "failed", "failed", "failed", "failed", "failed"};
  const Moments& m = sample.moments;
  const bool inside = m.minimum >= -1.0 && m.maximum <= 1.0;
  return {fmt::format("{:.4f} to {:.4f}", m.minimum, m.maximum),
          inside ? "yes" : "no",
          fmt::format("{:.1e}", m.mean),
          fmt::format("{:.4f}", m.variance),
          decimals(m.skewness, 3),
          decimals(m.excess_kurtosis, 3),
          probability(sample.normality),
          fmt::format("{:.1f} %", sample.zeros * 100.0)};
}

// The same as numbers, for programs.
std::vector<std::string> csv_of(const Sample& sample) {
  std::vector<std::string> cells = {std::string(sample.entry.algorithm->name), std::string(title_of(sample.entry.form)),
                                    fmt::format("{}", sample.dimensions)};
  const Moments& m = sample.moments;
  for (const double number : {m.minimum, m.maximum, m.mean, m.variance, m.skewness, m.excess_kurtosis,
                              sample.normality.statistic, sample.normality.log10_p, sample.zeros}) {
    cells.push_back(sample.error.empty() ? fmt::format("{:.9g}", number) : "failed");
  }
  return cells;
}

const Sample* find(const std::vector<Sample>& samples, std::string_view algorithm, Form form, int dimensions) {
  for (const Sample& sample : samples) {
    if (sample.entry.algorithm->name == algorithm && sample.entry.form == form && sample.dimensions == dimensions)
      return &sample;
  }
  return nullptr;
}

// The paper: "Partial hashes produce the same gaussian distribution".
void add_partials(const std::vector<Sample>& samples, Section& section) {
  section.data["partial_against_full"] = nlohmann::json::array();
  section.page["partials"] = nlohmann::json::array();
  for (const std::string_view hash : {"fnv1", "jenkins"}) {
    for (const Form form : {Form::published, Form::intended, Form::ours}) {
      for (const int dimensions : {2, 3}) {
        const Sample* const full = find(samples, hash, form, dimensions);
        const Sample* const partial = find(samples, fmt::format("partial_{}", hash), form, dimensions);
        if (!full || !partial || !full->error.empty() || !partial->error.empty()) continue;
        const HistogramComparison result = compare_histograms(full->histogram, partial->histogram);
        section.data["partial_against_full"].push_back({{"full", full->id()},
                                                        {"partial", partial->id()},
                                                        {"chi_square", result.statistic},
                                                        {"degrees", result.degrees},
                                                        {"p_value", result.p_value}});
        section.page["partials"].push_back(
            {{"full", full->title()},
             {"partial", partial->title()},
             {"deviations", fmt::format("{:.4f} and {:.4f}", std::sqrt(full->moments.variance),
                                        std::sqrt(partial->moments.variance))},
             {"chi_square", fmt::format("{:.0f}", result.statistic)},
             {"degrees", result.degrees},
             {"p_value", result.p_value > 0.0 ? fmt::format("{:.2g}", result.p_value) : "below 1e-300"}});
      }
    }
  }
}

}  // namespace

Result<Section> measure_statistics(Laboratory& laboratory) {
  std::vector<Sample> samples;
  for (const int dimensions : {2, 3}) {
    const auto points = positions(dimensions);
    for (const Entry& entry : all_entries()) samples.push_back(measure(laboratory, entry, dimensions, points));
  }
  Section section;
  section.data = {{"grid_2d", kGrid2},
                  {"grid_3d", kGrid3},
                  {"histogram_low", kLow},
                  {"histogram_high", kHigh},
                  {"samples", nlohmann::json::array()}};
  section.page = {{"count", std::size_t{1} << 20},
                  {"grid_2d", kGrid2},
                  {"grid_3d", kGrid3},
                  {"rows", nlohmann::json::array()},
                  {"plots", nlohmann::json::array()},
                  {"errors", nlohmann::json::array()}};
  Section::Csv csv{"statistics.csv",
                   {"algorithm", "form", "dimensions", "minimum", "maximum", "mean", "variance", "skewness",
                    "excess_kurtosis", "normality_statistic", "normality_log10_p", "zeros"},
                   {}};
  for (const Sample& sample : samples) {
    section.data["samples"].push_back(data_of(sample));
    section.page["rows"].push_back({{"title", sample.entry.algorithm->title},
                                    {"form", title_of(sample.entry.form)},
                                    {"dimensions", sample.dimensions},
                                    {"cells", cells_of(sample)}});
    csv.rows.push_back(csv_of(sample));
    section.complete = section.complete && sample.error.empty();
    if (!sample.error.empty()) section.page["errors"].push_back({{"id", sample.id()}, {"text", sample.error}});
    if (sample.moments.count > 0) section.page["plots"].push_back(plot(sample));
  }
  add_partials(samples, section);
  section.csv.push_back(std::move(csv));
  return section;
}

}  // namespace hn
