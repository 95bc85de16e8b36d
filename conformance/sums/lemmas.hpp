// Steps of the text that the numbers cannot follow, by their results: the proofs are here. lemmas_test.py compares
// them with the text.

// By how much the rotations of a position make a length larger at most: those in the planes of x and y and of z and w.
// The one between them makes lengths in its plane smaller, but not that along x.
inline const double kStretch = std::hypot(25.0, 20.0) / 32.0;

inline hn_i_num without_error(const Number& x) { return hn_i_num(Number{x.lo, x.hi, 0, x.grid}); }
inline int new_vector() {
  static thread_local int last = 0;
  return ++last;
}
// A linear map of a vector, and a shift: its error and its length grow by at most `stretch`. `roundings` are what the
// text makes of a vector that has no error, and `v` of one that has.
struct Turned {
  const Length& before;
  double stretch, shift;
  std::int32_t vector = new_vector();
  unsigned char axis = 1;

  void operator()(Number& x, const Number& rounded) {
    const double length = stretch * before.error, reach = stretch * before.reach + shift;
    x.of = {kCoordinate, axis, vector, length, rounded.off, reach};
    x.off = shift > 0 ? length + rounded.off : std::min(x.off, length + rounded.off);
    x.lo = std::max({shift > 0 ? -HUGE_VAL : x.lo, -(length - rounded.lo), -reach - x.off});
    x.hi = std::min({shift > 0 ? HUGE_VAL : x.hi, rounded.hi + length, reach + x.off});
    axis *= 2;
  }
};

// --- Fixed-point positions ---
//
// A coordinate of a fixed-point position is cut to a multiple of 2^-24, and the lacunarity to one of 2^-23; the product
// is rounded down, and so are both coordinates after each rotation. With a whole lacunarity the product is exact.

constexpr double kDensityError = 52.94;  // of the density of a sky, in units of 2^-21
constexpr double kWhole = 0x1p24;        // units of 2^-24
constexpr std::array kShifts = {11.0 / 32.0, 19.0 / 32.0, 23.0 / 32.0, 27.0 / 32.0};

template <typename Octaves, typename... Coordinates>
void advance(Octaves& o, Coordinates&... x) {
  constexpr int axes = sizeof...(Coordinates);
  if (!o.lacunarity.is_exact()) refuse("a lacunarity that rounds");
  const bool rotates = axes > 1 && !o.place.tiled;
  const double lacunarity = o.lacunarity.hi, ratio = std::trunc(lacunarity * 0x1p23) / 0x1p23;
  Length at = length_of(x.y...);
  if (!o.x.x.any) {  // the first octave
    at.reach = 0;
    ((at.reach += std::pow(x.x.size() * kWhole + x.y.size(), 2)), ...);
    at.reach = std::sqrt(at.reach);
  }
  const double lost = ratio == std::trunc(ratio) ? 0 : 1,
               of_cut = lacunarity > ratio ? (lacunarity - ratio) * at.reach : 0;
  at.error = ratio * at.error + of_cut + std::sqrt(axes) * lost;
  for (int plane = 0; rotates && plane < axes - 1; ++plane)
    at.error = (plane % 2 == 0 ? kStretch : 1.0) * at.error + std::sqrt(2.0);
  at.reach =
      lacunarity * (axes == 4 ? kStretch : 1.0) * kStretch * at.reach + std::sqrt(axes) * kShifts[axes - 1] * kWhole;
  const std::int32_t vector = new_vector();
  unsigned char axis = 1;
  const auto next = [&](ivec2& coordinate) {
    Number y{0, kWhole, rotates ? at.error : ratio * coordinate.y.off + of_cut + lost};
    y.of = {kCoordinate, axis, vector, rotates ? at.error : 0, rotates ? 0 : y.off, at.reach};
    coordinate = {Int::unknown(), Int(y)};
    axis *= 2;
  };
  (next(x), ...);
  hn_i_update_place(o);
}
inline void hn_i_advance(hn_octaves1& o) { advance(o, o.x); }
inline void hn_i_advance(hn_octaves2& o) { advance(o, o.x, o.y); }
inline void hn_i_advance(hn_octaves3& o) { advance(o, o.x, o.y, o.z); }
inline void hn_i_advance(hn_octaves4& o) { advance(o, o.x, o.y, o.z, o.w); }

