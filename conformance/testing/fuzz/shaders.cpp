// Tries what the harness does to texts of shaders and of logs: it expands #include, and finds the way back from a line
// of the expanded text. The input is a log, then the case's shader, then files a, b, c, ... to include, with a line
// "%%" between them.
#include <fmt/format.h>

#include <map>

#include "fuzz.hpp"
#include "library/source.hpp"

namespace hn::fuzz {
namespace {

std::vector<std::string> parts_of(std::string_view text) {
  constexpr std::string_view kBetween = "\n%%\n";
  std::vector<std::string> parts;
  for (auto end = text.find(kBetween); end != std::string_view::npos; end = text.find(kBetween)) {
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(end + kBetween.size());
  }
  parts.emplace_back(text);
  return parts;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

void check_translation(const std::string& log) {
  constexpr std::string_view kDigits = "0123456789";
  const ShaderText shader{{}, {"the case's shader", "glsl/a"}};
  const std::string translated = shader.translate(log);
  require(log.find_first_of(kDigits) != log.npos || translated == log, "without a number nothing changes", log);
  for (auto at = log.find_first_of("123456789"); at != log.npos;) {
    const auto end = std::min(log.find_first_not_of(kDigits, at), log.size());
    // It could be a line behind a colon, and a source before one.
    const bool is_short = end - at <= 10;
    const bool is_source = end < log.size() && (log[end] == ':' || log[end] == '(');
    require(is_short || is_source || translated.find(log.substr(at, end - at)) != log.npos, "what is not a line stays",
            log);
    at = log.find_first_of("123456789", end);
  }
}

// Counts lines as a compiler does, and looks up where each comes from.
void check_lines(const ShaderText& shader, const Profile& profile, const std::map<std::string, std::string>& texts) {
  int number = 1;
  for (const std::string_view line : lines_of(shader.text)) {
    int named = 0;
    if (line.starts_with("#line ")) {
      require(std::sscanf(std::string(line).c_str(), "#line %d", &named) == 1, "#line has a number", line);
      number = named + (profile.line_names_next() ? 0 : 1);
      continue;
    }
    if (!line.starts_with("#version")) {
      const std::string place = shader.translate(fmt::format("0:{}", number));
      const auto colon = place.rfind(':');
      require(colon != std::string::npos && texts.contains(place.substr(0, colon)), "a line comes from a file", place);
      const auto of_file = lines_of(texts.at(place.substr(0, colon)));
      const int at = std::stoi(place.substr(colon + 1)) - (place.starts_with("the case's shader") ? 2 : 1);
      require(at >= 0 && static_cast<std::size_t>(at) < of_file.size() && of_file[static_cast<std::size_t>(at)] == line,
              "a line of the text is the one that its place names", place);
    }
    ++number;
  }
}

bool has_long_file(const std::map<std::string, std::string>& texts) {
  for (const auto& [path, text] : texts) {
    if (lines_of(text).size() > 9000) return true;
  }
  return false;
}

}  // namespace
}  // namespace hn::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hn;
  const std::string_view input = fuzz::text_of(data, size);
  const auto parts = fuzz::parts_of(input);
  SourceSet sources;
  std::map<std::string, std::string> texts;
  texts["the case's shader"] = parts.size() > 1 ? parts[1] : std::string();
  for (std::size_t i = 2; i < parts.size() && i < 28; ++i) {
    const std::string name(1, static_cast<char>('a' + i - 2));
    sources.add(name, parts[i], "glsl/" + name);
    texts["glsl/" + name] = parts[i];
  }
  fuzz::check_translation(parts[0]);

  for (const Profile& profile : run_profiles()) {
    const auto shader = expand(sources, profile, texts["the case's shader"]);
    if (!shader) {
      const std::string& message = shader.error().message;
      fuzz::require(message.starts_with("the case's shader:") || message.starts_with("glsl/"),
                    "an error names the line", message);
      continue;
    }
    const bool numbered = input.find("#line") != std::string_view::npos || input.find("#version") != input.npos;
    if (!numbered && !fuzz::has_long_file(texts)) fuzz::check_lines(*shader, profile, texts);
  }
  return 0;
}
