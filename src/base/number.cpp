#include "base/number.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hn {

std::string three_digits(double value) {
  // From here on three digits are those before the point, which the other format would write.
  if (std::fabs(value) >= 99.95) return fmt::format("{:.0f}", value);
  return fmt::format("{:#.3g}", value);
}

std::string decimals(double value, int count) {
  std::string text = fmt::format("{:.{}f}", value, count);
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

}  // namespace hn
