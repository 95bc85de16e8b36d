// A kernel fills a map of heights, and the CPU computes it again: with HN_FIXED no bit differs.
//
// Exit status: 0 no bit differs, 1 some do, 2 CUDA has an error, 3 there is no GPU that CUDA can use.
#define HN_ARITHMETIC HN_FIXED
#include <cstdio>
#include <cstring>
#include <hashnoise/hashnoise.hpp>
#include <vector>

constexpr int kWidth = 640, kHeight = 480;

__host__ __device__ float height(int x, int y) {
  const hashnoise::vec2 p(static_cast<float>(x), static_cast<float>(y));
  return hashnoise::hn_fbm(p / 128.0f, 6, 2.0f, 0.5f, 7u);
}

extern "C" __global__ void fill(float* heights) {
  const int x = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x), y = static_cast<int>(blockIdx.y);
  if (x < kWidth) heights[y * kWidth + x] = height(x, y);
}

static cudaError_t filled(std::vector<float>& heights) {
  float* on_gpu = nullptr;
  const std::size_t bytes = heights.size() * sizeof(float);
  if (const cudaError_t error = cudaMalloc(&on_gpu, bytes)) return error;
  fill<<<dim3((kWidth + 127) / 128, kHeight), 128>>>(on_gpu);
  cudaError_t error = cudaGetLastError();
  if (error == cudaSuccess) error = cudaMemcpy(heights.data(), on_gpu, bytes, cudaMemcpyDeviceToHost);
  cudaFree(on_gpu);
  return error;
}

int main() {
  int gpus = 0;
  const cudaError_t none = cudaGetDeviceCount(&gpus);
  if (none != cudaSuccess) {
    std::fprintf(stderr, "heights: there is no GPU that CUDA can use: %s\n", cudaGetErrorString(none));
    return 3;
  }
  std::vector<float> heights(kWidth * kHeight);
  if (const cudaError_t error = filled(heights)) {
    std::fprintf(stderr, "heights: CUDA: %s\n", cudaGetErrorString(error));
    return 2;
  }
  int differ = 0;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const float here = height(i % kWidth, i / kWidth);
    differ += std::memcmp(&here, &heights[static_cast<std::size_t>(i)], sizeof here) != 0;
  }
  std::printf("%d of %d heights differ\n", differ, kWidth * kHeight);
  return differ == 0 ? 0 : 1;
}
