// The bounds of octave sums (sums.cpp, gullies.cpp) as a library, for tools/make bounds.
//
//   answer          of a row, its arguments, and the noise that it sums: the errors of its four outputs. An argument is
//                   three numbers: its kind (0 any word, 1 a word, 2 a float, 3 an int), and the ends of its range.
//                   The noise is its axes, and error, slope and limit of the value and of a derivative; none if
//                   SUMS_OWN has own_noises
//   answer_gullies  of the arguments in their order (gullies.hpp; a footprint of -1 is none), and of GULLIES_BOUNDS:
//                   the errors of the height and of a slope
//
// answer returns a sentence where there is no proof.
#include "sums/gullies.cpp"
#include "sums/sums.cpp"

namespace hn::sums {
namespace {

Uint argument_of(const double* n) {
  if (n[0] == 0.0) return Uint::unknown();
  if (n[0] == 1.0) return Uint(static_cast<std::uint32_t>(static_cast<std::int64_t>(n[1])));
  Uint word{n[1] == n[2] ? known(n[1]) : between(n[1], n[2], 0)};
  word.is_float = n[0] == 2.0;
  if (!word.is_float) word.grid = 0;
  return word;
}

}  // namespace
}  // namespace hn::sums

extern "C" const char* answer(const char* row, const double* arguments, [[maybe_unused]] const double* n,
                              double* errors) {
  using namespace hn::sums;
  static std::string problem;
#ifdef SUMS_OWN
  const Noises of = own_noises();
#else
  const auto axes = static_cast<std::size_t>(n[0]);
  Noises of;
  of.perlin[axes] = of.perlin_d[axes] = of.value_vector[axes] = of.cellular_d[axes] = of.curl[axes] =
      of.curl_phase[axes] = Noise(static_cast<int>(axes), {n[1], n[2], n[3]}, {n[4], n[5], n[6]});
#endif
  std::array<Uint, 16> words;
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = argument_of(arguments + 3 * i);
  try {
    std::ranges::copy(errors_of(kBodies.at(row), words, of), errors);
    return "";
  } catch (const std::logic_error& error) {
    problem = error.what();
    return problem.c_str();
  }
}

extern "C" void answer_gullies(const double* n, double* errors) {
  const double* const b = n + 7;
  const std::optional<double> footprint = n[4] >= 0.0 ? std::optional(n[4]) : std::nullopt;
  const hn::GulliesTolerance tolerance = hn::gullies_tolerance({n[0], n[1], n[2], n[3] != 0.0, footprint, n[5], n[6]},
                                                               {b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7], b[8]});
  errors[0] = tolerance.height, errors[1] = tolerance.slope;
}
