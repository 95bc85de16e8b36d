// The text of the library over numbers that prove.
#pragma once

// Before the first header of C++, as the library's own text: functions of the text need not be inlined.
#define HN_I_CALLED
#include <hashnoise/glsl.hpp>

#include "config.glsl"
#include "integers.hpp"

namespace hn::prover {

#include "names.hpp"

// The constructors of scalars are keywords of C++.
#define float Float
#define int Int
#if HN_ARITHMETIC != HN_FIXED
// The exact number is the sine: PROVER_SINE is how far the polynomial is off it. It drops up to 63 units of a quarter
// turn of 2^30, which is a rounding of a number that a hash makes, but not of one that is known.
static Float hn_i_polynomial_sine(Uint q);
inline Float hn_i_quarter_sine(Uint q) {
  return each(hn_i_polynomial_sine(q), [known = q.is != Word::kNumeric](Form f) {
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
  });
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
