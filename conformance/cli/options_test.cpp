#include "cli/options.hpp"

#include <gtest/gtest.h>

namespace hn {
namespace {

tl::expected<Command, Stop> parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "hn-conform");
  return parse_options(static_cast<int>(arguments.size()), arguments.data(), {.golden = "golden", .expect = "expect"});
}

TEST(Options, OfARunAreTaken) {
  const auto command =
      parse({"run",       "--driver",        "egl*",    "--driver", "zink",     "--seed",    "4294967295", "--shard",
             "2/3",       "--timeout",       "0.5",     "--resume", "--points", "100000000", "--through",  "spirv-opt",
             "--through", "mine {in} {out}", "--takes", "spirv",    "--gives",  "glsl-es"});
  ASSERT_TRUE(command) << command.error().err;
  const auto& run = std::get<RunCommand>(*command);
  EXPECT_EQ(run.selection.drivers, (std::vector<std::string>{"egl*", "zink"}));
  EXPECT_EQ(run.execution.suite.seed, 0xFFFFFFFFu);
  EXPECT_EQ(run.execution.suite.points, 100000000u);
  EXPECT_EQ(run.execution.suite.way.through, (std::vector<std::string>{"spirv-opt", "mine {in} {out}"}));
  EXPECT_EQ(run.execution.suite.way.takes, std::vector<std::string>{"spirv"});
  EXPECT_EQ(run.execution.suite.way.gives, std::vector<std::string>{"glsl-es"});
  EXPECT_EQ(run.selection.shard, "2/3");
  EXPECT_EQ(run.execution.timeout, 0.5);
  EXPECT_TRUE(run.output.resume);
  EXPECT_EQ(run.execution.suite.golden, "golden");
  EXPECT_EQ(run.execution.expect, "expect");
  EXPECT_GE(run.execution.jobs, 1u);
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

TEST(Options, HelpIsACommandToo) {
  EXPECT_EQ(parse({"help"}).error().out, parse({"--help"}).error().out);
  for (const char* const command : {"drivers", "list", "run", "check", "merge", "bench", "paper", "web", "help"}) {
    const auto help = parse({"help", command});
    ASSERT_FALSE(help);
    EXPECT_EQ(help.error().status, 0);
    EXPECT_EQ(help.error().out, parse({command, "--help"}).error().out);
    EXPECT_NE(help.error().out.find("\nExit status: 0 "), std::string::npos) << help.error().out;
  }
  EXPECT_NE(parse({"help"}).error().out.find("also 4, it could not be built"), std::string::npos);
  EXPECT_NE(parse({"run", "--help"}).error().out.find("also 4, it could not be built"), std::string::npos);
}

TEST(Options, ThatAreMisspeltAreSuggested) {
  using Arguments = std::vector<const char*>;
  for (const auto& [arguments, expected] :
       {std::pair<Arguments, std::string>{{"runn"},
                                          "there is no command \"runn\" (did you mean run?); there are drivers"},
        {{"help", "bnech"}, "there is no command \"bnech\" (did you mean bench?)"},
        {{"dance"}, "there is no command \"dance\"; there are drivers"},
        {{"run", "--diver", "x"}, "there is no option --diver (did you mean --driver?); see hn-conform run --help"},
        {{"run", "--out=a", "--diver=x"}, "there is no option --diver (did you mean --driver?)"},
        {{"bench", "--agianst", "x"}, "there is no option --agianst (did you mean --against?)"},
        {{"run", "--walk"}, "there is no option --walk; see hn-conform run --help"},
        {{"run", "-x"}, "there is no option -x; see hn-conform run --help"},
        {{"--verison"}, "there is no option --verison (did you mean --version?); see hn-conform --help"},
        {{"--driver", "zink", "run"}, "--driver belongs after a command, as in hn-conform run --driver"},
        {{"list", "noise2d"}, "\"noise2d\" is one argument too many; see hn-conform list --help"},
        {{"run", "--seed", "-1"}, "; see hn-conform run --help"}}) {
    const auto command = parse(arguments);
    ASSERT_FALSE(command) << expected;
    EXPECT_EQ(command.error().status, kBadUsage);
    EXPECT_NE(command.error().err.find(expected), std::string::npos) << command.error().err;
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

}  // namespace
}  // namespace hn
