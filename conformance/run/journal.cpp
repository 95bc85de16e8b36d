#include "run/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <set>
#include <stdexcept>

#include "base/file.hpp"
#include "base/json.hpp"

namespace hn {
namespace {

std::filesystem::path path_in(const std::filesystem::path& directory) { return directory / kJournalFile; }

// The names of what is other in two plans.
std::string differences(const nlohmann::json& a, const nlohmann::json& b) {
  std::set<std::string> names;
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const auto& [name, value] : one->items()) {
      if (!other->contains(name) || other->at(name) != value) names.insert(fmt::format("\"{}\"", name));
    }
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

// Throws the exceptions of json.hpp if a line is not a report of a driver, as run/job.hpp describes them.
Journal::Entry entry_from(std::string_view line) {
  const nlohmann::json json = parse_json(line);
  Journal::Entry entry{text_at(json, "driver"), member_at(json, "report")};
  const nlohmann::json& report = entry.report;
  if (!report.is_object()) throw std::invalid_argument("a report is an object");
  if (report.contains("ready")) context_info_from(report.at("ready"));
  if (report.contains("result")) case_result_from(report.at("result"));
  for (const char* why : {"absent", "error"}) {
    if (report.contains(why) && !report.at(why).is_string()) {
      throw std::invalid_argument(fmt::format("\"{}\" is not a text", why));
    }
  }
  return entry;
}

// Reads the plan of the first line. Null if it has none.
nlohmann::json plan_from(std::string_view line) {
  try {
    const nlohmann::json json = parse_json(line);
    return json.contains("plan") ? json.at("plan") : nlohmann::json();
  } catch (const std::invalid_argument&) {
    return {};
  }
}

}  // namespace

Result<std::vector<Journal::Entry>> parse_journal(std::string_view text, const nlohmann::json& plan) {
  std::vector<Journal::Entry> entries;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) break;  // killed while it was written
    const std::string_view current = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (line == 1) {
      const nlohmann::json earlier = plan_from(current);
      if (!earlier.is_object()) return fail("its first line is not a plan");
      if (earlier != plan) {
        return fail(fmt::format("it belongs to a run with other settings: {}", differences(plan, earlier)));
      }
      continue;
    }
    try {
      entries.push_back(entry_from(current));
    } catch (const std::invalid_argument& exception) {
      return fail(fmt::format("line {} is not a report of a driver: {}", line, exception.what()));
    }
  }
  return entries;
}

bool Journal::exists(const std::filesystem::path& directory) { return std::filesystem::exists(path_in(directory)); }

Result<void> Journal::open(int flags) {
  out_ = FileDescriptor(::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | flags, 0666));
  if (out_.get() < 0) return fail(fmt::format("cannot write {}: {}", path_.string(), std::strerror(errno)));
  return {};
}

void Journal::write(std::string line) {
  if (!problem_.empty()) return;
  line += '\n';
  for (std::string_view rest = line; !rest.empty();) {
    const ssize_t written = ::write(out_.get(), rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      problem_ = fmt::format("cannot write {}: {}", path_.string(), std::strerror(errno));
      return;
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

Result<Journal> Journal::create(const std::filesystem::path& directory, const nlohmann::json& plan) {
  Journal journal;
  journal.path_ = path_in(directory);
  HN_DO(journal.open(O_TRUNC));
  journal.write(nlohmann::json{{"plan", plan}}.dump());
  if (!journal.problem_.empty()) return fail(journal.problem_);
  return journal;
}

Result<Journal> Journal::reopen(const std::filesystem::path& directory, const nlohmann::json& plan) {
  Journal journal;
  journal.path_ = path_in(directory);
  HN_TRY(std::string text, read_file(journal.path_));
  auto entries = parse_journal(text, plan);
  if (!entries) {
    return fail(fmt::format("cannot go on with {}: {}", journal.path_.string(), entries.error().message));
  }
  journal.earlier_ = std::move(*entries);
  // A line that was begun is dropped, so that the next does not follow it on the same line.
  text.resize(text.find_last_of('\n') + 1);
  if (text.empty()) return create(directory, plan);
  std::error_code error;
  std::filesystem::resize_file(journal.path_, text.size(), error);
  if (error) return fail(fmt::format("cannot write {}: {}", journal.path_.string(), error.message()));
  HN_DO(journal.open(0));
  return journal;
}

std::string journal_line(const std::string& driver, const nlohmann::json& report) {
  return dump(nlohmann::json{{"driver", driver}, {"report", report}});
}

void Journal::add(const std::string& driver, const nlohmann::json& report) { write(journal_line(driver, report)); }

void Journal::remove() {
  out_ = FileDescriptor();
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace hn
