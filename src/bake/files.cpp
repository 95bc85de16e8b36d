#include "bake/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "bake/ktx2.hpp"
#include "bake/mapping.hpp"
#include "bake/picture.hpp"
#include "base/file.hpp"
#include "base/json.hpp"
#include "base/version.hpp"
#include "grid/functions.hpp"
#include "grid/ranges.hpp"
#include "grid/rules.hpp"

namespace hn {
namespace {

constexpr std::size_t kMostInPng = 4;
constexpr long long kLongestSide = 1 << 24;  // of a picture; far beyond what programs read

bool is_picture(Format format) { return format == Format::png || format == Format::exr; }

// The slices of a volume are numbered along z, then w.
Atlas atlas_of(const BakeOptions& options) {
  Atlas atlas;
  for (std::size_t axis = 2; axis < options.size.size(); ++axis) atlas.slices *= options.size[axis];
  if (!is_picture(options.format) || options.layout == Layout::slices || atlas.slices == 1) return atlas;
  const double width = options.size[0];
  const double height = options.size[1];
  const auto square = static_cast<int>(std::ceil(std::sqrt(atlas.slices * height / width)));
  atlas.columns = std::clamp(options.columns != 0 ? options.columns : square, 1, atlas.slices);
  atlas.rows = (atlas.slices + atlas.columns - 1) / atlas.columns;
  return atlas;
}

int height_of_slice(const BakeOptions& options) { return options.size.size() > 1 ? options.size[1] : 1; }

// The values of some slices as a picture; where an atlas has no slice it is 0.
template <typename T>
std::vector<T> arranged(std::span<const T> values, int width, int height, const Atlas& atlas) {
  if (atlas.columns == 1) return {values.begin(), values.end()};
  const auto across = static_cast<std::size_t>(width);
  const auto down = static_cast<std::size_t>(height);
  const auto columns = static_cast<std::size_t>(atlas.columns);
  std::vector<T> picture(across * down * columns * static_cast<std::size_t>(atlas.rows));
  for (std::size_t row = 0; row < values.size() / across; ++row) {
    const std::size_t slice = row / down;
    const std::size_t y = slice / columns * down + row % down;
    const std::size_t x = slice % columns * across;
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(row * across), across,
                picture.begin() + static_cast<std::ptrdiff_t>(y * across * columns + x));
  }
  return picture;
}

// Names that programs for pictures look for, if there are not more channels than these.
std::string channel_name(const std::vector<Component>& components, std::size_t index) {
  if (components.size() == 1) return "Y";
  return components.size() > kMostInPng ? components[index].name : std::string(1, "RGBA"[index]);
}

// The parameters of a function of the library.
nlohmann::ordered_json parameters_of(const BakeOptions& options) {
  using namespace hashnoise;
  const Settings& settings = options.settings;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (!settings.noise.empty()) json["noise"] = settings.noise;
  // Floats as they are written shortest, not as the doubles that they are.
  const auto number = [](float value) { return nlohmann::json::parse(fmt::format("{}", value)); };
  for (const float along : settings.wave) json["wave"].push_back(nlohmann::ordered_json(number(along)));
  if (settings.phase) json["phase"] = number(*settings.phase);
  const auto number_or_usual = [&](const std::optional<float>& value, const grid::Rule& rule) {
    return number(value.value_or(static_cast<float>(rule.usual)));
  };
  if (settings.fractal.empty()) {
    const grid::NoiseRow& noise = grid::kNoiseRows[grid::noise_named(settings.noise)];
    if (noise.has_jitter()) json["jitter"] = number_or_usual(settings.jitter, grid::kJitterRule);
    if (noise.has_metric()) {
      json["metric"] = grid::kMetricNames[static_cast<std::size_t>(settings.metric.value_or(Metric::kEuclidean)) - 1];
    }
  } else {
    if (settings.detail) {
      json["detail"] = number(*settings.detail);
    } else {
      json["octaves"] = settings.octaves.value_or(static_cast<int>(grid::kOctavesRule.usual));
    }
    if (settings.footprint) json["footprint"] = number(*settings.footprint);
    json["lacunarity"] = number_or_usual(settings.lacunarity, grid::kLacunarityRule);
    json["gain"] = number_or_usual(settings.gain, grid::kGainRule);
    const grid::SumRow& sum = grid::sum_row(settings.fractal);
    if (!sum.strength.empty())
      json[std::string(sum.strength)] = number(strength_of(settings, sum).value_or(sum.usual_strength));
  }
  return json;
}

nlohmann::ordered_json settings_of(const BakeOptions& options, hashnoise::InstructionSet set) {
  using namespace hashnoise;
  const Settings& settings = options.settings;
  nlohmann::ordered_json json;
  if (options.expression) {
    json["expression"] = options.expression->text;
    if (!options.expression->source.empty()) json["source"] = options.expression->source_text;
  } else {
    json = parameters_of(options);
  }
  constexpr std::string_view kArithmetics[] = {"fast", "precise", "fixed"};
  json["arithmetic"] = kArithmetics[static_cast<std::size_t>(settings.arithmetic) - 1];
  // The others have the same bits by all of them.
  if (settings.arithmetic == Arithmetic::kFast && !options.expression) json["instruction_set"] = name(set);
  json["seed"] = settings.seed;
  const auto end = settings.period.begin() + static_cast<std::ptrdiff_t>(options.size.size());
  if (std::any_of(settings.period.begin(), end, [](int period) { return period != 0; })) {
    json["period"] = std::vector<std::int32_t>(settings.period.begin(), end);
  }
  return json;
}

nlohmann::ordered_json to_json(const Component& component) {
  nlohmann::ordered_json json = {
      {"name", component.name}, {"least", component.range.least}, {"greatest", component.range.greatest}};
  if (component.nans != 0) json["nan"] = component.nans;
  if (!component.mapping) return json;
  const auto& [interval, source, clamped] = *component.mapping;
  json["0"] = interval.least;
  json["65535"] = interval.greatest;
  json["range"] = source;
  json["clamped"] = clamped;
  return json;
}

template <typename T>
std::string raw_of(std::vector<std::vector<T>> planes) {
  std::string bytes;
  for (std::vector<T>& plane : planes) {
    bytes += bytes_of(std::span<const T>(plane));
    plane = {};
  }
  return bytes;
}

// The part of a plane that is a slice, or all of it.
template <typename T>
std::span<const T> part_of(const std::vector<T>& plane, int slice, int slices) {
  const std::size_t size = plane.size() / static_cast<std::size_t>(slices);
  return std::span(plane).subspan(static_cast<std::size_t>(slice) * size, size);
}

template <typename T>
Result<std::string> picture_of(const BakeOptions& options, const std::vector<std::vector<T>>& planes, int slice,
                               const Report& report, const Texts& texts) {
  const int parts = options.layout == Layout::slices ? report.atlas.slices : 1;
  std::vector<Channel<T>> channels;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    channels.push_back({channel_name(report.components, i), arranged(part_of(planes[i], slice, parts), options.size[0],
                                                                     height_of_slice(options), report.atlas)});
  }
  if constexpr (std::is_same_v<T, float>) {
    // Programs that look for red look for blue, too.
    if (channels.size() == 2) channels.push_back({"B", std::vector<T>(channels.front().values.size())});
    return exr(channels, report.width, report.height, texts);
  } else {
    return png_16(channels, report.width, report.height, texts);
  }
}

