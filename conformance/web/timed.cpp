#include "web/timed.hpp"

#include <fmt/format.h>

#include "library/configurations.hpp"
#include "library/functions.hpp"
#include "library/timed.hpp"

namespace hn {
namespace {

// The positions of a pixel are apart, so that no evaluation can be left out.
constexpr std::string_view kTimedMain = R"(
uniform highp int rounds;
out highp uvec4 result;
highp float timed(highp float value) {{ return value; }}
highp float timed(highp vec2 value) {{ return value.x + value.y; }}
void main() {{
  highp float sum = 0.0;
  for (highp int i = 0; i < rounds; ++i) {{
    highp vec2 p = gl_FragCoord.xy * 0.0625 + vec2(float(i) * 0.375, float(i) * 0.21875);
    sum += timed({});
  }}
  result = uvec4(floatBitsToUint(sum));
}}
)";

}  // namespace

std::vector<TimedShader> timed_shaders() {
  std::vector<TimedShader> shaders = {{"empty", fmt::format(kTimedMain, "p")}};
  for (const std::string_view id : kTimed) {
    const Function& function = find_function(id);
    for (const std::string_view name : {"lattice", "lattice+fixed"}) {
      const Configuration& configuration = configuration_named(name);
      shaders.push_back({fmt::format("{}.{}", id, name_of(configuration.arithmetic)),
                         fmt::format("{}#include \"{}\"\n{}", knobs_of(configuration), function.file,
                                     fmt::format(kTimedMain, function.call))});
    }
  }
  return shaders;
}

}  // namespace hn
