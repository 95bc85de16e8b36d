// Which instructions the processor has, and the kernels for them.
#include <algorithm>
#include <array>
#include <iterator>
#include <mutex>

#include "plan.hpp"
#include "processor.hpp"

namespace hashnoise::inline HN_I_NAMESPACE {

namespace grid {
#define HASHNOISE_SET(set)                \
  HASHNOISE_ENTER(noises, set##_fast);    \
  HASHNOISE_ENTER(noises, set##_precise); \
  HASHNOISE_ENTER(noises, set##_fixed);   \
  HASHNOISE_ENTER(sums, set##_fast);      \
  HASHNOISE_ENTER(sums, set##_precise);   \
  HASHNOISE_ENTER(sums, set##_fixed);
HASHNOISE_SET(sse41)
HASHNOISE_SET(avx2)
HASHNOISE_SET(avx512)
HASHNOISE_SET(neon)
HASHNOISE_SET(generic)
}  // namespace grid

namespace {

using Enter = void (*)(grid::Kernels&);

struct Build {
  InstructionSet set;
  bool (*available)();
  std::array<Enter, 3> noises, sums;  // by arithmetic
};

#define HASHNOISE_BUILD(set, name)                                                                                    \
  {                                                                                                                   \
    set, processor::has_##name,                                                                                       \
        {grid::enter_noises_##name##_fast, grid::enter_noises_##name##_precise, grid::enter_noises_##name##_fixed}, { \
      grid::enter_sums_##name##_fast, grid::enter_sums_##name##_precise, grid::enter_sums_##name##_fixed              \
    }                                                                                                                 \
  }

// The widest first. HASHNOISE_HAS_AVX512 and so on name what CMake compiles.
const Build kBuilds[] = {
#if defined(HASHNOISE_HAS_AVX512)
    HASHNOISE_BUILD(InstructionSet::kAvx512, avx512),
#endif
#if defined(HASHNOISE_HAS_AVX2)
    HASHNOISE_BUILD(InstructionSet::kAvx2, avx2),
#endif
#if defined(HASHNOISE_HAS_SSE41)
    HASHNOISE_BUILD(InstructionSet::kSse41, sse41),
#endif
#if defined(HASHNOISE_HAS_NEON)
    HASHNOISE_BUILD(InstructionSet::kNeon, neon),
#endif
#if defined(HASHNOISE_HAS_GENERIC)
    HASHNOISE_BUILD(InstructionSet::kGeneric, generic),
#endif
};
constexpr std::size_t kCount = std::size(kBuilds);

std::array<grid::Kernels, 3> kernels_of(const Build& build) {
  std::array<grid::Kernels, 3> kernels{};
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    build.noises[i](kernels[i]);
    build.sums[i](kernels[i]);
  }
  return kernels;
}

}  // namespace

const grid::Kernels& grid::kernels_for(InstructionSet set, Arithmetic arithmetic) {
  // Code that enters kernels in a table is compiled for their instructions, too. So only tables of sets that the
  // processor has may be made.
  static std::array<std::array<Kernels, 3>, kCount> kernels{};
  static std::array<std::once_flag, kCount> made;
  const auto build = std::find_if(std::begin(kBuilds), std::end(kBuilds), [&](const Build& b) { return b.set == set; });
  const auto i = static_cast<std::size_t>(build - kBuilds);
  std::call_once(made.at(i), [&] { kernels.at(i) = kernels_of(*build); });
  return kernels.at(i).at(static_cast<std::size_t>(arithmetic) - 1);
}

std::vector<InstructionSet> grid::compiled_instruction_sets() {
  std::vector<InstructionSet> sets;
  for (const Build& build : kBuilds) sets.push_back(build.set);
  return sets;
}

}  // namespace hashnoise::inline HN_I_NAMESPACE

namespace hashnoise::inline HN_I_LIBRARY {

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets;
  for (const Build& build : kBuilds) {
    if (build.available()) sets.push_back(build.set);
  }
  return sets;
}

std::string_view name(InstructionSet set) {
  constexpr std::array<std::string_view, 5> kNames = {"sse4.1", "avx2", "avx512", "neon", "generic"};
  return kNames.at(static_cast<std::size_t>(set));
}

}  // namespace hashnoise::inline HN_I_LIBRARY