// In ASCII, since a PNG's texts are in Latin-1, and the comments of a source may be in anything.
Texts texts_of(const nlohmann::ordered_json& record, const std::string& name_of_writer) {
  return {{name_of_writer, fmt::format("hn-bake of hashnoise {}", library_version())},
          {"hashnoise", record.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace)}};
}

template <typename T>
Result<void> write_planes(const BakeOptions& options, std::vector<std::vector<T>> planes, Report& report,
                          nlohmann::ordered_json record, const WriteFile& write) {
  report.files = files_of(options);
  if (!is_picture(options.format)) {
    return write(options.out, is_texture(options.format) ? ktx2(planes, options.size, texts_of(record, "KTXwriter"))
                                                         : raw_of(std::move(planes)));
  }
  for (int slice = 0; const auto& file : report.files) {
    if (options.layout == Layout::slices) record["slice"] = slice;
    const auto bytes = picture_of(options, planes, slice, report, texts_of(record, "Software"));
    if (!bytes) return fail(fmt::format("cannot make {}: {}", file.string(), bytes.error().text()));
    HN_DO(write(file, *bytes));
    ++slice;
  }
  return {};
}

}  // namespace

std::vector<std::filesystem::path> files_of(const BakeOptions& options) {
  if (options.layout != Layout::slices) return {options.out};
  const int slices = atlas_of(options).slices;
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(slices - 1).size());
  std::vector<std::filesystem::path> files;
  for (int slice = 0; slice < slices; ++slice) {
    files.push_back(options.out);
    files.back().replace_filename(
        fmt::format("{}.{:0{}}{}", options.out.stem().string(), slice, digits, options.out.extension().string()));
  }
  return files;
}

