// GLSL of users beyond that of the library: comparisons, swizzles, arrays and matrices. own.hpp includes it.

// --- Scalars and vectors ---

template <typename V>
constexpr std::int32_t kSize = ::hashnoise::detail::kComponents<V>;

template <typename V>
auto part_of() {
  if constexpr (kSize < V >> 1) {
    return decltype(V::x){};
  } else {
    return V{};
  }
}
template <typename V>
using Part = decltype(part_of<V>());

template <typename T, std::int32_t size>
auto vector_type() {
  if constexpr (size == 2) {
    return ::hashnoise::Vector2<T>{};
  } else if constexpr (size == 3) {
    return ::hashnoise::Vector3<T>{};
  } else {
    return ::hashnoise::Vector4<T>{};
  }
}
template <typename T, std::int32_t size>
using VectorType = decltype(vector_type<T, size>());

// A component; of a scalar it is the scalar.
template <std::int32_t i, typename V>
auto& component(V& v) {
  if constexpr (kSize<std::remove_const_t<V>> == 1) {
    return v;
  } else if constexpr (i == 0) {
    return v.x;
  } else if constexpr (i == 1) {
    return v.y;
  } else if constexpr (i == 2) {
    return v.z;
  } else {
    return v.w;
  }
}

// The type that an operation has on these: that of a vector if one is, of a float if one is.
template <typename V>
constexpr std::int32_t kRank = 8 * kSize<V> + (std::is_same_v<Part<V>, float>  ? 3
                                               : std::is_same_v<Part<V>, uint> ? 2
                                                                               : std::is_same_v<Part<V>, int>);
template <typename A, typename... Rest>
auto joined_type() {
  if constexpr (sizeof...(Rest) == 0) {
    return A{};
  } else {
    using B = decltype(joined_type<Rest...>());
    if constexpr (kRank<A> < kRank<B>) {
      return B{};
    } else {
      return A{};
    }
  }
}
template <typename... A>
using Joined = decltype(joined_type<A...>());

// f of the components of each.
template <typename... A, typename F>
auto each(const F& f, const A&... a) {
  using V = Joined<A...>;
  using P = Part<V>;
  if constexpr (kSize<V> == 1) {
    return f(P(a)...);
  } else if constexpr (kSize<V> == 2) {
    return V(f(P(component<0>(a))...), f(P(component<1>(a))...));
  } else if constexpr (kSize<V> == 3) {
    return V(f(P(component<0>(a))...), f(P(component<1>(a))...), f(P(component<2>(a))...));
  } else {
    return V(f(P(component<0>(a))...), f(P(component<1>(a))...), f(P(component<2>(a))...), f(P(component<3>(a))...));
  }
}

template <typename V>
concept Changing = !std::is_arithmetic_v<V>;  // C++ has the rest
template <Changing V>
V& operator++(V& v) {
  return v = v + Part<V>(int(1));
}
template <Changing V>
V& operator--(V& v) {
  return v = v - Part<V>(int(1));
}
template <Changing V>
V operator++(V& v, std::int32_t) {
  const V before = v;
  ++v;
  return before;
}
template <Changing V>
V operator--(V& v, std::int32_t) {
  const V before = v;
  --v;
  return before;
}
template <Changing V, typename B>
requires(kSize<V> == 1) V& operator/=(V& a, const B& b) { return a = a / b; }
template <Changing V, typename B>
requires(kSize<V> == 1) V& operator%=(V& a, const B& b) { return a = a % b; }

// The library's vectors have the operators that it uses.
#define OF_VECTORS(op)                                                                              \
  template <typename A, typename B>                                                                 \
  requires((kSize<A> > 1) != (kSize<B> > 1) || (kSize<A> > 1 && kSize<A> == kSize<B>)) Joined<A, B> \
  operator op(const A& a, const B& b) {                                                             \
    return each([](const auto& x, const auto& y) { return x op y; }, a, b);                         \
  }                                                                                                 \
  template <typename A, typename B>                                                                 \
  requires(kSize<A> > 1) A& operator op##=(A& a, const B& b) { return a = a op b; }
OF_VECTORS(&)
OF_VECTORS(|)
OF_VECTORS(^)
OF_VECTORS(<<)
OF_VECTORS(>>)
OF_VECTORS(%)
#undef OF_VECTORS
template <typename A>
requires(kSize<A> > 1) A operator~(const A& a) {
  return each([](const auto& x) { return ~x; }, a);
}

