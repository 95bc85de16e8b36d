// Golden files, of the function and the configuration that they name, if there are such.
#include "expected/golden.hpp"

#include <fmt/format.h>

#include "fuzz.hpp"
#include "library/functions.hpp"

namespace hn::fuzz {
namespace {

constexpr std::string_view kPath = "file.golden";

// "file.golden:12: something"
bool has_place(std::string_view message) {
  const std::string start = fmt::format("{}:", kPath);
  if (!message.starts_with(start)) return false;
  const auto after = message.find_first_not_of("0123456789", start.size());
  return after > start.size() && after != std::string_view::npos && message.substr(after).starts_with(": ") &&
         message.size() > after + 2;
}

std::string list(const std::vector<std::uint32_t>& numbers) { return fmt::format("{}", fmt::join(numbers, ",")); }

std::string hex(std::uint64_t word, WordType type) {
  return type == WordType::f64 ? fmt::format("{:016x}", word) : fmt::format("{:08x}", word);
}

// As tools/golden writes it.
std::string text_of(const Golden& golden, const Function& function, const Configuration& configuration) {
  std::string text =
      fmt::format("hashnoise golden 1\nfunction {}\nhash {}\narithmetic {}\nbits 0\ncolumns {}\nrows {}\n", function.id,
                  golden_configuration(function, configuration), golden_arithmetic(function, configuration),
                  function.columns, golden.rows.size());
  for (const GoldenRow& row : golden.rows) {
    for (std::size_t i = 0; i < row.inputs.size(); ++i) text += hex(row.inputs[i], function.inputs[i].type) + " ";
    text += "=";
    for (std::size_t i = 0; i < row.values.size(); ++i) text += " " + hex(row.values[i], function.outputs[i].type);
    text += "\n";
  }
  if (const auto& digest = golden.digest) {
    text += fmt::format("digest origin={} size={} seed={} fnv1a64={:016x}\n", list(digest->origin), list(digest->size),
                        digest->seed, digest->fnv1a64);
  }
  return text;
}

void check(const Golden& golden, const Function& function, const Configuration& configuration) {
  for (const GoldenRow& row : golden.rows) {
    require(row.inputs.size() == function.inputs.size() && row.values.size() == function.outputs.size(),
            "a row has a word per column");
  }
  if (golden.digest) {
    constexpr std::size_t kMostPoints = 1u << 20;  // what a driver is asked in one draw
    const std::size_t points = golden.digest->points();
    require(points >= 1 && points <= kMostPoints, "a digest has at least one point and at most so many");
    // Large ones are slow, and no different.
    if (points <= 4096) {
      require(golden.digest->inputs().size() == points * kInputWords, "a digest gives the inputs of its points");
    }
  }
  const std::string text = text_of(golden, function, configuration);
  const auto again = parse_golden(text, kPath, function, configuration);
  require(again.has_value(), "what was read can be written and read again", text);
  require(text_of(*again, function, configuration) == text, "it is the same then", text);
}

}  // namespace
}  // namespace hn::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hn;
  const std::string_view text = fuzz::text_of(data, size);
  const Function* function = &all_functions().back();
  for (const Function& other : all_functions()) {
    if (text.find(fmt::format("\nfunction {}\n", other.id)) != text.npos) function = &other;
  }
  const Configuration* configuration = &default_configuration();
  for (const Configuration& other : all_configurations()) {
    if (text.find(fmt::format("\nhash {}\n", other.name)) != text.npos) configuration = &other;
  }
  const auto golden = parse_golden(text, fuzz::kPath, *function, *configuration);
  if (golden) {
    fuzz::check(*golden, *function, *configuration);
  } else {
    fuzz::require(fuzz::has_place(golden.error().message), "an error names the line", golden.error().message);
  }
  return 0;
}
