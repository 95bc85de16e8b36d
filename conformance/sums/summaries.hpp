// Noises as summaries, and which functions of the text are not called, since the numbers cannot follow them
// (lemmas.hpp). Included in text.hpp behind places.

inline thread_local const Noises* noises = nullptr;

// With HN_FIXED the number is a multiple of 2^grid.
inline Float summarized(const Summary& of, double moved, [[maybe_unused]] int grid) {
  const double off = of.error + moved;
  Number x = between(-of.limit, of.limit, off < 2 * of.limit ? off : 2 * of.limit);  // also for a NaN
#if HN_ARITHMETIC == HN_FIXED
  x.grid = grid;
#endif
  return Float(x);
}

// How long an error of a vector is, or the vector itself.
struct Length {
  double error = 0, reach = 0, largest = 0;
};
template <typename... Numbers>
Length length_of(const Numbers&... coordinates) {
  const std::array<const Number*, sizeof...(Numbers)> v = {&coordinates...};
  const std::int32_t vector = v[0]->of.vector;
  bool one = true;
  unsigned axes = 0;
  double length = 0, own = 0, off = 0, reach = 0, size = 0, largest = 0;  // squares of own, off and size
  for (const Number* x : v) {
    one = one && x->of.kind == kCoordinate && x->of.vector == vector && (axes & x->of.axes) == 0;
    axes |= x->of.axes;
    length = std::max(length, x->of.length), own += x->of.own * x->of.own, off += x->off * x->off;
    reach = std::max(reach, x->of.reach), size += x->size() * x->size();
    largest = std::max(largest, x->off);
  }
  if (off > 0) off = one ? std::min(length + std::sqrt(own), std::sqrt(off)) : std::sqrt(off);
  size = std::sqrt(size);
  return {off, one ? std::min(reach, size) : size, largest};
}

#if HN_ARITHMETIC == HN_FIXED
inline Number along(const Int& fraction, const Int& rest) {
  return times(plus(times(fraction, known(16)), rest), known(0x1p-24));
}
#define ALONG(axis) along(place.fraction axis, place.rest axis)
#else
#define ALONG(axis) place.fraction axis
#endif
// A fraction is as far off as the position is: the exact one is in the same cell.
inline Length off_of(const hn_place1& place) { return length_of(ALONG()); }
inline Length off_of(const hn_place2& place) { return length_of(ALONG(.x), ALONG(.y)); }
inline Length off_of(const hn_place3& place) { return length_of(ALONG(.x), ALONG(.y), ALONG(.z)); }
inline Length off_of(const hn_place4& place) { return length_of(ALONG(.x), ALONG(.y), ALONG(.z), ALONG(.w)); }
#undef ALONG

struct Summarized {
  const Noise& noise;
  Length off;
  // A noise that jumps is as good as any only where its place is exact.
  Float value() const {
    const double moved = std::min(noise.value.lipschitz * off.largest, noise.steepest * off.error);
    return summarized(noise.value, off.largest > 0 ? moved : 0, -21);
  }
  Float slope() const {
    return summarized(noise.slope, off.largest > 0 ? noise.slope.lipschitz * off.largest : 0, -19);
  }
};

inline Float hn_perlin(const hn_place1& place, const Uint&) {
  return Summarized{noises->perlin[1], off_of(place)}.value();
}
inline Float hn_perlin(const hn_place2& place, const Uint&) {
  return Summarized{noises->perlin[2], off_of(place)}.value();
}
inline Float hn_perlin(const hn_place3& place, const Uint&) {
  return Summarized{noises->perlin[3], off_of(place)}.value();
}
inline Float hn_perlin(const hn_place4& place, const Uint&) {
  return Summarized{noises->perlin[4], off_of(place)}.value();
}
inline vec3 hn_perlin_d(const hn_place2& place, const Uint&) {
  const Summarized n{noises->perlin_d[2], off_of(place)};
  return {n.value(), n.slope(), n.slope()};
}
inline vec4 hn_perlin_d(const hn_place3& place, const Uint&) {
  const Summarized n{noises->perlin_d[3], off_of(place)};
  return {n.value(), n.slope(), n.slope(), n.slope()};
}
inline vec2 hn_value_vector(const hn_place2& place, const Uint&) {
  const Summarized n{noises->value_vector[2], off_of(place)};
  return {n.value(), n.value()};
}
inline vec3 hn_value_vector(const hn_place3& place, const Uint&) {
  const Summarized n{noises->value_vector[3], off_of(place)};
  return {n.value(), n.value(), n.value()};
}
inline vec2 hn_cellular(const hn_place3& place, const Uint&) {
  const Summarized n{noises->cellular_d[3], off_of(place)};
  return {n.value(), n.value()};
}
inline vec2 hn_curl(const hn_place2& place, const Uint&) {
  const Summarized n{noises->curl[2], off_of(place)};
  return {n.value(), n.value()};
}
inline vec3 hn_curl(const hn_place3& place, const Uint&) {
  const Summarized n{noises->curl[3], off_of(place)};
  return {n.value(), n.value(), n.value()};
}
// With a phase: the error of a rotation is a part of theirs.
inline hn_i_num2 hn_i_new_curl_rotation2(const Float&) { return {}; }
inline hn_i_num4 hn_i_new_curl_rotation3(const Float&) { return {}; }
inline vec2 hn_i_curl(const hn_place2& place, const hn_i_num2&, const Uint&) {
  const Summarized n{noises->curl_phase[2], off_of(place)};
  return {n.value(), n.value()};
}
inline vec3 hn_i_curl(const hn_place3& place, const hn_i_num4&, const Uint&) {
  const Summarized n{noises->curl_phase[3], off_of(place)};
  return {n.value(), n.value(), n.value()};
}
// gullies.cpp has the proof of a sum of these.
inline hn_derivatives2x2 hn_phasor_d(const hn_place2&, const vec2&, const Float&, const Uint&) { refuse("gullies"); }

