#include "base/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <system_error>

namespace hn {

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
  const std::filesystem::path draft = path.string() + ".part";
  const auto cannot = [&](const std::string& why) {
    std::filesystem::remove(draft, error);
    return fail(fmt::format("cannot write {}: {}", path.string(), why));
  };
  std::FILE* const out = std::fopen(draft.c_str(), "wb");
  if (!out) return cannot(std::strerror(errno));
  // Some file systems report only when a file is closed that they are full.
  int problem = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size() ? 0 : errno;
  if (std::fclose(out) != 0 && problem == 0) problem = errno;
  if (problem != 0) return cannot(std::strerror(problem));
  std::filesystem::rename(draft, path, error);
  if (error) return cannot(error.message());
  return {};
}

}  // namespace hn
