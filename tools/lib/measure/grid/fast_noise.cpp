#include "fast_noise.hpp"

#include <dlfcn.h>

#include <array>
#include <filesystem>
#include <stdexcept>

namespace hn {
namespace {

// It numbers sets of instructions by bits, one for a family and one for each extension in it.
unsigned bits_of(hashnoise::InstructionSet set) {
  using hashnoise::InstructionSet;
  constexpr auto up_to = [](unsigned first, unsigned last) { return (2u << last) - (1u << first); };
  switch (set) {
    case InstructionSet::kSse41:
      return up_to(1, 6);
    case InstructionSet::kAvx2:
      return up_to(1, 9);
    case InstructionSet::kAvx512:
      return up_to(1, 13);
    case InstructionSet::kNeon:
      return up_to(14, 16);
    case InstructionSet::kGeneric:
      return 1u;
  }
  return 1u;
}

}  // namespace

FastNoise::FastNoise(const std::string& file) {
  // A name without a slash would be searched for elsewhere.
  void* const library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    throw std::invalid_argument("cannot load " + file + ": " + dlerror() +
                                "; it has to be the shared library of FastNoise2 (built with -DBUILD_SHARED_LIBS=ON)");
  }
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
    if (!function) throw std::invalid_argument(file + " has no function " + name + ", so it is no FastNoise2");
  };
  find(node_types_, "fnGetMetadataCount");
  find(type_name_, "fnGetMetadataName");
  find(make_, "fnNewFromMetadata");
  find(release_, "fnDeleteNodeRef");
  find(instructions_of_, "fnGetActiveFeatureSet");
  find(variables_, "fnGetMetadataVariableCount");
  find(variable_name_, "fnGetMetadataVariableName");
  find(set_float_, "fnSetVariableFloat");
  find(set_integer_, "fnSetVariableIntEnum");
  find(set_source_, "fnSetNodeLookup");
  find(grid2_, "fnGenUniformGrid2D");
  find(grid3_, "fnGenUniformGrid3D");
  find(points2_, "fnGenPositionArray2D");
  find(points3_, "fnGenPositionArray3D");
}

int FastNoise::type_named(const std::string& name) const {
  for (int type = 0; type < node_types_(); ++type) {
    if (type_name_(type) == name) return type;
  }
  throw std::runtime_error("this FastNoise2 has no node " + name);
}

void* FastNoise::made(const std::string& type, hashnoise::InstructionSet set) const {
  void* const node = make_(type_named(type), bits_of(set));
  if (!node || instructions_of_(node) == bits_of(set)) return node;
  release_(node);
  return nullptr;
}

template <typename Value>
void FastNoise::set(bool (*function)(void*, int, Value), void* node, const std::string& type, const char* variable,
                    Value value) const {
  const int number = type_named(type);
  for (int i = 0; i < variables_(number); ++i) {
    if (variable_name_(number, i) == std::string(variable) && function(node, i, value)) return;
  }
  throw std::runtime_error(type + " of FastNoise2 has no variable " + variable + " that can be set");
}

std::shared_ptr<void> FastNoise::node(const Subject& subject, hashnoise::InstructionSet instructions) const {
  const auto owned = [&](const std::string& type) {
    return std::shared_ptr<void>(made(type, instructions), [release = release_](void* node) {
      if (node) release(node);
    });
  };
  const std::shared_ptr<void> noise = owned(subject.node);
  if (!noise) return nullptr;
  // Its cells are 100 units by default, and ours are one.
  set(set_float_, noise.get(), subject.node, "Feature Scale", 1.0f);
  // The distance itself, as ours, and not its square.
  if (subject.noise == "cellular") set(set_integer_, noise.get(), subject.node, "Distance Function", 0);
  if (subject.fractal.empty()) return noise;
  const std::shared_ptr<void> sum = owned(subject.fractal);
  if (!sum) throw std::runtime_error("FastNoise2 cannot make its node " + subject.fractal);
  set(set_integer_, sum.get(), subject.fractal, "Octaves", kOctaves);
  if (!set_source_(sum.get(), 0, noise.get()))
    throw std::runtime_error(subject.fractal + " of FastNoise2 takes no source");
  return sum;  // it holds its source by itself
}

void FastNoise::fill_grid(const void* node, int dimensions, float* values) const {
  std::array<float, 2> range;  // as ours returns it
  if (dimensions == 2) {
    const auto [width, height] = grid<2>().size;
    grid2_(node, values, 0.0f, 0.0f, width, height, kStep, kStep, kSeed, range.data());
  } else {
    const auto [width, height, depth] = grid<3>().size;
    grid3_(node, values, 0.0f, 0.0f, 0.0f, width, height, depth, kStep, kStep, kStep, kSeed, range.data());
  }
}

void FastNoise::fill_points(const void* node, std::span<const std::span<const float>> positions, float* values) const {
  std::array<float, 2> range;
  const float *const x = positions[0].data(), *const y = positions[1].data();
  if (positions.size() == 2) {
    points2_(node, values, kPoints, x, y, 0.0f, 0.0f, kSeed, range.data());
  } else {
    points3_(node, values, kPoints, x, y, positions[2].data(), 0.0f, 0.0f, 0.0f, kSeed, range.data());
  }
}

}  // namespace hn
