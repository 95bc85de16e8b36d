// The functions that enter kernels in a table: one for each instruction set, each arithmetic, and noises and sums
// apart.
#pragma once

#include "kernel.hpp"

namespace hashnoise::inline HN_I_NAMESPACE::grid {

#define HASHNOISE_TABLES(set)            \
  void noises_##set##_fast(Kernels&);    \
  void noises_##set##_precise(Kernels&); \
  void noises_##set##_fixed(Kernels&);   \
  void sums_##set##_fast(Kernels&);      \
  void sums_##set##_precise(Kernels&);   \
  void sums_##set##_fixed(Kernels&);
HASHNOISE_TABLES(sse41)
HASHNOISE_TABLES(avx2)
HASHNOISE_TABLES(avx512)
HASHNOISE_TABLES(neon)
HASHNOISE_TABLES(generic)
#undef HASHNOISE_TABLES

}  // namespace hashnoise::grid

// The function of this translation unit; HASHNOISE_TABLE is a set and an arithmetic, like avx2_fast.
#define HASHNOISE_PASTE_TOKENS(a, b) a##b
#define HASHNOISE_PASTE(a, b) HASHNOISE_PASTE_TOKENS(a, b)
