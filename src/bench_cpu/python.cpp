#include "bench_cpu/python.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <sstream>

#include "base/process.hpp"
#include "base/text.hpp"
#include "bench_cpu/measure.hpp"

namespace hn {
namespace {

// Prints the seconds of a call, the medians of some, without an array of its own and with one.
constexpr std::string_view kProgram = R"(
import statistics, time
import numpy
import hashnoise
i = numpy.arange({points})
x = ((i % 1024) * numpy.float32({step})).astype(numpy.float32)
y = ((i // 1024) * numpy.float32({step})).astype(numpy.float32)
out = numpy.empty({points}, numpy.float32)
def median(call):
    seconds = []
    for _ in range(15):
        start = time.perf_counter()
        call()
        seconds.append(time.perf_counter() - start)
    return statistics.median(seconds[4:])
print(median(lambda: hashnoise.perlin(x, y, seed=7, threads=1)),
      median(lambda: hashnoise.perlin(x, y, seed=7, threads=1, out=out)))
)";

}  // namespace

Result<PythonMeasurement> measure_python(const std::string& python, int rounds) {
  const std::string program = fmt::format(kProgram, fmt::arg("points", kPoints), fmt::arg("step", kStep));
  const hashnoise::Field<2> field(
      settings_of(subjects()[2], hashnoise::Arithmetic::kFast, hashnoise::instruction_sets().front()));
  const auto positions = positions_of_grid(2);
  hashnoise::Points<2> points;
  for (std::size_t axis = 0; axis < 2; ++axis) points.p[axis] = positions[axis];
  std::vector<float> values(kPoints);
  const std::array<std::function<void()>, 1> ours = {[&] { field.fill(points, values); }};
  Timing cpp, new_array, own_array;
  for (int round = 0; round < rounds; ++round) {
    cpp.samples.push_back(measure(ours, 5).front().median());
    const auto printed = output_of(python, {"-c", program});
    if (!printed) return fail(fmt::format("--python: {}", printed.error().text()));
    std::istringstream words(*printed);
    double by_itself = 0.0, given = 0.0;
    if (!(words >> by_itself >> given)) {
      return fail(fmt::format("--python: {} printed {} and not two times", python, in_quotes(*printed)));
    }
    new_array.samples.push_back(by_itself);
    own_array.samples.push_back(given);
  }
  return PythonMeasurement{speed(new_array, cpp), speed(own_array, cpp)};
}

}  // namespace hn
