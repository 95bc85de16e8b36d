// Fills a grid once or more often, and prints nothing, so that its instructions can be counted: for another processor,
// which has no Google Benchmark. Without a word it prints its subjects.
//
//   fill TIMES FILL SUBJECT [fastnoise2=FILE]
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>

#include "fills.hpp"

int main(int argc, char** argv) {
  if (argc < 4) {
    for (const hn::Subject& subject : hn::subjects()) std::puts(subject.id.c_str());
    return 0;
  }
  try {
    const std::string wanted = argv[2], set(name(hashnoise::instruction_sets().front()));
    for (const hn::Fill& fill : hn::fills({argv + 3, argv + argc})) {
      if (fill.name != set + "/" + wanted) continue;
      for (int i = 0; i < std::atoi(argv[1]); ++i) fill.run();
      return 0;
    }
    throw std::runtime_error("there is no " + wanted + " in it for " + set);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
