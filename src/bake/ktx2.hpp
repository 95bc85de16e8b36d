// Textures as KTX 2.0 files: https://registry.khronos.org/KTX/specs/2.0/ktxspec.v2.html
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bake/picture.hpp"

namespace hn {

constexpr std::size_t kMostInTexture = 4;  // components of a texel

// A texture in as many dimensions as there are sizes, one to three, of one level and without compression: its texels
// are the channels side by side, with the format of Vulkan that has just these, such as R16G16_UNORM. A channel has all
// texels, x fastest. `texts` are of ASCII, and stand there by their names.
std::string ktx2(const std::vector<std::vector<std::uint16_t>>& channels, std::span<const int> size,
                 const Texts& texts);
std::string ktx2(const std::vector<std::vector<float>>& channels, std::span<const int> size, const Texts& texts);

}  // namespace hn
