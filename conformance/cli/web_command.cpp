// hn-conform web
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "cli/command.hpp"
#include "expected/golden.hpp"
#include "run/selection.hpp"
#include "web/suite.hpp"

namespace hn {
namespace {

constexpr std::string_view kPage = "index.html";

}  // namespace

int run(const WebCommand& options, Interruption& interruption) {
  const auto sources = library_sources(options.glsl);
  if (!sources) return usage_error(sources.error().text());
  if (const auto golden = check_golden_folder(options.golden); !golden) return usage_error(golden.error().text());
  std::vector<Case> cases = all_cases(options.thorough ? Scope::thorough : Scope::covered);
  std::erase_if(cases, [&](const Case& test) {
    return !is_on_page(test, options.thorough) || !matches_any(test.id, options.filters);
  });
  if (cases.empty()) return usage_error("no case of the page matches --filter; hn-conform list shows the ids");
  const auto write = [&]() -> Result<void> {
    HN_TRY(const auto folder, OutputFolder::prepare(options.out, {kPage}));
    const bool whole = options.filters.empty() && !options.thorough && options.glsl.empty();
    const PageSuite suite = make_suite(*sources, options.golden, cases, {}, Platform::opengl, whole);
    if (suite.defect) return fail(*suite.defect);
    HN_TRY(const auto page, web_page(suite.json, sources->edited()));
    interruption.note_the_first();
    return write_file(std::filesystem::path(options.out) / kPage, page);
  };
  if (const auto done = write(); !done) return usage_error(done.error().text());
  fmt::print("{}/{}: {} cases. Open it in a browser, or put it on any web server: python3 -m http.server -d {}\n",
             options.out, kPage, cases.size(), options.out);
  return 0;
}

}  // namespace hn
