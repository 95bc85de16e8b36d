#include "base/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace hn {

namespace {

std::filesystem::path draft_of(const std::filesystem::path& path) { return path.string() + ".part"; }

}  // namespace

Result<void> prepare_output(const std::filesystem::path& directory, std::initializer_list<std::string_view> names) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    return fail(fmt::format("cannot make the folder {}: {}; --out wants a folder that can be written",
                            directory.string(), error.message()));
  }
  for (const std::string_view name : names) {
    // Results of an earlier run must not pass for those of one that ends before it has any.
    const auto path = directory / name;
    if (!std::filesystem::is_directory(path)) std::filesystem::remove(path, error);
    const bool writable = !std::filesystem::exists(path) && std::ofstream(draft_of(path)).good();
    std::filesystem::remove(draft_of(path), error);
    if (!writable) {
      return fail(fmt::format("cannot write {}; --out wants a folder that can be written", path.string()));
    }
  }
  return {};
}

Result<std::string> read_file(const std::filesystem::path& path, std::string_view hint) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes;
  std::array<char, 65536> part;
  while (in.read(part.data(), part.size()) || in.gcount() > 0) bytes.append(part.data(), static_cast<std::size_t>(in.gcount()));
  if (in.eof()) return bytes;
  return fail(fmt::format("cannot read {}: {}{}{}", path.string(), std::strerror(errno), hint.empty() ? "" : "; ", hint));
}

std::string end_of_log(const std::filesystem::path& path, std::size_t most, std::size_t from) {
  std::string text = read_file(path).value_or("");
  return text.substr(std::max(std::min(from, text.size()), text.size() - std::min(most, text.size())));
}

Result<void> write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  {
    std::ofstream out(draft_of(path), std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!out.flush()) return fail(fmt::format("cannot write {}", draft_of(path).string()));
  }
  std::filesystem::rename(draft_of(path), path, error);
  if (error) return fail(fmt::format("cannot write {}: {}", path.string(), error.message()));
  return {};
}

}  // namespace hn