Result<std::vector<Mapping>> mappings_of(const BakeOptions& options, const std::vector<std::string>& components) {
  if (options.format == Format::png && components.size() > kMostInPng) {
    return fail(
        fmt::format("{} has {} components in {}D, and a PNG has at most {}; choose some with --components, or "
                    "write .exr, .f32 or .r16",
                    options.function, components.size(), options.size.size(), kMostInPng));
  }
  if (is_texture(options.format)) {
    if (options.size.size() > 3) return fail("--size: a texture has at most three axes; write .f32 or .r16");
    if (components.size() > kMostInTexture) {
      return fail(
          fmt::format("{} has {} components in {}D, and a texture has at most {}; choose some with "
                      "--components, or write .f32 or .r16",
                      options.function, components.size(), options.size.size(), kMostInTexture));
    }
  }
  const Atlas atlas = atlas_of(options);
  if (is_picture(options.format) && (static_cast<long long>(atlas.columns) * options.size[0] > kLongestSide ||
                                     static_cast<long long>(atlas.rows) * height_of_slice(options) > kLongestSide)) {
    return fail(fmt::format("--size: a picture has at most {} pixels along a side; write .f32 or .r16", kLongestSide));
  }
  std::vector<Mapping> mappings;
  if (!has_16_bits(options.format) || options.normalize) return mappings;
  const std::vector<Interval>& given = options.ranges;
  if (given.size() > 1 && given.size() != components.size()) {
    return fail(
        fmt::format("--range stands there {} times, and there are {} components; give it once for all of them, "
                    "or once for each",
                    given.size(), components.size()));
  }
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (!given.empty()) {
      mappings.push_back({given.size() == 1 ? given.front() : given[i], "given"});
      continue;
    }
    const auto documented =
        options.expression
            ? std::nullopt
            : hashnoise::grid::documented_range(options.settings, static_cast<int>(options.size.size()), components[i]);
    if (!documented) {
      return fail(
          fmt::format("no range is documented for the component {} of {} with these settings; name one with "
                      "--range LEAST:GREATEST, or let --normalize find it",
                      components[i], options.function));
    }
    mappings.push_back({*documented, "documented"});
  }
  return mappings;
}

Result<Report> write_files(const BakeOptions& options, Planes planes, std::vector<Mapping> mappings,
                           const WriteFile& write) {
  Report report;
  report.atlas = atlas_of(options);
  report.width = options.size[0] * report.atlas.columns;
  report.height = height_of_slice(options) * report.atlas.rows;
  for (const Plane& plane : planes.planes) {
    const auto nans = std::ranges::count_if(plane.values, [](float value) { return std::isnan(value); });
    report.components.push_back({plane.component, plane.range, {}, static_cast<std::size_t>(nans)});
  }
  if (!has_16_bits(options.format)) {
    std::vector<std::vector<float>> floats;
    for (Plane& plane : planes.planes) floats.push_back(std::move(plane.values));
    auto record = record_of(options, planes, report);
    HN_DO(write_planes(options, std::move(floats), report, std::move(record), write));
    return report;
  }
  std::vector<std::vector<std::uint16_t>> words;
  for (std::size_t i = 0; i < planes.planes.size(); ++i) {
    Plane& plane = planes.planes[i];
    if (options.normalize && !(std::isfinite(plane.range.least) && std::isfinite(plane.range.greatest))) {
      return fail(fmt::format("--normalize: the values of {} go from {} to {}; name the range with --range",
                              plane.component, plane.range.least, plane.range.greatest));
    }
    Mapping mapping =
        options.normalize
            ? Mapping{{static_cast<double>(plane.range.least), static_cast<double>(plane.range.greatest)}, "normalized"}
            : mappings[i];
    Texels mapped = to_16_bits(plane.values, mapping.interval);
    mapping.clamped = mapped.clamped;
    report.components[i].mapping = mapping;
    words.push_back(std::move(mapped.words));
    plane.values = {};
  }
  auto record = record_of(options, planes, report);
  HN_DO(write_planes(options, std::move(words), report, std::move(record), write));
  return report;
}

nlohmann::ordered_json record_of(const BakeOptions& options, const Planes& planes, const Report& report) {
  nlohmann::ordered_json json = {{"function", options.function},
                                 {"dimensions", options.size.size()},
                                 {"settings", settings_of(options, planes.instruction_set)},
                                 {"size", options.size},
                                 {"cells", options.cells},
                                 {"origin", options.origin},
                                 {"tile", options.tile},
                                 {"format", name_of(options.format)},
                                 {"components", nlohmann::ordered_json::array()},
                                 {"version", library_version()}};
  for (const Component& component : report.components) json["components"].push_back(to_json(component));
  if (is_picture(options.format) && report.atlas.slices > 1) {
    json["slices"] = report.atlas.slices;
    json["columns"] = options.layout == Layout::slices ? 0 : report.atlas.columns;
  }
  return json;
}

}  // namespace hn
