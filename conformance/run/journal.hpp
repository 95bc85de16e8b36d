// The journal has what a run has found so far, and is on disk as soon as that is found: for --resume.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "run/results.hpp"

namespace hn {

constexpr std::string_view kJournalFile = "journal.jsonl";

// A line of JSON each: first {"plan": what the run is about}, then {"driver": NAME, and what the driver's process
// reported}.
class Journal {
 public:
  // Begins a new journal.
  static Result<Journal> create(const std::filesystem::path& directory, const nlohmann::json& plan);
  // Continues the journal that is there. An error if the file is not a journal, or belongs to another run.
  static Result<Journal> reopen(const std::filesystem::path& directory, const nlohmann::json& plan);
  static bool exists(const std::filesystem::path& directory);

  // An entry of the journal when it was opened.
  struct Entry {
    std::string driver;
    nlohmann::json report;
  };
  const std::vector<Entry>& earlier() const { return earlier_; }

  // The line is in the file before this returns, whatever happens to this process.
  void add(const std::string& driver, const nlohmann::json& report);
  // Why something could not be written; nothing is written after that.
  const std::string& problem() const { return problem_; }
  // The run is complete, and its results are written.
  void remove();

 private:
  Result<void> open(int flags);
  void write(std::string line);

  std::filesystem::path path_;
  FileDescriptor out_;
  std::string problem_;
  std::vector<Entry> earlier_;
};

// A line, without its end.
std::string journal_line(const std::string& driver, const nlohmann::json& report);
// The lines of a journal, without the last if it is not whole. An error: it is not the journal of this plan.
Result<std::vector<Journal::Entry>> parse_journal(std::string_view text, const nlohmann::json& plan);

}  // namespace hn