// --- Positions in floats, slopes and Jacobians ---

inline hn_i_num2 without_error(const hn_i_num2& v) { return {without_error(v.x), without_error(v.y)}; }
inline hn_i_num3 without_error(const hn_i_num3& v) {
  return {without_error(v.x), without_error(v.y), without_error(v.z)};
}
template <typename Step>
hn_i_num2 turned(const hn_i_num2& v, double stretch, double shift, const Step& step) {
  const hn_i_num2 rounded = step(without_error(v));
  hn_i_num2 next = shift > 0 ? rounded : step(v);
  const Length before = length_of(v.x, v.y);
  Turned turn{before, stretch, shift};
  turn(next.x, rounded.x), turn(next.y, rounded.y);
  return next;
}
template <typename Step>
hn_i_num3 turned(const hn_i_num3& v, double stretch, double shift, const Step& step) {
  const hn_i_num3 rounded = step(without_error(v));
  hn_i_num3 next = shift > 0 ? rounded : step(v);
  const Length before = length_of(v.x, v.y, v.z);
  Turned turn{before, stretch, shift};
  turn(next.x, rounded.x), turn(next.y, rounded.y), turn(next.z, rounded.z);
  return next;
}
// A number of a Jacobian in ones.
inline double in_units(const Number& x) { return HN_ARITHMETIC == HN_FIXED ? x.size() * 0x1p-18 : x.size(); }
inline hn_i_num2 hn_i_rotated(hn_i_num2 v) {
  return turned(v, kStretch, 0, [](hn_i_num2 w) { return hn_i_rotated<0>(w); });
}
inline hn_i_num3 hn_i_rotated(hn_i_num3 v) {
  return turned(v, kStretch, 0, [](hn_i_num3 w) { return hn_i_rotated<0>(w); });
}

// The columns of a Jacobian.
inline hn_i_jacobian3 hn_i_next_jacobian(hn_i_jacobian3 k, hn_i_num growth, bool tiled) {
  const hn_i_jacobian3 exact{without_error(k.x), without_error(k.y), without_error(k.z)};
  const hn_i_jacobian3 rounded = hn_i_next_jacobian<0>(exact, growth, tiled);
  hn_i_jacobian3 next = hn_i_next_jacobian<0>(k, growth, tiled);
  const double stretch = in_units(growth) * (tiled ? 1.0 : kStretch);
  const auto column = [&](hn_i_num hn_i_num3::*of) {
    const Length before = length_of(k.x.*of, k.y.*of, k.z.*of);
    Turned turn{before, stretch, 0};
    turn(next.x.*of, rounded.x.*of), turn(next.y.*of, rounded.y.*of), turn(next.z.*of, rounded.z.*of);
  };
  column(&hn_i_num3::x), column(&hn_i_num3::y), column(&hn_i_num3::z);
  return next;
}

