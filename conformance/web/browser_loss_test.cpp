// Tries what can happen to a browser, and that it leaves nothing behind.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "base/file.hpp"
#include "web/browser_story.hpp"

namespace hn {
namespace {

// Kills the processes that have this in their command line.
void kill_chromium(std::string_view type) {
  for (const pid_t pid : chromium_of(getpid())) {
    const auto line = read_file(std::filesystem::path("/proc") / std::to_string(pid) / "cmdline");
    if (line && line->find(type) != std::string::npos) kill(pid, SIGKILL);
  }
}

void expect_the_others_go_on(std::string_view browser, const std::vector<std::string>& ids, const std::string& lost) {
  Story story;
  story.on_start = [&](const std::string& id) {
    if (id == lost) kill_chromium("--type=gpu-process");
  };
  const auto done = run(story, ids, browser);
  ASSERT_TRUE(done) << browser << ": " << done.error().text();
  EXPECT_EQ(story.finished_ids(), ids);
  for (const std::string& id : ids) {
    EXPECT_EQ(story.outcome(id).status, id == lost ? Status::crash : Status::pass)
        << browser << ": " << id << ": " << story.outcome(id).message;
  }
}

TEST(BrowserLoss, ALostContextCostsItsCaseAndTheOthersGoOn) {
  const std::vector<std::string> in_wgsl = {"hash.vec2.lattice.exact.compute.wgsl.golden",
                                            "noise2d.perlin.lattice.fixed.compute.wgsl.golden",
                                            "fbm.fbm2.lattice.fixed.compute.wgsl.golden"};
  for (const Browser& browser : all_browsers()) {
    const bool webgpu = browser.platform == Platform::webgpu;
    expect_the_others_go_on(browser.name, webgpu ? in_wgsl : kSome, webgpu ? in_wgsl[1] : kNoise);
  }
}

TEST(BrowserLoss, APageOrABrowserThatIsGoneIsAnErrorThatNamesTheCase) {
  for (const std::string_view gone : {"--type=renderer", "--headless=new"}) {
    Story story;
    story.on_start = [&](const std::string& id) {
      if (id == kNoise) kill_chromium(gone);
    };
    const auto done = run(story, kSome);
    ASSERT_FALSE(done) << gone;
    EXPECT_NE(done.error().message.find(std::string("while ") + kNoise + " ran"), std::string::npos)
        << done.error().message;
    EXPECT_EQ(story.finished_ids(), std::vector<std::string>{kHash});
    expect_nothing_is_left(getpid());
  }
}

// hn-conform kills what takes too long, and may be killed itself: with its whole group, and while Chromium is stopped.
TEST(BrowserLoss, NothingOutlivesAProcessThatIsKilled) {
  std::array<int, 2> running{};
  ASSERT_EQ(pipe(running.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    setpgid(0, 0);
    Story story;
    story.on_start = [&](const std::string&) {
      for (const pid_t pid : chromium_of(getpid())) kill(pid, SIGSTOP);
      if (write(running[1], "x", 1) == 1) pause();
    };
    const bool ended = run(story, kSome).has_value();
    _exit(ended ? 0 : 1);
  }
  close(running[1]);
  char byte = 0;
  EXPECT_EQ(read(running[0], &byte, 1), 1);
  EXPECT_FALSE(chromium_of(child).empty());
  kill(-child, SIGKILL);
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  expect_nothing_is_left(child);
  // Chromium and its guard had the other end as well, unless they closed it.
  EXPECT_EQ(read(running[0], &byte, 1), 0);
  close(running[0]);
}

TEST(BrowserLoss, AFolderThatWasLeftIsRemoved) {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  std::filesystem::create_directories(std::filesystem::temp_directory_path() / (folder_of(child) + "left"));
  ASSERT_TRUE(has_folders(child));
  ASSERT_TRUE(describe_browser(browser_named("webgl2")));
  EXPECT_FALSE(has_folders(child));
}

}  // namespace
}  // namespace hn
