#include "base/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

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

}  // namespace hn
