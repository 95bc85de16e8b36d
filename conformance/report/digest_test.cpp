#include "report/digest.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/version.hpp"
#include "cases/case.hpp"
#include "expected/exact_sets.hpp"
#include "output/checksum.hpp"
#include "run/result_support.hpp"

namespace hn {
namespace {

using Json = nlohmann::json;

CaseResult with_checksum(std::string id, std::uint32_t checksum, Status status = Status::pass) {
  CaseResult one = result(std::move(id), status);
  one.outcome.checksum = checksum;
  return one;
}

Run whole_run(std::vector<CaseResult> cases) {
  hn::Run run = run_of(std::move(cases));
  run.golden = "89abcdef";
  run.info.system = "Linux";
  return run;
}

Json digest_of(const Run& run) { return Json::parse(digest_text(run).value()); }

std::string checksum_text(std::vector<std::uint32_t> words) {
  return fmt::format("{:08x}", crc32_of(bytes_of(std::span<const std::uint32_t>(words))));
}

const std::string kPerlin = "noise2d.perlin.lattice.fixed.fragment.gl330.golden";

TEST(Digest, CountsByGroupAndHasAChecksumOfEach) {
  const Json digest = digest_of(
      whole_run({with_checksum("noise2d.value.lattice.fixed.fragment.gl330.golden", 2), with_checksum(kPerlin, 1),
                 result("noise2d.perlin.lattice.fast.fragment.gl330.twin", Status::warning),
                 result("hash.word.pcg.exact.fragment.gl330.twin", Status::unsupported)}));
  const Json& part = digest.at("apis").at("opengl");
  EXPECT_EQ(part.at("cases"),
            Json({{"noise2d.fixed", {2, 0, 0}}, {"noise2d.fast", {1, 0, 0}}, {"hash.exact", {0, 0, 1}}}));
  // In the order of the sets, not of the cases.
  EXPECT_EQ(part.at("checksums"), Json({{"noise2d", checksum_text({1, 2})}}));
  EXPECT_EQ(part.at("verdict"), "pass");
  const auto sets = part.at("sets").get<std::string>();
  EXPECT_EQ(sets.size(), (exact_sets().size() + 3) / 4);
  const std::size_t set = exact_set("noise2d.perlin", "lattice", "fixed").value();
  EXPECT_NE(std::stoi(sets.substr(set / 4, 1), nullptr, 16) & (8 >> (set % 4)), 0);
  EXPECT_EQ(digest.at("device"), Json({{"driver", "4.5"}, {"renderer", "r"}, {"vendor", "v"}}));
  EXPECT_EQ(digest.at("failed"), Json::array());
  EXPECT_EQ(digest.at("format"), "hashnoise-digest 1");
  EXPECT_EQ(digest.at("golden"), "89abcdef");
  EXPECT_EQ(digest.at("system"), "Linux");
  EXPECT_EQ(digest.at("version"), library_version());
}

TEST(Digest, HasTheChecksumOfWhatWasWrong) {
  const std::string other = "noise2d.perlin.lattice.fixed.vertex.gl330.golden";
  for (const auto& cases : {std::vector{with_checksum(kPerlin, 1), with_checksum(other, 9, Status::fail)},
                            std::vector{with_checksum(other, 9, Status::fail), with_checksum(kPerlin, 1)}}) {
    hn::Run run = whole_run(cases);
    run.cases.push_back(result("bugs.abs_of_int.any.exact.fragment.gl330.defined", Status::pass));
    const Json digest = digest_of(run);
    const Json& part = digest.at("apis").at("opengl");
    EXPECT_EQ(part.at("checksums"), Json({{"noise2d", checksum_text({9})}}));
    EXPECT_EQ(part.at("verdict"), "fail");
    EXPECT_EQ(digest.at("failed"), Json({other}));
  }
}

TEST(Digest, IsOfAWholeRunOnADriverAlone) {
  const hn::Run right = whole_run({with_checksum(kPerlin, 1)});
  EXPECT_TRUE(digest_text(right));
  const auto none = [&](auto change) {
    hn::Run run = right;
    change(run);
    return !digest_text(run).has_value();
  };
  EXPECT_TRUE(none([](hn::Run& run) { run.golden.clear(); }));
  EXPECT_TRUE(none([](hn::Run& run) { run.not_run = 1; }));
  EXPECT_TRUE(none([](hn::Run& run) { run.shard = "1/2"; }));
  EXPECT_TRUE(none([](hn::Run& run) { run.injected = "fused"; }));
  EXPECT_TRUE(none([](hn::Run& run) { run.library = EditedLibrary{}; }));
  EXPECT_TRUE(none([](hn::Run& run) { run.absent = "no driver"; }));
  EXPECT_TRUE(none([](hn::Run& run) { run.driver = "glslang"; }));
  EXPECT_TRUE(none([](hn::Run& run) { run.driver = "metal-stand-in"; }));
  EXPECT_TRUE(none([](hn::Run& run) { run.cases = {result(kPerlin, Status::unsupported)}; }));
}

TEST(Digest, TellsTheApi) {
  const auto api = [](std::string driver) {
    hn::Run run = whole_run({with_checksum(kPerlin, 1)});
    run.driver = std::move(driver);
    return digest_of(run).at("apis").begin().key();
  };
  EXPECT_EQ(api("osmesa"), "opengl");
  EXPECT_EQ(api("egl-device:0-gles"), "opengles");
  EXPECT_EQ(api("vulkan:1"), "vulkan");
  EXPECT_EQ(api("webgl2-mesa"), "webgl2");
  EXPECT_EQ(api("webgpu"), "webgpu");
}

TEST(Digest, OfAPageHasBothApisAndTheBrowser) {
  hn::Run run =
      whole_run({with_checksum(kPerlin, 1), with_checksum("noise2d.perlin.lattice.fixed.compute.wgsl.golden", 1)});
  run.driver = "webgl2";
  run.info.browser = "Chrome 150";
  const Json digest = digest_of(run);
  EXPECT_EQ(digest.at("apis").size(), 2u);
  EXPECT_EQ(digest.at("apis").at("webgpu").at("checksums"), digest.at("apis").at("webgl2").at("checksums"));
  EXPECT_EQ(digest.at("browser"), "Chrome 150");
  EXPECT_FALSE(digest.at("device").contains("driver"));
}

TEST(Digest, HasCostsInPercentOfPerlinNoise) {
  hn::Run run = whole_run({with_checksum(kPerlin, 1)});
  run.timings = R"({"clock": "wall", "functions": [{"id": "noise2d.perlin.lattice", "ratio": 2.0},
    {"id": "noise2d.perlin.lattice+fixed", "ratio": 4.5}, {"id": "noise2d.perlin.pcg", "ratio": 3.0},
    {"id": "noise3d.perlin.lattice", "ratio": 9.0}, {"id": "noise2d.value.lattice", "error": "no"}]})";
  EXPECT_EQ(digest_of(run).at("costs"), Json({{"noise2d.perlin.fast", 100}, {"noise2d.perlin.fixed", 225}}));
  run.timings = "{}";
  EXPECT_FALSE(digest_of(run).contains("costs"));
}

