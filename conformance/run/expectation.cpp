#include "run/expectation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "base/csv.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "run/selection.hpp"

namespace hn {
namespace {

std::string bad_statuses() {
  std::vector<std::string_view> names;
  for (const Status status : kStatuses) {
    if (is_bad(status)) names.push_back(name_of(status));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

Result<std::vector<Expectation>> parse_expectations(std::string_view text, const std::string& path) {
  constexpr std::array<std::string_view, 5> kColumns = {"driver", "renderer", "case", "status", "reason"};
  HN_TRY(const auto rows, parse_csv(text, path));
  const std::vector<std::string>& header = rows.front().fields;
  if (!std::ranges::is_permutation(header, kColumns)) {
    return fail(fmt::format("{}:{}: the columns are {}, and must be {}", path, rows.front().line,
                            in_quotes(fmt::format("{}", fmt::join(header, ","))), fmt::join(kColumns, ",")));
  }
  std::vector<Expectation> expectations;
  for (const CsvRow& row : std::span(rows).subspan(1)) {
    const std::string place = fmt::format("{}:{}", path, row.line);
    std::array<std::string, kColumns.size()> fields;  // in the order of kColumns
    std::ranges::transform(kColumns, fields.begin(), [&](std::string_view name) {
      return row.fields[static_cast<std::size_t>(std::ranges::find(header, name) - header.begin())];
    });
    const auto& [driver, renderer, id, status, reason] = fields;
    const auto named = status_named(status);
    if (!named || !is_bad(*named)) {
      return fail(fmt::format("{}: the status \"{}\" is not one of {}", place, status, bad_statuses()));
    }
    if (driver.empty() || renderer.empty() || id.empty()) {
      return fail(fmt::format("{}: driver, renderer and case must not be empty; * stands for any", place));
    }
    if (reason.empty()) return fail(fmt::format("{}: there must be a reason", place));
    expectations.push_back({driver, renderer, id, *named, reason, place});
  }
  return expectations;
}

Result<std::vector<Expectation>> read_expectations(const std::filesystem::path& directory) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory, error)) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  if (error) {
    return fail(fmt::format("cannot read the folder {}: {}; --expect wants the folder with tables of what may fail",
                            directory.string(), error.message()));
  }
  std::sort(files.begin(), files.end());
  std::vector<Expectation> expectations;
  for (const auto& path : files) {
    HN_TRY(const auto text, read_file(path));
    HN_TRY(const auto rows, parse_expectations(text, path.string()));
    expectations.insert(expectations.end(), rows.begin(), rows.end());
  }
  return expectations;
}

Result<void> check_expectations(const std::vector<Expectation>& expectations, const std::vector<std::string>& ids) {
  for (const Expectation& expectation : expectations) {
    const bool known =
        std::any_of(ids.begin(), ids.end(), [&](const std::string& id) { return matches_glob(id, expectation.id); });
    if (!known) return fail(fmt::format("{}: no case matches \"{}\"", expectation.place, expectation.id));
  }
  return {};
}

std::string excuse_for(const std::vector<Expectation>& expectations, const std::string& driver,
                       const std::string& renderer, const CaseResult& result) {
  // A case that cannot run is neither right nor wrong.
  const Status status = result.outcome.status;
  if (status == Status::unsupported) return {};
  for (const Expectation& expectation : expectations) {
    const bool fits = status == expectation.status || !is_bad(status);
    if (fits && matches_glob(driver, expectation.driver) && matches_glob(renderer, expectation.renderer) &&
        matches_glob(result.id, expectation.id)) {
      return fmt::format("{} ({})", expectation.reason, expectation.place);
    }
  }
  return {};
}

void apply_expectations(const std::vector<Expectation>& expectations, Run& run) {
  for (CaseResult& result : run.cases) {
    result.excuse = excuse_for(expectations, run.driver, run.info.renderer, result);
    // Behind translators a driver runs another shader, which may avoid its fault; and it is no excuse of a translator
    // that refuses the shader.
    const bool refused = result.outcome.step && result.outcome.mismatches == 0;
    if (!run.way.empty() && (refused || !is_bad(result.outcome.status))) result.excuse.clear();
  }
}

}  // namespace hn
