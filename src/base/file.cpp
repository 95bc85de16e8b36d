#include "base/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <system_error>

namespace hn {
namespace {

constexpr int kMostDrafts = 100;  // that earlier processes of this number may have left
constexpr int kMostLinks = 40;    // behind each other, as in Linux

tl::unexpected<Error> cannot_write(const std::filesystem::path& path, std::string_view why) {
  return fail(fmt::format("cannot write {}: {}", path.string(), why));
}

// The file that a path leads to, or would lead to: a link may name a file that does not exist yet.
std::filesystem::path behind_links(std::filesystem::path path) {
  std::error_code error;
  for (int links = 0; links < kMostLinks && std::filesystem::is_symlink(path, error); ++links) {
    path = path.parent_path() / std::filesystem::read_symlink(path, error);
  }
  return path;
}

// An empty file beside the one that it will replace, which no other file has the name of.
struct Draft {
  std::filesystem::path path;
  std::filesystem::path target;  // the file, behind all links
  std::FILE* out;
};
Result<Draft> open_draft(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path target = behind_links(path);
  if (std::filesystem::is_symlink(target, error)) return cannot_write(path, std::strerror(ELOOP));
  const std::filesystem::file_status status = std::filesystem::status(target, error);
  const bool is_there = std::filesystem::exists(status);
  // Devices, pipes and sockets would be replaced, too. rename() refuses folders.
  if (is_there && !std::filesystem::is_regular_file(status) && !std::filesystem::is_directory(status)) {
    return cannot_write(path, "it is no regular file");
  }
  // rename() needs only a folder that one may write to, and would replace a file that is protected.
  if (is_there && faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) {
    return cannot_write(path, std::strerror(errno));
  }
  for (int number = 0; number < kMostDrafts; ++number) {
    const std::filesystem::path draft = fmt::format("{}.{}-{}.part", target.string(), getpid(), number);
    const int file = open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0 && errno == EEXIST) continue;
    if (file < 0) break;
    if (is_there) fchmod(file, static_cast<mode_t>(status.permissions()));
    return Draft{draft, target, fdopen(file, "wb")};
  }
  return cannot_write(path, std::strerror(errno));
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path, std::string_view hint) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes;
  std::array<char, 65536> part;
  while (in.read(part.data(), part.size()) || in.gcount() > 0)
    bytes.append(part.data(), static_cast<std::size_t>(in.gcount()));
  if (in.eof()) return bytes;
  return fail(
      fmt::format("cannot read {}: {}{}{}", path.string(), std::strerror(errno), hint.empty() ? "" : "; ", hint));
}

std::string end_of_log(const std::filesystem::path& path, std::size_t most, std::size_t from) {
  std::string text = read_file(path).value_or("");
  return text.substr(std::max(std::min(from, text.size()), text.size() - std::min(most, text.size())));
}

Result<void> write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  const auto draft = open_draft(path);
  if (!draft) return tl::unexpected(draft.error());
  // Some file systems report only when a file is closed that they are full.
  int problem = std::fwrite(bytes.data(), 1, bytes.size(), draft->out) == bytes.size() ? 0 : errno;
  if (std::fclose(draft->out) != 0 && problem == 0) problem = errno;
  if (problem == 0) {
    std::filesystem::rename(draft->path, draft->target, error);
    if (!error) return {};
  }
  const std::string why = problem != 0 ? std::strerror(problem) : error.message();
  std::filesystem::remove(draft->path, error);
  return cannot_write(path, why);
}

}  // namespace hn
