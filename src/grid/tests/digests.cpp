// Prints a digest of every noise and every sum in HN_PRECISE and HN_FIXED, by the instructions that are named or by the
// widest. It is the same on every processor. With --list it prints which instructions there are, the widest first.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <hashnoise/field.hpp>
#include <string>
#include <string_view>

namespace {

std::optional<hashnoise::InstructionSet> wanted;

// FNV-1a of the words of all values.
std::uint64_t digest_of(std::span<const float> values, std::uint64_t digest) {
  for (const float value : values) digest = (digest ^ hashnoise::floatBitsToUint(value)) * 0x100000001B3u;
  return digest;
}

template <int D>
void print(hashnoise::Settings settings) {
  settings.instruction_set = wanted;
  settings.seed = 7;
  const hashnoise::Field<D> field(settings);
  constexpr std::array<float, 4> kOrigin = {-3.3f, 1000.25f, 0.0f, -7.75f};
  constexpr std::array<float, 4> kStep = {0.0371f, -0.11f, 0.7f, 1.3f};
  constexpr std::array<int, 4> kSize = {67, 5, 3, 2};
  hashnoise::Grid<D> grid;
  hashnoise::CellGrid<D> cells;
  std::size_t points = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    grid.origin[axis] = kOrigin[axis];
    grid.step[axis] = kStep[axis];
    cells.cell[axis] = axis == 0 ? 2147483640 : -5;
    cells.f[axis] = 0.3f;
    cells.step[axis] = static_cast<double>(kStep[axis]);
    grid.size[axis] = cells.size[axis] = kSize[axis];
    points *= static_cast<std::size_t>(kSize[axis]);
  }
  std::vector<float> values(points * static_cast<std::size_t>(field.component_count()));
  field.fill(grid, values);
  std::uint64_t digest = digest_of(values, 0xCBF29CE484222325u);
  field.fill(cells, values);
  digest = digest_of(values, digest);
  std::printf("%dD %s %s %s%s %016llx\n", D, settings.arithmetic == hashnoise::Arithmetic::kFixed ? "fixed" : "precise",
              settings.noise.c_str(), settings.fractal.c_str(), settings.period[0] != 0 ? " tile" : "",
              static_cast<unsigned long long>(digest));
}

template <int D>
void print_all(hashnoise::Arithmetic arithmetic) {
  for (const std::int32_t period : {0, 5}) {
    hashnoise::Settings settings;
    settings.arithmetic = arithmetic;
    settings.period = {period, 2 * period, 0, period};
    for (const std::string_view noise : hashnoise::noises(D)) {
      settings.noise = noise;
      print<D>(settings);
    }
    settings.octaves = 3;
    for (const std::string_view sum : hashnoise::fractals(D)) {
      settings.noise.clear();
      settings.fractal = sum;
      print<D>(settings);
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count == 2 && std::string_view(arguments[1]) == "--list") {
      for (const hashnoise::InstructionSet set : hashnoise::instruction_sets()) {
        std::printf("%s\n", std::string(hashnoise::name(set)).c_str());
      }
      return 0;
    }
    if (count == 2) {
      for (const hashnoise::InstructionSet set : hashnoise::instruction_sets()) {
        if (hashnoise::name(set) == arguments[1]) wanted = set;
      }
      if (!wanted) {
        std::fprintf(stderr, "no instructions \"%s\" here\n", arguments[1]);
        return 2;
      }
    }
    for (const auto arithmetic : {hashnoise::Arithmetic::kPrecise, hashnoise::Arithmetic::kFixed}) {
      print_all<1>(arithmetic);
      print_all<2>(arithmetic);
      print_all<3>(arithmetic);
      print_all<4>(arithmetic);
    }
    return 0;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 1;
  }
}
