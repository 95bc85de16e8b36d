// These rules state what settings may be. The constructor of Field checks them, and with it the Python package, which
// also reads from here what it has to know before there is a Field. docs/guide/cpu.md has it as a table.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <hashnoise/glsl.hpp>
#include <limits>
#include <string>
#include <string_view>

namespace hashnoise::inline HN_I_NAMESPACE::grid {

struct Rule {
  std::string_view setting;
  bool is_whole;
  double least;
  double most;
  double usual;  // if it is left out
};

constexpr double kMostFloat = std::numeric_limits<float>::max();
constexpr double kMostLacunarity = 255.0;  // where positions are whole numbers: in cells, in tiles and with HN_FIXED
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();  // nothing is usual

// kSeedRule, kPeriodRule and so on; the period, the cell, the size and the wave are for each axis.
#define HN_CATALOG_SETTING(Id, name, is_whole, least, most, usual) \
  constexpr Rule k##Id##Rule = {#name, is_whole, least, most, usual};
#include "catalog.inc"

// The rules of the strength and the amplitude depend on the sum: see strength_rule.
constexpr Rule kRules[] = {
#define HN_CATALOG_SETTING(Id, ...) k##Id##Rule,
#include "catalog.inc"
};

// A number in as few digits as distinguish it from other floats.
inline std::string digits_of(double number) {
  char text[64];
  if (std::trunc(number) == number && std::abs(number) < 1e15) {
    std::snprintf(text, sizeof text, "%.0f", number);
    return text;
  }
  for (int digits = 6; digits <= 9; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    if (std::strtof(text, nullptr) == static_cast<float>(number)) break;
  }
  return text;
}

inline std::string words_of(const Rule& rule) {
  if (rule.most < kMostFloat) return "from " + digits_of(rule.least) + " to " + digits_of(rule.most);
  return rule.least > -kMostFloat ? "a finite number of " + digits_of(rule.least) + " or more" : "a finite number";
}

// The fault of a number, with the right ones; empty if it is right.
inline std::string problem_of(const Rule& rule, double number) {
  if (number >= rule.least && number <= rule.most) return {};  // false for NaN
  return std::string(rule.setting) + " is " + digits_of(number) + ", and has to be " + words_of(rule);
}

}  // namespace hashnoise::inline HN_I_NAMESPACE::grid
