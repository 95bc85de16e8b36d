// The shaders that the page times: a function at many positions for each pixel.
#pragma once

#include <string>
#include <vector>

namespace hn {

struct TimedShader {
  std::string name;  // "noise2d.perlin.fixed"; "empty" is what all have besides
  std::string text;  // of a fragment shader in GLSL ES 3.00, before its includes are expanded
};

std::vector<TimedShader> timed_shaders();

}  // namespace hn
