#include "base/command_line.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace hn {
namespace {

TEST(CommandLine, IsAsAShellWouldTakeItAgain) {
  const std::vector<const char*> arguments = {"/usr/bin/hn-conform", "bench", "--filter", "a*", "it's", "", "x=y"};
  EXPECT_EQ(command_line("hn-conform", static_cast<int>(arguments.size()), arguments.data()),
            "hn-conform bench --filter 'a*' 'it'\\''s' '' x=y");
}

}  // namespace
}  // namespace hn
