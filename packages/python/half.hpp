// Floats of 16 bits, as IEEE 754 has them: binary16.
// SPDX-License-Identifier: MIT

#pragma once

#include <bit>
#include <cstdint>

namespace hashnoise::python {

// The nearest, and of two that are as near the even one, as NumPy converts. A value that is too large becomes infinite.
inline std::uint16_t half_of(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t sign = (bits >> 16u) & 0x8000u;
  const std::uint32_t size = bits & 0x7FFFFFFFu;
  // All of these are computed, so that compilers vectorize a loop over it. Rounding up may carry into the exponent.
  const std::uint32_t usual = (size - 0x38000000u + 0x0FFFu + ((size >> 13u) & 1u)) >> 13u;
  // Less than 2^-14: a multiple of 2^-24. Beside 0.5 a float has steps of 2^-24, so the sum is rounded to one.
  const std::uint32_t small = std::bit_cast<std::uint32_t>(std::bit_cast<float>(size) + 0.5f) - 0x3F000000u;
  const std::uint32_t large = size > 0x7F800000u ? 0x7E00u : 0x7C00u;  // 2^16 or more, or no number
  const std::uint32_t half = size < 0x38800000u ? small : usual;
  return static_cast<std::uint16_t>(sign | (size >= 0x47800000u ? large : half));
}

}  // namespace hashnoise::python
