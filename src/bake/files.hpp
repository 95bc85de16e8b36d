// Makes what is written: the bytes of each file, and how the values became what is in them.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "bake/options.hpp"
#include "bake/planes.hpp"
#include "base/result.hpp"

namespace hn {

// How a component became 16 bits.
struct Mapping {
  Interval interval;
  std::string_view source;  // "documented", "given" or "normalized"
  std::size_t clamped = 0;
};

struct Component {
  std::string name;
  hashnoise::Range range;          // of the values, before they are mapped
  std::optional<Mapping> mapping;  // for 16 bits
  std::size_t nans = 0;            // values that are NaN
};

// How the slices of a volume lie in a picture. Of what is no volume there is one.
struct Atlas {
  int slices = 1;
  int columns = 1;
  int rows = 1;
};

struct Report {
  std::vector<std::filesystem::path> files;
  std::vector<Component> components;
  int width = 0;  // of a picture, in pixels
  int height = 0;
  Atlas atlas;
};

// The intervals of these components: documented, or given. Empty for floats, and for --normalize, which finds them. The
// error names a component without one, or another misfit of the format. It is known before anything is computed.
Result<std::vector<Mapping>> mappings_of(const BakeOptions& options, const std::vector<std::string>& components);

// The files that write_files makes. A slice of heights.exr is in heights.007.exr.
std::vector<std::filesystem::path> files_of(const BakeOptions& options);

// Writes bytes to a file; if it fails, nothing of the file may be left.
using WriteFile = std::function<Result<void>(const std::filesystem::path& path, std::string_view bytes)>;

// Makes and writes the files; the planes are used up.
Result<Report> write_files(const BakeOptions& options, Planes planes, std::vector<Mapping> mappings,
                           const WriteFile& write);

// The settings behind the values, and their order in the file: all that the bytes depend on.
nlohmann::ordered_json record_of(const BakeOptions& options, const Planes& planes, const Report& report);

}  // namespace hn
