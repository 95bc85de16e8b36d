// Times the fills of a subject on this processor, beside those of FastNoise2. Without a word it prints its subjects.
//
//   bench SUBJECT [fastnoise2=FILE] [strict=FILE] [options of Google Benchmark]
#include <benchmark/benchmark.h>

#include <cstdio>
#include <exception>

#include "fills.hpp"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc == 1) {
    for (const hn::Subject& subject : hn::subjects()) std::puts(subject.id.c_str());
    return 0;
  }
  try {
    for (const hn::Fill& fill : hn::fills({argv + 1, argv + argc})) {
      const auto measure = [run = fill.run](benchmark::State& state) {
        run();  // so that none finds what it reads further away than the next one does
        for (auto _ : state) run();
      };
      benchmark::RegisterBenchmark(fill.name.c_str(), measure);
    }
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
