#include "base/version.hpp"

#include <fmt/format.h>

#include <hashnoise/hashnoise.hpp>

namespace hn {

std::string library_version() { return fmt::format("{}.{}.{}", HN_VERSION_MAJOR, HN_VERSION_MINOR, HN_VERSION_PATCH); }

}  // namespace hn