// A Jacobian times a vector. The square of a norm is no more than the largest sum of magnitudes in a row of K^T K.
inline hn_i_num2 hn_i_jacobian_times(hn_i_num2 k, hn_i_num2 v) {
  return turned(v, std::hypot(in_units(k.x), in_units(k.y)), 0,
                [&](hn_i_num2 w) { return hn_i_jacobian_times<0>(k, w); });
}
inline hn_i_num3 hn_i_jacobian_times(hn_i_jacobian3 k, hn_i_num3 v) {
  Interval products[3][3] = {};
  for (const hn_i_num3* row : {&k.x, &k.y, &k.z}) {
    const Number* const x[] = {&row->x, &row->y, &row->z};
    for (int i = 0; i < 9; ++i) {
      const Interval a{x[i / 3]->lo, x[i / 3]->hi}, b{x[i % 3]->lo, x[i % 3]->hi};
      products[i / 3][i % 3] = products[i / 3][i % 3] + a * b;
    }
  }
  double square = 0;
  for (const auto& row : products) square = std::max(square, row[0].size() + row[1].size() + row[2].size());
  return turned(v, in_units(Number{0, std::sqrt(square)}), 0,
                [&](hn_i_num3 w) { return hn_i_jacobian_times<0>(k, w); });
}

// The largest slope of 1 / (1 + strength r^2) for r up to `reach`: it is steepest where strength r^2 = 1/3.
inline double steepest_fall(double strength, double reach) {
  const double r = strength > 0 ? std::min(reach, 1 / std::sqrt(3 * strength)) : reach, divisor = 1 + strength * r * r;
  return 2 * strength * r / (divisor * divisor);
}

#if HN_ARITHMETIC != HN_FIXED
inline vec4 without_error(const vec4& v) {
  return {without_error(v.x), without_error(v.y), without_error(v.z), without_error(v.w)};
}
inline double shift_of(int axes) {
  double square = 0;
  for (auto shift = kShifts.begin(); shift != kShifts.begin() + axes; ++shift) square += *shift * *shift;
  return std::sqrt(square);
}
template <typename Step>
vec4 turned(const vec4& v, double stretch, double shift, const Step& step) {
  const vec4 rounded = step(without_error(v));
  vec4 next = shift > 0 ? rounded : step(v);
  const Length before = length_of(v.x, v.y, v.z, v.w);
  Turned turn{before, stretch, shift};
  turn(next.x, rounded.x), turn(next.y, rounded.y), turn(next.z, rounded.z), turn(next.w, rounded.w);
  return next;
}
inline vec2 hn_i_next(hn_vec2 q, hn_float lacunarity) {
  return turned(q, lacunarity.size() * kStretch, shift_of(2), [&](vec2 v) { return hn_i_next<0>(v, lacunarity); });
}
inline vec3 hn_i_next(hn_vec3 q, hn_float lacunarity) {
  return turned(q, lacunarity.size() * kStretch, shift_of(3), [&](vec3 v) { return hn_i_next<0>(v, lacunarity); });
}
inline vec4 hn_i_next(hn_vec4 q, hn_float lacunarity) {
  return turned(q, lacunarity.size() * kStretch * kStretch, shift_of(4),
                [&](vec4 v) { return hn_i_next<0>(v, lacunarity); });
}
// Moves a fixed-point position: the shift is cut to 2^-24, and so is the fraction of the difference.
inline ivec2 hn_i_displaced(hn_ivec2 x, hn_float n) {
  Number y = plus(x.y, times(n, known(kWhole)));
  y.lo = 0, y.hi = kWhole, y.grid = 0, y.off += 2, y.of.own += 2;
  return {x.x.any ? x.x : Int(plus(x.x, n)), Int(y)};
}

// A cell and its fraction are the position again, but for a rounding.
inline Float position_of(const Int& cell, const Float& fraction) {
  if (cell.any) throw Unbounded{};
  return Float(rounded(plus(Number{cell.lo, cell.hi, 0, 0}, fraction)));
}
inline Float hn_position(hn_place1 place) { return position_of(place.cell, place.fraction); }
inline vec2 hn_position(hn_place2 place) {
  return {position_of(place.cell.x, place.fraction.x), position_of(place.cell.y, place.fraction.y)};
}
inline vec3 hn_position(hn_place3 place) {
  return {position_of(place.cell.x, place.fraction.x), position_of(place.cell.y, place.fraction.y),
          position_of(place.cell.z, place.fraction.z)};
}
inline vec4 hn_position(hn_place4 place) {
  return {position_of(place.cell.x, place.fraction.x), position_of(place.cell.y, place.fraction.y),
          position_of(place.cell.z, place.fraction.z), position_of(place.cell.w, place.fraction.w)};
}

