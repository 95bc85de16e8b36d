#include "bench_cpu/options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <sstream>

#include "base/text.hpp"
#include "base/version.hpp"

namespace hn {

tl::expected<BenchCpuOptions, Stop> parse_options(int argc, const char* const* argv) {
  CLI::App app("Measures what hashnoise::grid costs on this processor, by each of its instruction sets.",
               "hn-bench-cpu");
  app.set_version_flag("--version", library_version());
  app.footer(
      "Exit status: 0 done, even if an aim is missed, 1 something could not be measured, 2 bad usage, 130 ended by "
      "Ctrl-C (SIGINT), 143 by SIGTERM, 129 by SIGHUP; of tools/measure cpu also 4, it could not be built.");
  BenchCpuOptions options;
  std::vector<std::string> against;
  app.add_option("--out", options.out,
                 "The folder for the record: gcc.csv or clang.csv by the compiler of this program")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_option("--against", against,
                 "Also measure FastNoise2, from its shared library; strict=FILE is one that was built with "
                 "FASTNOISE2_STRICT_FP, beside HN_FIXED and HN_PRECISE")
      ->type_name("fastnoise2=FILE")
      ->allow_extra_args(false);
  app.add_option("--python", options.python, "Also measure the Python package, by a Python that has it")
      ->type_name("FILE");
  app.add_option("--filter", options.filters,
                 "Only the subjects whose id matches this glob, as in perlin2 or fbm_*; may be repeated")
      ->type_name("GLOB")
      ->allow_extra_args(false);
  app.add_option("--rounds", options.rounds, "How many samples of each time")
      ->type_name("N")
      ->check(CLI::Range(3, 1000))
      ->capture_default_str();
  app.add_option("--note", options.note, "A sentence for the record, such as the commit of FastNoise2")
      ->type_name("TEXT");
  const auto wrong = [](const std::string& message) { return tl::unexpected(Stop{kBadUsage, {}, message}); };
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return wrong(fmt::format("{}; see --help", error.what()));
    std::ostringstream out;
    std::ostringstream err;
    app.exit(error, out, err);
    return tl::unexpected(Stop{0, out.str(), err.str()});
  }
  for (const std::string& one : against) {
    const std::size_t equals = one.find('=');
    const std::string_view name = std::string_view(one).substr(0, equals);
    if (equals + 1 >= one.size() || (name != "fastnoise2" && name != "strict")) {
      return wrong(
          fmt::format("--against {}: it wants fastnoise2=FILE or strict=FILE, the shared library of FastNoise2; there "
                      "is no other library that it knows",
                      in_quotes(one)));
    }
    (name == "strict" ? options.strict : options.against) = one.substr(equals + 1);
  }
  return options;
}

}  // namespace hn
