// CMake compiles it to find the architecture, and runs it for HASHNOISE_INSTRUCTION_SETS=native: its exit status is the
// number of the widest instruction set that this processor has, in the order of CMakeLists.txt. It includes no header
// of a system, because one that is missing would look like another architecture.
#include "processor.hpp"

int main() {
#if defined(HASHNOISE_X86)
  using namespace hashnoise::processor;
  return has_avx512() ? 2 : has_avx2() ? 1 : 0;
#else
  return 0;
#endif
}
