// Where the points of an axis are: exactly, at any size, so that the last one of a tile is followed by the first.
#pragma once

#include <cstdint>
#include <vector>

namespace hn {

struct Axis {
  std::vector<std::int32_t> cell;
  std::vector<float> f;  // the place in it, a multiple of 2^-24
  std::vector<float> p;  // the same as a float: what is nearest to cell + f
};

// Point i is at origin + i * cells / size, rounded down to a multiple of 2^-24 of a cell, where the origin and the
// cells are rounded to multiples of 2^-32. All of it is whole numbers, so every machine has the same points.
Axis axis_of(double origin, double cells, int size);

}  // namespace hn
