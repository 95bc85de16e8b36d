// The known name that a user probably meant by an unknown word, as the library knows it.
#pragma once

#include <hashnoise/detail/closest.hpp>

namespace hn {

using hashnoise::detail::closest;
using hashnoise::detail::suggestion;

}  // namespace hn
