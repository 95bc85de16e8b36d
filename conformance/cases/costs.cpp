#include "cases/costs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <ctime>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "cases/case.hpp"
#include "cases/files.hpp"
#include "output/embedded.hpp"

namespace hn {
namespace {

constexpr std::string_view kHeader = "check,function,cases,seconds";

std::string_view check_of(std::string_view id) { return id.substr(id.rfind('.') + 1); }

template <typename Number>
bool read(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (auto comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
    fields.push_back(line.substr(0, comma));
    line.remove_prefix(comma + 1);
  }
  fields.push_back(line);
  return fields;
}

double growth_of(const Costs::Change& change) { return change.now.seconds - change.was.seconds; }

}  // namespace

Costs::Key Costs::key_of(std::string_view id) { return {std::string(check_of(id)), std::string(function_of(id))}; }

void Costs::add(const Key& key, std::size_t cases, double seconds) {
  for (Cost* const cost : {&costs_[key], &of_checks_[key.first]}) {
    std::tie(cost->check, cost->function) = key;
    cost->cases += cases;
    cost->seconds += seconds;
  }
}

Result<Costs> Costs::parse(std::string_view text) {
  Costs costs;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    ++number;
    const auto wrong = [&](std::string_view wanted) {
      return fail(fmt::format("line {} of the costs is \"{}\", and should be {}", number, line, wanted));
    };
    if (number == 1) {
      if (line != kHeader) return wrong(fmt::format("\"{}\"", kHeader));
      continue;
    }
    const auto fields = fields_of(line);
    std::size_t cases = 0;
    double seconds = 0.0;
    if (fields.size() != 4 || !read(fields[2], cases) || !read(fields[3], seconds) || cases == 0) {
      return wrong("a check, a function, how many cases, and their seconds");
    }
    if (fields[0] == "calibration") {
      costs.calibration_ = seconds;
    } else {
      costs.add({std::string(fields[0]), std::string(fields[1])}, cases, seconds);
    }
  }
  if (!(costs.calibration_ > 0.0)) return fail("the costs lack a calibration");
  return costs;
}

Costs Costs::of(std::span<const CaseResult> results, double calibration) {
  Costs costs;
  costs.calibration_ = calibration;
  for (const CaseResult& result : results) costs.add(key_of(result.id), 1, result.processor_seconds);
  return costs;
}

const Costs& Costs::recorded() {
  static const Costs kRecorded = [] {
    auto costs = parse(text_of(kCasesFiles, "costs.csv"));
    if (!costs) throw std::logic_error(costs.error().text());
    return *costs;
  }();
  return kRecorded;
}

std::string Costs::text() const {
  std::string text = fmt::format("{}\ncalibration,,1,{:.6f}\n", kHeader, calibration_);
  for (const auto& [key, cost] : costs_) {
    text += fmt::format("{},{},{},{:.3f}\n", cost.check, cost.function, cost.cases, cost.seconds);
  }
  return text;
}

double Costs::seconds_of(std::string_view id) const {
  constexpr double kUnknown = 0.1;  // of a check that was never recorded: most compile a program
  const Key key = key_of(id);
  const auto mean = [](const Cost& cost) { return cost.seconds / static_cast<double>(cost.cases); };
  if (const auto found = costs_.find(key); found != costs_.end()) return mean(found->second);
  const auto found = of_checks_.find(key.first);
  return found != of_checks_.end() ? mean(found->second) : kUnknown;
}

double Costs::seconds_of(std::span<const std::string> ids) const {
  double seconds = 0.0;
  for (const std::string& id : ids) seconds += seconds_of(id);
  return seconds;
}

std::vector<Costs::Change> Costs::changes_to(std::span<const std::string> ids) const {
  Costs there_is;
  for (const std::string& id : ids) there_is.add(key_of(id), 1, seconds_of(id));
  std::map<Key, Change> changes;
  for (const auto& [key, cost] : costs_) changes[key].was = cost;
  for (const auto& [key, cost] : there_is.costs_) changes[key].now = cost;
  std::vector<Change> changed;
  for (const auto& [key, change] : changes) {
    if (change.was.cases != change.now.cases) changed.push_back(change);
  }
  std::ranges::stable_sort(changed, std::greater{}, growth_of);
  return changed;
}

double calibration_here() {
  // The fastest of a few, since others use the machine, too.
  constexpr int kTries = 5;
  constexpr std::uint32_t kSteps = 1'000'000;
  double best = 0.0;
  for (int i = 0; i < kTries; ++i) {
    const std::clock_t start = std::clock();
    volatile std::uint32_t word = 1;
    for (std::uint32_t step = 0; step < kSteps; ++step) word = (word ^ step) * 0x01000193u;
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (i == 0 || seconds < best) best = seconds;
  }
  return best;
}

double Costs::factor_here() const { return calibration_here() / calibration_; }

std::string complaint_about(const Costs& recorded, std::span<const std::string> ids, double budget) {
  const double seconds = recorded.seconds_of(ids);
  const auto changes = recorded.changes_to(ids);
  if (seconds <= budget && changes.empty()) return {};
  std::string text =
      fmt::format("the default run is predicted to take {:.1f} s of processor time, of {:.1f} s", seconds, budget);
  for (const auto& [was, now] : changes) {
    const Cost& cost = now.cases > 0 ? now : was;
    text += fmt::format("\n  {} of {}: {} cases in place of {}, {:+.2f} s", cost.check, cost.function, now.cases,
                        was.cases, now.seconds - was.seconds);
  }
  return text +
         "\nIf that is meant, `tools/conform --record-costs` measures anew; else let a program serve more checks";
}

std::vector<std::string> ids_of_default_run() {
  std::vector<std::string> ids;
  for (const Case& test : all_cases(Scope::covered)) {
    if (!test.is_covered()) continue;
    if (profile_named(test.name.profile).platform() == Platform::opengl || !test.needs_driver()) ids.push_back(test.id);
  }
  return ids;
}

}  // namespace hn
