// Cases whose shaders go through translators, most of them faulty, on a device of Vulkan.
#include <fmt/format.h>

#include <thread>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "cases/case.hpp"
#include "gpu/vulkan/vulkan_fixture.hpp"
#include "gpu/way/evaluator.hpp"

namespace hn {
namespace {

// A command that the translators below are made of: {in} and {out} are SPIR-V.
std::string swapping(std::string_view from, std::string_view to) {
  return fmt::format("spirv-dis {{in}} | sed 's/= {} /= {} /' | spirv-as --target-env vulkan1.0 - -o {{out}}", from,
                     to);
}
// It does this to the case's shader, and copies the small one that tries the way.
std::string to_large(std::string_view action) {
  return fmt::format("if test $(wc -c <{{in}}) -gt 2500; then {}; else cp {{in}} {{out}}; fi", action);
}

constexpr const char* kHash = "hash.word.lattice.exact.compute.vulkan.golden";

class Ways : public OnVulkan<> {
 protected:
  // Runs a case of a hash through steps: commands from SPIR-V to SPIR-V, or known translators.
  Outcome run(const std::vector<std::string>& through, std::string_view id = kHash) {
    auto inner = create_vulkan_evaluator(number_, reference_);
    EXPECT_TRUE(inner) << inner.error().text();
    return run(std::move(*inner), through, id);
  }

  Outcome run(std::unique_ptr<Evaluator> inner, const std::vector<std::string>& through, std::string_view id) {
    WayOptions options{.through = through};
    for (const std::string& spec : through) {
      if (spec.find(' ') == spec.npos) continue;
      options.takes.emplace_back("spirv");
      options.gives.emplace_back("spirv");
    }
    auto way = find_way(options, inner->takes());
    EXPECT_TRUE(way) << way.error().text();
    Session session{{sources_, reference_, HN_GOLDEN_DIRECTORY, 1},
                    evaluator_through(*way, std::move(inner), reference_, {}, {limit_, folder_.path() / "ways"})};
    return run_case(session, case_named(id)).outcome;
  }

  // The text of a file that was kept of the case.
  std::string kept(const std::string& file) const { return read_file(folder_.path() / file).value_or(""); }

  std::chrono::milliseconds limit_{30000};
  const TemporaryFolder folder_;
  const ReferenceCompiler reference_;
  const SourceSet sources_ = SourceSet::embedded();
};

TEST_F(Ways, TheFirstFaultyStepIsNamed) {
  struct Row {
    std::vector<std::string> through;
    Status status;
    std::string_view message;
    std::size_t step;
  };
  const std::string swap = swapping("OpBitwiseXor", "OpBitwiseOr");
  const std::string copy = "cp {in} {out}";
  for (const Row& row : {
           Row{{swap}, Status::fail, "right before spirv-dis, wrong after it: ", 1},
           Row{{"spirv-opt", copy, swap, copy}, Status::fail, "right before spirv-dis, wrong after it: ", 3},
           Row{{to_large("kill -SEGV $$")}, Status::crash, "if crashes: ended by signal 11", 1},
           Row{{to_large("exit 3")}, Status::fail, "if refuses the shader", 1},
           Row{{to_large("head -c 44 {in} >{out}")}, Status::fail, "if gives SPIR-V that is invalid: spirv-val", 1},
           Row{{to_large(":")}, Status::fail, "if writes nothing", 1},
           Row{{copy, "kill -ABRT $$ # {in} {out}"}, Status::crash, "kill crashes: ended by signal 6", 2},
           Row{{"false {in} {out}"}, Status::unsupported, "false refuses the shader", 0},
       }) {
    const Outcome outcome = run(row.through);
    EXPECT_EQ(outcome.status, row.status) << outcome.message;
    EXPECT_EQ(outcome.message.find(row.message), 0u) << outcome.message;
    ASSERT_EQ(outcome.step.has_value(), row.step != 0) << outcome.message;
    if (!outcome.step) continue;
    EXPECT_EQ(outcome.step->number, row.step);
    EXPECT_NE(kept(outcome.step->input), "") << outcome.step->input;
  }
}

// OpenGL runs no SPIR-V, so the first step's result is seen only through the second.
TEST_F(Ways, AFaultyStepIsNamedWhereItsResultCannotBeRun) {
  auto context = create_osmesa();
  ASSERT_TRUE(context) << context.error().text();
  const Outcome outcome =
      run(evaluator_on(std::move(*context)), {swapping("OpBitwiseXor", "OpBitwiseOr"), "spirv-cross"}, kHash);
  EXPECT_EQ(outcome.status, Status::fail) << outcome.message;
  EXPECT_EQ(outcome.message.find("right without spirv-dis, wrong with it: "), 0u) << outcome.message;
  ASSERT_TRUE(outcome.step);
  EXPECT_EQ(outcome.step->number, 1u);
}

TEST_F(Ways, WhatHangsIsKilledWithAllThatItStarted) {
  limit_ = std::chrono::milliseconds(300);
  const auto file = folder_.path() / "pid";
  const Outcome outcome = run({to_large(fmt::format("sh -c 'echo $$ >{}; exec sleep 100' & wait", file.string()))});
  EXPECT_EQ(outcome.status, Status::timeout) << outcome.message;
  EXPECT_EQ(outcome.message.find("if does not end within 0.3 s"), 0u) << outcome.message;
  const int pid = std::stoi(read_file(file).value_or("0"));
  ASSERT_GT(pid, 0);
  // Where nobody waits for it, it stays as a zombie.
  const auto runs = [&] {
    const auto state = read_file(fmt::format("/proc/{}/stat", pid));
    return state && state->find(") Z ") == state->npos;
  };
  for (int i = 0; i < 100 && runs(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_FALSE(runs());
}

TEST_F(Ways, PreciseCasesAreUnsupportedWhereAFormHasNoWordForIt) {
  const Outcome outcome = run({"spirv-cross:glsl-es"}, "noise2d.perlin.lattice.precise.compute.vulkan.golden");
  EXPECT_EQ(outcome.status, Status::unsupported);
  EXPECT_EQ(outcome.message, "glsl-es knows no `precise`");
}

TEST_F(Ways, TranslatorsThatAreRightPass) {
  for (const auto& [through, id] : {
           std::pair{std::vector<std::string>{"spirv-opt"}, kHash},
           std::pair{std::vector<std::string>{"spirv-opt", "spirv-cross"},
                     "hash.word.lattice.exact.compute.hlsl60.golden"},
           std::pair{std::vector<std::string>{"spirv-cross:hlsl"}, kHash},
           std::pair{std::vector<std::string>{"glslang"}, kHash},
       }) {
    const Outcome outcome = run(through, id);
    EXPECT_EQ(outcome.status, Status::pass) << fmt::format("{}: {}", through.back(), outcome.message);
  }
}

}  // namespace
}  // namespace hn