// --- Steps ---

// t = (n + 1)*strength;  t = t - 2*floor(t/2);  z = min(t, 2 - t);  2*z - 1
//
// Only n + 1 and the product of t round: 2 - t is exact for t from 1 on. The difference may be fused with the product,
// so that t is less than 0 or more than 2 by the rounding of the product; this counts twice, then.
inline Float hn_i_folds(hn_float n, hn_float strength) {
  const Float sum = n + Float(1.0f), t = sum * strength;
  const double product = times(sum, strength).off, error = 2 * (product + 2 * (t.off - product));
  return Float(between(-1.001, 1.001, std::min(error + kUnit * (1 + error), 2.001)));
}

// t = clamp(2*mean + 0.25, 0, 1);  density = t*t*(3 - 2*t)
//
// The smoothstep has slopes up to 3/2 and three roundings, relative to a value of at most 1.
inline Float hn_i_density(hn_float mean) {
  return Float(between(0, 1.001, 1.5 * (2 * mean.off + kUnit) + 3.001 * kUnit));
}

// A square of a coordinate, and 1 / (strength*(e_x*e_x + e_y*e_y [+ e_z*e_z]) + 1). The divisor goes through n + 2
// operations of terms that are not negative.
inline Float hn_i_squared_slope(hn_float slope) {
  Number x = rounded(times(slope, slope));
  x.of = slope.of;
  if (x.of.kind != kCoordinate) x.of = {kCoordinate, 255, new_vector(), 0, slope.off, 0};
  x.of.kind = kSquares, x.of.reach = slope.size();
  return Float(x);
}
inline Float hn_i_erosion_weight(hn_float square, hn_float strength) {
  if (square.of.kind != kSquares) refuse("an erosion by what is no sum of squares");
  const double error = steepest_fall(strength.hi, square.of.reach) * (square.of.length + square.of.own) +
                       std::pow(1 + kUnit, 5) - 1 + 3.5 * kUnit + 1000 * kTiny;
  return Float(between(0, 1.001, std::min(error, 1.001)));
}

#else

// --- Places ---
//
// A fraction and its rest are one number here, in units of 2^-20: the rest stays 0.

