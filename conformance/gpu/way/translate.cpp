#include "gpu/way/translate.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <csignal>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "gpu/spirv.hpp"

namespace hn {
namespace {

// The signal that ended a program, by itself or by the status of a shell; 0 for none.
int signal_of(int status) {
  if (WIFSIGNALED(status)) return WTERMSIG(status);
  const int signal = WEXITSTATUS(status) - 128;
  constexpr std::array kCrashes = {SIGILL, SIGTRAP, SIGABRT, SIGBUS, SIGFPE, SIGKILL, SIGSEGV, SIGTERM};
  return std::ranges::find(kCrashes, signal) == kCrashes.end() ? 0 : signal;
}

// vkd3d prints a line for every #line otherwise.
std::vector<std::string> environment() {
  constexpr std::array<std::string_view, 1> kOwn = {"VKD3D_SHADER_DEBUG="};
  std::vector<std::string> variables = environment_without(kOwn);
  variables.emplace_back("VKD3D_SHADER_DEBUG=none");
  return variables;
}

tl::expected<Code, StepError> translate(const Step& step, const Code& code, std::chrono::milliseconds limit) {
  const auto failed = [&](StepEnd end, std::string message, std::string log = {}) {
    return tl::unexpected(StepError{end, 0, {fmt::format("{} {}", step.text(), message), std::move(log)}});
  };
  const TemporaryFolder folder;
  const auto in = folder.path() / fmt::format("in{}", ending_of(code.form));
  const auto out = folder.path() / fmt::format("out{}", ending_of(step.gives));
  const auto output = folder.path() / "printed";
  if (const auto written = write_file(in, code.bytes); !written)
    return failed(StepEnd::refused, written.error().text());
  std::vector<std::string> words = step.command_for(in.string(), out.string());
  const std::string program = words.front();
  words.erase(words.begin());
  const auto status = run_within(
      limit, {.program = program, .arguments = std::move(words), .environment = environment(), .output = output});
  if (!status) return failed(StepEnd::refused, "cannot be run: " + status.error().message);
  const std::string printed = printable(read_file(output).value_or(""));
  if (!*status) {
    return failed(StepEnd::hung, fmt::format("does not end within {} s", std::chrono::duration<double>(limit).count()),
                  printed);
  }
  if (const int signal = signal_of(**status)) {
    return failed(StepEnd::crashed, fmt::format("crashes: {}", describe_end(signal)), printed);
  }
  if (**status != 0) return failed(StepEnd::refused, "refuses the shader", printed);
  auto bytes = read_file(out);
  if (!bytes) return failed(StepEnd::refused, "writes nothing", printed);
  Code given{step.gives, *std::move(bytes)};
  if (step.gives != Form::spirv) return given;
  auto module = spirv_of(given.bytes);
  forget_source_language(module);
  if (step.repeats_decorations) module = without_repeated_decorations(module);
  given.bytes = bytes_of(std::span<const std::uint32_t>(module));
  if (const auto valid = validate_spirv(module); !valid) {
    return failed(StepEnd::gave_invalid, "gives SPIR-V that is invalid: " + valid.error().message, valid.error().log);
  }
  return given;
}

}  // namespace

tl::expected<void, StepError> translate(std::span<const Step> steps, const Code& code, std::chrono::milliseconds limit,
                                        std::vector<Code>& given) {
  given.clear();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    auto next = translate(steps[i], i == 0 ? code : given.back(), limit);
    if (!next) {
      next.error().number = i + 1;
      return tl::unexpected(std::move(next.error()));
    }
    given.push_back(*std::move(next));
  }
  return {};
}

}  // namespace hn
