#include "cli/options.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

tl::expected<Command, Stop> parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "hn-conform");
  return parse_options(static_cast<int>(arguments.size()), arguments.data(), {.golden = "golden", .expect = "expect"});
}

TEST(Options, OfARunAreTaken) {
  const auto command = parse({"run", "--driver", "egl*", "--driver", "zink", "--seed", "4294967295", "--shard", "2/3",
                              "--timeout", "0.5", "--resume", "--points", "100000000"});
  ASSERT_TRUE(command) << command.error().err;
  const auto& run = std::get<RunCommand>(*command);
  EXPECT_EQ(run.drivers, (std::vector<std::string>{"egl*", "zink"}));
  EXPECT_EQ(run.suite.seed, 0xFFFFFFFFu);
  EXPECT_EQ(run.suite.points, 100000000u);
  EXPECT_EQ(run.shard, "2/3");
  EXPECT_EQ(run.timeout, 0.5);
  EXPECT_TRUE(run.resume);
  EXPECT_EQ(run.suite.golden, "golden");
  EXPECT_EQ(run.expect, "expect");
  EXPECT_GE(run.jobs, 1u);
}

TEST(Options, HelpAndVersionAreNoErrors) {
  for (const auto& arguments : {std::vector<const char*>{"--help"}, {"run", "--help"}, {"--version"}}) {
    const auto command = parse(arguments);
    ASSERT_FALSE(command);
    EXPECT_EQ(command.error().status, 0);
    EXPECT_FALSE(command.error().out.empty());
    EXPECT_TRUE(command.error().err.empty());
  }
}

TEST(Options, ThatAreWrongAreBadUsage) {
  for (const auto& arguments : {std::vector<const char*>{},
                                {"walk"},
                                {"run", "--walk"},
                                {"run", "--out"},
                                {"run", "list"},
                                {"merge"},
                                {"run", "--seed", "-1"},
                                {"run", "--seed", "4294967296"},
                                {"run", "--seed", "1.5"},
                                {"run", "--points", "0"},
                                {"run", "--points", "-1"},
                                {"run", "--points", "1e8"},
                                {"run", "--points", "10000000001"},
                                {"run", "--jobs", "0"},
                                {"run", "--timeout", "0"},
                                {"run", "--timeout", "inf"},
                                {"run", "--timeout", "nan"},
                                {"bench", "--rounds", "2"}}) {
    const auto command = parse(arguments);
    ASSERT_FALSE(command) << arguments.back();
    EXPECT_EQ(command.error().status, kBadUsage);
    EXPECT_FALSE(command.error().err.empty());
  }
}

TEST(CommandLine, IsAsAShellWouldTakeItAgain) {
  const std::vector<const char*> arguments = {"/usr/bin/hn-conform", "bench", "--filter", "a*", "it's", "", "x=y"};
  EXPECT_EQ(command_line(static_cast<int>(arguments.size()), arguments.data()),
            "hn-conform bench --filter 'a*' 'it'\\''s' '' x=y");
}

}  // namespace
}  // namespace hn
