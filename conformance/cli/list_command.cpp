// hn-conform list
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cases/case.hpp"
#include "cli/command.hpp"
#include "run/selection.hpp"

namespace hn {
namespace {

// docs/reference/checks.md.
std::string page_of_checks() {
  std::string page =
      "# Checks\n\nThis page lists what each check demands. The last part of a case's id names its check. Unless a row "
      "states otherwise, a check takes 4,096 points, and values agree bit by bit, for `fast` within the tolerances of "
      "both. `hn-conform list --checks` prints this page.\n\n"
      "| check | what holds if it passes |\n| --- | --- |\n";
  for (const auto& [check, text] : check_descriptions()) page += fmt::format("| `{}` | {} |\n", check, text);
  return page;
}

}  // namespace

Result<Selection> select_cases(const std::vector<std::string>& filters, bool thorough) {
  Selection chosen{filter_cases(all_cases(thorough ? Scope::thorough : Scope::covered), filters), thorough};
  if (chosen.cases.empty() && !thorough) chosen = {filter_cases(all_cases(), filters), true};
  if (!chosen.cases.empty()) return chosen;
  return fail(fmt::format("no case matches --filter '{}'; hn-conform list shows the ids, and * stands for any part",
                          fmt::join(filters, "' '")));
}

int run(const ListCommand& options, Interruption&) {
  if (options.checks) {
    say(page_of_checks());
    return 0;
  }
  const auto chosen = select_cases(options.filters, options.thorough);
  if (!chosen) return usage_error(chosen.error().text());
  for (const Case& test : chosen->cases) say(fmt::format("{}\n{}", test.id, options.about ? test.about : ""));
  return 0;
}

}  // namespace hn
