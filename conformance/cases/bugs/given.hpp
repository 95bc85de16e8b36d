// Somebody's own function, which hn-conform check runs as it runs a row of the table of bugs.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cases/bugs/bugs.hpp"

namespace hn {

struct GivenFile {
  std::string name;  // to be included as
  std::string text;
  std::string path;  // for messages
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GivenFile, name, text, path)

struct GivenColumn {
  std::string name;
  WordType type = WordType::f32;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GivenColumn, name, type)

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BugPoint, inputs, expected)

// Everything that another process needs to run it.
struct GivenFunction {
  std::string id = {};    // "check.snoise"; empty: there is none
  std::string text = {};  // as the command names it: "noise.glsl:snoise(p)"
  std::vector<GivenFile> files = {};
  std::string file = {};  // of these, to include
  std::string body = {};  // as of a row of the library's functions
  std::vector<GivenColumn> inputs = {};
  std::vector<GivenColumn> outputs = {};
  std::string profiles = {};
  std::vector<BugPoint> points = {};  // without expected values, until they are known
  double tolerance = 0.0;             // of floats
  std::string expected_from = {};     // "values.csv", "osmesa in gl330"
  bool expected_right = false;        // somebody states that these are right
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GivenFunction, id, text, files, file, body, inputs, outputs, profiles, points,
                                   tolerance, expected_from, expected_right)

// The rest of this process has it in all_bugs(). Call it once, before there is a case.
const Bug& give(const GivenFunction& function);

}  // namespace hn
