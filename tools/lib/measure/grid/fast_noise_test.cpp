// Stands for FastNoise2 in the tests: it knows Perlin noise in 2D, by this library, and computes it three times, so
// that its speed is known. FAKE_FAST_NOISE in the environment takes something away from it.
#include <cstdlib>
#include <hashnoise/field.hpp>
#include <optional>
#include <string_view>

namespace {

using hashnoise::InstructionSet;

constexpr int kTimes = 3;
constexpr unsigned kSse41 = 0x7E;

bool lacks(std::string_view what) {
  const char* const lacking = std::getenv("FAKE_FAST_NOISE");
  return lacking && what == lacking;
}

std::optional<InstructionSet> set_of(unsigned instructions) {
  switch (instructions) {
    case kSse41:
      return InstructionSet::kSse41;
    case 0x3FE:
      return InstructionSet::kAvx2;
    case 0x3FFE:
      return InstructionSet::kAvx512;
    case 1u:
      return InstructionSet::kGeneric;
    case 0x1C000:
      return InstructionSet::kNeon;
    default:
      return std::nullopt;
  }
}

struct Node {
  unsigned instructions;
  hashnoise::Field<2> field;
  float scale = 100.0f;
};

const Node& of(const void* node) { return *static_cast<const Node*>(node); }

}  // namespace

extern "C" {

int fnGetMetadataCount() { return 2; }
const char* fnGetMetadataName(int id) { return id == 1 && !lacks("node") ? "Perlin" : "Constant"; }
void* fnNewFromMetadata(int, unsigned instructions) {
  if (lacks("instructions")) instructions = kSse41;
  hashnoise::Settings settings;
  settings.seed = 7;
  settings.instruction_set = set_of(instructions);
  if (!settings.instruction_set || lacks("all instructions")) return nullptr;
  return new Node{instructions, hashnoise::Field<2>(settings)};
}
void fnDeleteNodeRef(void* node) { delete static_cast<Node*>(node); }
unsigned fnGetActiveFeatureSet(const void* node) { return of(node).instructions; }
int fnGetMetadataVariableCount(int) { return lacks("variable") ? 0 : 1; }
const char* fnGetMetadataVariableName(int, int) { return "Feature Scale"; }
bool fnSetVariableFloat(void* node, int, float value) {
  static_cast<Node*>(node)->scale = value;
  return true;
}
bool fnSetVariableIntEnum(void*, int, int) { return false; }
bool fnSetNodeLookup(void*, int, const void*) { return false; }

void fnGenUniformGrid2D(const void* node, float* out, float x, float y, int width, int height, float step_x,
                        float step_y, int, float* range) {
  if (of(node).scale != 1.0f) std::abort();  // its cells were to be as large as ours
  const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (int i = 0; i < kTimes; ++i) {
    const auto [least, greatest] =
        of(node).field.fill(hashnoise::Grid<2>{{x, y}, {step_x, step_y}, {width, height}}, {out, size});
    range[0] = least;
    range[1] = greatest;
  }
}
void fnGenPositionArray2D(const void* node, float* out, int count, const float* x, const float* y, float, float, int,
                          float* range) {
  const auto size = static_cast<std::size_t>(count);
  for (int i = 0; i < kTimes; ++i) {
    const auto [least, greatest] = of(node).field.fill(hashnoise::Points<2>{{{{x, size}, {y, size}}}}, {out, size});
    range[0] = least;
    range[1] = greatest;
  }
}
void fnGenUniformGrid3D(const void*, float*, float, float, float, int, int, int, float, float, float, int, float*) {}
void fnGenPositionArray3D(const void*, float*, int, const float*, const float*, const float*, float, float, float, int,
                          float*) {}
}