inline Int fraction_of(const Number& f) {
  Number x = times(f, known(0x1p24));
  if (x.grid < 0) x = off_by(x, -1, 1);
  x.lo = 0, x.hi = kWhole;
  return Int(times(x, known(0x1p-4)));
}
inline Int cell_of(const Float& p) { return Int(Number{std::floor(p.lo), std::floor(p.hi)}); }
inline hn_place1 hn_place(hn_float p) { return hn_i_place<0>(cell_of(p), fraction_of(p), Int()); }
inline hn_place2 hn_place(hn_vec2 p) {
  return hn_i_place<0>(ivec2{cell_of(p.x), cell_of(p.y)}, ivec2{fraction_of(p.x), fraction_of(p.y)}, ivec2());
}
inline hn_place3 hn_place(hn_vec3 p) {
  return hn_i_place<0>(ivec3{cell_of(p.x), cell_of(p.y), cell_of(p.z)},
                       ivec3{fraction_of(p.x), fraction_of(p.y), fraction_of(p.z)}, ivec3());
}
inline hn_place4 hn_place(hn_vec4 p) {
  return hn_i_place<0>(ivec4{cell_of(p.x), cell_of(p.y), cell_of(p.z), cell_of(p.w)},
                       ivec4{fraction_of(p.x), fraction_of(p.y), fraction_of(p.z), fraction_of(p.w)}, ivec4());
}
inline hn_place1 hn_place(hn_int cell, hn_float f) { return hn_i_place<0>(cell, fraction_of(f), Int()); }
inline hn_place2 hn_place(hn_ivec2 cell, hn_vec2 f) {
  return hn_i_place<0>(cell, ivec2{fraction_of(f.x), fraction_of(f.y)}, ivec2());
}
inline hn_place3 hn_place(hn_ivec3 cell, hn_vec3 f) {
  return hn_i_place<0>(cell, ivec3{fraction_of(f.x), fraction_of(f.y), fraction_of(f.z)}, ivec3());
}
inline hn_place4 hn_place(hn_ivec4 cell, hn_vec4 f) {
  return hn_i_place<0>(cell, ivec4{fraction_of(f.x), fraction_of(f.y), fraction_of(f.z), fraction_of(f.w)}, ivec4());
}
inline ivec2 hn_i_fixed_position(hn_int cell, hn_int fraction, hn_int) {
  return {cell, Int(times(fraction, known(16)))};
}
inline Int of_position(const ivec2& x) { return Int(times(x.y, known(0x1p-4))); }
inline void hn_i_update_place(hn_octaves1& o) { o.place.cell = o.x.x, o.place.fraction = of_position(o.x); }
inline void hn_i_update_place(hn_octaves2& o) {
  o.place.cell = {o.x.x, o.y.x}, o.place.fraction = {of_position(o.x), of_position(o.y)};
}
inline void hn_i_update_place(hn_octaves3& o) {
  o.place.cell = {o.x.x, o.y.x, o.z.x}, o.place.fraction = {of_position(o.x), of_position(o.y), of_position(o.z)};
}
inline void hn_i_update_place(hn_octaves4& o) {
  o.place.cell = {o.x.x, o.y.x, o.z.x, o.w.x};
  o.place.fraction = {of_position(o.x), of_position(o.y), of_position(o.z), of_position(o.w)};
}
inline ivec2 hn_i_displaced(hn_ivec2 x, hn_int n) {
  Number y = plus(x.y, times(n, known(8)));
  y.lo = 0, y.hi = kWhole;
  return {x.x.any ? x.x : Int(plus(x.x, times(n, known(0x1p-21)))), Int(y)};
}
inline Int hn_i_next_footprint(hn_int footprint, hn_float lacunarity) {
  const Uint ratio = max(hn_i_ratio<0>(lacunarity), Uint(8388608u));
  return Int(least(Int::shifted(times(footprint, ratio), 23), known(0x1p25)));
}

// --- Steps ---
//
// Products in halves that fit 32 bits are rounded down once or twice.

