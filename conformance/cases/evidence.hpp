// Makes evidence of a fault for developers: a shader that stands alone and shows a wrong value and nothing else, and
// pictures.
#pragma once

#include <array>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "cases/case.hpp"
#include "cases/value_checks.hpp"
#include "gpu/gpu.hpp"
#include "gpu/reference_compiler.hpp"
#include "library/shaders.hpp"
#include "library/source.hpp"

namespace hn {

// Evidence for a case that failed, if it is about values: of a known bug a shader without pictures. Nothing where
// evidence is impossible, or where making it throws.
std::optional<Evidence> make_evidence(Session& session, const Case& test, const Outcome& outcome);

// The colour that a program gives the first pixel of a target of 8 bits per channel: red, green, blue, alpha.
Result<std::array<std::uint8_t, 4>> draw_pixel(const Context& context, const Program& program);

// Decides which of the failed cases get evidence. A wrong function fails in many cases that look alike, and
// results.json must stay small enough to send even if all cases fail.
class EvidenceBudget {
 public:
  // Whether this case gets evidence. If so, it is counted.
  bool take(const CaseName& name);

 private:
  std::map<std::string, std::set<std::string>, std::less<>> by_function_;  // the cases, whatever their version
  int all_ = 0;
};

// --- The shader ---

struct ShaderFacts {
  std::string id;        // of the case
  std::string renderer;  // where it failed
  std::span<const std::uint32_t> inputs;
  std::span<const std::uint32_t> got = {};  // empty if there was no value
  std::array<std::uint32_t, kOutputWords> expected = {};
  std::array<double, kOutputWords> allowed = {};  // how far each float may be off,
  bool every_bit;                                 // unless every bit counts
};

// A fragment shader, complete, without textures or attributes: green where the function has the expected value,
// else red. The point is hidden from the compiler behind a uniform that nobody needs to set, so that it
// evaluates the function on the device. Comments describe it. With a compiler it is brief: macros are expanded,
// and what main does not call is left out.
Result<std::string> stand_alone_shader(const SourceSet& sources, const Evaluation& evaluation, const ShaderFacts& facts,
                                       const ReferenceCompiler* compiler = nullptr);

// A shader that stands alone, made green where the function has the wrong value that the suite got.
std::string expecting_got(std::string shader, const ShaderFacts& facts);

// Lines without comments, #line directives and lines left empty.
std::string without_comments(std::string_view glsl);

// --- Pictures ---

// Pixels along each side of a picture, and where along each the point itself is.
inline constexpr std::size_t kPictureSide = 96;
inline constexpr std::size_t kMiddle = kPictureSide / 2;

// The points of a picture, from top to bottom: the first two coordinates go through a window with the point in the
// middle, the other words are the point's.
Words window_around(const Function& function, std::span<const std::uint32_t> words);
// A sentence or two for people: the window, and its greys.
std::string describe_window(const Function& function, const Words& window);

// PNG files in base64, and the factor that multiplies the difference, so that the largest is white.
struct Pictures {
  std::string got;
  std::string reference;
  std::string difference;
  double factor = 0.0;
};
// Draws the first result of the function at each point of a window.
Pictures draw_pictures(const Function& function, const Words& got, const Words& reference);

}  // namespace hn
