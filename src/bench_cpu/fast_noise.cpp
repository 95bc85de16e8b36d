#include "bench_cpu/fast_noise.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <string_view>

#include "base/text.hpp"

namespace hn {

// Its functions have C linkage. Nodes are pointers that it hands out and takes back; names are those that its editor
// shows. Functions that set something return whether they could.
struct FastNoiseFunctions {
  void* library = nullptr;
  int (*node_types)() = nullptr;
  const char* (*type_name)(int type) = nullptr;
  void* (*make)(int type, unsigned instructions) = nullptr;
  void (*release)(void* node) = nullptr;
  unsigned (*instructions_of)(const void* node) = nullptr;
  int (*variables)(int type) = nullptr;
  const char* (*variable_name)(int type, int variable) = nullptr;
  bool (*set_float)(void* node, int variable, float value) = nullptr;
  bool (*set_integer)(void* node, int variable, int value) = nullptr;
  bool (*set_source)(void* node, int input, const void* source) = nullptr;
  void (*grid2)(const void* node, float* out, float x, float y, int width, int height, float step_x, float step_y,
                int seed, float* least_and_greatest) = nullptr;
  void (*grid3)(const void* node, float* out, float x, float y, float z, int width, int height, int depth, float step_x,
                float step_y, float step_z, int seed, float* least_and_greatest) = nullptr;
  void (*points2)(const void* node, float* out, int count, const float* x, const float* y, float shift_x, float shift_y,
                  int seed, float* least_and_greatest) = nullptr;
  void (*points3)(const void* node, float* out, int count, const float* x, const float* y, const float* z,
                  float shift_x, float shift_y, float shift_z, int seed, float* least_and_greatest) = nullptr;

