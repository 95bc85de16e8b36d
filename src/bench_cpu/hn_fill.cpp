// hn-fill: fills a grid a number of times, and prints nothing, so that its instructions can be counted. tools/measure
// neon compiles it for another processor, which has only header-only packages.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <exception>
#include <optional>

#include "bench_cpu/fast_noise.hpp"
#include "bench_cpu/subjects.hpp"

namespace {

constexpr int kFailed = 1;
constexpr int kBadUsage = 2;
constexpr std::string_view kFastNoise = "fastnoise2=";
constexpr std::string_view kUsage =
    "usage: hn-fill --list                       how many points a grid has, their step, and the id of each subject\n"
    "       hn-fill fast|fixed|precise ID TIMES  fill a grid so often, 1 to 1000 times\n"
    "       hn-fill fastnoise2=FILE ID TIMES     by the shared library of FastNoise2\n";

int complain(int status, std::string_view message) {
  fmt::print(stderr, "hn-fill: {}\n", message);
  return status;
}

std::optional<int> times_of(std::string_view word) {
  int times = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), times);
  if (error != std::errc() || end != word.data() + word.size() || times < 1 || times > 1000) return std::nullopt;
  return times;
}

std::optional<hashnoise::Arithmetic> arithmetic_named(std::string_view name) {
  using hashnoise::Arithmetic;
  if (name == "fast") return Arithmetic::kFast;
  if (name == "fixed") return Arithmetic::kFixed;
  if (name == "precise") return Arithmetic::kPrecise;
  return std::nullopt;
}

template <int D>
void fill(const hn::Subject& subject, hashnoise::Arithmetic arithmetic, int times) {
  const hashnoise::Field<D> field(hn::settings_of(subject, arithmetic, hashnoise::instruction_sets().front()));
  std::vector<float> values(static_cast<std::size_t>(field.component_count()) * hn::kPoints);
  for (int i = 0; i < times; ++i) field.fill(hn::grid<D>(), values);
}

int fill_by_fast_noise(std::string_view path, const hn::Subject& subject, int times) {
  const auto library = hn::FastNoise::open(path);
  if (!library) return complain(kBadUsage, library.error().text());
  const hashnoise::InstructionSet set = hashnoise::instruction_sets().front();
  const auto field = library->field(subject, set);
  if (!field) return complain(kFailed, field.error().text());
  if (!*field) return complain(kFailed, fmt::format("this FastNoise2 has no {} in it", name(set)));
  std::vector<float> values(hn::kPoints);
  for (int i = 0; i < times; ++i) (*field)->fill_grid(subject.dimensions, values);
  return 0;
}

int run(std::span<const std::string_view> words) {
  const std::vector<hn::Subject> subjects = hn::subjects();
  if (words.size() == 1 && words.front() == "--list") {
    fmt::print("{} {}\n", hn::kPoints, hn::kStep);
    for (const hn::Subject& subject : subjects) fmt::print("{}\n", subject.id);
    return 0;
  }
  if (words.size() == 3) {
    const auto subject = std::ranges::find(subjects, words[1], &hn::Subject::id);
    const auto times = times_of(words[2]);
    if (subject != subjects.end() && times) {
      if (words[0].starts_with(kFastNoise)) {
        return fill_by_fast_noise(words[0].substr(kFastNoise.size()), *subject, *times);
      }
      if (const auto arithmetic = arithmetic_named(words[0])) {
        (subject->dimensions == 2 ? fill<2> : fill<3>)(*subject, *arithmetic, *times);
        return 0;
      }
    }
  }
  fmt::print(stderr, "{}", kUsage);
  return kBadUsage;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(std::vector<std::string_view>(argv + 1, argv + argc));
  } catch (const std::exception& exception) {
    return complain(kFailed, exception.what());
  }
}
