// Faults on a healthy driver, OSMesa's: what has one fails, what has none passes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "cases/bugs/bugs.hpp"
#include "fault/faults.hpp"
#include "gpu/osmesa_fixture.hpp"

namespace hn {
namespace {

struct FaultAndBug {
  std::string_view fault;
  std::string_view bug;
  std::string_view profile = "gl330";
};

// A bug for each of the faults, that fails if the fault is there.
constexpr FaultAndBug kCaught[] = {
    {"modulo_sign", "bugs.modulo_of_large_word"},
    {"uint_of_int_shift", "bugs.uint_of_int_shifted_by_31"},
    {"integers_16_bits", "bugs.words_wrap_at_32_bits"},
    {"integers_saturated", "bugs.ints_beyond_65536"},
    {"uint_shifted_by_int", "bugs.uint_shifted_by_int"},
    {"shifts_merged", "bugs.shifted_twice_by_16"},
    {"abs_int", "bugs.abs_of_int"},
    {"negative_lost", "bugs.larger_size"},
    {"bit_casts_flat", "bugs.bit_cast_hash"},
    {"sin_imprecise", "bugs.sin_within_a_turn"},
    {"sin_by_table", "bugs.sin_within_a_turn"},
    {"fract_returns_one", "bugs.fract_of_exact"},
    {"floor_divide_merged", "bugs.quotient_of_floor"},
    {"mod_at_integers", "bugs.mod_between_multiples"},
    {"contracted", "bugs.contracted_despite_precise", "gl400"},
    {"reassociated", "bugs.contracted_despite_precise", "gl400"},
    {"mediump_everywhere", "bugs.highp_beside_mediump", "es300"},
    {"small_flushed", "bugs.small_normals_kept"},
    {"uint_to_float", "bugs.uint_to_float_exact"},
    {"mediump_conversions", "bugs.uint_to_float_exact", "es300"},
    {"constants_folded_coarsely", "bugs.folded_floats"},
    {"unary_minus_in_loop", "bugs.unary_minus_in_loop"},
    {"loop_condition", "bugs.loop_condition"},
    {"loop_initializer", "bugs.loop_initializer"},
    {"array_in_loop", "bugs.array_initialized_in_loop"},
    {"vector_plus_scalar_in_loop", "bugs.vector_plus_scalar_in_loop"},
    {"swizzle_written_twice", "bugs.swizzle_written_twice"},
    {"loop_condition", "bugs.do_while"},
    {"third_nested_loop", "bugs.three_nested_loops"},
    {"selection_nested", "bugs.nested_selections"},
    {"switch_default", "bugs.switch_in_loop"},
    {"switch_default", "bugs.switch_default_in_middle"},
    {"switch_default", "bugs.switch_of_constant"},
    {"vectors_anded", "bugs.and_of_vectors"},
    {"literals_multiplied", "bugs.products_of_literals"},
    {"modulo_by_large", "bugs.remainder_of_constant"},
    {"negation_moved", "bugs.negated_quotient"},
    {"negation_moved", "bugs.division_by_large_negative"},
    {"int_as_uint", "bugs.int_of_uint_vector"},
    {"int_as_uint", "bugs.float_beside_uint"},
    {"int_as_uint", "bugs.bits_of_constants"},
    {"unary_minus", "bugs.unary_minus"},
    {"negative_shifted_left", "bugs.negative_shifted_left"},
    {"overflow_ignored", "bugs.ints_overflow"},
    {"literal_converted", "bugs.literals_converted"},
    {"carry_lost", "bugs.hash_of_pairs"},
    {"constants_spread", "bugs.vector_of_constants"},
};

TEST(Faults, EachHasABugThatCatchesIt) {
  for (const Fault& fault : all_faults()) {
    const bool caught = std::any_of(std::begin(kCaught), std::end(kCaught),
                                    [&](const FaultAndBug& c) { return c.fault == fault.name; });
    EXPECT_TRUE(caught) << fault.name;
  }
}

// In the first versions, without bit casts, with them and in ES, all that an injection changes is compiled. Later
// versions of these languages have the same text; there what it adds is compiled with a part of the library.
constexpr std::pair<std::string_view, std::string_view> kInjectedFiles[] = {
    {"gl130", "hashnoise.glsl"}, {"gl330", "hashnoise.glsl"}, {"es300", "hashnoise.glsl"},
    {"gl460", "fbm2d.glsl"},     {"es320", "fbm2d.glsl"},     {"vulkan", "fbm2d.glsl"}};

// An injection must be right GLSL: else a run would turn red for another reason. Each is compiled in one of these, in
// turn; with tools/test --thorough in all.
TEST(Faults, EachIsRightGlslInEveryVersion) {
  const ReferenceCompiler compiler;
  std::size_t number = 0;
  for (const Fault& fault : all_faults()) {
    SourceSet sources = SourceSet::embedded();
    ASSERT_TRUE(inject_into(sources, fault.name));
    const std::size_t turn = number++ % std::size(kInjectedFiles);
    for (std::size_t i = 0; i < std::size(kInjectedFiles); ++i) {
      const auto& [name, file] = kInjectedFiles[i];
      if (i != turn && !std::getenv("HN_THOROUGH")) continue;
      const Profile& profile = profile_named(name);
      const auto shader =
          expand(sources, profile, calling_shader(file, default_configuration(), profile, Stage::fragment));
      ASSERT_TRUE(shader) << fault.name << shader.error().text();
      const auto done = compiler.check(*shader, profile, Stage::fragment);
      EXPECT_TRUE(done) << fault.name << ' ' << name << ": " << done.error().text();
    }
  }
}

class Injected : public OnOsmesa<testing::TestWithParam<FaultAndBug>> {
 protected:
  Outcome run(const SourceSet& sources) {
    const ReferenceCompiler reference;
    Session session({sources, reference, "", 1}, *context_);
    std::vector<Case> cases;
    add_bug_cases(cases);
    const std::string start = fmt::format("{}.any.", GetParam().bug);
    const std::string end = fmt::format(".{}.defined", GetParam().profile);
    for (const Case& test : cases) {
      if (test.id.starts_with(start) && test.id.ends_with(end)) return run_case(session, test).outcome;
    }
    return outcome_with(Status::error, {"there is no such case", {}});
  }
};

TEST_P(Injected, TheBugFailsAndWithoutPasses) {
  SourceSet sources = SourceSet::embedded();
  const Outcome healthy = run(sources);
  EXPECT_EQ(healthy.status, Status::pass) << healthy.message;
  ASSERT_TRUE(inject_into(sources, GetParam().fault));
  const Outcome faulty = run(sources);
  EXPECT_EQ(faulty.status, Status::fail);
  EXPECT_GT(faulty.mismatches, 0u) << faulty.message;  // a value is wrong; it did compile
}

INSTANTIATE_TEST_SUITE_P(Faults, Injected, testing::ValuesIn(kCaught), [](const auto& instance) {
  return fmt::format("{}_{}", instance.param.fault, instance.param.bug.substr(5));
});

}  // namespace
}  // namespace hn
