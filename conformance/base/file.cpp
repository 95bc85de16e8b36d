#include "base/file.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
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

TemporaryDirectory::TemporaryDirectory() {
  std::string path = (std::filesystem::temp_directory_path() / "hn-conform-XXXXXX").string();
  if (!mkdtemp(path.data())) throw std::system_error(errno, std::generic_category(), path);
  path_ = path;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
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
