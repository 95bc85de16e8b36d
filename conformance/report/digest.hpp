// A digest is the part of a run that is worth sending: a file of a few kilobytes with the results of a device and its
// driver. docs/reference/formats.md describes it; web/digest.js makes the same from a page's results, and tools/make
// results checks it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "run/results.hpp"

namespace hn {

// Nobody needs a larger one, and an address line takes one of this size.
inline constexpr std::size_t kMostDigestBytes = 4096;

// The text. Nothing if the run is not one of all default cases to its end, on a driver of a device.
std::optional<std::string> digest_text(const Run& run);

// "digest-vulkan-0.json"
std::string digest_file(const Run& run);
// Whether a file in a folder of results is a digest of some run.
bool is_digest_file(std::string_view name);

// A driver's own name, without the numbers of builds, and without characters that have a meaning anywhere.
std::string without_builds(std::string_view text);

}  // namespace hn
