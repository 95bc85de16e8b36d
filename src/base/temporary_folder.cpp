#include "base/temporary_folder.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <fstream>
#include <system_error>
#include <utility>

namespace hn {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "hashnoise-";
constexpr int kMostAttempts = 10;

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string path = (fs::temp_directory_path() / (prefix(getpid()) + "XXXXXX")).string();
  if (!mkdtemp(path.data())) throw std::system_error(errno, std::generic_category(), path);
  path_ = path;
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

void TemporaryFolder::write(std::string_view name, std::string_view text) const {
  const fs::path path = path_ / name;
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

std::string TemporaryFolder::prefix(pid_t owner) { return fmt::format("{}{}-", kPrefix, owner); }

void remove_folders_of(pid_t owner) {
  std::error_code error;
  const std::string prefix = TemporaryFolder::prefix(owner);
  bool any = true;
  for (int attempt = 0; any && attempt < kMostAttempts; ++attempt) {  // it may still write into them
    any = false;
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path(error), error)) {
      if (!entry.path().filename().string().starts_with(prefix)) continue;
      fs::remove_all(entry.path(), error);
      any = true;
    }
  }
}

void remove_left_folders() {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fs::temp_directory_path(), error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(kPrefix)) continue;
    pid_t owner = 0;
    std::from_chars(name.data() + kPrefix.size(), name.data() + name.size(), owner);
    const bool left = owner > 0 && kill(owner, 0) != 0 && errno == ESRCH;
    if (left) fs::remove_all(entry.path(), error);
  }
}

}  // namespace hn
