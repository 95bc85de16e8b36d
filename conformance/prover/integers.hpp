// Integers of the text: words of 32 bits.
#pragma once

#include "linear.hpp"

namespace hn::prover {

// Words of 32 bits: signed or not they are the same here.
struct Word {
  enum Is : char { kNumber, kAny, kBits, kFloat, kNumeric } is = kNumber;
  std::uint32_t value = 0;
  int word = 0;       // of kAny and kBits
  Vector<Bits> bits;  // of kBits, one for each class
  int down = 0;       // these were so many bits higher in the word
  int n = 0;          // of kFloat: these are its bits; of kNumeric: it is this number
  int step = -1;      // that made it, of kAny and kBits
  // Where an angle rounds, the exact one, which may be no whole number, is so far from the computed one at most,
  // modulo 2^modulo; and within kAngleCut of a number that is known.
  double off = 0;
  int modulo = 32;
  static constexpr double kAngleCut = 16;

  static Word any() {
    Word w;
    w.is = kAny;
    w.word = ++last_word;
    w.step = new_step('X', 0);
    return w;
  }
  // Any word that is made so: it has the same number on all paths.
  static Word made_by(int step) {
    Word w = any();
    w.step = step;
    w.word = steps[step].word = steps[step].word ? steps[step].word : w.word;
    return w;
  }
  // The step that made it, also of a constant or a number.
  int step_of() const {
    if (is == kNumber) return new_step('#', static_cast<int>(value));
    if (is == kFloat || is == kNumeric) return new_step('N', n);
    return step;
  }
  // Bits that decide.
  [[noreturn]] void want(std::uint32_t of) const { want_bits(word, down >= 0 ? of << down : of >> -down); }
  std::uint32_t wanted() const { return down >= 0 ? division(word).bits >> down : division(word).bits << -down; }
  void must_be_exact() const {
    if (off > 0) refuse("the bits of an angle that rounds");
  }
  Word divided() const {
    must_be_exact();
    if (is == kBits) return *this;
    if (is != kAny) refuse("the bits of a number");
    Word w = *this;
    w.is = kBits;
    w.bits = classes(word);
    return w;
  }
};
inline Float select(Mask c, Float a, Float b);
// How many parts a turn has, if a number is in these what another one has beyond whole turns.
inline double parts_of_a_turn(int n) {
  double parts = 0;
  const bool is_part = nodes[n].made == '*' && nodes[nodes[n].left].made == '%';
  return is_part && is_constant(Float::at(nodes[n].right), &parts) ? parts : 0;
}
template <bool Signed>
struct Integer : Word {
  using Native = std::conditional_t<Signed, std::int32_t, std::uint32_t>;
  Integer() = default;
  explicit Integer(Word w) : Word(std::move(w)) {}
  template <typename T>
  requires std::is_integral_v<T>
  explicit(!std::same_as<T, Native>) Integer(T v) { value = static_cast<std::uint32_t>(v); }
  template <bool Other>
  requires(Other != Signed) explicit Integer(Integer<Other> o) : Word(o) {
    if (Signed && is == kBits) {
      const Float f = o.number();
      *this = range_of(f.n).hi < 0x1p31 ? numeric(f) : Integer(made_by(new_step('I', step_of())));
    }
    if (is == kAny) n = 0;
    if (Signed && is == kNumeric) *this = numeric(Float::at(n));
  }
  explicit Integer(Float f) {
    if (nodes[f.n].lazy) {
      if (grid_of(f.n) < 0) throw TooLarge{"a float that is no integer"};
      *this = numeric(f);
      return;
    }
    const Form& form = f.form();
    if (double x = 0; is_one_of_several(f, &x)) {
      value = static_cast<std::uint32_t>(static_cast<std::int64_t>(x));
    } else if (is_of_cells(form)) {
      *this = Integer(made_by(new_step('N', f.n)));
      n = f.n;
    } else if (!(form.range.lo > (Signed ? -0x1p31 - 1 : -1) && form.range.hi < (Signed ? 0x1p31 : 0x1p32)))
      throw TooLarge{"a float beyond integers"};
    else if (form.range.lo == form.range.hi && form.terms.empty() && !(kFixed && is_fraction(form)))
      value = static_cast<std::uint32_t>(static_cast<std::int64_t>(form.range.lo));
    else if (const double lo = std::trunc(form.range.lo), hi = std::trunc(form.range.hi);
             !kFixed && hi - lo < 64 && std::fabs(lo) < 0x1p31)
      value = static_cast<std::uint32_t>(static_cast<std::int64_t>(one_of('t', f, lo, hi).form().range.lo));
    else if (kFixed && form.grid >= 0 && form.range.size() < 0x1p31) {
      *this = numeric(Float::of(Form(form)));
      nodes[n].made = 'L', nodes[n].leaf = n, nodes[n].shift = kFraction;
    } else if (const double turn = parts_of_a_turn(f.n); decided_by_hash(form) || turn > 0) {
      *this = Integer(made_by(new_step('N', f.n)));
      if (turn == 0 || kExactSines) return;
      // It is cut off, and rounding may take it to another whole turn.
      const Form turns = Float::at(nodes[nodes[f.n].left].left).form();
      const Interval exact = turns.exact() * point(turn);
      if (exact.hi - exact.lo < 0.5) *this = Integer(static_cast<Native>(std::int64_t(std::floor(exact.lo))));
      off = turns.error().size() * turn + 1, modulo = std::ilogb(turn);
      if (std::ldexp(1.0, modulo) != turn) refuse("parts of a turn");
    } else
      throw TooLarge{"a float that is no integer"};
  }
  // Uints are modulo 2^32 only where they are read.
  static Integer numeric(Float f) {
    nodes[f.n].type = nodes[f.n].type != 0 ? nodes[f.n].type : Signed ? 'i' : 'u';
    if (Signed) as_read(f);
    Integer w;
    w.is = kNumeric, w.n = f.n;
    return w;
  }
  static Float as_read(Float f) {
    if (nodes[f.n].lazy && of_one(f.n)) return f;  // its table reads it
    const Interval most{Signed ? -0x1p31 : 0, Signed ? 0x1p31 - 1 : 0x1p32 - 1};
    if (!is_in(range_of(f.n), most) && !(nodes[f.n].lazy && is_in(narrowed(f.n), most)))
      throw TooLarge{"an integer beyond 32 bits"};
    return f;
  }
  Float read() const { return as_read(number()); }
  bool counts() const { return is == kNumber || is == kNumeric || is == kFloat; }
  Float number() const {
    must_be_exact();
    if (is == kNumber) return Float::whole(static_cast<double>(native()));
    if (is == kBits) {  // some bits of a hash
      return Float::at(once('B', step, Signed, 0, [&] {
        Vector<Form> out;
        for (const Bits& x : bits) {
          const double lo = std::max(x.lo, x.value), hi = std::min(x.hi, x.value | ~x.known);
          if (Signed && hi >= 0x1p31) throw TooLarge{"a word as an int"};
          Form f = constant((lo + hi) / 2);
          f.range = {lo, hi}, f.bits = 99;
          f.grid = std::countr_zero(x.value | ~x.known | 0x80000000u);
          if (lo < hi) choose(f, (hi - lo) / 2);
          out.push_back(f);
        }
        const int by = out.size() == 1 ? 0 : word;  // before it is moved from
        const int n = node(by, std::move(out));
        nodes[n].made = Signed ? 'b' : 'B', nodes[n].step = step;
        return n;
      }));
    }
    return is == kFloat ? as_bits(Float::at(n)) : Float::at(n);
  }
  template <typename Step>
  static Float taken_once(int op, const Integer& a, const Integer& b, const Step& step) {
    const Float x = a.number(), y = b.number();
    return Float::at(once(op | 2 << 16, x.n, y.n, 0, [&] { return step(x, y).n; }));
  }
  static bool numbers(const Integer& a, const Integer& b) {
    return a.counts() && b.counts() && (a.is != kNumber || b.is != kNumber);
  }
  explicit Integer(Mask m) { value = bool(m) ? 1 : 0; }
  Native native() const {
    must_be_exact();
    return static_cast<Native>(value);
  }
  // An integer may be any instead, if it is the same in exact arithmetic.
  static void forget(const Integer& a) {
    if (a.is != kNumeric && a.is != kFloat) return;
    for (const Form& x : nodes[a.n].forms) {
      if (!decided_by_hash(x)) refuse("a number that is made of a place, and a hash");
    }
  }
  template <typename Step>
  static Integer both(const Integer& a, const Integer& b, const Step& step) {
    if (a.is == kNumber && b.is == kNumber)
      return Integer(static_cast<Native>(step(static_cast<Native>(a.value), static_cast<Native>(b.value))));
    forget(a), forget(b);
    return Integer(any());
  }
  // A number that has only high bits, where a hash's are known: the others stay as they are.
  static bool shifts_high(const Integer& a, const Integer& b) {
    if (a.is != kBits || b.is != kNumber || b.value == 0) return false;
    const std::uint32_t high = ~0u << std::countr_zero(b.value);
    if (std::popcount(high) > 4) return false;
    for (const Bits& x : a.bits) {
      if (high & ~x.known) a.want(high & ~x.known);
    }
    return true;
  }
  // The highest bits decide where a hash is compared with a number that is made of it.
  static const Integer& spread(const Integer& a) {
    std::uint32_t all = 1;
    for (const Bits& x : a.bits) all |= x.value | ~x.known;
    const std::uint32_t high = ~(~0u >> kSpread >> std::countl_zero(all));
    for (const Bits& x : a.bits) {
      if (high & ~x.known) a.want(high & ~x.known);
    }
    return a;
  }
  static bool is_beyond(const Integer& a, const Integer& b) {  // a known number, and bits that are never more
    if (Signed || a.is != kNumber || b.is != kBits) return false;
    return std::all_of(b.bits.begin(), b.bits.end(), [&](const Bits& x) { return (x.value | ~x.known) <= a.value; });
  }
  // The bits of a number and a sign, which is 0 or that bit of a hash.
  static bool signs(const Integer& a, const Integer& b) {
    return a.is == kFloat && (b.is == kBits || (b.is == kNumber && b.value << 1 == 0));
  }
  static Integer with_sign(Integer a, Integer b, bool flips) {
    if (b.is == kNumber) {
      if (!flips && Float::at(a.n).form().range.lo < 0) throw TooLarge{"a sign for a number that may have one"};
      if (b.value != 0) a.n = (-Float::at(a.n)).n;
      return a;
    }
    Integer result;
    result.is = kFloat;
    result.n = once(flips ? '^' : '|', a.n, b.step_of(), 0, [&] {
      Vector<Form> out;
      out.reserve(b.bits.size());
      const int n = nodes[a.n].word == b.word ? a.n : joined_node(a.n);
      for (size_t i = 0; i < b.bits.size(); ++i) {
        const Form& f = nodes[n].forms[nodes[n].word ? i : 0];
        if ((b.bits[i].known | 0x80000000u) != ~0u || (b.bits[i].value & 0x7FFFFFFFu) != 0) refuse("more than a sign");
        if (!(b.bits[i].known >> 31)) b.want(0x80000000u);
        if (!flips && f.range.lo < 0) throw TooLarge{"a sign for a number that may have one"};
        out.push_back(b.bits[i].value >> 31 ? negative(f) : f);
      }
      const int signed_one = node(b.word, std::move(out));
      nodes[signed_one].made = flips ? '^' : '|', nodes[signed_one].left = a.n, nodes[signed_one].step = b.step_of();
      return signed_one;
    });
    return result;
  }
#define PROVER_BOTH(op) both(a, b, [](auto x, auto y) { return x op y; })
  static Integer sum(Integer a, Integer b) {
    if (shifts_high(a, b)) {
      for (Bits& x : a.bits) x = {x.known, (x.value + b.value) & x.known, 0, ~0u};
      return a;
    }
    return numbers(a, b) ? numeric(taken_once('+', a, b, [](Float x, Float y) { return exact_sum(x, y, 1); }))
                         : PROVER_BOTH(+);
  }
  static Integer difference(Integer a, Integer b) {
    const bool beyond = is_beyond(a, b);
    if (beyond) spread(b);
    return numbers(a, b) || beyond
               ? numeric(taken_once('-', a, b, [](Float x, Float y) { return exact_sum(x, y, -1); }))
               : PROVER_BOTH(-);
  }
  static Integer product(Integer a, Integer b) {
    return numbers(a, b) ? numeric(taken_once('*', a, b, exact_product)) : PROVER_BOTH(*);
  }
  static Integer up(Integer a, Integer b) {
    if (a.word != 0 && b.is == kNumber && b.value < 32) {
      a.off = 0;  // see stepped
      Integer out(a.divided());
      for (Bits& x : out.bits) x = {~(~x.known << b.value), x.value << b.value, 0, ~0u};
      out.down -= static_cast<int>(b.value);
      return out;
    }
    if (!numbers(a, b) || b.is != kNumber || b.value >= 32) return PROVER_BOTH(<<);
    return numeric(exact_product(a.number(), Float(std::ldexp(1.0f, b.value))));
  }
  static Integer down_by(Integer a, Integer b) {
    if (!Signed && a.word != 0 && b.is == kNumber && b.value < 32) {
      const std::uint32_t most = ~0u >> b.value;
      Integer out(a.divided());
      for (Bits& x : out.bits) x = {x.known >> b.value | ~most, x.value >> b.value, 0, most};
      out.down += static_cast<int>(b.value);
      return out;
    }
    if (!numbers(a, b) || a.is == kFloat || b.is != kNumber || b.value >= 32) return PROVER_BOTH(>>);
    return numeric(shifted(a.read(), b.value));
  }
  static Integer conjunction(Integer a, Integer b) {
    if (b.is != kNumber) std::swap(a, b);
    if (numbers(a, b) && (b.value & (b.value + 1)) == 0) return numeric(low_bits(a.read(), std::popcount(b.value)));
    if (a.is == kNumber || b.is != kNumber) return PROVER_BOTH(&);
    Integer out(a.divided());
    for (Bits& x : out.bits) x = {x.known | ~b.value, x.value & b.value, 0, b.value};
    return out;
  }
  static Integer exclusive(Integer a, Integer b) {
    if (a.is == kNumber) std::swap(a, b);
    if (b.is == kNumber && b.value == 0) return a;
    if (a.is == kBits && b.is == kNumber) {
      for (Bits& x : a.bits) x = {x.known, (x.value ^ b.value) & x.known, 0, ~0u};
      return a;
    }
    return signs(a, b) ? with_sign(a, b, true) : PROVER_BOTH(^);
  }
  static Integer disjunction(Integer a, Integer b) {
    if (signs(a, b)) return with_sign(a, b, false);
    if (b.is != kNumber) std::swap(a, b);
    if (a.is != kBits || b.is != kNumber) return PROVER_BOTH(|);
    for (Bits& x : a.bits) x = {x.known | b.value, x.value | b.value, b.value, ~0u};
    return a;
  }
  // Words are made of others by steps; some depend on the sign alone.
  static Integer stepped(char op, const Integer& a, const Integer& b, Integer out) {
    const bool by_sign = op == '/' || op == '%' || op == '>';
    const bool shifts = op == '<' && b.is == kNumber && b.value < 32, numeric = out.is == kNumeric || out.is == kFloat;
    if (numeric || (op != '+' && !shifts)) a.must_be_exact(), b.must_be_exact();
    if (numeric) return out;
    if (out.is != kNumber) {
      const int step = new_step(op + by_sign * Signed * 256, a.step_of(), b.step_of());
      if (out.is == kAny) out = Integer(made_by(step));
      out.step = step;
    }
    out.off = shifts ? std::ldexp(a.off, static_cast<int>(b.value)) : a.off + b.off;
    out.modulo = std::min(shifts ? a.modulo + static_cast<int>(b.value) : std::min(a.modulo, b.modulo), 32);
    return out;
  }
#define PROVER_OPERATOR(op, result)                                                          \
  friend Integer operator op(Integer a, Integer b) { return stepped(#op[0], a, b, result); } \
  friend Integer& operator op##=(Integer& a, Integer b) { return a = a op b; }
  PROVER_OPERATOR(+, sum(a, b))
  PROVER_OPERATOR(-, difference(a, b))
  PROVER_OPERATOR(*, product(a, b))
  PROVER_OPERATOR(/, numbers(a, b) ? numeric(quotient(a.read(), b.read())) : PROVER_BOTH(/))
  PROVER_OPERATOR(%, PROVER_BOTH(%))
  PROVER_OPERATOR(<<, up(a, b))
  PROVER_OPERATOR(>>, down_by(a, b))
  PROVER_OPERATOR(&, conjunction(a, b))
  PROVER_OPERATOR(^, exclusive(a, b))
  PROVER_OPERATOR(|, disjunction(a, b))
#undef PROVER_OPERATOR
#undef PROVER_BOTH
  friend Integer operator-(Integer a) { return Integer(Native(0)) - a; }
  friend Integer& operator++(Integer& a) { return a = a + Integer(Native(1)); }

  static Mask unknown(const Integer& a, const Integer& b) {
    a.must_be_exact(), b.must_be_exact();
    const auto rounds = [](const Integer& x) {
      return (x.is == kNumeric || x.is == kFloat) && Float::at(x.n).form().rounds();
    };
    return Mask::unknown(rounds(a) || rounds(b));
  }
  static Mask compared(const Integer& a, std::uint32_t t, bool flip) {  // a < t
    Word w = a.divided();
    Mask m = Mask::make(w.word, {});
    m.step = new_step(flip ? 'G' : 'L', a.step_of(), new_step('#', static_cast<int>(t)));
    for (const Bits& x : w.bits) {
      const std::uint32_t lo = std::max(x.lo, x.value), hi = std::min(x.hi, x.value | ~x.known);
      if (lo < t && hi >= t) {
        if (a.is == kAny) want_threshold(a.word, t);
        refuse("a part of a word compared");
      }
      m.v.push_back((hi < t) != flip);
    }
    return m;
  }
  friend Mask operator<(Integer a, Integer b) {
    if (a.is == kNumber && b.is == kNumber) return Mask::of(a.native() < b.native());
    if (numbers(a, b)) return a.read() < b.read();
    if (Signed || b.is != kNumber) return unknown(a, b);
    return compared(a, b.value, false);
  }
  friend Mask operator>(Integer a, Integer b) { return b < a; }
  friend Mask operator>=(Integer a, Integer b) {
    if (a.is == kNumber && b.is == kNumber) return Mask::of(a.native() >= b.native());
    if (numbers(a, b)) return a.read() >= b.read();
    if (Signed || b.is != kNumber) return unknown(a, b);
    return compared(a, b.value, true);
  }
  friend Mask operator<=(Integer a, Integer b) { return b >= a; }
  friend Mask equal(Integer a, Integer b, bool flip) {
    if (a.is == kNumber && b.is == kNumber) return Mask::of((a.value == b.value) != flip);
    Mask m = unknown(a, b);
    if (b.is != kNumber || a.word == 0) return m;
    m.step = new_step(flip ? 'D' : 'E', a.step_of(), b.step_of());
    if (a.is != kBits) return m;
    m.word = a.word, m.v.clear();
    for (const Bits& x : a.bits) {
      if (std::popcount(~x.known) > 8) return Mask::unknown();
      if (x.known != ~0u) a.want(~x.known);
      m.v.push_back((x.value == b.value) != flip);
    }
    return m;
  }
  friend Mask operator==(Integer a, Integer b) { return equal(a, b, false); }
  friend Mask operator!=(Integer a, Integer b) { return equal(a, b, true); }
  friend Integer hn_i_select(Mask c, Integer a, Integer b) {
    if (c.word == 0 && c.v[0] >= 0) return c.v[0] ? a : b;
    if (numbers(a, b) || (c.word != 0 && a.counts() && b.counts())) return numeric(select(c, a.number(), b.number()));
    if (c.rounds) throw TooLarge{"a word by a number that rounds"};
    forget(a), forget(b), a.must_be_exact(), b.must_be_exact();
    return Integer(c.step >= 0 ? made_by(new_step('?', c.step, a.step_of(), b.step_of())) : any());
  }
  friend Integer min(Integer a, Integer b) {
    if (!Signed && a.is == kBits && b.is == kNumeric && nodes[b.n].word == a.word)
      return numeric(min(spread(a).number(), b.number()));
    if (!numbers(a, b)) return hn_i_select(b < a, b, a);
    const Float x = a.read(), y = b.read();
    if (is_of_places(x.n) && is_known(y.n)) return numeric(least_of_places(x, y));
    return numeric(is_of_one(x, y) ? least_of_one(x, y) : min(x, y));
  }
  friend Integer max(Integer a, Integer b) {
    return numbers(a, b) ? numeric(max(a.read(), b.read())) : hn_i_select(a < b, b, a);
  }
};
template <bool Signed>
Float::Float(const Integer<Signed>& i) : Float() {
  i.must_be_exact();
  if (i.is == Word::kNumber) {
    *this = Float(i.native());
  } else if (i.is == Word::kNumeric || i.is == Word::kFloat || i.is == Word::kBits) {
    const Float number = i.is == Word::kNumeric ? i.read() : i.number();
    if (nodes[number.n].lazy) {
      *this = exactly(number);
      return;
    }
    const auto rounded = [](Form x) {
      x.bits = 99;
      round(x, false);
      return x;
    };
    *this = at(once('F', number.n, 0, 0, [&] { return each(number, rounded).n; }));
  } else if (i.is == Word::kAny && i.n != 0) {  // it was a float
    *this = at(i.n);
  } else {  // anything
    Form f = constant(Signed ? 0 : 0x1p31);
    f.range = Signed ? Interval{-0x1p31, 0x1p31} : Interval{0, 0x1p32}, f.grid = 0, f.bits = 99;
    choose(f, 0x1p31);
    round(f, false);
    *this = of(f);
  }
}
using Int = Integer<true>;
using Uint = Integer<false>;

inline Float select(Mask c, Float a, Float b) {
  if (c.zero >= 0 && is_zero(a) && vanishes_with(b, c.zero)) return b;
  if (c.word == 0) {
    if (c.v[0] < 0) {
      // Rounded and exact arithmetic may take either side, or both the same one.
      const double apart = given || c.open ? 0 : (a.form().range - b.form().range).size();
      Form f = joined({a.form(), b.form()});
      if (apart > 0) f.terms.push_back({symbol(kError, {-apart, apart}), {1, 1}});
      return given ? made(Float::of(f), 'o', a, b) : Float::of(f);
    }
    return c.v[0] ? a : b;
  }
  // Per class; numbers of other words are joined.
  return Float::at(once('?', a.n, b.n, c.step, [&] {
    const auto of = [&](Float x) { return nodes[x.n].word == c.word ? x.n : joined_node(x.n); };
    const int x = of(a), y = of(b);
    Vector<Form> out;
    out.reserve(c.v.size());
    for (size_t i = 0; i < c.v.size(); ++i) {
      const int n = c.v[i] ? x : y;
      out.push_back(nodes[n].forms[nodes[n].word ? i : 0]);
    }
    const Float f = made(Float::at(node(c.word, std::move(out))), '?', a, b);
    nodes[f.n].step = c.step;
    return f.n;
  }));
}
inline Float hn_i_select(Mask c, Float a, Float b) { return select(c, a, b); }
inline bool hn_i_to_bool(Mask m) { return bool(m); }
inline bool hn_i_any(Mask m) { return bool(m); }
inline Int hn_i_select_int(Mask c, Int a, Int b) { return hn_i_select(c, a, b); }

inline Uint floatBitsToUint(Float x) {
  double known = 0;
  if (is_constant(x, &known) && static_cast<double>(static_cast<float>(known)) == known)
    return std::bit_cast<std::uint32_t>(static_cast<float>(known));
  Uint w;
  w.is = Word::kFloat;
  w.n = x.n;
  return w;
}
inline int of_bits(const Uint& w) {
  Vector<Form> out;
  for (const Bits& x : w.bits) {
    const std::uint32_t open = ~x.known;
    const int divided = std::popcount(w.wanted() & 0x007FFFFFu & -(open & -open));
    if (open == 0) {
      out.push_back(constant(std::bit_cast<float>(x.value)));
    } else if (std::popcount(open) + divided <= 4 || (open & 0xFF800000u) != 0) {
      w.want(open);
    } else if (divided < split && std::popcount(division(w.word).bits) < 9) {
      const std::uint32_t bit = std::bit_floor(open);
      if (division(w.word).bits == 0) w.want(bit);
      want_bits_of_all(w.down >= 0 ? bit << w.down : bit >> -w.down);
    } else {  // a number that the hash makes, with a known exponent
      may_split |= split < kMostSplit;
      const double one = std::bit_cast<float>(x.value), other = std::bit_cast<float>(x.value | open);
      if (!std::isnormal(one) || !std::isnormal(other)) refuse("a number beyond floats");
      Form f;
      f.range = hull(point(one), point(other)), f.mid = point(middle(f.range));
      f.grid = std::ilogb(one) - 23 + std::countr_zero((open | x.value) & 0x7FFFFF);
      const double half = reach(f.range, f.mid.lo);
      f.terms = {{symbol(kChoice, {-half, half}), {1, 1}}};
      out.push_back(f);
    }
  }
  const Float f = out.size() == 1 ? Float::of(out[0]) : Float::at(node(w.word, std::move(out)));
  nodes[f.n].made = 'U', nodes[f.n].step = w.step;
  return f.n;
}
inline Float uintBitsToFloat(Uint w) {
  if (w.is == Word::kFloat) return Float::at(w.n);
  w.must_be_exact();
  if (w.is == Word::kNumber) return Float(std::bit_cast<float>(w.value));
  if (w.is == Word::kAny) {  // a finite argument
    if (w.step < 0 || steps[w.step].op != 'A') refuse("a float of any bits");
    return Float::at(once('A', w.step, 0, 0, [] {
      Form f = constant(0);
      f.range = {-0x1.fffffep127, 0x1.fffffep127}, f.grid = -149, f.bits = 24;
      choose(f, f.range.hi);
      return Float::of(f).n;
    }));
  }
  return Float::at(once('U', w.step, 0, 0, [&] { return of_bits(Uint(w.divided())); }));
}

}  // namespace hn::prover
