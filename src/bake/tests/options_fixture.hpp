// Options as the command line gives them.
#pragma once

#include <string>
#include <vector>

#include "bake/options.hpp"

namespace hn {

inline tl::expected<BakeOptions, Stop> parsed(std::vector<std::string> words) {
  words.insert(words.begin(), "hn-bake");
  words.insert(words.end(), {"--out", "out.f32"});
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  return parse_options(static_cast<int>(pointers.size()), pointers.data());
}

}  // namespace hn
