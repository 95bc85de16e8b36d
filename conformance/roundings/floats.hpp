// Lanes of floats that round either way, one lane otherwise than the next: lanes.hpp includes it in the place of its
// own. A lane is a run of the text as some driver might do it: each operation rounds up or down, a sum of a product may
// take the product as it was before it was rounded, and a quotient or a root is further off, as GLSL allows.
//
// While they are computed the processor rounds down (sums.cpp). A result that has to round up is computed with other
// signs: -(-a - b). The bits are the same with every compiler and on every processor: what is fused is fused by
// doubles, which hold the product, and rounding down twice is rounding down once.

template <>
struct Lanes<float> {
  using Vector = detail::FloatVector;
  using Bits = detail::UintVector;
  using Doubles = detail::DoubleVector;
  Vector v;
  Vector p, q;  // the factors of a product, before it was rounded
  bool is_product = false;

  HN_I_INLINE Lanes() : v{} {}
  HN_I_INLINE explicit Lanes(Vector vector) : v(vector) {}
  template <typename T>
  requires std::is_arithmetic_v<T> HN_I_INLINE explicit(!std::same_as<float, T>) Lanes(T s) {
    const Bits bits = Bits{} + __builtin_bit_cast(std::uint32_t, static_cast<float>(s));
    v = __builtin_bit_cast(Vector, bits);
  }
  HN_I_INLINE explicit Lanes(Lanes<std::int32_t> n) {
    const Bits up = way(Bits(n.v)) & kSign;
    v = flipped(detail::converted<Vector>(flipped(detail::converted<Doubles>(n.v), up)), up);
  }
  HN_I_INLINE explicit Lanes(Lanes<std::uint32_t> n) {
    const Bits up = way(n.v) & kSign;
    // In two halves: -0x1p31 + 0x1p31 is -0 where the processor rounds down, and 0 has to be 0.
    const Doubles half = detail::converted<Doubles>(detail::IntVector(n.v >> 1u));
    const Doubles exact = half + half + detail::converted<Doubles>(detail::IntVector(n.v & 1u));
    v = flipped(detail::converted<Vector>(flipped(exact, up)), up);
  }
  HN_I_INLINE explicit Lanes(Mask mask) : v(detail::converted<Vector>(-mask.v)) {}

  HN_I_INLINE float operator[](int i) const { return v[i]; }
  HN_I_INLINE static Lanes load(const float* from) {
    Lanes lanes;
    std::memcpy(&lanes.v, from, sizeof(Vector));
    return lanes;
  }
  HN_I_INLINE void store(float* to) const { std::memcpy(to, &v, sizeof(Vector)); }

  HN_I_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) {
    const Bits way = Lanes::way(a.v, b.v), up = way & kSign;
    Lanes sum(flipped(flipped(a.v, up) + flipped(b.v, up), up));
    if (a.is_product || b.is_product) {
      const Lanes& product = a.is_product ? a : b;
      const Vector other = a.is_product ? b.v : a.v;
      const Doubles exact = detail::converted<Doubles>(flipped(product.p, up)) * detail::converted<Doubles>(product.q);
      const Vector fused = detail::converted<Vector>(exact + detail::converted<Doubles>(flipped(other, up)));
      sum.v = chosen(detail::IntVector(way << 31u) >> 31, flipped(fused, up), sum.v);
    }
    return sum;
  }
  HN_I_INLINE friend Lanes operator-(const Lanes& a) {
    Lanes minus(flipped(a.v, Bits{} + kSign));
    minus.is_product = a.is_product;
    if (a.is_product) minus.p = flipped(a.p, Bits{} + kSign), minus.q = a.q;
    return minus;
  }
  HN_I_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return a + -b; }
  HN_I_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) {
    const Bits up = way(a.v, b.v) & kSign;
    Lanes product(flipped(flipped(a.v, up) * b.v, up));
    product.p = a.v, product.q = b.v, product.is_product = true;
    return product;
  }
  HN_I_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) {  // off by 2.5 ULPs in GLSL
    const Bits up = way(a.v, b.v) & kSign;
    return off_by(flipped(flipped(a.v, up) / b.v, up), up, 2);
  }
  HN_I_INLINE friend Lanes sqrt(const Lanes& a) {  // as 1 / inversesqrt(a), which is off by 2: times a division
    Vector root;
    for (int i = 0; i < 16; ++i) root[i] = std::sqrt(a.v[i]);
    return off_by(root, way(a.v) & kSign, 5);
  }
  HN_I_INLINE friend Lanes inversesqrt(const Lanes& a) {
    Vector inverse;
    for (int i = 0; i < 16; ++i) inverse[i] = static_cast<float>(1.0 / std::sqrt(static_cast<double>(a.v[i])));
    return off_by(inverse, way(a.v) & kSign, 2);
  }
  HN_I_INLINE friend Lanes& operator+=(Lanes& a, const Lanes& b) { return a = a + b; }
  HN_I_INLINE friend Lanes& operator-=(Lanes& a, const Lanes& b) { return a = a - b; }
  HN_I_INLINE friend Lanes& operator*=(Lanes& a, const Lanes& b) { return a = a * b; }

  HN_I_LANE_COMPARISON(<)
  HN_I_LANE_COMPARISON(>)
  HN_I_LANE_COMPARISON(<=)
  HN_I_LANE_COMPARISON(>=)
  HN_I_LANE_COMPARISON(==)
  HN_I_LANE_COMPARISON(!=)

  HN_I_INLINE friend Lanes hn_i_select(Mask condition, const Lanes& a, const Lanes& b) {
    return Lanes(chosen(condition.v, a.v, b.v));
  }

 private:
  static constexpr std::uint32_t kSign = 0x80000000u;

  // For each lane a word of an operation: with the highest bit it rounds up, with the lowest it fuses.
  HN_I_INLINE static Bits way(Bits a, Bits b = Bits{}) {
    Bits words;
    std::memcpy(&words, hn::roundings::ways.of_next(a[0], b[0]), sizeof words);
    return words;
  }
  HN_I_INLINE static Bits way(Vector a, Vector b = Vector{}) {
    return way(__builtin_bit_cast(Bits, a), __builtin_bit_cast(Bits, b));
  }
  HN_I_INLINE static Vector flipped(Vector x, Bits sign) {
    return __builtin_bit_cast(Vector, __builtin_bit_cast(Bits, x) ^ sign);
  }
  HN_I_INLINE static Doubles flipped(Doubles x, Bits sign) {
    using Longs [[gnu::vector_size(sizeof(Doubles))]] = std::uint64_t;
    return __builtin_bit_cast(Doubles, __builtin_bit_cast(Longs, x) ^ __builtin_convertvector(sign, Longs) << 32u);
  }
  // So many ULPs away from 0 or toward it; 0 stays.
  HN_I_INLINE static Lanes off_by(Vector x, Bits up, int ulps) {
    const Bits bits = __builtin_bit_cast(Bits, x);
    const Bits way = Bits(detail::IntVector(bits ^ up) >> 31);  // -1 away
    const Bits moved = bits + ((Bits{} + ulps) & way) - ((Bits{} + ulps) & ~way);
    return Lanes(chosen(x != 0.0f, __builtin_bit_cast(Vector, moved), x));
  }
  // GCC makes this of ?: lane by lane, where the processor has no such vectors.
  HN_I_INLINE static Vector chosen(detail::IntVector mask, Vector x, Vector y) {
    return __builtin_bit_cast(Vector,
                              (Bits(mask) & __builtin_bit_cast(Bits, x)) | (~Bits(mask) & __builtin_bit_cast(Bits, y)));
  }
};
