// Finds where a point lies along an axis, for checks that compare it with its neighbours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "expected/points.hpp"
#include "library/functions.hpp"

namespace hn {

// A cell, and where in it. Fractions are multiples of 2^-16, and the cells of positions lie within 64 or 1,024 of the
// origin, so that floats hold both.
struct Place {
  std::uint32_t cell;
  double fraction;  // in [0, 1], both ends included
};

// Cells anywhere for a function that takes them, else of a position less than `furthest` from the origin.
std::uint32_t random_cell_of(const Function& function, std::uint32_t furthest, Random& random);

// Some way on, in the cell where that is. A place that does not leave its cell keeps it, also at the far end.
Place moved(const Place& place, double by);

// Writes a place into the words of a point.
void put(const Function& function, std::span<std::uint32_t> words, std::size_t axis, const Place& place);

}  // namespace hn