// --- Comparisons: a < less > b ---

template <typename Operation, typename A, typename B>
bool compared(const A& a, const B& b) {
  using V = Joined<A, B>;
  const auto one = [](const Part<V>& x, const Part<V>& y) {
    if constexpr (std::is_same_v<Part<V>, float>) tie(x - y);
    return decided(Operation::of(x, y));
  };
  static_assert(kSize<A> == kSize<B>, "vectors of different sizes are compared");
  bool all = true;
  const auto take = [&](const Part<V>& x, const Part<V>& y) {
    all = one(x, y) && all;
    return x;
  };
  each(take, V(a), V(b));
  return all;
}
#define COMPARISON(Name, name, left, right, op)                   \
  struct Name {                                                   \
    template <typename X>                                         \
    static auto of(const X& x, const X& y) {                      \
      return x op y;                                              \
    }                                                             \
    template <typename A>                                         \
    struct Left {                                                 \
      A a;                                                        \
      template <typename B>                                       \
      friend bool operator right(const Left& left_, const B& b) { \
        return compared<Name>(left_.a, b);                        \
      }                                                           \
    };                                                            \
    template <typename A>                                         \
    friend Left<A> operator left(const A& a, Name) {              \
      return {a};                                                 \
    }                                                             \
  };                                                              \
  constexpr Name name{};
COMPARISON(Less, less, <, >, <)
COMPARISON(Greater, greater, >, <, >)
COMPARISON(AtMost, at_most, <=, >=, <=)
COMPARISON(AtLeast, at_least, >=, <=, >=)
COMPARISON(Same, same, ==, ==, ==)
#undef COMPARISON
struct Different {
  template <typename A>
  struct Left {
    A a;
    template <typename B>
    friend bool operator!=(const Left& left, const B& b) {
      return !compared<Same>(left.a, b);
    }
  };
  template <typename A>
  friend Left<A> operator!=(const A& a, Different) {
    return {a};
  }
};
constexpr Different different{};

// --- Swizzles ---

template <std::int32_t... axes, typename V>
auto swizzled(const V& v) {
  return VectorType<Part<V>, sizeof...(axes)>(component<axes>(v)...);
}

// Components of a vector that are written.
template <typename V, std::int32_t... axes>
struct Swizzle {
  using Value = VectorType<Part<V>, sizeof...(axes)>;
  V& v;
  operator Value() const { return swizzled<axes...>(v); }
  Swizzle& operator=(const Value& value) {
    set(value, std::make_integer_sequence<std::int32_t, sizeof...(axes)>{});
    return *this;
  }
  template <typename B>
  Swizzle& operator+=(const B& b) {
    return *this = swizzled<axes...>(v) + b;
  }
  template <typename B>
  Swizzle& operator-=(const B& b) {
    return *this = swizzled<axes...>(v) - b;
  }
  template <typename B>
  Swizzle& operator*=(const B& b) {
    return *this = swizzled<axes...>(v) * b;
  }
  template <typename B>
  Swizzle& operator/=(const B& b) {
    return *this = swizzled<axes...>(v) / b;
  }

 private:
  template <std::int32_t... i>
  void set(const Value& value, std::integer_sequence<std::int32_t, i...>) {
    ((component<axes>(v) = component<i>(value)), ...);
  }
};
template <std::int32_t... axes, typename V>
Swizzle<V, axes...> swizzle(V& v) {
  return {v};
}

// --- Arrays and matrices ---

template <typename T, std::int32_t size>
struct Array {
  T element[size]{};
  Array() = default;
  template <typename... A>
  requires(sizeof...(A) == size &&
           !(sizeof...(A) == 1 && (std::is_same_v<A, Array> && ...))) explicit Array(const A&... a)
      : element{T(a)...} {}
  int length() const { return int(size); }
};

template <std::int32_t size>
struct Matrix {
  using V = VectorType<float, size>;
  V column[size];