struct hn_octaves1;
struct hn_octaves2;
struct hn_octaves3;
struct hn_octaves4;
void hn_i_advance(hn_octaves1& o);
void hn_i_advance(hn_octaves2& o);
void hn_i_advance(hn_octaves3& o);
void hn_i_advance(hn_octaves4& o);
struct hn_i_jacobian3;
hn_i_num2 hn_i_rotated(hn_i_num2 v);
hn_i_num3 hn_i_rotated(hn_i_num3 v);
hn_i_num2 hn_i_jacobian_times(hn_i_num2 k, hn_i_num2 v);
hn_i_num3 hn_i_jacobian_times(hn_i_jacobian3 k, hn_i_num3 v);
hn_i_jacobian3 hn_i_next_jacobian(hn_i_jacobian3 k, hn_i_num growth, bool tiled);
hn_i_num hn_i_folds(hn_i_num n, hn_i_num strength);
hn_i_num hn_i_density(hn_i_num mean);
ivec2 hn_i_displaced(hn_ivec2 x, hn_i_num n);
#if HN_ARITHMETIC != HN_FIXED
Float hn_position(hn_place1 place);
vec2 hn_position(hn_place2 place);
vec3 hn_position(hn_place3 place);
vec4 hn_position(hn_place4 place);
vec2 hn_i_next(hn_vec2 q, hn_float lacunarity);
vec3 hn_i_next(hn_vec3 q, hn_float lacunarity);
vec4 hn_i_next(hn_vec4 q, hn_float lacunarity);
Float hn_i_squared_slope(hn_float slope);
Float hn_i_erosion_weight(hn_float square, hn_float strength);
#else
hn_place1 hn_place(hn_float p);
hn_place2 hn_place(hn_vec2 p);
hn_place3 hn_place(hn_vec3 p);
hn_place4 hn_place(hn_vec4 p);
hn_place1 hn_place(hn_int cell, hn_float f);
hn_place2 hn_place(hn_ivec2 cell, hn_vec2 f);
hn_place3 hn_place(hn_ivec3 cell, hn_vec3 f);
hn_place4 hn_place(hn_ivec4 cell, hn_vec4 f);
ivec2 hn_i_fixed_position(hn_int cell, hn_int fraction, hn_int rest);
void hn_i_update_place(hn_octaves1& o);
void hn_i_update_place(hn_octaves2& o);
void hn_i_update_place(hn_octaves3& o);
void hn_i_update_place(hn_octaves4& o);
Int hn_i_next_footprint(hn_int footprint, hn_float lacunarity);
Int hn_i_magnitude(hn_int n);
Int hn_i_weight_times(hn_int a, hn_int b);
Int hn_i_summed(hn_int sum, hn_int n, hn_int weight);
Int hn_i_mean(hn_int sum, hn_int total);
Int hn_i_wide_times(hn_int a, hn_int b);
Int hn_i_wide_plus(hn_int a, hn_int b);
Int hn_i_wide_minus(hn_int a, hn_int b);
Int hn_i_rotated_by(hn_int a, hn_int b, hn_int along, hn_int across);
Int hn_i_growth(hn_int gain, hn_float lacunarity);
Int hn_i_coarse(hn_int n);
Uint hn_i_squared_slope(hn_int slope);
Int hn_i_erosion_weight(hn_uint square, hn_int strength);
#endif
