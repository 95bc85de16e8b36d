#include "expected/golden.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "base/folder.hpp"
#include "library/configurations.hpp"

namespace hn {
namespace {

// A file of hn_lattice. Its values with PCG are those given, and with other hashes 0.
std::string file_of_lattice() {
  std::string settings = "settings";
  std::string rows[] = {"00000001 ffffffff 00000000", "00000002 80000000 00000007"};
  std::string digests;
  for (const GoldenSetting& setting : golden_settings(find_function("hash.lattice2"))) {
    const bool own = setting.configuration->hash == "PCG";
    settings += " " + setting.name;
    rows[0] += own ? " = 0000000a" : " = 00000000";
    rows[1] += own ? " = ffffffff" : " = 00000000";
    digests +=
        fmt::format("digest {} origin=-1,4294967295 size=2,3 seed=5 fnv1a64={}\n",
                    setting.name.substr(0, setting.name.find(':')), own ? "0123456789abcdef" : "fedcba9876543210");
  }
  return fmt::format(
      "hashnoise golden 2\nfunction hash.lattice2\ncalls hn_lattice\nbits 0.1.0\n"
      "columns x:i32 y:i32 seed:u32 = value:u32\n{}\nrows 2\n{}\n{}\n{}",
      settings, rows[0], rows[1], digests);
}

const std::string kValid = file_of_lattice();

Result<Golden> parse(std::string_view text) {
  return parse_golden(text, "file.golden", find_function("hash.lattice2"), configuration_named("pcg"));
}

TEST(Golden, AValidFileIsRead) {
  const auto golden = parse(kValid);
  ASSERT_TRUE(golden) << golden.error().text();
  EXPECT_EQ(golden->calls, "hn_lattice");
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
  std::string text = kValid;
  const auto at = text.find(corruption.from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string_view(corruption.from).size(), corruption.to);
  const auto golden = parse(text);
  ASSERT_FALSE(golden);
  const std::string& message = golden.error().message;
  EXPECT_TRUE(message.starts_with(fmt::format("file.golden:{}: ", corruption.line))) << message;
  EXPECT_TRUE(message.find(" should ") != std::string::npos || message.find("more than") != std::string::npos ||
              message.find("the file ends") != std::string::npos)
      << message << " names the right text";
  EXPECT_TRUE(std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c <= '~'; })) << message;
}

INSTANTIATE_TEST_SUITE_P(
    All, CorruptGolden,
    testing::Values(
        Corruption{"magic", "golden 2", "golden 1", 1}, Corruption{"function", "lattice2", "lattice3", 2},
        Corruption{"calls", "calls hn_", "calls ", 3}, Corruption{"bits", "bits 0.1.0", "bit", 4},
        Corruption{"columns", "y:i32", "y:u32", 5}, Corruption{"arithmetic", "pcg:exact", "pcg:fast", 6},
        Corruption{"setting", " pcg:exact", "", 6}, Corruption{"rows", "rows 2", "rows two", 7},
        Corruption{"no_rows", "rows 2", "rows 0", 7}, Corruption{"too_few_rows", "rows 2", "rows 1", 9},
        Corruption{"too_many_rows", "rows 2", "rows 3", 10}, Corruption{"short_word", "00000001 f", "0000001 f", 8},
        Corruption{"bad_digit", "0000000a", "0000000g", 8}, Corruption{"sign", "0000000a", "-000000a", 8},
        Corruption{"missing_word", "00000007 =", "=", 9}, Corruption{"extra_word", "0000000a", "0000000a 00000000", 8},
        Corruption{"missing_values", " = 0000000a", "", 8}, Corruption{"more_values", "0a", "0a = 00000000", 8},
        Corruption{"no_values", "0000000a", "-", 8}, Corruption{"space", "\n00000002", " \n00000002", 8},
        Corruption{"digest_word", "digest pcg", "digset pcg", 15}, Corruption{"digest_axes", "size=2,3", "size=2", 10},
        Corruption{"digest_setting", "digest pcg", "digest lattice", 15},
        Corruption{"digest_empty", "size=2,3", "size=2,0", 10},
        Corruption{"digest_huge", "size=2,3", "size=4000000000,4000000000", 10},
        Corruption{"digest_value", "fnv1a64=0123456789abcdef", "fnv1a64=0123", 15},
        Corruption{"digest_missing", " fnv1a64=0123456789abcdef", "", 15},
        Corruption{"carriage_return", "golden 2\n", "golden 2\r\n", 1},
        Corruption{"bytes", "golden 2", "\x1b[2J\xff", 1}, Corruption{"bytes_in_a_row", "ffffffff 0", "\xc2\x9b 0", 8},
        Corruption{"bytes_for_a_row", "00000001 f", "\x80\n", 8},
        Corruption{"bytes_in_the_digest", "seed=5", "seed=\a", 10}, Corruption{"bytes_in_bits", "bits", "\x8f", 4},
        Corruption{"after_the_end", "3210\n", "3210\nmore\n", 11}),
    [](const auto& corruption) { return std::string(corruption.param.name); });

