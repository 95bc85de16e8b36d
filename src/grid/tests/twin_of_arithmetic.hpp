// The exports of each arithmetic of the twin: twin_of_arithmetic.cpp is compiled once for each.
// SPDX-License-Identifier: MIT

#pragma once

#include <string_view>

#include "twin.hpp"

namespace hashnoise::twin {

template <int D, Arithmetic A>
Function<D> function_of(const Settings& settings);

#define HN_TWIN_DECLARE(A)                                    \
  template <>                                                 \
  Function<1> function_of<1, Arithmetic::A>(const Settings&); \
  template <>                                                 \
  Function<2> function_of<2, Arithmetic::A>(const Settings&); \
  template <>                                                 \
  Function<3> function_of<3, Arithmetic::A>(const Settings&); \
  template <>                                                 \
  Function<4> function_of<4, Arithmetic::A>(const Settings&);
HN_TWIN_DECLARE(kFast)
HN_TWIN_DECLARE(kPrecise)
HN_TWIN_DECLARE(kFixed)
#undef HN_TWIN_DECLARE

}  // namespace hashnoise::twin
