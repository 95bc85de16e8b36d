// Which instructions this processor has. Each function is for one set of instructions that kernels are compiled for.
// CMake compiles them to find the architecture, and runs them for HASHNOISE_INSTRUCTION_SETS=native (native.cpp).
#pragma once

#if (defined(HASHNOISE_X86) && !defined(__x86_64__)) || (defined(HASHNOISE_NEON) && !defined(__aarch64__)) || \
    (defined(HASHNOISE_X87) && !defined(__i386__))
#error this is another architecture
#endif

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