  Matrix() = default;
  explicit Matrix(const float& x) {
    for (std::int32_t i = 0; i < size; ++i) number(i, i) = x;
  }
  template <std::int32_t other>
  explicit Matrix(const Matrix<other>& m) : Matrix(float(1.0_f)) {
    for (std::int32_t i = 0; i < std::min(size, other); ++i) {
      for (std::int32_t k = 0; k < std::min(size, other); ++k) number(i, k) = m.number(i, k);
    }
  }
  template <typename... A>
  requires(sizeof...(A) > 1 && (kSize<A> + ...) == size * size) explicit Matrix(const A&... a) {
    std::int32_t count = 0;
    const auto take = [&](const auto& x) {
      number(count / size, count % size) = float(x);
      ++count;
      return x;
    };
    (each(take, a), ...);
  }
  float& number(std::int32_t of, std::int32_t row) { return component_at(column[of], row); }
  const float& number(std::int32_t of, std::int32_t row) const { return component_at(column[of], row); }

  friend V operator*(const Matrix& m, const V& v) {
    V sum = m.column[0] * component<0>(v);
    for (std::int32_t i = 1; i < size; ++i) sum += m.column[i] * component_at(v, i);
    return sum;
  }
  friend V operator*(const V& v, const Matrix& m) {
    V product{};
    for (std::int32_t i = 0; i < size; ++i) component_at(product, i) = dot_of(v, m.column[i]);
    return product;
  }
  friend Matrix operator*(const Matrix& a, const Matrix& b) {
    return of([&](std::int32_t i) { return a * b.column[i]; });
  }
  friend Matrix operator*(const Matrix& m, const float& x) {
    return of([&](std::int32_t i) { return m.column[i] * x; });
  }
  friend Matrix operator*(const float& x, const Matrix& m) { return m * x; }
  friend Matrix operator/(const Matrix& m, const float& x) {
    return of([&](std::int32_t i) { return m.column[i] / x; });
  }
  friend Matrix operator+(const Matrix& a, const Matrix& b) {
    return of([&](std::int32_t i) { return a.column[i] + b.column[i]; });
  }
  friend Matrix operator-(const Matrix& a, const Matrix& b) {
    return of([&](std::int32_t i) { return a.column[i] - b.column[i]; });
  }
  friend Matrix operator-(const Matrix& m) {
    return of([&](std::int32_t i) { return -m.column[i]; });
  }
  friend Matrix& operator+=(Matrix& a, const Matrix& b) { return a = a + b; }
  friend Matrix& operator-=(Matrix& a, const Matrix& b) { return a = a - b; }
  template <typename B>
  friend Matrix& operator*=(Matrix& a, const B& b) {
    return a = a * b;
  }

  template <typename F>
  static Matrix of(const F& f) {
    Matrix m;
    for (std::int32_t i = 0; i < size; ++i) m.column[i] = f(i);
    return m;
  }
  template <typename U>
  static auto& component_at(U& v, std::int32_t i) {
    if (i == 0) return v.x;
    if constexpr (size > 2) {
      if (i == 2) return v.z;
    }
    if constexpr (size > 3) {
      if (i == 3) return v.w;
    }
    return v.y;
  }
  static float dot_of(const V& a, const V& b) {
    float sum = a.x * b.x + a.y * b.y;
    if constexpr (size > 2) sum += a.z * b.z;
    if constexpr (size > 3) sum += a.w * b.w;
    return sum;
  }
};
using mat2 = Matrix<2>;
using mat3 = Matrix<3>;
using mat4 = Matrix<4>;

// An element of an array, a column or a component, by an index of the leader's lane. One beyond the ends counts as the
// end.
template <typename T, std::int32_t size>
auto& element(Array<T, size>& a, std::int32_t i) {
  return a.element[std::clamp(i, 0, size - 1)];
}
template <std::int32_t size>
auto& element(Matrix<size>& m, std::int32_t i) {
  return m.column[std::clamp(i, 0, size - 1)];
}
template <typename V>
requires(kSize<V> > 1) auto& element(V& v, std::int32_t i) {
  return Matrix<kSize<V>>::component_at(v, std::clamp(i, 0, kSize<V> - 1));
}
template <typename A, typename I>
auto& at(A& a, const I& i) {
  return element(a, whole(i));
}
template <typename A, typename I>
const auto& at(const A& a, const I& i) {
  return element(const_cast<A&>(a), whole(i));
}
template <typename A, typename I>
auto at(const A&& a, const I& i) {
  return element(const_cast<A&>(a), whole(i));
}
