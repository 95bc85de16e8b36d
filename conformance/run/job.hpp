// The process that runs the cases of one driver: its job, and its reports.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "cases/bugs/given.hpp"
#include "gpu/way/way.hpp"
#include "library/profile.hpp"
#include "library/source.hpp"

namespace hn {

enum class Task {
  describe,  // report what the driver is
  cases,     // run cases
  devices,   // report how many EGL devices there are
  vulkan,    // report how many devices of Vulkan there are
  values,    // report what the given function returns
};
NLOHMANN_JSON_SERIALIZE_ENUM(Task, {{Task::describe, "describe"},
                                    {Task::cases, "cases"},
                                    {Task::devices, "devices"},
                                    {Task::vulkan, "vulkan"},
                                    {Task::values, "values"}})

// The settings that change what a case does; the same for every process of a run.
struct SuiteOptions {
  std::string glsl;  // a folder; empty for what is built in
  std::string golden;
  std::string inject;  // the name of a fault, or nothing
  std::uint64_t seed = 1;
  std::uint64_t points = 0;  // of each comparison with the twin; 0 for the case's own number
  bool thorough = false;     // so many as --thorough has
  WayOptions way = {};       // of shaders to the driver
  GivenFunction given = {};
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SuiteOptions, glsl, golden, inject, seed, points, thorough, way, given)

// The library that these options select. An error if the folder or the fault does not exist.
Result<SourceSet> suite_sources(const SuiteOptions& options);

struct Job {
  Task task = Task::cases;
  std::string driver;
  SuiteOptions suite;
  std::vector<std::string> ids;            // of cases, in the order in which they are to be run
  std::vector<std::string> examined = {};  // of cases that have had their evidence made, or tried
  std::string kept = {};                   // a folder for inputs of the steps of a way
  std::int64_t step_limit = 30000;         // milliseconds for a step
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Job, task, driver, suite, ids, examined, kept, step_limit)

// Digests of the text of the library and of the golden files. Results with different digests do not belong together.
std::string suite_digest(const SuiteOptions& options, const SourceSet& sources);

// The hidden subcommand that does a job.
constexpr const char* kChildCommand = "child";

// Does a job that has one report, and waits for it. An error has the process's message or how it ended. It is also an
// error if stop_fd can be read: then this does not wait any longer.
Result<nlohmann::json> report_of(const Job& job, const std::filesystem::path& directory,
                                 std::chrono::milliseconds limit, int stop_fd = -1);

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LanguageSupport, gl_version, es_version, gl130, bit_encoding, profiles)

// The reports, a line of JSON each:
//   {"ready": {context info}}         once, before the first case; with "languages": {...} of a driver that has them
//   {"absent": "why"}                 in place of it: the driver cannot be used here
//   {"result": {case result}}         for each case; with "examined": true if its evidence is made next
//   {"evidence": {...}, "id": ID}     then; null in place of an object if there is none
//   {"alive": true}                   from a case that takes long: the limit of its time starts again
//   {"lost": true}                    after these: the context or device is lost, and the process ends
//   {"devices": N}                    from the tasks that count
//   {"values": [[word, ...], ...], "profile": NAME, ...}     of each point, and the context info
//   {"error": "why"}                  a task cannot be done

}  // namespace hn
