// The known name that a user probably meant by an unknown word.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hn {

// The name that a few typing errors turn into the word: a letter too many, too few, wrong, or two exchanged. Empty if
// that takes more errors than a third of the letters.
std::string closest(std::string_view word, std::span<const std::string> names);

}  // namespace hn
