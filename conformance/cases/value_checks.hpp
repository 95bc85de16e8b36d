// The checks of the cases that evaluate functions on the driver, and their common parts.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "cases/case.hpp"
#include "expected/compare.hpp"
#include "library/functions.hpp"

namespace hn {

using Words = std::vector<std::uint32_t>;

inline std::span<const std::uint32_t> point(std::span<const std::uint32_t> inputs, std::size_t i) {
  return inputs.subspan(i * kInputWords, kInputWords);
}

inline std::span<const std::uint32_t> result(std::span<const std::uint32_t> outputs, std::size_t i) {
  return outputs.subspan(i * kOutputWords, kOutputWords);
}

// A word as the float that it is, and the float input of that name.
inline double number_of(std::uint32_t word) { return static_cast<double>(std::bit_cast<float>(word)); }
inline double number_of(const Function& function, std::span<const std::uint32_t> inputs, std::string_view name) {
  return number_of(inputs[static_cast<std::size_t>(function.input(name))]);
}

// Evaluates on the driver; the outcome of a failure is ready to be returned.
tl::expected<Words, Outcome> evaluate(Session& session, const Evaluation& evaluation,
                                      std::span<const std::uint32_t> inputs);

// How many points checks of properties evaluate: fewer of costly functions.
std::size_t property_points(const Session& session, const Function& function);

Check check_golden;  // against the golden file
Check check_twin;    // against the C++ twin, at random points
// property_checks.cpp
Check check_zero;         // noise is 0 at lattice points
Check check_range;        // values keep to their range and use it
Check check_seeds;        // fields of different seeds are uncorrelated
Check check_mirror;       // no quadrant mirrors another
Check check_finite;       // and neither NaN nor infinity at extreme points
Check check_unseeded;     // unseeded_check.cpp: without a seed means with seed 0
Check check_other_noise;  // other_noise_check.cpp: sums over a constant noise
// Whether an octave sum cuts off the noise of each octave at 1 and -1, or its slopes at 128 and -128, and it shows.
bool cuts_noise_off(const Function& function, Arithmetic arithmetic);

// derivative_check.cpp, slope_sum_check.cpp, divergence_check.cpp and seams_check.cpp
Check check_derivative;  // derivatives are those of the noise
Check check_slope_sum;   // or those of the octave sum
Check check_divergence;  // what flows into a place flows out of it
Check check_seams;       // nothing jumps where other lattice points begin to count

// cellular_checks.cpp
Check check_search;      // distances, points and borders are those that a search of more cells finds
Check check_cell_names;  // the name of the nearest point, the way to it and its distance belong together
Check check_border;      // borders lie where the two nearest points put them
Check check_returned;    // what is returned beside the nearest point is what the form without it returns
// The row of the function that takes the same and sets nothing, for one that sets the nearest point; else null.
const Function* returning(const Function& function);

// compile_cases.cpp
Outcome check_compilation(Session& session, const CompilationKind& compilation);

// metamorphic_checks.cpp: the same values, computed in another way.
Judged check_pairing(Session& session, const Pairing& pairing);
// Judges the results of both ways: kOutputWords per point.
Outcome judge_pairing(const Pairing& pairing, std::span<const std::uint32_t> got,
                      std::span<const std::uint32_t> expected);

// A case of an evaluation beside its golden values.
struct Relation {
  std::string_view check;
  CaseKind kind;
  const Function* with = nullptr;  // whose program it takes besides, in the same version and stage
  int programs = 1;                // or how many programs beside its own
  std::string besides = {};        // something else that must be shown with the check, such as a noise's dimension
};
// The relations that compile another program: a variant of the shader, or another function. metamorphic_checks.cpp has
// them, and value_cases.cpp chooses.
std::vector<Relation> relations_of(const Evaluation& evaluation, const Target& target);
// The relations that need no other program: the function again at other points.
std::vector<Relation> repetitions_of(const Evaluation& evaluation);
// A stage of OpenGL against the fragment stage.
Relation as_fragment(const Evaluation& evaluation);

// The overloads without a seed, of all functions of a file in one program.
std::vector<Case> unseeded_cases();

// The positions of places of all dimensions, in one program.
std::vector<Case> position_cases();

// The name of a case about values.
CaseName name_of(const Evaluation& evaluation, std::string_view check);

}  // namespace hn
