// Draws the values around a point: those of a driver, those that should be, and the difference.
#pragma once

#include <string>

#include "cases/value_checks.hpp"

namespace hn {

// Pixels along each side of a picture, and where along each the point itself is.
inline constexpr std::size_t kPictureSide = 96;
inline constexpr std::size_t kMiddle = kPictureSide / 2;

// The points of a picture, from top to bottom: the first two coordinates go through a window with the point in the
// middle, the other words are the point's.
Words window_around(const Function& function, std::span<const std::uint32_t> words);
// A sentence or two for people: the window, and its greys.
std::string describe_window(const Function& function, const Words& window);

// PNG files in base64, and the factor that multiplies the difference, so that the largest is white.
struct Pictures {
  std::string got;
  std::string reference;
  std::string difference;
  double factor = 0.0;
};
// Draws the first result of the function at each point of a window.
Pictures draw_pictures(const Function& function, const Words& got, const Words& reference);

}  // namespace hn
