#include "web/webgpu_evaluator.hpp"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/process.hpp"
#include "web/files.hpp"
#include "web/suite.hpp"
#include "web/wgsl.hpp"

namespace hn {
namespace {

using Words = std::vector<std::uint32_t>;

struct Program {
  std::string name;
  std::vector<std::string> command;  // the interpreter; the first of the files, which is the program
  std::vector<std::string_view> files;
  std::vector<Form> takes;
};

Program program_of(WebGpu which) {
  if (which == WebGpu::wgpu) return {"wgpu", {"python3", "-B"}, {"wgpu_program.py"}, {Form::wgsl, Form::spirv}};
  return {"dawn", {"node"}, {"dawn.mjs", "webgpu.js", "renderer.js", "suite.js"}, {Form::wgsl}};
}

// A program that answers each line of JSON with one.
class DeviceProgram {
 public:
  static Result<std::unique_ptr<DeviceProgram>> start(const Program& program) {
    auto made = std::make_unique<DeviceProgram>();
    made->name_ = program.name;
    for (const std::string_view file : program.files) made->folder_.write(file, text_of(kWebFiles, file));
    made->folder_.write("package.json", R"({"type": "module"})");  // for Node.js
    std::array<int, 2> channel{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, channel.data()) != 0) return fail("cannot make a socket");
    made->questions_ = FileDescriptor(channel[0]);
    const FileDescriptor its_end(channel[1]);
    std::vector<std::string> arguments(program.command.begin() + 1, program.command.end());
    arguments.insert(arguments.end(), {made->path(program.files.front()), std::to_string(kReportFd)});
    auto process = start_process({.program = program.command.front(),
                                  .arguments = std::move(arguments),
                                  .output = made->path("log"),
                                  .input = its_end.get()});
    if (!process) return tl::unexpected(process.error());
    made->process_ = std::move(*process);
    return made;
  }

  ~DeviceProgram() {
    questions_ = FileDescriptor();  // it ends when it can read no more
    wait();
  }

  std::string path(std::string_view file) const { return (folder_.path() / file).string(); }
  bool is_lost() const { return lost_; }

  // An error has the output of the program meanwhile.
  Result<nlohmann::json> ask(const nlohmann::json& question) {
    const std::string line = question.dump() + "\n";
    send(questions_.get(), line.data(), line.size(), MSG_NOSIGNAL);
    return answer();
  }

  Result<nlohmann::json> answer() {
    std::array<char, 4096> bytes;
    while (answers_.find('\n') == std::string::npos) {
      const ssize_t count = read(process_.reports.get(), bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return failed(wait());
      answers_.append(bytes.data(), static_cast<std::size_t>(count));
    }
    const auto end = answers_.find('\n');
    const auto found = nlohmann::json::parse(answers_.substr(0, end));
    answers_.erase(0, end + 1);
    lost_ = found.contains("lost");
    if (found.contains("error")) return failed(found.at("error").get<std::string>());
    return found;
  }

 private:
  tl::unexpected<Error> failed(std::string_view how) {
    const std::string all = read_file(path("log")).value_or("");
    return fail(fmt::format("{}: {}", name_, how), all.substr(std::exchange(printed_, all.size())));
  }

  std::string wait() {
    lost_ = true;
    if (const pid_t pid = std::exchange(process_.pid, 0); pid != 0) {
      while (waitpid(pid, &status_, 0) < 0 && errno == EINTR) {
      }
    }
    return describe_end(status_);
  }

  std::string name_;
  TemporaryFolder folder_;
  Process process_;
  int status_ = 0;  // of the process that has ended
  FileDescriptor questions_;
  std::string answers_;      // the bytes that are not read yet
  std::size_t printed_ = 0;  // of the log, so far
  bool lost_ = false;
};

class LoadedShader final : public Evaluable {
 public:
  LoadedShader(DeviceProgram& program, nlohmann::json shader) : program_(program), shader_(std::move(shader)) {}
  ~LoadedShader() override {
    std::error_code ignored;
    std::filesystem::remove(shader_["shader"].get<std::string>(), ignored);
  }

  // Whole groups of points: a translator makes a shader write the last result in place of those beyond it.
  Result<Words> evaluate(std::span<const std::uint32_t> inputs) override {
    const std::size_t points = inputs.size() / kInputWords;
    const std::size_t count = (points + kComputeGroup - 1) / kComputeGroup * kComputeGroup;
    Words words(inputs.begin(), inputs.end());
    words.resize(count * kInputWords);
    const auto results = program_.path("results");
    nlohmann::json question = shader_;
    question.update({{"points", program_.path("points")},
                     {"results", results},
                     {"count", count},
                     {"uniforms", {uniforms.trips, uniforms.variant_seed}}});
    HN_DO(write_file(program_.path("points"), bytes_of(std::span<const std::uint32_t>(words))));
    HN_DO(program_.ask(question));
    HN_TRY(const std::string bytes, read_file(results));
    words.resize(points * kOutputWords);
    if (bytes.size() != count * kOutputWords * sizeof(words[0]))
      return fail("the device returns another number of words");
    std::memcpy(words.data(), bytes.data(), words.size() * sizeof(words[0]));
    return words;
  }

 private:
  DeviceProgram& program_;
  nlohmann::json shader_;  // the question that builds it
};

class WebGpuEvaluator final : public Evaluator {
 public:
  WebGpuEvaluator(std::vector<Form> takes, std::unique_ptr<DeviceProgram> device, const nlohmann::json& info)
      : takes_(std::move(takes)), program_(std::move(device)) {
    info_.vendor = info.value("vendor", "");
    info_.renderer = info.value("renderer", "");
    info_.gl_version = info.value("version", "");
    info_.languages = webgpu_languages();
  }

  const ContextInfo& info() const override { return info_; }

  std::string unsupported(const Profile& profile, Stage stage) const override {
    if (auto reason = unsupported_to_run(profile, info_.languages); !reason.empty()) return reason;
    return stage == Stage::compute ? "" : "functions are evaluated in compute shaders here";
  }

  Result<std::unique_ptr<Evaluable>> build(const SourceSet& sources, const Evaluation& evaluation,
                                           std::string_view) override {
    HN_TRY(std::string text, wgsl_text(sources, evaluation));
    return load({Form::wgsl, std::move(text)});
  }

  std::vector<Form> takes() const override { return takes_; }

  Result<std::unique_ptr<Evaluable>> load(const Code& code) override {
    const auto path = program_->path(fmt::format("shader{}", number_++));
    HN_DO(write_file(path, code.bytes));
    nlohmann::json shader = {{"shader", path}, {"form", name_of(code.form)}};
    HN_DO(program_->ask(shader));
    return std::make_unique<LoadedShader>(*program_, std::move(shader));
  }

  bool is_lost() const override { return program_->is_lost(); }
  const Context* context() const override { return nullptr; }

 private:
  std::vector<Form> takes_;
  std::unique_ptr<DeviceProgram> program_;
  ContextInfo info_;
  int number_ = 0;  // of shaders so far
};

}  // namespace

Result<std::unique_ptr<Evaluator>> create_webgpu_evaluator(WebGpu which) {
  const Program program = program_of(which);
  HN_TRY(auto device, DeviceProgram::start(program));
  HN_TRY(const auto info, device->answer());
  if (info.contains("absent")) return fail(info.at("absent").get<std::string>());
  return std::make_unique<WebGpuEvaluator>(program.takes, std::move(device), info);
}

}  // namespace hn
