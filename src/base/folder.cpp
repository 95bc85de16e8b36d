#include "base/folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "base/file.hpp"
#include "base/text.hpp"

namespace hn {
namespace {

constexpr std::string_view kHint = "--out wants a folder that can be written";

// The arguments of a process, or nothing.
std::string command_of(const std::string& pid) {
  std::string command = read_file("/proc/" + pid + "/cmdline").value_or("");
  std::replace(command.begin(), command.end(), '\0', ' ');
  return command.substr(0, command.find_last_not_of(' ') + 1);
}

// Who has the lock of a file. The lines of /proc/locks are "1: FLOCK  ADVISORY  WRITE PID MAJOR:MINOR:INODE START END".
std::string holder_of(int fd) {
  struct stat file {};
  std::ifstream locks("/proc/locks");
  if (fstat(fd, &file) != 0 || !locks) return "another process";
  const std::string inode = fmt::format(":{}", file.st_ino);
  for (std::string line; std::getline(locks, line);) {
    std::istringstream words(line);
    std::string number, kind, strictness, mode, pid, place;
    words >> number >> kind >> strictness >> mode >> pid >> place;
    // One of another container has the number 0 here.
    if (kind != "FLOCK" || !place.ends_with(inode) || pid == "0") continue;
    const std::string command = command_of(pid);
    return fmt::format("process {}{}", pid, command.empty() ? "" : fmt::format(" ({})", printable(command)));
  }
  return "another process";
}

Result<FileDescriptor> lock(const std::filesystem::path& directory) {
  FileDescriptor folder(open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() < 0) {
    return fail(fmt::format("cannot open the folder {}: {}; {}", directory.string(), std::strerror(errno), kHint));
  }
  // Some file systems have no locks; there nobody is kept out.
  if (flock(folder.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    return fail(fmt::format("the folder {} is in use by {}; wait for its end, or name another folder with --out",
                            directory.string(), holder_of(folder.get())));
  }
  return folder;
}

Result<void> make_room(const std::filesystem::path& path) {
  std::error_code error;
  const auto cannot = [&](const std::string& why) {
    return fail(fmt::format("cannot write {}: {}; {}", path.string(), why, kHint));
  };
  if (std::filesystem::is_directory(path, error)) return cannot("it is a folder");
  // Results of an earlier run must not pass for those of one that ends before it has any.
  std::filesystem::remove(path, error);
  if (error) return cannot(error.message());
  HN_DO(write_file(path, ""));
  std::filesystem::remove(path, error);
  return {};
}

}  // namespace

Result<OutputFolder> OutputFolder::prepare(const std::filesystem::path& directory,
                                           std::initializer_list<std::string_view> names) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    return fail(fmt::format("cannot make the folder {}: {}; {}", directory.string(), error.message(), kHint));
  }
  HN_TRY(auto lock_of_folder, lock(directory));
  for (const std::string_view name : names) HN_DO(make_room(directory / name));
  return OutputFolder(std::move(lock_of_folder));
}

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
