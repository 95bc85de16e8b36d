// The text of the library over numbers that prove.
#pragma once

// Before the first header of C++, as the library's own text: functions of the text need not be inlined.
#define HN_I_CALLED
#include <hashnoise/glsl.hpp>

#include "config.glsl"
#include "integers.hpp"

namespace hn::prover {

using vec2 = hashnoise::Vector2<Float>;
using vec3 = hashnoise::Vector3<Float>;
using vec4 = hashnoise::Vector4<Float>;
using uint = Uint;
using ivec2 = hashnoise::Vector2<Int>;
using ivec3 = hashnoise::Vector3<Int>;
using ivec4 = hashnoise::Vector4<Int>;
using uvec2 = hashnoise::Vector2<Uint>;
using uvec3 = hashnoise::Vector3<Uint>;
using uvec4 = hashnoise::Vector4<Uint>;
using hn_float = Float;
using hn_vec2 = vec2;
using hn_vec3 = vec3;
using hn_vec4 = vec4;
using hn_int = Int;
using hn_ivec2 = ivec2;
using hn_ivec3 = ivec3;
using hn_ivec4 = ivec4;
using hn_uint = Uint;
using hn_uvec2 = uvec2;
using hn_uvec3 = uvec3;
using hn_uvec4 = uvec4;
inline vec2 floor(vec2 v) { return {floor(v.x), floor(v.y)}; }
inline vec3 floor(vec3 v) { return {floor(v.x), floor(v.y), floor(v.z)}; }
inline vec4 floor(vec4 v) { return {floor(v.x), floor(v.y), floor(v.z), floor(v.w)}; }
inline vec3 uintBitsToFloat(uvec3 v) { return {uintBitsToFloat(v.x), uintBitsToFloat(v.y), uintBitsToFloat(v.z)}; }
inline uvec3 floatBitsToUint(vec3 v) { return {floatBitsToUint(v.x), floatBitsToUint(v.y), floatBitsToUint(v.z)}; }

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
    std::erase_if(f.terms, [](const Term& t) { return symbols[t.symbol].kind == kError; });
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

// The bodies of rows of the suite's table read and return words.
#define SEEDED(s) , s
#define SEED(s) s
inline Float float_of(Uint bits) { return uintBitsToFloat(bits); }
inline Uint bits_of(Float x) { return floatBitsToUint(x); }
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
