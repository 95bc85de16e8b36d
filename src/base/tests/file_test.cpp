#include "base/file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <set>
#include <string>

#include "base/folder.hpp"

namespace hn {
namespace {

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

TEST(File, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  for (const std::string& bytes : {std::string(), std::string("a\r\n\0b", 5), std::string(200000, 'x')}) {
    ASSERT_TRUE(write_file(folder.path() / "some" / "file", bytes));
    EXPECT_EQ(read_file(folder.path() / "some" / "file").value(), bytes);
  }
}

TEST(File, ThatCannotBeReadIsAnErrorThatNamesIt) {
  const TemporaryFolder folder;
  const auto folder_itself = read_file(folder.path());
  ASSERT_FALSE(folder_itself);
  EXPECT_EQ(folder_itself.error().text(), "cannot read " + folder.path().string() + ": Is a directory");
  const auto absent = read_file(folder.path() / "absent", "it should be here");
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().text(),
            "cannot read " + (folder.path() / "absent").string() + ": No such file or directory; it should be here");
}

TEST(File, ThatCannotBeWrittenSaysWhyAndIsAsItWas) {
  const TemporaryFolder folder;
  folder.write("file", "before");
  const auto problem = [](const std::filesystem::path& path, std::string_view bytes) {
    const auto written = write_file(path, bytes);
    return written ? "" : written.error().text();
  };
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string too_large = problem(folder.path() / "file", std::string(200000, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(too_large, "cannot write " + (folder.path() / "file").string() + ": File too large");
  EXPECT_EQ(read_file(folder.path() / "file").value(), "before");
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"file"}));
  EXPECT_EQ(problem(folder.path(), "x"), "cannot write " + folder.path().string() + ": Is a directory");
  EXPECT_EQ(problem(folder.path() / "file" / "below", "x"),
            "cannot write " + (folder.path() / "file" / "below").string() + ": Not a directory");
}

TEST(File, BehindALinkIsWrittenAndTheLinkStays) {
  const TemporaryFolder folder;
  folder.write("target", "before");
  std::filesystem::create_symlink("target", folder.path() / "link");
  ASSERT_TRUE(write_file(folder.path() / "link", "behind"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link"));
  EXPECT_EQ(read_file(folder.path() / "target").value(), "behind");
}

TEST(File, BehindALinkIsMadeIfThereIsNone) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("second", folder.path() / "first");
  std::filesystem::create_symlink(folder.path() / "file", folder.path() / "second");
  ASSERT_TRUE(write_file(folder.path() / "first", "x"));
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"first", "second", "file"}));
  EXPECT_EQ(read_file(folder.path() / "file").value(), "x");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "second"));
  std::filesystem::create_symlink("circle", folder.path() / "circle");
  EXPECT_FALSE(write_file(folder.path() / "circle", "x"));
}

TEST(File, ThatIsProtectedIsNotReplaced) {
  const TemporaryFolder folder;
  folder.write("file", "before");
  const std::filesystem::path file = folder.path() / "file";
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  std::filesystem::permissions(file, std::filesystem::perms::owner_read | std::filesystem::perms::others_read);
  const uid_t user = geteuid();
  constexpr uid_t kNobody = 65534;
  if (user == 0 && seteuid(kNobody) != 0) GTEST_SKIP() << "root may write to everything";
  const auto written = write_file(file, "x");
  ASSERT_EQ(seteuid(user), 0);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().text(), "cannot write " + file.string() + ": Permission denied");
  EXPECT_EQ(read_file(file).value(), "before");
}

TEST(File, KeepsItsMode) {
  const TemporaryFolder folder;
  folder.write("file", "before");
  const auto mode = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(folder.path() / "file", mode);
  ASSERT_TRUE(write_file(folder.path() / "file", "behind"));
  EXPECT_EQ(std::filesystem::status(folder.path() / "file").permissions(), mode);
}

TEST(File, ReplacesNothingBesideItself) {
  const TemporaryFolder folder;
  const std::string draft = "file." + std::to_string(getpid()) + "-0.part";
  for (const std::string& name : {std::string("file.part"), std::string("file.try"), draft}) folder.write(name, "mine");
  ASSERT_TRUE(write_file(folder.path() / "file", "text"));
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"file", "file.part", "file.try", draft}));
  EXPECT_EQ(read_file(folder.path() / draft).value(), "mine");
}

// As root, a program would replace /dev/null.
TEST(File, ThatIsNoRegularOneIsAnError) {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("pipe", folder.path() / "link");
  for (const auto& path : {pipe, folder.path() / "link"}) {
    const auto written = write_file(path, "x");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().text(), "cannot write " + path.string() + ": it is no regular file");
  }
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"pipe", "link"}));
}

TEST(File, EndsOfLogsAreAsLongAsTheyMayBe) {
  const TemporaryFolder folder;
  folder.write("log", "0123456789");
  const auto end = [&](std::size_t most, std::size_t from) { return end_of_log(folder.path() / "log", most, from); };
  EXPECT_EQ(end(3, 0), "789");
  EXPECT_EQ(end(100, 0), "0123456789");
  EXPECT_EQ(end(100, 8), "89");
  EXPECT_EQ(end(1, 8), "9");
  EXPECT_EQ(end(100, 11), "");
  EXPECT_EQ(end_of_log(folder.path() / "absent", 3), "");
}

TEST(TemporaryFolder, IsGoneAfterItsLastOwner) {
  std::filesystem::path path;
  {
    TemporaryFolder first;
    path = first.path();
    first.write("file", "x");
    const TemporaryFolder second = std::move(first);
    EXPECT_EQ(second.path(), path);
    EXPECT_TRUE(std::filesystem::exists(path / "file"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

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
