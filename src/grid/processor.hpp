// Which instructions this processor has. Each function is for one set of instructions that kernels are compiled for.
// CMake runs the same questions to find what HASHNOISE_INSTRUCTION_SETS=native means (native.cpp).
#pragma once

namespace hashnoise::processor {

#if defined(HASHNOISE_X86)
inline bool has_avx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}
inline bool has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
inline bool has_sse41() { return __builtin_cpu_supports("sse4.1"); }
#endif
// These are what every processor of the architecture has.
inline bool has_neon() { return true; }
inline bool has_generic() { return true; }

}  // namespace hashnoise::processor
