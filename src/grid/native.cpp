// Prints the widest instruction set that this processor has, or nothing: CMake runs it for
// HASHNOISE_INSTRUCTION_SETS=native.
#include <cstdio>

#include "processor.hpp"

int main() {
#if defined(HASHNOISE_X86)
  using namespace hashnoise::processor;
  std::puts(has_avx512() ? "avx512" : has_avx2() ? "avx2" : has_sse41() ? "sse4.1" : "");
#endif
}
