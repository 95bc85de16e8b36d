// Floats of the text.
#pragma once

#include <type_traits>

#include "literal.hpp"
#include "words.hpp"

namespace hn::prover {

// The exact number may be any within half a unit of the float: the decimals may be another number's.
inline Form constant_of(Literal x) {
  const double value = static_cast<double>(x.exact);
  Form f = constant(value);
  if (x.off == 0) return f;
  f.range = f.mid = f.ends[0] = f.ends[1] = point(value) + Interval{-x.off, x.off};
  f.grid = std::ilogb(std::fabs(value) - x.off) - 23;
  f.bits = 24;
  add_error(f, {-x.off, x.off});
  return f;
}

inline std::vector<long double> literals;  // that are no floats, perhaps
struct Float {
  int n;
  Float() : Float(0.0f) {}
  template <std::same_as<float> T>
  Float(T x) : Float(whole(x)) {}
  Float(Literal x) {
    const auto found = std::find(literals.begin(), literals.end(), x.exact);
    const int number = static_cast<int>(found - literals.begin());
    if (found == literals.end()) literals.push_back(x.exact);
    n = x.off == 0 ? whole(static_cast<double>(x.exact)).n
                   : once('C', number, 0, 0, [&] { return node(0, {constant_of(x)}); });
  }
  static Float whole(double x) {  // or another number that is known
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return at(once('#', int(bits), int(bits >> 32), 0, [&] { return node(0, {constant(x)}); }));
  }
  template <typename T>
  requires std::is_integral_v<T>
  explicit Float(T x) {
    n = once('i', static_cast<int>(x), x < 0, 0, [&] {
      Form f = constant(static_cast<double>(x));
      f.bits = 99;
      round(f, false);
      return node(0, {f});
    });
  }
  template <bool Signed>
  explicit Float(const Integer<Signed>& n);
  static Float at(int n) { return std::bit_cast<Float>(n); }
  static Float of(Form f) { return at(node(0, {std::move(f)})); }
  const Form& form() const { return nodes[joined_node(n)].forms[0]; }
};

template <typename Step>
Float each(Float a, const Step& step) {
  if (nodes[a.n].lazy) a = Float::at(joined_node(a.n));
  Vector<Form> out;
  out.reserve(nodes[a.n].forms.size());
  for (size_t i = 0; i < nodes[a.n].forms.size(); ++i) out.push_back(step(nodes[a.n].forms[i]));
  return Float::at(node(nodes[a.n].word, std::move(out)));
}
// Whether x's choice of a hash is in y, too.
inline bool is_joined_in(int x, int y) {
  if (nodes[y].word != 0 || nodes[x].joined < 0) return false;
  const auto &of_x = nodes[nodes[x].joined].forms[0].terms, &of_y = nodes[y].forms[0].terms;
  return std::any_of(of_x.begin(), of_x.end(), [&](const Term& t) {
    const auto has = [&](const Term& other) { return other.symbol == t.symbol; };
    return symbols[t.symbol].kind == kChoice && std::any_of(of_y.begin(), of_y.end(), has);
  });
}
template <typename Step>
Float each(Float a, Float b, const Step& step) {
  int x = nodes[a.n].lazy ? joined_node(a.n) : a.n, y = nodes[b.n].lazy ? joined_node(b.n) : b.n;
  // Then the same symbol stands for that.
  if (is_joined_in(x, y)) x = nodes[x].joined;
  if (is_joined_in(y, x)) y = nodes[y].joined;
  if (nodes[x].word != nodes[y].word && nodes[x].word != 0 && nodes[y].word != 0)
    x = joined_node(x), y = joined_node(y);
  const int word = std::max(nodes[x].word, nodes[y].word);
  const size_t count = std::max(nodes[x].forms.size(), nodes[y].forms.size());
  Vector<Form> out;
  out.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    out.push_back(step(nodes[x].forms[nodes[x].word ? i : 0], nodes[y].forms[nodes[y].word ? i : 0]));
  }
  return Float::at(node(word, std::move(out)));
}
inline bool is_constant(Float a, double* x) {
  const Node& n = nodes[a.n];
  *x = n.forms[0].range.lo;
  return n.word == 0 && !n.lazy && n.forms[0].terms.empty() && n.forms[0].range.lo == n.forms[0].range.hi;
}
inline void only_leaf(int n, std::initializer_list<int> from) {
  int leaf = -1;
  for (int x : from) {
    const int other = nodes[x].word != 0                                        ? -2
                      : nodes[x].leaf == -1 && !nodes[x].forms[0].terms.empty() ? -2
                                                                                : nodes[x].leaf;
    leaf = leaf == -1 || leaf == other ? other : other == -1 ? leaf : -2;
  }
  nodes[n].leaf = leaf;
}
inline Float made(Float f, char how, Float a) {
  nodes[f.n].made = how, nodes[f.n].left = a.n;
  return f;
}
inline Float made(Float f, char how, Float a, Float b) {
  nodes[f.n].made = how, nodes[f.n].left = a.n, nodes[f.n].right = b.n;
  only_leaf(f.n, {a.n, b.n});
  return f;
}
// Whether `product` is t (b - a), and all of them are numbers without alternatives, or were joined.
inline bool interpolates(Float a, Float product, int& b, int& t, int& difference) {
  const Node& p = nodes[product.n];
  if (p.made != '*' || p.word != 0) return false;
  for (const auto [x, y] : {std::pair(p.left, p.right), std::pair(p.right, p.left)}) {
    const Node& d = nodes[y];
    if (d.made == '-' && d.right == a.n && d.word == 0) {
      difference = y, b = joined_node(d.left), t = joined_node(x);
      return true;
    }
  }
  return false;
}
Float with_powers(Float f, char how, Float a, Float b);
bool is_counted(Float a, Float b, char how);
Float exactly(Float f);
Float exact_sum(Float a, Float b, double sign);
Float exact_product(Float a, Float b);
inline Float new_sum(Float a, Float b, double sign);
inline Float sum(Float a, Float b, double sign) {
  if (is_counted(a, b, '+')) return exactly(exact_sum(a, b, sign));
  const char how = sign > 0 ? '+' : '-';
  return Float::at(once(how, a.n, b.n, 0, [&] {
    const int n = new_sum(a, b, sign).n;
    if (nodes[n].made == 0 && n != a.n) nodes[n].made = how, nodes[n].left = a.n, nodes[n].right = b.n;
    return n;
  }));
}
inline Float new_sum(Float a, Float b, double sign) {
  if (double zero = 1; is_constant(b, &zero) && zero == 0) return a;
  if (sign < 0 && nodes[b.n].made == 'T' && nodes[b.n].left == a.n) {  // a float without its whole part is a float
    Form f = constant(0);
    f.range = {-1, 1}, f.grid = -149, f.bits = 24;
    choose(f, 1);
    if (a.form().rounds()) add_error(f, {-2, 2}), f.range = {-1, 1};
    return made(Float::of(f), '%', a);
  }
  int to = 0, t = 0, apart = 0;
  if (sign > 0 && interpolates(a, b, to, t, apart)) {
    Form f = between(a.form(), nodes[to].forms[0], nodes[t].forms[0], nodes[apart].forms[0], b.form());
    round(f, false);
    return Float::of(f);
  }
  double more = 0;
  for (int swap = 0; swap < 2 && sign > 0; ++swap, std::swap(a, b)) {  // t (b - a) + (a + constant)
    if (nodes[b.n].made != '+' || !is_constant(Float::at(nodes[b.n].right), &more)) continue;
    const Node n = nodes[b.n];
    if (!interpolates(Float::at(n.left), a, to, t, apart)) continue;
    const Vector<Form>& of_left = nodes[n.left].forms;
    const auto is_exact = [](const Form& sum, const Form& x) {  // it has no symbol of its own
      return sum.terms.empty() || (!x.terms.empty() && sum.terms.back().symbol <= x.terms.back().symbol);
    };
    if (!std::equal(n.forms.begin(), n.forms.end(), of_left.begin(), of_left.end(), is_exact)) continue;
    Form f = between(nodes[joined_node(n.left)].forms[0], nodes[to].forms[0], nodes[t].forms[0], nodes[apart].forms[0],
                     a.form());
    f = plus(f, constant(more), 1);
    round(f, false);
    return Float::of(f);
  }
  const Float f = made(each(a, b,
                            [&](const Form& x, const Form& y) {
                              Form f = a.n == b.n && sign > 0 && x.fused < 0 ? times(x, constant(2)) : plus(x, y, sign);
                              round(f, false);
                              if (sign > 0 && x.range.lo >= 0 && y.range.lo >= 0)
                                f.range.lo = std::max(f.range.lo, 0.0);
                              return f;
                            }),
                       sign > 0 ? '+' : '-', a, b);
  return with_powers(f, sign > 0 ? '+' : '-', a, b);
}
inline Float operator+(Float a, Float b) { return sum(a, b, 1); }
inline Float operator-(Float a, Float b) { return sum(a, b, -1); }
inline Float operator*(Float a, Float b) {
  if (is_counted(a, b, '*')) return exactly(exact_product(a, b));
  return Float::at(once('*', a.n, b.n, 0, [&] {
    const Float f = made(each(a, b,
                              [&](const Form& x, const Form& y) {
                                Form f = times(x, y);
                                if (a.n == b.n) f.range.lo = std::max(f.range.lo, 0.0);
                                round(f, true);
                                return f;
                              }),
                         '*', a, b);
    return with_powers(f, '*', a, b).n;
  }));
}
inline Float operator-(Float a) {
  if (nodes[a.n].lazy) return a * Float(-1.0f);
  return Float::at(once('~', a.n, 0, 0, [&] { return made(each(a, negative), '~', a).n; }));
}
inline Float& operator+=(Float& a, Float b) { return a = a + b; }
inline Float& operator-=(Float& a, Float b) { return a = a - b; }
inline Float& operator*=(Float& a, Float b) { return a = a * b; }
inline Float abs(Float a) {
  const auto absolute = [](const Form& x) {
    if (x.range.lo >= 0) return x;
    if (x.range.hi <= 0) return negative(x);
    const double least = std::max(0.0, std::max(x.mid.lo, -x.mid.hi));
    return either(x, negative(x), {0, x.range.size()}, {least, x.mid.size()});
  };
  return Float::at(once('a', a.n, 0, 0, [&] { return made(each(a, absolute), 'a', a).n; }));
}
Float max(Float a, Float b);
Float min(Float a, Float b);
Float sqrt(Float a);
Float operator/(Float a, Float b);
// One of two whole numbers, the larger from `hi` on.
inline Float one_of(char how, Float a, double lo, double hi) {
  const auto key = step_key(lo >= 0 ? 'f' : how, a.n, 0);
  const auto found = same.find(key);
  if (found != same.end()) return Float::at(found->second);
  if (hi > lo + 1) throw TooLarge{"more than two whole numbers"};
  const Form less = plus(a.form(), constant(lo < 0 && how == 't' ? lo : hi), -1);
  if (hi > lo && !less.rounds()) cut(less);
  const Float f = Float::whole(hi > lo && taken(2, less) ? hi : lo);
  same[key] = f.n;
  return f;
}
// Whether it is one of several whole numbers, by conditions that are not known. Then each is a path.
inline bool are_whole(int n, std::vector<double>& all) {
  if (nodes[n].made == 'o') return are_whole(nodes[n].left, all) && are_whole(nodes[n].right, all);
  double x = 0.5;
  const bool is_whole = is_constant(Float::at(n), &x) && x == std::trunc(x);
  all.push_back(x);
  return is_whole;
}
inline bool is_one_of_several(Float a, double* which) {
  std::vector<double> all;
  if (nodes[a.n].made != 'o' || !are_whole(a.n, all)) return false;
  if (last_common == 0) last_common = last_word;
  const auto [found, is_new] = same.try_emplace(step_key('o', a.n, 0), 0);
  if (is_new) found->second = taken(static_cast<int>(all.size()));
  *which = all[found->second];
  return true;
}
inline Float floor(Float a) {
  Form cells;
  Interval rest;
  if (!in_cells(a.form(), &cells, &rest)) {
    const Interval x = a.form().range;
    return one_of('f', a, std::floor(x.lo), std::floor(x.hi));
  }
  const auto key = step_key('f', a.n, 0);
  if (const auto found = same.find(key); found != same.end()) return Float::at(found->second);
  double whole = std::floor(rest.lo);
  if (std::floor(rest.hi) > whole) {
    const Float part = Float::of(plus(a.form(), cells, -1));
    whole = one_of('f', part, whole, std::floor(rest.hi)).form().range.lo;
  }
  const Float f = Float::of(plus(cells, constant(whole), 1));
  same[key] = f.n;
  return f;
}
inline Float trunc(Float a) {
  Form f = a.form();
  const Interval error = f.error() + Interval{-1, 1};
  const bool by_hash = decided_by_hash(f);
  if (by_hash ? f.range.size() < 0x1p24 : kFixed) return one_of('t', a, std::trunc(f.range.lo), std::trunc(f.range.hi));
  f = constant(0), f.grid = 0, f.bits = 24;
  f.range = {std::trunc(a.form().range.lo), std::trunc(a.form().range.hi)};
  return Float::at(once('T', a.n, 0, 0, [&] {
    const Interval range = f.range;
    choose(f, range.size());
    if (!by_hash) add_error(f, error), f.range = range;
    return made(Float::of(f), 'T', a).n;
  }));
}
// Whether a < b is wrong since b is the largest of a and of numbers that are less than b, or likewise the other way.
inline bool is_extreme(int a, int b, char how) {
  const Node& n = nodes[how == 'M' ? b : a];
  const int extreme = how == 'M' ? b : a, other = how == 'M' ? a : b;
  bool is_in = false;
  const auto all_beyond = [&](int m, const auto& again) -> bool {
    if (m == other) return is_in = true;
    if (nodes[m].made == how) return again(nodes[m].left, again) && again(nodes[m].right, again);
    const auto known = same.find(how == 'M' ? step_key('<', m, extreme) : step_key('<', extreme, m));
    return known != same.end() && known->second != 0;
  };
  return n.made == how && all_beyond(n.left, all_beyond) && all_beyond(n.right, all_beyond) && is_in;
}
inline Mask operator<(Float a, Float b) {
  const Interval x = a.form().range, y = b.form().range;
  if (x.hi < y.lo || x.lo >= y.hi || a.n == b.n) return Mask::of(x.hi < y.lo);
  const Form less = plus(a.form(), b.form(), -1);
  for (const Term& t : less.terms) {  // a hash decides: few texts choose by that
    if (symbols[t.symbol].kind == kChoice) return Mask::unknown(less.rounds());
  }
  const auto key = step_key('<', a.n, b.n);
  if (!same.count(key)) {
    if (!less.rounds()) cut(less);
    const bool is_wrong = is_extreme(a.n, b.n, 'M') || is_extreme(a.n, b.n, 'n');
    if (!kFixed && !is_wrong && !less.rounds() && decided >= kMostDecisions) return Mask::either(key);
    same[key] = is_wrong ? 0 : taken(2, less);
  }
  return Mask::of(same[key] != 0);
}
inline Mask operator>(Float a, Float b) { return b < a; }
inline Mask operator<=(Float a, Float b) { return !(b < a); }
inline Mask operator>=(Float a, Float b) { return !(a < b); }
inline bool is_zero(Float a) {
  double x = 1;
  return is_constant(a, &x) && x == 0;
}
inline Mask operator==(Float a, Float b) {
  Mask m = Mask::unknown(a.form().rounds() || b.form().rounds());
  if (is_zero(b)) m.zero = a.n;
  return m;
}
// Whether a number is 0 wherever that node is, rounded or not: its negative, or a multiple.
inline bool vanishes_with(Float a, int n) {
  const Node& x = nodes[a.n];
  double factor = 0;
  return x.left == n && (x.made == '~' || (x.made == '*' && is_constant(Float::at(x.right), &factor)));
}

}  // namespace hn::prover
