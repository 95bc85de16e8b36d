// hn-conform paper
#include <fmt/format.h>

#include <chrono>

#include "base/file.hpp"
#include "base/json.hpp"
#include "base/output_folder.hpp"
#include "cli/command.hpp"
#include "output/csv.hpp"
#include "output/files.hpp"
#include "output/page.hpp"
#include "paper/files.hpp"
#include "paper/laboratory.hpp"

namespace hn {
namespace {

struct Part {
  std::string_view name;
  Result<Section> (*measure)(Laboratory&);
};
// The table first: it decides which clock is believed.
constexpr Part kParts[] = {{"table", measure_table},
                           {"figures", draw_figures},
                           {"statistics", measure_statistics},
                           {"periods", measure_periods},
                           {"bandwidth", measure_bandwidth}};

Result<void> write(const std::filesystem::path& out, const nlohmann::json& data, const nlohmann::json& page,
                   const std::vector<Section::Csv>& tables) {
  HN_TRY(const auto html, render_page(text_of(kPaperFiles, "paper.mustache"), page));
  for (const Section::Csv& table : tables) {
    HN_DO(write_file(out / table.name, to_csv(table.header, table.rows)));
  }
  HN_DO(write_file(out / "paper.json", dump(data, 1) + "\n"));
  return write_file(out / "index.html", html);
}

}  // namespace

int paper_command(const PaperCommand& options, Interruption& interruption) {
  const auto sources = library_sources(options.glsl);
  if (!sources) return usage_error(sources.error().text());
  const auto folder = OutputFolder::prepare(options.out, {"paper.json", "index.html"});
  if (!folder) return usage_error(folder.error().text());
  const auto driver = open_driver(options.driver, options.line);
  if (!driver) return driver.error();
  const ReferenceCompiler reference;
  Laboratory laboratory(*driver->context, *sources, reference, options.out, options.rounds, options.dump);
  Provenance provenance = driver->provenance;
  provenance.library = sources->edited();
  nlohmann::json data = to_json(provenance);
  nlohmann::json page = {{"style", text_of(kOutputFiles, "style.mustache")},
                         {"provenance", data},
                         {"library", library_text(provenance.library)},
                         {"rounds", options.rounds},
                         {"failures", nlohmann::json::array()}};
  data["schema"] = 1;
  data["rounds"] = options.rounds;
  std::vector<Section::Csv> tables;
  bool complete = true;
  for (const Part& part : kParts) {
    const auto start = std::chrono::steady_clock::now();
    auto section = part.measure(laboratory);
    if (!section) {
      // The other sections are still worth having.
      complain(fmt::format("{}: {}", part.name, section.error().text()));
      data[std::string(part.name)] = {{"error", section.error().text()}};
      page[std::string(part.name)] = false;
      page["failures"].push_back({{"section", part.name}, {"text", section.error().text()}});
      complete = false;
      continue;
    }
    data[std::string(part.name)] = std::move(section->data);
    page[std::string(part.name)] = std::move(section->page);
    complete = complete && section->complete;
    std::move(section->csv.begin(), section->csv.end(), std::back_inserter(tables));
    fmt::print(stderr, "{}: {:.1f} s\n", part.name,
               std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  interruption.note_the_first();
  if (const auto written = write(options.out, data, page, tables); !written) {
    complain(written.error().text());
    return kNotAsExpected;
  }
  fmt::print("The paper on {}: {}/index.html\n", driver->provenance.info.renderer, options.out);
  if (complete) return 0;
  fmt::print("NOT AS EXPECTED: something could not be measured; the page says what\n");
  return kNotAsExpected;
}

}  // namespace hn
