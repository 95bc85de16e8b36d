// The program that hn-bake makes of an expression: it computes rows and writes them. A program of its own may loop for
// ever or crash without harm to hn-bake, which reads what it writes (program.cpp has the other end).
//
//   PROGRAM                            prints how many components the expression has
//   PROGRAM AXES FIRST STEP ROWS       writes bands of so many rows to kRows: band FIRST, then each that is STEP
//   further
//
// A band has all values of each component, x fastest. AXES is a file with the cells, the places in them and the
// positions of all points along x, then of those along y and so on.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "builtins.hpp"

namespace hn_bake {

constexpr int kRows = 3;  // the file, as in hn::kReportFd
constexpr int kFailed = 1;

template <int D>
struct Point;
template <>
struct Point<1> {
  using Cell = int;
  using Position = float;
};
template <>
struct Point<2> {
  using Cell = hashnoise::ivec2;
  using Position = hashnoise::vec2;
};
template <>
struct Point<3> {
  using Cell = hashnoise::ivec3;
  using Position = hashnoise::vec3;
};
template <>
struct Point<4> {
  using Cell = hashnoise::ivec4;
  using Position = hashnoise::vec4;
};

template <typename Value>
constexpr int kComponents = 0;
template <>
inline constexpr int kComponents<float> = 1;
template <>
inline constexpr int kComponents<hashnoise::vec2> = 2;
template <>
inline constexpr int kComponents<hashnoise::vec3> = 3;
template <>
inline constexpr int kComponents<hashnoise::vec4> = 4;

// A number or a vector of those of each axis.
template <typename Vector, int D, typename Number>
Vector vector_of(const Number (&n)[D]) {
  if constexpr (D == 1) {
    return n[0];
  } else if constexpr (D == 2) {
    return {n[0], n[1]};
  } else if constexpr (D == 3) {
    return {n[0], n[1], n[2]};
  } else {
    return {n[0], n[1], n[2], n[3]};
  }
}

inline void keep(float value, float* to, long long) { to[0] = value; }
inline void keep(hashnoise::vec2 value, float* to, long long points) {
  to[0] = value.x;
  to[points] = value.y;
}
inline void keep(hashnoise::vec3 value, float* to, long long points) {
  keep(hashnoise::vec2(value.x, value.y), to, points);
  to[2 * points] = value.z;
}
inline void keep(hashnoise::vec4 value, float* to, long long points) {
  keep(hashnoise::vec3(value.x, value.y, value.z), to, points);
  to[3 * points] = value.w;
}

// The points along one axis.
struct Axis {
  int* cell;
  float* f;
  float* p;
};

template <typename T>
T* read_numbers(std::FILE* from, int count) {
  T* const numbers = static_cast<T*>(std::malloc(static_cast<std::size_t>(count) * sizeof(T)));
  const auto wanted = static_cast<std::size_t>(count);
  if (!numbers || std::fread(numbers, sizeof(T), wanted, from) != wanted) std::exit(kFailed);
  return numbers;
}

inline bool write_all(const float* values, long long count) {
  const char* at = reinterpret_cast<const char*>(values);
  for (long long left = count * static_cast<long long>(sizeof(float)); left > 0;) {
    const long long written = write(kRows, at, static_cast<std::size_t>(left));
    if (written <= 0) return false;
    at += written;
    left -= written;
  }
  return true;
}

// value(cell, f, p) at each point of a row.
template <int D, typename Function>
void compute_row(const Axis (&axes)[D], const int (&size)[D], long long row, long long points, float* to,
                 const Function& value) {
  int cell[D];
  float f[D];
  float p[D];
  for (int axis = 1; axis < D; ++axis) {
    const long long i = row % size[axis];
    row /= size[axis];
    cell[axis] = axes[axis].cell[i];
    f[axis] = axes[axis].f[i];
    p[axis] = axes[axis].p[i];
  }
  for (int x = 0; x < size[0]; ++x) {
    cell[0] = axes[0].cell[x];
    f[0] = axes[0].f[x];
    p[0] = axes[0].p[x];
    keep(value(vector_of<typename Point<D>::Cell>(cell), vector_of<typename Point<D>::Position>(f),
               vector_of<typename Point<D>::Position>(p)),
         to + x, points);
  }
}

// The program; the words are those of its command line.
template <int D, typename Function>
int run(int count, char** words, const int (&size)[D], const Function& value) {
  using Position = typename Point<D>::Position;
  using Value = decltype(value(typename Point<D>::Cell(), Position(), Position()));
  constexpr int components = kComponents<Value>;
  static_assert(components > 0, "hn-bake: the expression is no float, vec2, vec3 or vec4");
  if constexpr (components > 0) {
    if (count != 5) {
      std::printf("%d", components);
      return 0;
    }
    std::FILE* const file = std::fopen(words[1], "rb");
    if (!file) return kFailed;
    Axis axes[D];
    long long rows = 1;
    for (int axis = 0; axis < D; ++axis) {
      axes[axis].cell = read_numbers<int>(file, size[axis]);
      axes[axis].f = read_numbers<float>(file, size[axis]);
      axes[axis].p = read_numbers<float>(file, size[axis]);
      if (axis > 0) rows *= size[axis];
    }
    const long long most = std::atoll(words[4]);
    float* const values = static_cast<float*>(std::malloc(static_cast<std::size_t>(most * size[0]) * sizeof(Value)));
    if (!values) return kFailed;
    for (long long band = std::atoll(words[2]); band * most < rows; band += std::atoll(words[3])) {
      const long long first = band * most;
      const long long end = first + most < rows ? first + most : rows;
      const long long points = (end - first) * size[0];
      for (long long row = first; row < end; ++row) {
        compute_row<D>(axes, size, row, points, values + (row - first) * size[0], value);
      }
      if (!write_all(values, points * components)) return kFailed;
    }
  }
  return 0;
}

}  // namespace hn_bake
