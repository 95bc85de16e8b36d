// The functions whose costs are published by device.
#pragma once

#include <array>
#include <string_view>

namespace hn {

// They take a position on the plane: those of other dimensions are measured in another way (bench/).
inline constexpr std::array<std::string_view, 6> kTimed = {"fbm.fbm2",        "noise2d.cellular", "noise2d.perlin",
                                                           "noise2d.simplex", "noise2d.value",    "warp.warp2"};

}  // namespace hn
