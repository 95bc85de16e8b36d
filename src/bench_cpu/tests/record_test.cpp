#include "bench_cpu/record.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

TEST(Record, HasARowForEachInstructionSet) {
  const Subject perlin = subjects()[2];
  const std::string record = record_of({{"date", "today"}},
                                       {{perlin,
                                         hashnoise::InstructionSet::kAvx2,
                                         {{"grids", {1.25, 0.03}}, {"fixed", {}}},
                                         {{"fast", 1234.5}, {"FastNoise2", 0.5}}},
                                        {perlin, hashnoise::InstructionSet::kAvx512, {}, {}}},
                                       PythonMeasurement{{0.85, 0.02}, {0.95, 0.01}});
  EXPECT_EQ(record,
            "# date: today\n# Python with out=: 0.95 ± 0.01\n# Python with a new array: 0.85 ± 0.02\n"
            "noise,instructions,grids,grids spread,points,points spread,octaves,octaves spread,strict fixed,"
            "strict fixed spread,strict precise,strict precise spread,fixed,fixed spread,precise,precise "
            "spread,tiles,tiles spread,lists,lists spread,threads,threads spread,fast million/s,"
            "fixed million/s,precise million/s,tiles million/s,points million/s,two threads million/s,"
            "FastNoise2 million/s,FastNoise2 points million/s,FastNoise2 strict million/s\n"
            "perlin2,avx2,1.25,0.03,,,,,,,,,cannot be told,cannot be told,,,,,,,,,1234.5,,,,,,0.5,,\n"
            "perlin2,avx512,,,,,,,,,,,,,,,,,,,,,,,,,,,,,\n");
}

}  // namespace
}  // namespace hn
