// A kernel for each function of the suite, which is called kernel and the number of its line in bodies.inc. Tests of the
// C++ header in CUDA and HIP compile it, and run what becomes of it at the points of twin_flags.cpp.
#include <hashnoise/hashnoise.hpp>

using namespace hashnoise;

#define SEEDED(s) , s
#define SEED(s) s
#define HN_TEST_PASTE_TOKENS(a, b) a##b
#define HN_TEST_PASTE(a, b) HN_TEST_PASTE_TOKENS(a, b)

static __host__ __device__ inline float float_of(uint bits) { return uintBitsToFloat(bits); }
static __host__ __device__ inline uint bits_of(float value) { return floatBitsToUint(value); }

#define FUNCTION(id, family, configurations, columns, ...)                                                        \
  static __host__ __device__ inline uvec4 HN_TEST_PASTE(body, __LINE__)(                                          \
      [[maybe_unused]] uvec4 a, [[maybe_unused]] uvec4 b, [[maybe_unused]] uvec4 c, [[maybe_unused]] uvec4 d) {   \
    __VA_ARGS__                                                                                                   \
  }                                                                                                               \
  extern "C" __global__ void HN_TEST_PASTE(kernel, __LINE__)(const uint* in, uint* out) {                         \
    const uvec4 n = HN_TEST_PASTE(body, __LINE__)(                                                                \
        uvec4(in[0], in[1], in[2], in[3]), uvec4(in[4], in[5], in[6], in[7]), uvec4(in[8], in[9], in[10], in[11]), \
        uvec4(in[12], in[13], in[14], in[15]));                                                                   \
    out[0] = n.x;                                                                                                 \
    out[1] = n.y;                                                                                                 \
    out[2] = n.z;                                                                                                 \
    out[3] = n.w;                                                                                                 \
  }
#include "library/bodies.inc"
