// Steps of HN_FIXED in place of the text's own (STEPS in prover.py): their exact numbers are stated here. It is
// included in the namespace, before the text.

// The exact number is the sine: PROVER_FIXED_SINE is how far the integer is off it (sine.py). A hash makes any sine.
static Int hn_i_computed_whole_wave(Uint angle, Uint sign);
inline Int hn_i_whole_wave(Uint angle, Uint sign) {
  if (angle.is != Word::kAny) return hn_i_computed_whole_wave(angle, sign);
  constexpr double kOne = 65536;
  Form f = constant(0);
  f.range = {-kOne, kOne}, f.bits = 99;
  choose(f, kOne);
  f.terms.push_back({symbol(kError, {-PROVER_FIXED_SINE * kOne, PROVER_FIXED_SINE * kOne}), {1, 1}});
  symbols.back().stays = true;  // a sine of integers is at most 1
  return Int::numeric(Float::of(f));
}
// A place is a phase, in turns, which the text cuts off to a multiple of 2^-30. Places of a box are 2^-20 apart, and a
// phase is at most so far behind one.
inline Int wave_of(const Form& phase, double shift) {
  constexpr double kTurn = 2 * 3.14159265358979324, kOne = 262144, kApart = kTurn * (0x1p-20 + 0x1p-40) * kOne;
  const double at = kTurn * (middle(phase.mid) + shift), half = kTurn * (phase.range.hi - phase.range.lo) / 2 * kSafe;
  const double off = kOne * (PROVER_FIXED_SINE + kTurn * 0x1p-30);
  Form f = phase;
  f.range = {-kOne, kOne}, f.mid = point(kOne * std::sin(at)) + Interval{-kApart, kApart};
  for (Term& t : f.terms) t.d = t.d * point(kOne * kTurn) * (point(std::cos(at)) + Interval{-half, half});
  f.place = Form::kSeveral, f.grid = 2, f.bits = 99;
  f.terms.push_back({symbol(kError, {-off, off}), {1, 1}});
  f.tighten();
  return Int::numeric(Float::of(f));
}
inline ivec2 hn_i_rotation(Float phase) { return {wave_of(phase.form(), 0.25), wave_of(phase.form(), 0)}; }

// The digits of a square are exact, so it is a sum of squares that is shifted.
template <typename... Offset>
Uint hn_i_square(Offset... offsets) {
  Form sum = constant(0);
  for (const Form& x : {offsets.number().form()...}) sum = plus(sum, times(x, x), 1);
  sum.range.lo = std::max(sum.range.lo, 0.0);
  return Uint::numeric(shifted(Float::of(sum), 10));
}
// The whole part of a place is the same in exact arithmetic: an offset is a multiple of 2^-20, and exact.
inline Int hn_i_floor(Int x) {
  if (x.is == Word::kNumber) return x.native() >> 20;
  if (x.number().form().rounds()) refuse("a whole part of a number that rounds");
  return static_cast<int>(floor(x.number() * Float(0x1p-20f)).form().range.lo);
}
inline Int hn_i_truncate(Int x) { return hn_i_floor(x); }
inline Int hn_i_fract(Int x) {
  if (x.is == Word::kNumber) return x.native() & 0xFFFFF;
  const std::int32_t whole = hn_i_floor(x).native();
  return Int::numeric(Float::at(once('r', x.n, whole, 0, [&] {
    Form f = plus(x.number().form(), constant(std::ldexp(whole, 20)), -1);
    f.grid = std::min(grid_of(x.n), 20);
    f.range = meet(f.range, {0, 0x1p20 - 1});
    return node(0, {f});
  })));
}
