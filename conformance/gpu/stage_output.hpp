// Where the results of a stage end up, and how they get there.
#pragma once

#include <glad/gl.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.hpp"
#include "library/profile.hpp"

namespace hn {

struct GridSize {
  GLsizei width;
  GLsizei height;
};
// The size of a grid that holds this number of points.
GridSize grid_size(std::size_t points);

// The results of the fragment stage are pixels, those of the vertex stage are captured by transform feedback, a draw
// for each row of the grid, whose number is in the uniform "row"; those of the compute stage are in a storage buffer.
class StageOutput {
 public:
  StageOutput() = default;
  virtual ~StageOutput() = default;
  StageOutput(const StageOutput&) = delete;
  StageOutput& operator=(const StageOutput&) = delete;

  // Evaluates a program, which is in use, at points 0, 1, ... of the grid and reads kOutputWords for each. Before, the
  // words are filled with 0xDEADBEEF, so that a program that does nothing cannot pass for the one before it. A vertex
  // array and a framebuffer of RGBA32UI pixels for the grid are bound.
  virtual Result<std::vector<std::uint32_t>> run(GLuint program, std::size_t points) = 0;
};

std::unique_ptr<StageOutput> make_stage_output(const GladGLContext& gl, Stage stage);

}  // namespace hn
