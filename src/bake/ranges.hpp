// The ranges that the functions document: what 16 bits stand for if nobody says otherwise.
#pragma once

#include "grid/ranges.hpp"

namespace hn {

using hashnoise::grid::documented_range;

}  // namespace hn
