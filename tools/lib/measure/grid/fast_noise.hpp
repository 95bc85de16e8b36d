// FastNoise2 from a file: what of its C interface a comparison needs.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "fills.hpp"

namespace hn {

class FastNoise {
 public:
  // Throws std::invalid_argument, which names what the file is not.
  explicit FastNoise(const std::string& file);

  // The noise or sum of a subject; null if this build of it has not these instructions. Throws std::runtime_error if it
  // does not know a name.
  std::shared_ptr<void> node(const Subject& subject, hashnoise::InstructionSet set) const;

  // kPoints values of a node: of grid(), and of a list.
  void fill_grid(const void* node, int dimensions, float* values) const;
  void fill_points(const void* node, std::span<const std::span<const float>> positions, float* values) const;

 private:
  void* made(const std::string& type, hashnoise::InstructionSet set) const;
  template <typename Value>
  void set(bool (*function)(void*, int, Value), void* node, const std::string& type, const char* variable,
           Value value) const;
  int type_named(const std::string& name) const;

  // Nodes are pointers that it hands out and takes back; names are those that its editor shows. Functions that set
  // something return whether they could.
  int (*node_types_)();
  const char* (*type_name_)(int type);
  void* (*make_)(int type, unsigned instructions);
  void (*release_)(void* node);
  unsigned (*instructions_of_)(const void* node);
  int (*variables_)(int type);
  const char* (*variable_name_)(int type, int variable);
  bool (*set_float_)(void* node, int variable, float value);
  bool (*set_integer_)(void* node, int variable, int value);
  bool (*set_source_)(void* node, int input, const void* source);
  void (*grid2_)(const void* node, float* out, float x, float y, int width, int height, float step_x, float step_y,
                 int seed, float* least_and_greatest);
  void (*grid3_)(const void* node, float* out, float x, float y, float z, int width, int height, int depth,
                 float step_x, float step_y, float step_z, int seed, float* least_and_greatest);
  void (*points2_)(const void* node, float* out, int count, const float* x, const float* y, float shift_x,
                   float shift_y, int seed, float* least_and_greatest);
  void (*points3_)(const void* node, float* out, int count, const float* x, const float* y, const float* z,
                   float shift_x, float shift_y, float shift_z, int seed, float* least_and_greatest);
};

}  // namespace hn
