// The options of hn-bake, as CLI11 reads them.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bake/options.hpp"
#include "grid/rules.hpp"

namespace hn {

constexpr int kLongestAxis = static_cast<int>(hashnoise::grid::kSizeRule.most);

// Options that are read as words; parse_options interprets them.
struct Words {
  std::string size = "512x512";
  std::string cells = "8";
  std::optional<std::string> origin;
  std::optional<std::string> period;
  std::optional<std::string> noise;
  std::optional<std::string> wave;
  std::optional<std::string> expression;
  std::optional<std::string> source;
  std::string arithmetic = "fixed";
  std::optional<std::string> metric;
  std::optional<std::string> instruction_set;
  std::string format;
  std::string layout;
  std::vector<std::string> ranges;
};

// Adds all options, with their help. The options and the words have to live until they are parsed.
void add_options(CLI::App& app, BakeOptions& options, Words& words);

}  // namespace hn
