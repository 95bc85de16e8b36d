#include "cases/facets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "cases/case.hpp"

namespace hn {
namespace {

TEST(Facets, SayWhatTheNameSays) {
  EXPECT_EQ(
      facets_of("noise2d.perlin_cell_period.lattice+sine.fixed.vertex.es300.golden"),
      (Facets{"of perlin noise", "in 2D", "with HN_FIXED", "with HN_HASH_LATTICE", "with HN_GRADIENT_SINE",
              "with a period", "in the vertex stage", "in GLSL ES", "in es300", "of noise2d.perlin_cell_period", ""}));
  EXPECT_EQ(facets_of("fbm.fbm3.partial_fnv1.fast.fragment.gl330.twin"),
            (Facets{"of octave sums", "in 3D", "with HN_FAST", "with HN_HASH_PARTIAL_FNV1", "without HN_GRADIENT_SINE",
                    "without a period", "in the fragment stage", "in desktop GLSL", "in gl330", "of fbm.fbm3", ""}));
}

TEST(Facets, AreEmptyWhereTheNameSaysNothing) {
  EXPECT_EQ(facets_of("hash.unorm.any.exact.compute.gl430.golden"),
            (Facets{"of hashes", "", "", "", "", "", "in the compute stage", "in desktop GLSL", "in gl430",
                    "of hash.unorm", ""}));
  EXPECT_EQ(facets_of("value3d.all.lattice.fast.vertex.vulkan.spirv"),
            (Facets{"", "in 3D", "with HN_FAST", "with HN_HASH_LATTICE", "without HN_GRADIENT_SINE", "",
                    "in the vertex stage", "in Vulkan's GLSL", "in vulkan", "of value3d.all", "of the check spirv"}));
  EXPECT_EQ(facets_of("position.cell4.any.exact.vertex.es300.golden")[0], "of positions");
  EXPECT_EQ(facets_of("a.b.c"), (Facets{"", "", "", "", "", "", "", "", "", "of a.b", ""}));
}

TEST(Facets, GoWithARuleOfGlsl) {
  EXPECT_TRUE(rule_of("hash.lattice2.pcg.exact.compute.gl430.golden").starts_with("GLSL 4.60 section 4.1.3"));
  EXPECT_EQ(rule_of("noise2d.perlin.pcg.fixed.vertex.es300.twin"),
            rule_of("hash.word.pcg.exact.fragment.gl330.golden"));
  EXPECT_NE(rule_of("noise2d.perlin.pcg.precise.vertex.es320.twin").find("neither fused"), std::string::npos);
  EXPECT_NE(rule_of("noise2d.perlin.pcg.fast.vertex.es320.twin").find("rounded correctly"), std::string::npos);
  EXPECT_TRUE(rule_of("bugs.abs_of_int.any.exact.fragment.gl330.defined").starts_with("GLSL 4.60 section 8.3"));
  EXPECT_EQ(rule_of("noise2d.perlin.pcg.fast.compute.hlsl60.twin"), "");
  EXPECT_EQ(rule_of("a.b.c"), "");
}

TEST(Facets, KnowEveryCase) {
  for (const Case& test : all_cases()) {
    const Facets facets = facets_of(test.id);
    EXPECT_NE(facets[9], "") << test.id;
    if (test.evaluation() != nullptr && test.evaluation()->function.axes != 0) {
      EXPECT_NE(facets[1], "") << test.id;
    }
  }
}

}  // namespace
}  // namespace hn
