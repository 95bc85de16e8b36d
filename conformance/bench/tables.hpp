// The textures of the noise that the paper compares with: tables.glsl.
#pragma once

#include <array>

#include "gpu/gpu.hpp"

namespace hn {

// A permutation of 0 to 255.
std::array<std::uint8_t, 256> table_permutation();

class NoiseTables {
 public:
  explicit NoiseTables(const Context& context);
  ~NoiseTables();
  NoiseTables(const NoiseTables&) = delete;
  NoiseTables& operator=(const NoiseTables&) = delete;

  // Gives a program the texture units of its tables. They stay bound, behind the texture units of the grid renderer.
  void attach(const Program& program) const;

 private:
  static constexpr std::size_t kCount = 6;
  const GladGLContext& gl_;
  std::array<GLuint, kCount> textures_{};
};

}  // namespace hn
