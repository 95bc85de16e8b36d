#include "run/job.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <string_view>

#include "base/file.hpp"
#include "base/worker.hpp"
#include "fault/faults.hpp"
#include "library/digest.hpp"
#include "library/files.hpp"

namespace hn {

Result<SourceSet> suite_sources(const SuiteOptions& options) {
  auto sources = library_sources(options.glsl);
  if (sources) {
    for (const GivenFile& file : options.given.files) sources->add(file.name, file.text, file.path);
  }
  if (!sources || options.inject.empty()) return sources;
  HN_DO(inject_into(*sources, options.inject));
  return sources;
}

std::string suite_digest(const SuiteOptions& options, const SourceSet& sources) {
  std::uint64_t digest = kEmptyDigest;
  const auto add = [&](std::string_view text) { digest = fnv1a64(text, digest); };
  for (const EmbeddedFile& file : kLibraryFiles) add(sources.find(file.name)->text);
  std::set<std::filesystem::path> golden;
  std::error_code none;  // a folder that is missing is an error of each case
  for (const auto& entry : std::filesystem::directory_iterator(options.golden, none)) golden.insert(entry.path());
  for (const std::filesystem::path& path : golden) {
    add(path.filename().string());
    add(read_file(path).value_or(""));
  }
  return fmt::format("{:016x}", digest);
}

Result<nlohmann::json> report_of(const Job& job, const std::filesystem::path& directory,
                                 std::chrono::milliseconds limit, int stop_fd) {
  HN_TRY(auto worker, Worker::start(job, {own_program(), kChildCommand, directory / "job.json", "/dev/null", limit}));
  while (!worker.end()) {
    for (const nlohmann::json& report : worker.wait(stop_fd)) {
      for (const char* wrong : {"absent", "error"}) {
        if (report.contains(wrong)) return fail(report.at(wrong).get<std::string>());
      }
      return report;
    }
    if (can_be_read(stop_fd)) return fail("the run was ended");
  }
  return fail(fmt::format("its process {}", worker.end()->text));
}

}  // namespace hn
