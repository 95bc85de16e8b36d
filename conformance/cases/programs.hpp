// Selects the programs of a run. A program is a function with a setting of the knobs, in a version and a stage.
// Compiling them is the cost of a run, and one program serves many checks.
//
// --thorough has the product of functions, settings, versions and stages. Any other run has a cover of that product: a
// few of its programs, which together show everything in kShown at least once. These are single things (every
// function),
// and pairs of things (every function of a dimension in every arithmetic, every setting with each of its dimensions,
// every version and stage with each form of a function).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cases/case.hpp"
#include "library/functions.hpp"

namespace hn {

struct PlannedProgram {
  const Function* function;
  const Configuration* configuration;
  Target target;
};

// The product: every function that has values with a setting, in every version and stage of that setting. In the order
// of the table of functions.
const std::vector<PlannedProgram>& all_programs();

// The part of a cover that a program shows, in words: "fbm.fbm2_cell", "fixed with perlin of 2 axes".
std::vector<std::string> shown_by(const PlannedProgram& program);

// The words that the product shows, and the programs of `extents` (one for each of all_programs()) do not.
std::vector<std::string> not_shown(std::span<const Extent> extents);

// The extent of each of all_programs(): for every driver, for some driver, and for --thorough.
const std::vector<Extent>& program_extents();

// Whether each of all_programs() is in the cover of GLSL ES 3.00 alone: for browsers and phones, which could run few of
// the programs above.
const std::vector<bool>& is_in_es_cover();

// Chooses from candidates so that everything is shown that can be: each shows some of the things from 0 to `things` -
// 1.
// The choice goes in order: a candidate is chosen if its round still lacks something that it shows. `rounds` lists the
// candidates that stand for each other; the one that shows most new things is taken, and of equals the cheapest.
struct Candidate {
  std::vector<std::size_t> shows;
  std::size_t round;  // rounds are numbers from 0 on, in order
  int cost;
};
std::vector<bool> cover_of(std::span<const Candidate> candidates, std::size_t things);

}  // namespace hn
