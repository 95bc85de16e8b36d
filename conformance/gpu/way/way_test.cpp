#include "gpu/way/way.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/folder.hpp"
#include "gpu/spirv.hpp"

namespace hn {
namespace {

// Programs with versions, in place of those of this machine.
class FindWay : public testing::Test {
 protected:
  FindWay() {
    add("spirv-opt", "SPIRV-Tools v2023.1 unknown hash, 2023-02-15");
    add("naga", "22.0.0");
    add("spirv-cross", "(Debian package)");
    add("vkd3d-old", "vkd3d shader compiler version 1.9 using vkd3d-shader 1.9");
    add("vkd3d", "vkd3d shader compiler version 1.10 (git)");
    add("dxc", "libdxcompiler.so: 1.7 - 1.7.0.1 (hash)");
    folder_.write("failing", "#!/bin/sh\nexit 3\n");
    allow("failing");
  }

  void add(const std::string& name, std::string_view version) {
    folder_.write(name, fmt::format("#!/bin/sh\necho '{}'\n", version));
    allow(name);
  }
  void allow(const std::string& name) const {
    std::filesystem::permissions(folder_.path() / name, std::filesystem::perms::owner_all);
  }
  std::string program(const std::string& name) const { return (folder_.path() / name).string(); }

  // "spirv > glsl-es > wgsl", or the error.
  std::string found(const WayOptions& options, std::vector<Form> driver = {Form::spirv}) const {
    const auto way = find_way(options, driver);
    if (!way) return way.error().text();
    std::string text(name_of(way->steps.front().takes));
    for (const Step& step : way->steps) text += fmt::format(" > {}", name_of(step.gives));
    return text;
  }