// Whatever fails, and with every group that the suite has.
TEST(Digest, StaysSmall) {
  std::vector<CaseResult> all;
  for (const Case& test : all_cases(Scope::covered)) all.push_back(result(test.id, Status::fail));
  for (std::size_t i = 0; i < all.size(); ++i) all[i].outcome.checksum = static_cast<std::uint32_t>(i);
  all.push_back(result("bugs.abs_of_int.any.exact.fragment.gl330.defined", Status::pass));
  hn::Run run = whole_run(all);
  run.driver = "webgl2";
  run.info.renderer = run.info.vendor = run.info.gl_version = std::string(1000, 'x');
  const std::string text = digest_text(run).value();
  EXPECT_LE(text.size(), kMostDigestBytes);
  EXPECT_GT(Json::parse(text).at("failed").size(), 0u);
}

TEST(Digest, CutsBuildsAndStrangeCharactersOff) {
  EXPECT_EQ(without_builds("llvmpipe (LLVM 15.0.6, 256 bits)"), "llvmpipe (LLVM 15.0, 256 bits)");
  EXPECT_EQ(without_builds("4.6 (Core Profile) Mesa 23.1.0-devel (git-0a1b2c3d4e)"),
            "4.6 (Core Profile) Mesa 23.1-devel");
  EXPECT_EQ(without_builds("4.6.0 NVIDIA 535.183.01"), "4.6 NVIDIA 535.183");
  EXPECT_EQ(without_builds("ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), "
                           "SwiftShader driver-5.0.0)"),
            "ANGLE (Google, Vulkan 1.3 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver-5.0)");
  EXPECT_EQ(without_builds("<img src=x>\xff\n\x1b[2J\"'&`$"), "img src x 2J");
  EXPECT_EQ(without_builds("  "), "unknown");
  EXPECT_LE(without_builds(std::string(1000, 'a') + "b").size(), 96u);
}

TEST(Digest, IsAFileOfItsDriver) {
  hn::Run run;
  run.driver = "vulkan:0";
  EXPECT_EQ(digest_file(run), "digest-vulkan-0.json");
  EXPECT_TRUE(is_digest_file("digest-vulkan-0.json"));
  EXPECT_FALSE(is_digest_file("results.json"));
}

}  // namespace
}  // namespace hn
