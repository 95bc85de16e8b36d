#include "expected/golden.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "base/temporary_folder.hpp"
#include "library/configurations.hpp"

namespace hn {
namespace {

constexpr std::string_view kValid =
    "hashnoise golden 1\n"
    "function hash.lattice2\n"
    "hash pcg\n"
    "arithmetic exact\n"
    "bits 0.1.0\n"
    "columns x:i32 y:i32 seed:u32 = value:u32\n"
    "rows 2\n"
    "00000001 ffffffff 00000000 = 0000000a\n"
    "00000002 80000000 00000007 = ffffffff\n"
    "digest origin=-1,4294967295 size=2,3 seed=5 fnv1a64=0123456789abcdef\n";

Result<Golden> parse(std::string_view text) {
  return parse_golden(text, "file.golden", find_function("hash.lattice2"), configuration_named("pcg"));
}

TEST(Golden, AValidFileIsRead) {
  const auto golden = parse(kValid);
  ASSERT_TRUE(golden) << golden.error().text();
  ASSERT_EQ(golden->rows.size(), 2u);
  EXPECT_EQ(golden->rows[1].line, 9);
  EXPECT_EQ(golden->rows[1].inputs, (std::vector<std::uint32_t>{2, 0x80000000u, 7}));
  EXPECT_EQ(golden->rows[1].values, (std::vector<std::uint64_t>{0xFFFFFFFFu}));
  ASSERT_TRUE(golden->digest);
  EXPECT_EQ(golden->digest->points(), 6u);
  EXPECT_EQ(golden->digest->fnv1a64, 0x0123456789abcdefull);
}

TEST(Golden, DigestPointsRunLastAxisFastestAndWrap) {
  const auto inputs = parse(kValid)->digest->inputs();
  const auto at = [&](std::size_t i) {
    return std::vector(inputs.begin() + static_cast<int>(i * kInputWords),
                       inputs.begin() + static_cast<int>(i * kInputWords + 3));
  };
  EXPECT_EQ(at(0), (std::vector<std::uint32_t>{0xFFFFFFFFu, 0xFFFFFFFFu, 5}));
  EXPECT_EQ(at(1), (std::vector<std::uint32_t>{0xFFFFFFFFu, 0u, 5}));
  EXPECT_EQ(at(3), (std::vector<std::uint32_t>{0u, 0xFFFFFFFFu, 5}));
}

struct Corruption {
  const char* name;
  const char* from;
  const char* to;
  int line;  // that the error must name
};

class CorruptGolden : public testing::TestWithParam<Corruption> {};

TEST_P(CorruptGolden, IsAnErrorThatNamesTheLine) {
  const Corruption& corruption = GetParam();
  std::string text(kValid);
  const auto at = text.find(corruption.from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string_view(corruption.from).size(), corruption.to);
  const auto golden = parse(text);
  ASSERT_FALSE(golden);
  const std::string& message = golden.error().message;
  EXPECT_TRUE(message.starts_with(fmt::format("file.golden:{}: ", corruption.line))) << message;
  EXPECT_TRUE(message.find(" should ") != std::string::npos || message.find("more than") != std::string::npos ||
              message.find("the file ends") != std::string::npos)
      << message << " says what would be right";
  EXPECT_TRUE(std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c <= '~'; })) << message;
}

INSTANTIATE_TEST_SUITE_P(
    All, CorruptGolden,
    testing::Values(
        Corruption{"magic", "golden 1", "golden 2", 1}, Corruption{"function", "lattice2", "lattice3", 2},
        Corruption{"hash", "hash pcg", "hash fnv1", 3}, Corruption{"arithmetic", "exact", "fast", 4},
        Corruption{"bits", "bits 0.1.0", "bit", 5}, Corruption{"columns", "y:i32", "y:u32", 6},
        Corruption{"rows", "rows 2", "rows two", 7}, Corruption{"no_rows", "rows 2", "rows 0", 7},
        Corruption{"too_few_rows", "rows 2", "rows 1", 9}, Corruption{"too_many_rows", "rows 2", "rows 3", 10},
        Corruption{"short_word", "00000001 f", "0000001 f", 8}, Corruption{"bad_digit", "0000000a", "0000000g", 8},
        Corruption{"sign", "0000000a", "-000000a", 8}, Corruption{"missing_word", "00000007 =", "=", 9},
        Corruption{"extra_word", "0000000a", "0000000a 00000000", 8}, Corruption{"no_equals", " = 0000000a", "", 8},
        Corruption{"digest_word", "digest ", "digset ", 10}, Corruption{"digest_axes", "size=2,3", "size=2", 10},
        Corruption{"digest_empty", "size=2,3", "size=2,0", 10},
        Corruption{"digest_huge", "size=2,3", "size=4000000000,4000000000", 10},
        Corruption{"digest_value", "fnv1a64=0123456789abcdef", "fnv1a64=0123", 10},
        Corruption{"digest_missing", " fnv1a64=0123456789abcdef", "", 10},
        Corruption{"carriage_return", "golden 1\n", "golden 1\r\n", 1},
        Corruption{"bytes", "golden 1", "\x1b[2J\xff", 1}, Corruption{"bytes_in_a_row", "ffffffff 0", "\xc2\x9b 0", 8},
        Corruption{"bytes_for_a_row", "00000001 f", "\x80\n", 8},
        Corruption{"bytes_in_the_digest", "seed=5", "seed=\a", 10}, Corruption{"bytes_in_bits", "bits", "\x8f", 5},
        Corruption{"after_the_end", "cdef\n", "cdef\nmore\n", 11}),
    [](const auto& corruption) { return std::string(corruption.param.name); });