  const TemporaryFolder folder_;
};

TEST_F(FindWay, FormsFollowFromTheNextStepAndTheDriver) {
  const std::string opt = "spirv-opt=" + program("spirv-opt");
  const std::string cross = "spirv-cross=" + program("spirv-cross");
  const std::string naga = "naga=" + program("naga");
  EXPECT_EQ(found({.through = {opt}}), "spirv > spirv");
  EXPECT_EQ(found({.through = {opt, cross}}, {Form::gl, Form::glsl_es}), "spirv > spirv > glsl-es");
  EXPECT_EQ(found({.through = {opt, cross}}, {Form::gl}), "spirv > spirv > gl");
  EXPECT_EQ(found({.through = {naga, cross, "dxc=" + program("dxc")}}), "wgsl > spirv > hlsl > spirv");
  EXPECT_EQ(found({.through = {opt, naga}}, {Form::wgsl}), "spirv > spirv > wgsl");
  EXPECT_EQ(found({.through = {"naga:glsl:spirv=" + program("naga")}}), "glsl > spirv");
  EXPECT_EQ(found({.through = {"vkd3d=" + program("vkd3d"), "vkd3d-compiler=" + program("vkd3d-old")}}),
            "hlsl > dxbc > spirv");
  // The first form of naga's is WGSL, which these cases do not have.
  EXPECT_EQ(found({.through = {naga}, .profiles = {"vulkan"}}, {Form::glsl_es}), "spirv > glsl-es");
  EXPECT_EQ(found({.through = {naga}, .profiles = {"gl330", "hlsl60"}}, {Form::wgsl}), "spirv > wgsl");
  EXPECT_EQ(found({.through = {naga}, .profiles = {"vulkan", "wgsl"}}, {Form::glsl_es}), "wgsl > glsl-es");
  EXPECT_EQ(found({.through = {"glslang=" + program("naga")}, .profiles = {"hlsl2021"}}), "hlsl > spirv");
  EXPECT_EQ(found({.through = {opt, "mine {in} {out}", opt}, .takes = {"spirv"}, .gives = {"spirv"}}),
            "spirv > spirv > spirv > spirv");
}

TEST_F(FindWay, AnErrorNamesThePlaceAndWhatWouldBeRight) {
  const std::string opt = "spirv-opt=" + program("spirv-opt");
  const std::string cross = "spirv-cross=" + program("spirv-cross");
  const std::string vkd3d = "vkd3d=" + program("vkd3d-old");
  const std::string mine = "mine {in} {out}";
  for (const auto& [options, message] : {
           std::pair{WayOptions{{"sprv-opt"}, {}, {}}, "there is no translator \"sprv-opt\"; there are spirv-opt, "},
           std::pair{WayOptions{{cross, opt}, {}, {}},
                     "step 1, spirv-cross, gives glsl-es, gl, glsl, hlsl, msl, and step 2, spirv-opt, takes spirv"},
           std::pair{WayOptions{{opt, "spirv-cross:msl=" + program("spirv-cross")}, {}, {}},
                     "step 2, spirv-cross, gives msl, and the driver takes spirv"},
           std::pair{WayOptions{{"spirv-cross:dxil=" + program("spirv-cross")}, {}, {}},
                     "spirv-cross gives no dxil, but glsl-es, gl, glsl, hlsl, msl"},
           std::pair{WayOptions{{"naga:spriv"}, {}, {}}, "there is no form \"spriv\"; there are glsl, gl, glsl-es, "},
           std::pair{WayOptions{{"spirv-opt=/nowhere/opt"}, {}, {}}, "/nowhere/opt cannot be run: "},
           std::pair{WayOptions{{"naga=" + program("failing")}, {}, {}}, "failing cannot be run: "},
           std::pair{WayOptions{{mine}, {}, {}}, "the command \"mine {in} {out}\" needs a form that it takes"},
           std::pair{WayOptions{{"mine {in}"}, {"spirv"}, {"spirv"}}, "the command \"mine {in}\" has no {out}"},
           std::pair{WayOptions{{opt}, {"spirv"}, {}}, "--takes and --gives are for commands"},
           std::pair{WayOptions{{mine}, {"msl"}, {"spirv"}}, "takes msl, which the suite does not write"},
           std::pair{
               WayOptions{{"dxc=" + program("dxc")}, {}, {}, {"gl330", "vulkan"}},
               "step 1, dxc, takes hlsl, which cases of hlsl60, hlsl2021 have, and these cases are of gl330, vulkan"},
           std::pair{
               WayOptions{{vkd3d, vkd3d}, {}, {}, {"hlsl60"}},
               "step 1, vkd3d, takes hlsl, dxbc, dxil, which cases of hlsl50 have, and these cases are of hlsl60"},
           std::pair{WayOptions{{vkd3d, vkd3d}, {}, {}}, "vkd3d-old is version 1.9, and HLSL needs 1.10"},
       }) {
    const std::string got = found(options);
    EXPECT_NE(got.find(message), std::string::npos) << got;
  }
}

// Among the translators that this machine has.
TEST_F(FindWay, NamesAChainThatWorks) {
  setenv("HN_SPIRV_CROSS", program("spirv-cross").c_str(), 1);
  const std::string dxc = "dxc=" + program("dxc");
  const std::string before = found({.through = {dxc}, .profiles = {"vulkan"}});
  EXPECT_TRUE(before.ends_with("; this chain works: --through spirv-cross --through " + dxc)) << before;
  const std::string command =
      found({.through = {"mine {in} {out}"}, .takes = {"hlsl"}, .gives = {"spirv"}, .profiles = {"vulkan"}});
  EXPECT_TRUE(command.ends_with(": --through spirv-cross --through 'mine {in} {out}' --takes hlsl --gives spirv"))
      << command;
  const std::string none = found({.through = {"spirv-cross:msl"}});
  unsetenv("HN_SPIRV_CROSS");
  EXPECT_TRUE(none.ends_with("and the driver takes spirv")) << none;
}

TEST_F(FindWay, NamesVersionsAndSources) {
  setenv("HN_SPIRV_OPT", program("spirv-opt").c_str(), 1);
  const auto way = find_way({.through = {"spirv-opt", "spirv-cross=" + program("spirv-cross")}}, {});
  unsetenv("HN_SPIRV_OPT");
  ASSERT_TRUE(way) << way.error().text();
  EXPECT_EQ(way->text(), "spirv-opt 2023.1, spirv-cross to glsl-es");
  EXPECT_EQ(way->steps.front().command.front(), program("spirv-opt"));
  EXPECT_EQ(way->contracts(), "glsl-es");
  EXPECT_EQ(way->sources(), (std::vector<std::string>{"vulkan", "hlsl60"}));
  const auto dxc = find_way({.through = {"dxc=" + program("dxc")}}, {});
  ASSERT_TRUE(dxc) << dxc.error().text();
  EXPECT_EQ(dxc->contracts(), "");
  EXPECT_EQ(dxc->steps.front().version, "libdxcompiler.so: 1.7 - 1.7.0.1 (hash)");
}

}  // namespace
}  // namespace hn
