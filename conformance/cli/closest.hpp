// What was meant by a word that is none of those that there are.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hn {

// The name that a few slips of the fingers turn into the word: a letter too many, too few, wrong, or two exchanged.
// Empty if it takes more than a third of the word.
std::string closest(std::string_view word, std::span<const std::string> names);

}  // namespace hn