// A row for each line, of Perlin noise on the line with HN_FAST and with HN_FIXED.
Result<Golden> parse_perlin(std::string_view configuration, std::string_view rows) {
  const std::string text = fmt::format(
      "hashnoise golden 2\nfunction noise1d.perlin\ncalls hn_perlin\nbits 0.2.0\ncolumns x:f32 seed:u32 = value:f64\n"
      "settings lattice:fast lattice+fixed:fixed\nrows {}\n{}",
      std::ranges::count(rows, '\n'), rows);
  return parse_golden(text, "file.golden", find_function("noise1d.perlin"), configuration_named(configuration));
}

TEST(Golden, AValueOfFixedArithmeticIsAFloat) {
  const auto golden = parse_perlin("lattice+fixed", "3f000000 00000007 = 3fe0000000000001 = 3fe0000000000000\n");
  ASSERT_TRUE(golden) << golden.error().text();
  EXPECT_EQ(result_bits({"value", WordType::f64}, golden->rows[0].values[0]), 0x3F000000u);
  for (const char* const no_float : {"3fe0000000000001", "7ff8000000000000"}) {
    const auto refused =
        parse_perlin("lattice+fixed", fmt::format("3f000000 00000007 = 3fe0000000000000 = {}\n", no_float));
    ASSERT_FALSE(refused) << no_float;
    EXPECT_TRUE(refused.error().message.starts_with("file.golden:8: ")) << refused.error().message;
  }
}

TEST(Golden, FixedArithmeticHasRowsOfItsOwnAtTheEnd) {
  const std::string whole = "3f000000 00000007 = 3fe0000000000000 = bfe0000000000000\n";
  const std::string of_fixed = "3f800000 00000007 = - = 4000000000000000\n";
  const auto fast = parse_perlin("lattice", whole + of_fixed + of_fixed);
  const auto precise = parse_perlin("lattice+precise", whole + of_fixed + of_fixed);
  const auto fixed = parse_perlin("lattice+fixed", whole + of_fixed + of_fixed);
  ASSERT_TRUE(fast && precise && fixed);
  EXPECT_EQ(fast->rows.size(), 1u);
  EXPECT_EQ(fast->rows[0].values, (std::vector<std::uint64_t>{0x3fe0000000000000u}));
  EXPECT_EQ(precise->rows[0].values, fast->rows[0].values);
  ASSERT_EQ(fixed->rows.size(), 3u);
  EXPECT_EQ(fixed->rows[0].values, (std::vector<std::uint64_t>{0xbfe0000000000000u}));
  EXPECT_EQ(fixed->rows[2].line, 10);
  for (const std::string& wrong : {whole + of_fixed + whole, whole + "3f800000 00000007 = - = -\n" + of_fixed}) {
    const auto refused = parse_perlin("lattice+fixed", wrong);
    ASSERT_FALSE(refused) << wrong;
    EXPECT_NE(refused.error().message.find(" should be "), std::string::npos) << refused.error().message;
  }
}

TEST(Golden, SettingsAreThoseOfTheTable) {
  const auto names = [](std::string_view id) {
    std::string all;
    for (const GoldenSetting& setting : golden_settings(find_function(id))) all += setting.name + " ";
    return all;
  };
  EXPECT_EQ(names("noise1d.perlin"), "lattice:fast lattice+fixed:fixed ");
  EXPECT_EQ(names("noise2d.simplex"), "pcg:fast lattice:fast lattice+fixed:fixed ");
  EXPECT_EQ(names("hash.unorm"), "any:exact ");
  EXPECT_EQ(names("gradient.sine2").substr(0, 33), "fnv1+sine:fast partial_fnv1+sine:");
  EXPECT_EQ(golden_setting(find_function("noise2d.perlin"), configuration_named("lattice+sine+precise")),
            "lattice+sine:fast");
  const auto none = parse_golden("", "file.golden", find_function("noise1d.perlin"), configuration_named("pcg"));
  EXPECT_EQ(none.error().message, "file.golden:0: the configuration has no values of the function");
}

TEST(Golden, EveryTruncationIsAnError) {
  for (std::size_t length = 0; length + 1 < kValid.size(); ++length) {
    EXPECT_FALSE(parse(std::string_view(kValid).substr(0, length))) << length;
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
  EXPECT_NE(message.find("2985 bytes more should be \"hashnoise golden 2\"; tools/make golden"), std::string::npos)
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

TEST(ExactSets, AreThoseOfTheGoldenFilesInTheOrderOfTheirNames) {
  const auto& sets = exact_sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_TRUE(std::ranges::is_sorted(sets, {}, &ExactSet::function));
  std::size_t count = 0;
  for (const Function& function : all_functions()) {
    for (const GoldenSetting& setting : golden_settings(function)) {
      if (!setting.name.ends_with(":exact") && !setting.name.ends_with(":fixed")) continue;
      ASSERT_LT(count, sets.size());
      count += std::ranges::count_if(
          sets, [&](const ExactSet& set) { return set.function == function.id && set.setting == setting.name; });
    }
  }
  EXPECT_EQ(count, sets.size());  // and none of floats
}

TEST(GoldenChecksum, IsThatOfAllFilesInTheOrderOfTheirNames) {
  const TemporaryFolder folder;
  folder.write("b.golden", "6789");
  folder.write("a.golden", "12345");
  folder.write("note.txt", "x");
  EXPECT_EQ(golden_checksum(folder.path()), "cbf43926");  // that of 123456789, by which a CRC-32 is known
  folder.write("a.golden", "12354");
  EXPECT_NE(golden_checksum(folder.path()), "cbf43926");
}

}  // namespace
}  // namespace hn
