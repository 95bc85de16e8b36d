#include "paper/algorithm.hpp"

#include <fmt/format.h>

#include <array>

#include "base/entry_named.hpp"
#include "paper/files.hpp"

namespace hn {
namespace {

constexpr std::array kAlgorithms = {
    Algorithm{"fnv1", "Perlin/FNV1", "FNV1", true},
    Algorithm{"partial_fnv1", "Perlin/PartialFNV1", "PARTIAL_FNV1", true},
    Algorithm{"jenkins", "Perlin/Jenkins", "JENKINS", true},
    Algorithm{"partial_jenkins", "Perlin/PartialJenkins", "PARTIAL_JENKINS", true},
    Algorithm{"murmur", "Perlin/Murmur", "MURMUR", true},
    Algorithm{"float", "Perlin/Float", "1", true},
    Algorithm{"integer", "Perlin/Integer", "2", true},
    Algorithm{"lattice", "hashnoise's default", "LATTICE", false},
};

bool is_table(const Algorithm& algorithm) { return algorithm.name == "float" || algorithm.name == "integer"; }

// The lines that declare the noise.
std::string prelude(const Entry& entry) {
  const std::string_view macro = entry.algorithm->macro;
  switch (entry.form) {
    case AlgorithmForm::published:
      return fmt::format("#define PAPER_HASH PAPER_{}\n#include \"published.glsl\"\n", macro);
    case AlgorithmForm::table:
      return fmt::format("#define TABLE_ARITHMETIC {}\n#include \"tables.glsl\"\n", macro);
    case AlgorithmForm::intended:
      return fmt::format(
          "#define HN_HASH HN_HASH_{}\n#define HN_GRADIENT HN_GRADIENT_SINE\n"
          "#include \"noise2d.glsl\"\n#include \"noise3d.glsl\"\n",
          macro);
    case AlgorithmForm::ours:
      break;
  }
  return fmt::format("#define HN_HASH HN_HASH_{}\n#include \"noise2d.glsl\"\n#include \"noise3d.glsl\"\n", macro);
}

// The noise at a position. The table noises and the listings have no seed, and periods of their own.
std::string noise_at(std::string_view position, const Entry& entry, int dimensions, std::uint32_t period,
                     std::string_view seed) {
  if (entry.form == AlgorithmForm::published) return fmt::format("paper_perlin({})", position);
  if (entry.form == AlgorithmForm::table) return fmt::format("table_perlin({})", position);
  const std::uint32_t cells = entry.form == AlgorithmForm::intended ? kPaperPeriod : period;
  if (cells == 0) return fmt::format("hn_perlin({})", position);
  return fmt::format("hn_perlin(hn_tile({}, ivec{}({})), {})", position, dimensions, cells, seed);
}

}  // namespace

std::string_view name_of(AlgorithmForm form) {
  constexpr std::array<std::string_view, 4> kNames = {"published", "intended", "ours", "table"};
  return kNames[static_cast<std::size_t>(form)];
}

std::string_view title_of(AlgorithmForm form) {
  constexpr std::array<std::string_view, 4> kTitles = {"as published", "as intended", "ours", "tables in textures"};
  return kTitles[static_cast<std::size_t>(form)];
}

std::span<const Algorithm> all_algorithms() { return kAlgorithms; }

const Algorithm& algorithm_named(std::string_view name) {
  return entry_named(kAlgorithms, &Algorithm::name, name, "algorithm");
}

std::string Entry::id() const { return fmt::format("{}.{}", algorithm->name, name_of(form)); }

std::vector<Entry> all_entries() {
  std::vector<Entry> entries;
  for (const Algorithm& algorithm : kAlgorithms) {
    if (is_table(algorithm)) {
      entries.push_back({&algorithm, AlgorithmForm::table});
    } else if (!algorithm.printed) {
      entries.push_back({&algorithm, AlgorithmForm::ours});
    } else {
      for (const AlgorithmForm form : {AlgorithmForm::published, AlgorithmForm::intended, AlgorithmForm::ours})
        entries.push_back({&algorithm, form});
    }
  }
  return entries;
}

std::string_view name_of(Picture picture) {
  constexpr std::array<std::string_view, 3> kNames = {"noise", "turbulence", "clouds"};
  return kNames[static_cast<std::size_t>(picture)];
}

Subject subject_of(const Entry& entry, int dimensions, Picture picture, std::uint32_t period) {
  const std::string id = fmt::format("{}.{}d", entry.id(), dimensions);
  std::string text = prelude(entry);
  if (picture == Picture::noise) {
    return {id, dimensions, std::move(text), noise_at("p", entry, dimensions, period, "0u")};
  }
  text += fmt::format("#include \"fbm{}d.glsl\"\n", dimensions);
  std::string expression = fmt::format("hn_{}(p, 6, 2.0, 0.5)", name_of(picture));
  // Without a seed the octaves are all of the same field.
  if (entry.form != AlgorithmForm::ours || period != 0) {
    const bool is_clouds = picture == Picture::clouds;
    text += fmt::format(
        "float paper_sum(hn_octaves{} o) {{\n  do {}(o, {}); while (hn_next(o));\n  return {}(o);\n}}\n", dimensions,
        is_clouds ? "hn_add" : "hn_add_turbulence",
        noise_at("hn_position(o.place)", entry, dimensions, period, "o.seed"), is_clouds ? "hn_density" : "hn_mean");
    expression = "paper_sum(hn_octaves(p, 6, 2.0, 0.5, 0u))";
  }
  return {fmt::format("{}.{}", id, name_of(picture)), dimensions, std::move(text), std::move(expression)};
}

SourceSet with_published_listings(SourceSet sources) {
  constexpr std::string_view kName = "published.glsl";
  sources.add(std::string(kName), std::string(text_of(kPaperFiles, kName)), "conformance/paper/published.glsl");
  return sources;
}

}  // namespace hn