  FastNoiseFunctions() = default;
  FastNoiseFunctions(const FastNoiseFunctions&) = delete;
  FastNoiseFunctions& operator=(const FastNoiseFunctions&) = delete;
  ~FastNoiseFunctions() {
    if (library) dlclose(library);
  }
};

namespace {

constexpr int kSeed = 7;

// It numbers sets of instructions by bits, one for a family and one for each extension in it.
unsigned instructions_of(hashnoise::InstructionSet set) {
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

template <typename Function>
Result<void> find(void* library, const std::filesystem::path& path, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function) return {};
  return fail(fmt::format("--against: {} has no function {}, so it is no FastNoise2 with its C interface",
                          path.string(), name));
}

int type_named(const FastNoiseFunctions& functions, std::string_view name) {
  const int count = functions.node_types();
  for (int type = 0; type < count; ++type) {
    if (functions.type_name(type) == name) return type;
  }
  return -1;
}

int variable_named(const FastNoiseFunctions& functions, int type, std::string_view name) {
  const int count = functions.variables(type);
  for (int variable = 0; variable < count; ++variable) {
    if (functions.variable_name(type, variable) == name) return variable;
  }
  return -1;
}

Result<int> type_of(const FastNoiseFunctions& functions, const std::string& name) {
  const int type = type_named(functions, name);
  if (type >= 0) return type;
  return fail(fmt::format("--against: this FastNoise2 has no node {}", name));
}

Error cannot_set(std::string_view variable, std::string_view node) {
  return {fmt::format("--against: {} of FastNoise2 has no variable {} that can be set", node, variable), {}};
}

Result<void> set_float(const FastNoiseFunctions& functions, void* node, int type, const std::string& node_name,
                       const char* name, float value) {
  const int variable = variable_named(functions, type, name);
  if (variable >= 0 && functions.set_float(node, variable, value)) return {};
  return tl::unexpected(cannot_set(name, node_name));
}

Result<void> set_integer(const FastNoiseFunctions& functions, void* node, int type, const std::string& node_name,
                         const char* name, int value) {
  const int variable = variable_named(functions, type, name);
  if (variable >= 0 && functions.set_integer(node, variable, value)) return {};
  return tl::unexpected(cannot_set(name, node_name));
}

}  // namespace

FastNoiseField::FastNoiseField(std::shared_ptr<const FastNoiseFunctions> functions, std::vector<void*> nodes)
    : functions_(std::move(functions)), nodes_(std::move(nodes)) {}

FastNoiseField::~FastNoiseField() {
  for (void* const node : nodes_) functions_->release(node);
}

void FastNoiseField::fill_grid(int dimensions, std::span<float> values) const {
  float* const out = values.data();
  std::array<float, 2> range;  // as ours returns it
  if (dimensions == 2) {
    const auto [width, height] = grid<2>().size;
    functions_->grid2(nodes_.front(), out, 0.0f, 0.0f, width, height, kStep, kStep, kSeed, range.data());
  } else {
    const auto [width, height, depth] = grid<3>().size;
    functions_->grid3(nodes_.front(), out, 0.0f, 0.0f, 0.0f, width, height, depth, kStep, kStep, kStep, kSeed,
                      range.data());
  }
}

void FastNoiseField::fill_points(std::span<const std::span<const float>> positions, std::span<float> values) const {
  const int count = static_cast<int>(values.size());
  std::array<float, 2> range;
  if (positions.size() == 2) {
    functions_->points2(nodes_.front(), values.data(), count, positions[0].data(), positions[1].data(), 0.0f, 0.0f,
                        kSeed, range.data());
  } else {
    functions_->points3(nodes_.front(), values.data(), count, positions[0].data(), positions[1].data(),
                        positions[2].data(), 0.0f, 0.0f, 0.0f, kSeed, range.data());
  }
}

Result<FastNoise> FastNoise::open(const std::filesystem::path& path) {
  auto functions = std::make_shared<FastNoiseFunctions>();
  // A name without a slash would be searched for elsewhere.
  const std::filesystem::path absolute = std::filesystem::absolute(path);
  functions->library = dlopen(absolute.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!functions->library) {
    return fail(
        fmt::format("--against: cannot load {}: {}; it wants the shared library of FastNoise2 (built with "
                    "-DBUILD_SHARED_LIBS=ON)",
                    path.string(), printable(dlerror())));
  }
  void* const library = functions->library;
  HN_DO(find(library, path, "fnGetMetadataCount", functions->node_types));
  HN_DO(find(library, path, "fnGetMetadataName", functions->type_name));
  HN_DO(find(library, path, "fnNewFromMetadata", functions->make));
  HN_DO(find(library, path, "fnDeleteNodeRef", functions->release));
  HN_DO(find(library, path, "fnGetActiveFeatureSet", functions->instructions_of));
  HN_DO(find(library, path, "fnGetMetadataVariableCount", functions->variables));
  HN_DO(find(library, path, "fnGetMetadataVariableName", functions->variable_name));
  HN_DO(find(library, path, "fnSetVariableFloat", functions->set_float));
  HN_DO(find(library, path, "fnSetVariableIntEnum", functions->set_integer));
  HN_DO(find(library, path, "fnSetNodeLookup", functions->set_source));
  HN_DO(find(library, path, "fnGenUniformGrid2D", functions->grid2));
  HN_DO(find(library, path, "fnGenUniformGrid3D", functions->grid3));
  HN_DO(find(library, path, "fnGenPositionArray2D", functions->points2));
  HN_DO(find(library, path, "fnGenPositionArray3D", functions->points3));
  return FastNoise(std::move(functions));
}

Result<std::optional<FastNoiseField>> FastNoise::field(const Subject& subject, hashnoise::InstructionSet set) const {
  const FastNoiseFunctions& functions = *functions_;
  const unsigned wanted = instructions_of(set);
  HN_TRY(const int type, type_of(functions, subject.node));
  void* const noise = functions.make(type, wanted);
  if (!noise || functions.instructions_of(noise) != wanted) {
    if (noise) functions.release(noise);
    return std::optional<FastNoiseField>();
  }
  std::optional<FastNoiseField> field(FastNoiseField(functions_, {noise}));
  // Its cells are 100 units by default, and ours are one.
  HN_DO(set_float(functions, noise, type, subject.node, "Feature Scale", 1.0f));
  // The distance itself, as ours, and not its square.
  if (subject.noise == "cellular") HN_DO(set_integer(functions, noise, type, subject.node, "Distance Function", 0));
  if (subject.fractal.empty()) return field;
  HN_TRY(const int sum_type, type_of(functions, subject.fractal));
  void* const sum = functions.make(sum_type, wanted);
  if (!sum) return fail(fmt::format("--against: FastNoise2 cannot make its node {}", subject.fractal));
  FastNoiseField summed(functions_, {sum});
  HN_DO(set_integer(functions, sum, sum_type, subject.fractal, "Octaves", 6));
  if (!functions.set_source(sum, 0, noise)) {
    return fail(fmt::format("--against: {} of FastNoise2 takes no source", subject.fractal));
  }
  // The sum holds its source by itself.
  return std::optional<FastNoiseField>(std::move(summed));
}

}  // namespace hn
