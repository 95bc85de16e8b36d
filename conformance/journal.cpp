#include "journal.hpp"

#include <fmt/format.h>

#include <iterator>

namespace hn {
namespace {

std::filesystem::path path_in(const std::filesystem::path& directory) { return directory / kJournalFile; }

// The names of what is other in two plans.
std::string differences(const nlohmann::json& a, const nlohmann::json& b) {
  std::string names;
  for (const auto& [name, value] : a.items()) {
    if (!b.contains(name) || b.at(name) != value) names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
  }
  return names;
}

}  // namespace

Result<std::vector<Journal::Entry>> parse_journal(std::string_view text, const nlohmann::json& plan) {
  std::vector<Journal::Entry> entries;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) break;  // killed while it was written
    const auto json = nlohmann::json::parse(text.substr(0, end), nullptr, false);
    text.remove_prefix(end + 1);
    if (line == 1) {
      if (!json.is_object() || !json.contains("plan")) return fail("its first line is no plan");
      if (json.at("plan") != plan) {
        return fail(fmt::format("it is of a run with other settings: {}", differences(plan, json.at("plan"))));
      }
      continue;
    }
    const bool known = json.is_object() && json.contains("driver") && json.at("driver").is_string() &&
                       json.contains("report") && json.at("report").is_object();
    if (!known) return fail(fmt::format("line {} is no report of a driver", line));
    entries.push_back({json.at("driver").get<std::string>(), json.at("report")});
  }
  return entries;
}

bool Journal::exists(const std::filesystem::path& directory) { return std::filesystem::exists(path_in(directory)); }

Result<Journal> Journal::create(const std::filesystem::path& directory, const nlohmann::json& plan) {
  Journal journal;
  journal.path_ = path_in(directory);
  journal.out_.open(journal.path_, std::ios::binary | std::ios::trunc);
  journal.out_ << nlohmann::json{{"plan", plan}} << std::endl;
  if (!journal.out_) return fail(fmt::format("cannot write {}", journal.path_.string()));
  return journal;
}

Result<Journal> Journal::reopen(const std::filesystem::path& directory, const nlohmann::json& plan) {
  Journal journal;
  journal.path_ = path_in(directory);
  std::ifstream in(journal.path_, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(in), {});
  auto entries = parse_journal(text, plan);
  if (!entries) {
    return fail(fmt::format("cannot go on with {}: {}", journal.path_.string(), entries.error().message));
  }
  journal.earlier_ = std::move(*entries);
  // A line that was begun is dropped, so that the next does not follow it on the same line.
  text.resize(text.find_last_of('\n') + 1);
  std::error_code error;
  std::filesystem::resize_file(journal.path_, text.size(), error);
  journal.out_.open(journal.path_, std::ios::binary | std::ios::app);
  if (error || !journal.out_) return fail(fmt::format("cannot write {}", journal.path_.string()));
  if (text.empty()) return create(directory, plan);
  return journal;
}

void Journal::add(const std::string& driver, const nlohmann::json& report) {
  out_ << nlohmann::json{{"driver", driver}, {"report", report}}.dump(-1, ' ', false,
                                                                      nlohmann::json::error_handler_t::replace)
       << std::endl;
}

void Journal::remove() {
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace hn
