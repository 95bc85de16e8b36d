// The command line, an argument per line, and shards.
#include "cli/options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/text.hpp"
#include "fuzz.hpp"
#include "run/selection.hpp"

namespace hn::fuzz {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

// Splits a line of plain words and words in single quotes, as a shell does.
std::vector<std::string> shell_words(std::string_view line) {
  std::vector<std::string> words(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\'') {
      quoted = !quoted;
    } else if (line[i] == ' ' && !quoted) {
      words.emplace_back();
    } else {
      if (line[i] == '\\' && !quoted) ++i;
      if (i < line.size()) words.back() += line[i];
    }
  }
  return words;
}

void check(const DriversCommand&) {}
void check(const ListCommand&) {}
void check(const SpirvCommand&) {}
void check(const WebCommand& web) { require(!web.golden.empty(), "there are golden files"); }

void check(const RunCommand& run) {
  require(run.execution.suite.seed <= 0xFFFFFFFFu, "a seed has 32 bits");
  require(std::isfinite(run.execution.timeout) && run.execution.timeout >= 0.1 && run.execution.timeout <= 86400.0,
          "a time limit is in its range");
  require(run.execution.jobs >= 1 && run.execution.jobs <= 256, "the jobs are in their range");
  require(!run.selection.drivers.empty(), "there is a driver");
}

void check(const CheckCommand& command) {
  require(command.tolerance >= 0.0 && command.tolerance <= 1e30, "a tolerance is in its range");
  check(command.run);
}

void check(const MergeCommand& merge) { require(!merge.inputs.empty(), "there is something to merge"); }

template <typename Command>
void check(const Command& measuring) {
  require(measuring.rounds >= 3 && measuring.rounds <= 1000, "the rounds are in their range");
}

void check_stop(const Stop& stop) {
  require(stop.status == 0 || stop.status == kBadUsage, "the status is one of the documented");
  require(stop.status == 0 ? !stop.out.empty() : !stop.err.empty(), "something is printed");
}

void check_shard(const std::string& text) {
  const auto shard = parse_shard(text);
  if (!shard) {
    require(shard.error().message.find(text) != std::string::npos, "an error names the text", shard.error().message);
    return;
  }
  require(shard->index >= 1 && shard->index <= shard->count, "a shard is one of its number", text);
  std::size_t cases = 0;
  for (std::size_t i = 0; i < shard->count; ++i) cases += shard->has(i) ? 1 : 0;
  require(cases == 1, "of as many cases as there are shards each has one", text);
  const auto again = parse_shard(fmt::format("{}/{}", shard->index, shard->count));
  require(again && again->index == shard->index && again->count == shard->count, "it can be written and read again",
          text);
}

}  // namespace
}  // namespace hn::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hn;
  // An argument ends with a NUL.
  const std::string_view text = fuzz::text_of(data, size);
  const auto arguments = fuzz::lines_of(text.substr(0, text.find('\0')));
  std::vector<const char*> argv = {"hn-conform"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  const int argc = static_cast<int>(argv.size());

  const auto command = parse_options(argc, argv.data(), {.golden = "golden", .expect = "expect"});
  if (command) {
    std::visit([](const auto& chosen) { fuzz::check(chosen); }, *command);
  } else {
    fuzz::check_stop(command.error());
  }
  const std::string line = command_line("hn-conform", argc, argv.data());
  const auto words = fuzz::shell_words(line);
  fuzz::require(std::vector<std::string>(words.begin() + 1, words.end()) == arguments,
                "the line for the record gives the arguments again", line);
  for (const std::string& argument : arguments) fuzz::check_shard(argument);
  return 0;
}
