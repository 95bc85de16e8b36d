// A subject of measurements is an expression of a position, with what it needs. Here are the shaders that evaluate it,
// too.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "library/shaders.hpp"
#include "library/source.hpp"

namespace hn {

struct Subject {
  std::string id;                      // "noise2d.perlin.lattice"
  int dimensions;                      // of the position p: 2 or 3
  std::string prelude;                 // macros, includes, declarations
  std::string expression;              // of p, a vec2 or vec3; its value a float, a uint, a vec2 or a vec3
  std::string_view profile = "gl330";  // the version of its shaders, but for Vulkan's
};

// The position itself: the cost of a shader without any noise.
Subject empty_subject(int dimensions);

// Perlin/Float and Perlin/Integer (tables.glsl). Costs are stated relative to the former.
Subject float_subject(int dimensions);
Subject integer_subject(int dimensions);

// "noise2d.perlin.lattice+fixed"
std::string subject_id(const Function& function, const Configuration& configuration);
// Every function that the configuration covers.
std::vector<Subject> library_subjects(const Configuration& configuration);
// Every function with every configuration whose id, or part of it, matches the case ids' "file.function.configuration".
std::vector<Subject> library_subjects();

// A subject from another library: an expression with p after the text of a file. It must be a float.
Subject foreign_subject(std::string_view name, std::string_view file, std::string_view expression, int dimensions,
                        std::string_view profile = "gl330");

// Fragment shaders, before their includes are expanded.
// One evaluation per pixel at the coordinate of a textured quad, as grey: for counting, and for the paper's table. Also
// valid for Vulkan.
std::string quad_shader(const Subject& subject);
// Evaluates at as many positions per pixel as the uniform "iterations" holds, all different: for timing.
std::string loop_shader(const Subject& subject);
// For GridRenderer: the value, a float, at the position in the first three input words.
std::string value_shader(const Subject& subject);

// For all of them but the last: one triangle over the viewport. The position passes over so many cells along each side,
// far enough from 0 that no coordinate is special.
constexpr int kQuadCells = 32;
std::string quad_vertex_shader();

// The library's files, and those that float_subject and integer_subject include.
SourceSet with_comparison_shaders(SourceSet sources);

}  // namespace hn
