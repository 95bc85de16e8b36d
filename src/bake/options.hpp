// The command line of hn-bake: what is to be baked.
#pragma once

#include <filesystem>
#include <hashnoise/field.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "grid/ranges.hpp"

namespace hn {

// Exit statuses. 0 means that the file is there.
constexpr int kNotWritten = 1;
constexpr int kBadUsage = 2;
constexpr int kNotBuilt = 4;  // an expression, by no fault of its own

enum class Format {
  png,         // 16 bits
  exr,         // floats
  f32,         // planes of floats, one for each component
  r16,         // the same of 16 bits
  ktx2,        // a texture of 16 bits
  ktx2_float,  // one of floats
};
std::string_view name_of(Format format);
inline bool has_16_bits(Format format) {
  return format == Format::png || format == Format::r16 || format == Format::ktx2;
}
inline bool is_texture(Format format) { return format == Format::ktx2 || format == Format::ktx2_float; }

enum class Layout {
  atlas,   // all slices of a volume in one picture
  slices,  // a file for each
};

// The interval of 16 bits: 0 is its least number, 65535 the greatest.
using hashnoise::grid::Interval;

// A value that GLSL computes, of the position p, in place of a function of the library.
struct Expression {
  std::string text;
  std::filesystem::path source{};  // of functions that it calls; empty for none
  std::string source_text{};       // what is there, once it was read
};

struct BakeOptions {
  std::string function;  // as it was named: a noise, or a fractal; "expression" for one
  std::optional<Expression> expression;
  hashnoise::Settings settings;
  std::vector<int> size;       // points along each axis; as many as there are dimensions
  std::vector<double> cells;   // along each axis
  std::vector<double> origin;  // the first point, in cells
  bool tile = false;           // the period is `cells`
  std::filesystem::path out;
  Format format = Format::png;
  Layout layout = Layout::atlas;
  int columns = 0;                      // slices beside each other in an atlas; 0: so that it is about a square
  std::vector<std::string> components;  // which; all if it is empty
  std::vector<Interval> ranges;         // one for all components, or one for each; empty: the documented ones
  bool normalize = false;               // what is there fills the 16 bits
  int threads = 0;                      // 0: as many as the processor has
  bool json = false;
};

// There is nothing to do: help or the version was requested, or the usage is wrong.
struct Stop {
  int status;       // of the program: 0 or kBadUsage
  std::string out;  // for the standard output
  std::string err;  // what is wrong, and what would be right
};

// Only reads the arguments. The first is the program's name.
tl::expected<BakeOptions, Stop> parse_options(int argc, const char* const* argv);

}  // namespace hn
