#include "bench_cpu/record.hpp"

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/strings.hpp"
#include "base/text.hpp"

namespace hn {
namespace {

std::vector<std::string> header_of() {
  std::vector<std::string> header = {"noise", "instructions"};
  for (const char* const comparison : kComparisons) {
    header.insert(header.end(), {fmt::format("{}", comparison), fmt::format("{} spread", comparison)});
  }
  for (const char* const fill : kFills) header.push_back(fmt::format("{} million/s", fill));
  return header;
}

// Cells of what was not measured are empty.
std::vector<std::string> row_of(const Measurement& measurement) {
  std::vector<std::string> row = {measurement.subject.id, std::string(name(measurement.set))};
  for (const char* const comparison : kComparisons) {
    const auto found = measurement.ratios.find(comparison);
    const bool is_there = found != measurement.ratios.end();
    for (const auto part : {&Ratio::value, &Ratio::spread}) {
      row.push_back(!is_there               ? ""
                    : found->second.known() ? fmt::format("{:.5g}", found->second.*part)
                                            : "cannot be told");
    }
  }
  for (const char* const fill : kFills) {
    const auto found = measurement.millions_a_second.find(fill);
    row.push_back(found == measurement.millions_a_second.end() ? "" : fmt::format("{:.5g}", found->second));
  }
  return row;
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

std::string record_of(Facts facts, const std::vector<Measurement>& measurements,
                      const std::optional<PythonMeasurement>& python) {
  if (python) {
    for (const auto& [what, ratio] :
         {std::pair{"Python with out=", python->own_array}, std::pair{"Python with a new array", python->new_array}}) {
      facts.emplace_back(what, fmt::format("{:.5g} ± {:.5g}", ratio.value, ratio.spread));
    }
  }
  std::vector<std::vector<std::string>> rows;
  for (const Measurement& measurement : measurements) rows.push_back(row_of(measurement));
  return to_record(facts, header_of(), rows);
}

}  // namespace hn
