#include "base/output_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/file.hpp"
#include "base/temporary_folder.hpp"

namespace hn {
namespace {

std::string refusal(const std::filesystem::path& path) {
  const auto folder = OutputFolder::prepare(path, {"results.json"});
  return folder ? "" : folder.error().message;
}

TEST(OutputFolder, BelongsToOneAtATime) {
  const TemporaryFolder scratch;
  const auto path = scratch.path() / "a" / "out";
  {
    const auto first = OutputFolder::prepare(path, {"results.json"});
    ASSERT_TRUE(first) << first.error().text();
    ASSERT_TRUE(write_file(path / "results.json", "mine"));
    const std::string second = refusal(path);
    EXPECT_NE(second.find(fmt::format("{} is in use by process {} (", path.string(), getpid())), std::string::npos)
        << second;
    EXPECT_NE(second.find("--out"), std::string::npos) << second;
    EXPECT_EQ(read_file(path / "results.json").value(), "mine") << "the second touches nothing";
    EXPECT_EQ(refusal(scratch.path()), "") << "only this folder is taken";
  }
  EXPECT_EQ(refusal(path), "");
  EXPECT_TRUE(std::filesystem::is_empty(path)) << "nothing is left of it";
}

TEST(OutputFolder, ThatCannotBeOneSaysWhy) {
  const TemporaryFolder scratch;
  scratch.write("file", "");
  EXPECT_NE(refusal(scratch.path() / "file").find("Not a directory"), std::string::npos);
  EXPECT_NE(refusal(scratch.path() / "file" / "out").find("Not a directory"), std::string::npos);
  std::filesystem::create_directories(scratch.path() / "taken" / "results.json");
  EXPECT_NE(refusal(scratch.path() / "taken").find("results.json: it is a folder"), std::string::npos);
}

}  // namespace
}  // namespace hn