inline Int part_of(const Number& a, const Number& b, int bits) { return Int(Int::shifted(times(a, b), bits)).held(); }
inline Int hn_i_magnitude(hn_int n) { return Int(magnitude(n)); }
inline Int hn_i_weight_times(hn_int a, hn_int b) {
  Number x = part_of(a, b, 18);
  if (x.is_exact()) return Int(x);
  x.of = root_of_product(a, b, a.name == b.name);
  x.of.length *= 0x1p-9, x.of.own = x.of.own * 0x1p-18 + 1;
  return Int(squared(x));
}
// The products by the high half and by the low half of a weight are summed before they are rounded down. A weight that
// is a multiple of 2^9 has no low half.
inline Int hn_i_summed(hn_int sum, hn_int n, hn_int weight) {
  if (n.size() * 512 + (n.size() / 512 + 1) * 511 >= 0x1p31) throw Unbounded{};
  const Number product = times(times(n, weight), known(0x1p-18));
  Number x = plus(sum, product.grid >= 0 ? product : off_by(product, weight.grid >= 9 ? -1 : -2, 0));
  x.grid = 0;
  return Int(x).held();
}
// sum * 2^18 / total, cut off towards 0
inline Int hn_i_mean(hn_int sum, hn_int total) {
  const Interval range = Interval{sum.lo, sum.hi} * Interval{-(-0x1p18 / total.hi), 0x1p18 / total.lo};
  const Number x{range.lo, range.hi};
  Number y = between(x.lo, x.hi, (sum.off * 0x1p18 + x.size() * total.off) / total.lo);
  if (sum.is_exact() && total.is_exact()) {  // the quotient is between two doubles
    const double cut = std::trunc(sum.lo * 0x1p18 / total.lo);
    y = {std::min(cut, y.lo), std::max(cut, y.hi), std::max(std::fabs(y.lo - cut), std::fabs(y.hi - cut)), 0};
    return Int(y).held();
  }
  y = off_by(y, -1, 1);
  y.grid = 0;
  return Int(y).held();
}
// 1/2 + c (3/2 - 2 c^2) of c = 2 mean - 1/4 has slopes up to 3 by the mean. The rounding is the worst c's.
inline Int hn_i_density(hn_int mean) {
  Number x = between(0, 0x1p21, 3 * mean.off + kDensityError);
  x.grid = 0;
  return Int(x);
}
// (n + 1) * strength is rounded down to 2^-30, and the folded number to 2^-21.
inline Int hn_i_folds(hn_int n, hn_int strength) {
  const double t = n.off * strength.size() * 0x1p-39 + strength.off * 0x1p-18 * 2 + 0x1p-30;
  Number x = between(-0x1p21, 0x1p21, std::min(2 * t * 0x1p21 + 1, 0x1p22));
  x.grid = 0;
  return Int(x);
}

inline Int hn_i_wide_times(hn_int a, hn_int b) { return part_of(a, b, 18); }
inline Int hn_i_wide_plus(hn_int a, hn_int b) { return Int(plus(a, b)).held(); }
inline Int hn_i_wide_minus(hn_int a, hn_int b) { return Int(plus(a, negative(b))).held(); }
inline Int hn_i_rotated_by(hn_int a, hn_int b, hn_int along, hn_int across) {
  return Int(Int::shifted(Int(plus(times(a, along), times(b, across))).held(), 5));
}
inline Int hn_i_growth(hn_int gain, hn_float lacunarity) { return part_of(gain, hn_i_ratio<0>(lacunarity), 23); }
inline Int hn_i_coarse(hn_int n) { return n.size() < 0x1p24 ? n : Int(off_by(n, -127, 127)); }
inline Uint hn_i_squared_slope(hn_int slope) {
  Number x = times(slope, slope);
  x.lo = 0, x.of = slope.of;
  if (x.of.kind != kCoordinate) x.of = {kCoordinate, 255, new_vector(), 0, slope.off, 0};
  x.of.kind = kSquares, x.of.reach = slope.size();
  return Uint(x).held();
}
// Slopes are in units of 2^-12. The square times the strength rounds down by less than 2^-16 of a number from 1 on, and
// the quotient by 2^-18. An error d of the strength changes the factor by up to d r^2 / (1 + strength r^2)^2, which is
// largest where strength r^2 = 1.
inline Int hn_i_erosion_weight(hn_uint square, hn_int strength) {
  if (square.of.kind != kSquares) refuse("an erosion by what is no sum of squares");
  const double s = strength.hi * 0x1p-18, off = strength.off * 0x1p-18, reach = square.of.reach * 0x1p-12;
  if (0x1p16 + square.size() * strength.size() * 0x1p-26 >= 0x1p32) throw Unbounded{};
  const double of_strength = off * (s > 0 ? std::min(reach * reach, 1 / (4 * std::max(s - off, 0.0))) : reach * reach);
  const double error = steepest_fall(s, reach) * (square.of.length + square.of.own) * 0x1p-12 + of_strength + 0x1p-16;
  Number x = between(0, 0x1p18, std::min(error * 0x1p18 + 1, 0x1p18));
  x.grid = 0;
  return Int(x);
}

#endif
