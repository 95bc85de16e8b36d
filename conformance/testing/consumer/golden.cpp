// The header's values with HN_FIXED, to the bit, on a system that has no hn-conform: golden FOLDER, with the golden
// files (docs/reference/formats.md). Exit status: 0 all are equal, 1 not, 2 a file cannot be read.
#define HN_ARITHMETIC HN_FIXED
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <hashnoise/hashnoise.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

using hashnoise::vec2, hashnoise::vec3, hashnoise::vec4;
using Words = std::array<std::uint32_t, 8>;  // of a row

float number(std::uint32_t word) { return hashnoise::uintBitsToFloat(word); }

// The function of a file, from the words in their order there.
constexpr std::pair<const char*, float (*)(const Words&)> kFunctions[] = {
    {"noise1d.value", [](const Words& in) { return hashnoise::hn_value(number(in[0]), in[1]); }},
    {"noise2d.perlin", [](const Words& in) { return hashnoise::hn_perlin(vec2(number(in[0]), number(in[1])), in[2]); }},
    {"noise3d.simplex",
     [](const Words& in) { return hashnoise::hn_simplex(vec3(number(in[0]), number(in[1]), number(in[2])), in[3]); }},
    {"noise4d.perlin",
     [](const Words& in) {
       return hashnoise::hn_perlin(vec4(number(in[0]), number(in[1]), number(in[2]), number(in[3])), in[4]);
     }},
    {"fbm.fbm2", [](const Words& in) {
       return hashnoise::hn_fbm(vec2(number(in[0]), number(in[1])), static_cast<int>(in[2]), number(in[3]),
                                number(in[4]), in[5]);
     }}};

// The place of this setting among the values of a row.
int place_of(const std::string& settings) {
  std::istringstream names(settings);
  std::string name;
  for (int place = -1; names >> name; ++place) {
    if (name == "lattice+fixed:fixed") return place;
  }
  throw std::runtime_error("has no values of lattice+fixed");
}

// How many values of a file differ, and how many there are.
std::pair<int, int> differences(const std::string& path, float (*function)(const Words&)) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line) && !line.starts_with("settings ")) continue;
  const int place = place_of(line);
  std::getline(file, line);   // how many rows there are
  std::pair<int, int> count;  // of wrong ones, and of all
  while (std::getline(file, line) && !line.starts_with("digest")) {
    std::istringstream row(line);
    Words in{};
    std::string word;
    for (std::uint32_t& one : in) {
      if (!(row >> word) || word == "=") break;
      one = static_cast<std::uint32_t>(std::stoul(word, nullptr, 16));
    }
    for (int i = 0; i < place; ++i) row >> word >> word;  // the value, and "="
    row >> word;
    const auto value = static_cast<double>(function(in));
    if (std::bit_cast<std::uint64_t>(value) != std::stoull(word, nullptr, 16)) ++count.first;
    ++count.second;
  }
  if (count.second == 0) throw std::runtime_error("has no rows");
  return count;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::puts("golden FOLDER");
    return 2;
  }
  std::pair<int, int> all;
  for (const auto& [name, function] : kFunctions) {
    const std::string path = std::string(arguments[1]) + "/" + name + ".golden";
    try {
      const auto [wrong, rows] = differences(path, function);
      if (wrong != 0) std::printf("%s: %d of %d values differ\n", name, wrong, rows);
      all = {all.first + wrong, all.second + rows};
    } catch (const std::exception& failure) {
      std::printf("%s: %s\n", path.c_str(), failure.what());
      return 2;
    }
  }
  std::printf("%d of %d values differ from the golden files\n", all.first, all.second);
  return all.first == 0 ? 0 : 1;
}