Result<Golden> parse_fixed(std::string_view value) {
  const std::string text = fmt::format(
      "hashnoise golden 1\nfunction noise2d.perlin\nhash lattice+fixed\narithmetic fixed\nbits 0.2.0\n"
      "columns x:f32 y:f32 seed:u32 = value:f64\nrows 1\n3f000000 3f000000 00000007 = {}\n",
      value);
  return parse_golden(text, "file.golden", find_function("noise2d.perlin"), configuration_named("lattice+fixed"));
}

TEST(Golden, AValueOfFixedArithmeticIsAFloat) {
  const auto golden = parse_fixed("3fe0000000000000");
  ASSERT_TRUE(golden) << golden.error().text();
  EXPECT_EQ(result_bits({"value", WordType::f64}, golden->rows[0].values[0]), 0x3F000000u);
  for (const char* const no_float : {"3fe0000000000001", "7ff8000000000000"}) {
    const auto refused = parse_fixed(no_float);
    ASSERT_FALSE(refused) << no_float;
    EXPECT_TRUE(refused.error().message.starts_with("file.golden:8: ")) << refused.error().message;
  }
}

TEST(Golden, FixedArithmeticHasFilesOfItsOwnAndPreciseThoseOfFast) {
  const Function& perlin = find_function("noise2d.perlin");
  const auto file = [&](std::string_view name) { return golden_path("", perlin, configuration_named(name)).string(); };
  EXPECT_EQ(file("lattice+sine"), "noise2d.perlin.lattice+sine.golden");
  EXPECT_EQ(file("lattice+sine+precise"), "noise2d.perlin.lattice+sine.golden");
  EXPECT_EQ(file("lattice+sine+fixed"), "noise2d.perlin.lattice+sine+fixed.golden");
  const auto arithmetic = [&](std::string_view name) { return golden_arithmetic(perlin, configuration_named(name)); };
  EXPECT_EQ(arithmetic("lattice"), "fast");
  EXPECT_EQ(arithmetic("lattice+precise"), "fast");
  EXPECT_EQ(arithmetic("lattice+fixed"), "fixed");
}

TEST(Golden, EveryTruncationIsAnError) {
  for (std::size_t length = 0; length + 1 < kValid.size(); ++length) {
    EXPECT_FALSE(parse(kValid.substr(0, length))) << length;
  }
}

TEST(Golden, AMissingFileIsAnErrorThatNamesIt) {
  const auto golden = read_golden("/nowhere/x.golden", find_function("hash.word"), configuration_named("pcg"));
  ASSERT_FALSE(golden);
  EXPECT_NE(golden.error().message.find("/nowhere/x.golden"), std::string::npos);
}

TEST(Golden, OneBrokenFileIsNamedWithTheToolThatWritesIt) {
  const TemporaryFolder folder;
  folder.write("x.golden", std::string(3000, '\0'));
  const auto golden = read_golden(folder.path() / "x.golden", find_function("hash.word"), configuration_named("pcg"));
  ASSERT_FALSE(golden);
  const std::string& message = golden.error().message;
  EXPECT_NE(message.find("x.golden:1: \"\\x00"), std::string::npos) << message;
  EXPECT_NE(message.find("2985 bytes more should be \"hashnoise golden 1\"; tools/golden"), std::string::npos)
      << message;
  EXPECT_FALSE(read_golden(folder.path(), find_function("hash.word"), configuration_named("pcg")));
}

TEST(Golden, AFolderWithoutGoldenFilesIsRefused) {
  EXPECT_TRUE(check_golden_folder(HN_GOLDEN_DIRECTORY));
  const TemporaryFolder folder;
  folder.write("file", "");
  const auto refusal = [](const std::filesystem::path& path) {
    const auto refused = check_golden_folder(path);
    return refused ? "" : refused.error().message;
  };
  EXPECT_NE(refusal(folder.path()).find("there is no golden file in "), std::string::npos) << refusal(folder.path());
  EXPECT_NE(refusal(folder.path() / "file").find("Not a directory"), std::string::npos);
  const std::string absent = refusal(folder.path() / "absent");
  EXPECT_NE(absent.find("absent: No such file or directory; --golden wants"), std::string::npos) << absent;
  folder.write("x.golden", "");
  EXPECT_TRUE(check_golden_folder(folder.path()));
}

TEST(Golden, DigestFunctionIsFnv1a) {
  // FNV-1a 64 of the empty string and of "a\0\0\0", from the algorithm's definition.
  EXPECT_EQ(fnv1a64({}), 0xcbf29ce484222325ull);
  std::uint64_t expected = 0xaf63dc4c8601ec8cull;  // published: FNV-1a 64 of "a"
  for (int i = 0; i < 3; ++i) expected *= 0x100000001b3ull;
  EXPECT_EQ(fnv1a64({0x61u}), expected);
}

}  // namespace
}  // namespace hn
