// hn-conform web
#include <fmt/format.h>

#include "base/file.hpp"
#include "cli/command.hpp"
#include "run/filter.hpp"
#include "web/suite.hpp"

namespace hn {
namespace {

constexpr std::string_view kPage = "index.html";

}  // namespace

int web_command(const WebCommand& options) {
  const auto sources = library_sources(options.glsl);
  if (!sources) return usage_error(sources.error().text());
  std::vector<Case> cases = all_cases();
  std::erase_if(cases, [&](const Case& test) {
    return !unsupported_in_browser(test).empty() || (test.extent == Extent::thorough && !options.thorough) ||
           !matches_any(test.id, options.filters);
  });
  if (cases.empty()) return usage_error("no case of the page matches --filter; hn-conform list shows the ids");
  const auto write = [&]() -> Result<void> {
    HN_DO(prepare_output(options.out, {kPage}));
    const PageSuite suite = make_suite(*sources, options.golden, cases);
    if (suite.defect) return fail(*suite.defect);
    HN_TRY(const auto page, web_page(suite.json, sources->edited()));
    return write_file(std::filesystem::path(options.out) / kPage, page);
  };
  if (const auto done = write(); !done) return usage_error(done.error().text());
  fmt::print("{}/{}: {} cases. Open it in a browser, or put it on any web server: python3 -m http.server -d {}\n",
             options.out, kPage, cases.size(), options.out);
  return 0;
}

}  // namespace hn
