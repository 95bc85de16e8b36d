// hn-conform spirv
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/output_folder.hpp"
#include "base/progress.hpp"
#include "bench/foreign.hpp"
#include "cli/command.hpp"
#include "run/filter.hpp"

namespace hn {
namespace {

// The matching subjects of the library, then the foreign ones. The empty shaders come first: the cost of each is
// subtracted from the others.
Result<std::vector<Subject>> subjects_of(const SpirvCommand& options, SourceSet& sources,
                                         const ReferenceCompiler& reference) {
  std::vector<Subject> subjects = {empty_subject(2), empty_subject(3)};
  for (Subject& subject : library_subjects()) {
    if (matches_any(subject.id, options.filters)) subjects.push_back(std::move(subject));
  }
  if (subjects.size() == 2 && options.against.empty()) {
    return fail(
        fmt::format("no subject matches --filter '{}'; ids are like noise2d.perlin.lattice, and * stands for any part",
                    fmt::join(options.filters, "' '")));
  }
  for (const std::string& argument : options.against) {
    HN_TRY(const auto foreign, read_foreign(argument, sources));
    HN_TRY(auto found, foreign_subjects(sources, reference, foreign));
    for (Subject& subject : found) subjects.push_back(std::move(subject));
  }
  return subjects;
}

}  // namespace

int spirv_command(const SpirvCommand& options) {
  auto sources = library_sources(options.glsl);
  if (!sources) return usage_error(sources.error().text());
  const ReferenceCompiler reference;
  const auto subjects = subjects_of(options, *sources, reference);
  if (!subjects) return usage_error(subjects.error().text());
  const auto folder = OutputFolder::prepare(options.out, {});
  if (!folder) return usage_error(folder.error().text());
  std::size_t failed = 0;
  Progress progress(stderr, subjects->size());
  for (std::size_t i = 0; i < subjects->size(); ++i) {
    const Subject& subject = (*subjects)[i];
    progress.show(i, failed, subject.id);
    const auto written = optimised_spirv(*sources, reference, subject).and_then([&](const auto& words) {
      return write_spirv(options.out, subject.id, words);
    });
    if (written) {
      say(fmt::format("{} {}\n", subject.id, subject.dimensions));
    } else {
      complain(fmt::format("{}: {}", subject.id, written.error().text()));
      ++failed;
    }
  }
  return failed == 0 ? 0 : kNotAsExpected;
}

}  // namespace hn
