// The text of the library over numbers that prove.
#pragma once

// Before the first header of C++, as the library's own text: functions of the text need not be inlined.
#define HN_I_CALLED
#include <hashnoise/glsl.hpp>

#include "config.glsl"
#include "integers.hpp"

namespace hn::prover {

#include "names.hpp"

#if HN_ARITHMETIC == HN_FIXED
#include "stated.hpp"
#endif

// The constructors of scalars are keywords of C++.
#define float Float
#define int Int
#if HN_ARITHMETIC != HN_FIXED
// The exact number is the sine: PROVER_SINE is how far the polynomial is off it. It drops up to 63 units of a quarter
// turn of 2^30, which is a rounding of a number that a hash makes, but not of one that is known.
static Float hn_i_polynomial_sine(Uint q);
inline Float hn_i_quarter_sine(Uint q) {
  const auto sine = [known = q.is != Word::kNumeric](Form f) {
    const double most = PROVER_SINE + (known ? 63 * 0x1p-30 * 1.5708 : 0);
    const Interval off{-most, most}, range = hull(f.range, {0, 1});
    f.mid = f.mid + off, f.place = Form::kSeveral;
#ifdef PROVER_EXACT_SINES  // as computed, which is within that of the polynomial, too
    f = with_error(std::move(f), {});
    f.range = f.range + off;
#else
    add_error(f, off);
#endif
    f.range = meet(f.range, range);
    return f;
  };
  return made(each(hn_i_polynomial_sine(q), sine), 'W', q.number());
}
#endif
#if HN_ARITHMETIC != HN_FIXED
#define hn_i_wave hn_i_known_wave
#include "detail/sine.glsl"
#undef hn_i_wave
// How far the sine of any angle is off.
inline double error_of_sines() {
  static const double most = [] {
    const auto words = last_word;
    const auto before = divisions;
    for (;;) {
      try {
        const double found = Float::at(joined_node(hn_i_known_wave(Uint(Word::any()), 0u).n)).form().error().size();
        last_word = words, divisions = before;
        return found;
      } catch (const Again&) {
        last_word = words;
      }
    }
  }();
  return most;
}
// The sine of an angle that rounds: the angle moves it by no more than that.
inline Float hn_i_wave(Uint angle, Uint sign) {
  if (angle.off == 0) return hn_i_known_wave(angle, sign);
  if (angle.modulo < 32 || sign.is != Word::kNumber || sign.value != 0) refuse("a part of an angle that rounds");
  constexpr double kUnit = 0x1p-32 * 6.283186;
  const double error = error_of_sines() + std::exchange(angle.off, 0) * kUnit;
  Form f = constant(0);
  f.range = {-1, 1}, f.grid = kNoGrid, f.bits = 24;
  if (angle.is == Word::kNumber) {
    f.mid = hn_i_known_wave(angle, sign).form().mid + Interval{-kUnit, kUnit} * point(Word::kAngleCut);
  } else {
    choose(f, 1);
  }
  add_error(f, {-error, error});
  const auto n = node(0, {f});
  nodes[n].made = 'w', nodes[n].step = angle.step;
  return Float::at(n);
}
#endif
#ifdef PROVER_ANY_DIRECTION
// A direction may be any, with each component in [-1, 1]: it is exact, and a word of its own makes it.
#define HN_SPHERE_GLSL
inline Int any_component(Uint h) { return Int(h >> 15u) - 65536; }
inline hn_ivec2 hn_i_on_circle(Uint h) { return ivec2(any_component(h), any_component(h * 0x9E3779B1u)); }
inline hn_ivec3 hn_i_on_sphere(Uint h, Uint height) {
  return ivec3(any_component(h), any_component(h * 0x9E3779B1u), any_component(height));
}
#endif
#include "hashnoise.glsl"
#undef float
#undef int

}  // namespace hn::prover

#ifdef PROVER_OWN
// A text of one's own.
#include "builtins.hpp"
namespace hn::prover::own {
const Proving rounding_up;  // while constants are made
#define float Float
#define int Int
#define bool Truth
#include "own.inc"
#undef float
#undef int
#undef bool
}  // namespace hn::prover::own
#endif
