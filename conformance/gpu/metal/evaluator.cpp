#include "gpu/evaluator.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "gpu/files.hpp"
#include "output/embedded.hpp"

namespace hn {
namespace {

using Words = std::vector<std::uint32_t>;

// The compiler of Metal is one of this family.
constexpr const char* kCompiler = "clang++";
constexpr std::uint32_t kNothing = 0xDEADBEEF;

class SharedObject {
 public:
  explicit SharedObject(const std::filesystem::path& path) : handle_(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {}
  SharedObject(SharedObject&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  SharedObject& operator=(SharedObject&&) = delete;
  ~SharedObject() {
    if (handle_) dlclose(handle_);
  }

  void* find(const char* name) const { return handle_ ? dlsym(handle_, name) : nullptr; }

 private:
  void* handle_;
};

// A case's shader defines this (library/shaders.cpp): it evaluates the point of that number.
using Kernel = void(std::uint32_t* results, const std::uint32_t* points, std::uint32_t index);

class CompiledKernel final : public Evaluable {
 public:
  CompiledKernel(SharedObject object, Kernel* kernel) : object_(std::move(object)), kernel_(kernel) {}

  Result<Words> evaluate(std::span<const std::uint32_t> inputs) override {
    const auto points = static_cast<std::uint32_t>(inputs.size() / kInputWords);
    Words results(points * kOutputWords, kNothing);
    for (std::uint32_t point = 0; point < points; ++point) kernel_(results.data(), inputs.data(), point);
    return results;
  }

 private:
  SharedObject object_;
  Kernel* kernel_;
};

class MetalEvaluator final : public Evaluator {
 public:
  MetalEvaluator() {
    folder_.write(header().filename().string(), text_of(kGpuFiles, "metal_stdlib.hpp"));
    info_.vendor = "hashnoise";
    info_.renderer = "a stand-in for Metal";
    info_.languages.profiles = {"msl"};
  }

  // Gets the compiler's version, and compiles the part that all kernels include.
  Result<void> find_compiler() {
    HN_TRY(const std::string text, output_of(kCompiler, {"--version"}));
    info_.gl_version = text.substr(0, text.find('\n'));
    std::vector<std::string> arguments = options();
    arguments.insert(arguments.end(), {"-x", "c++-header", header().string(), "-o", precompiled().string()});
    if (auto compiled = run_process({.program = kCompiler, .arguments = std::move(arguments)}); !compiled)
      return fail("the stand-in for Metal does not compile its standard library", compiled.error().log);
    return {};
  }

  const ContextInfo& info() const override { return info_; }

  std::string unsupported(const Profile& profile, Stage stage) const override {
    if (auto reason = unsupported_to_run(profile, info_.languages); !reason.empty()) return reason;
    return stage == Stage::compute ? "" : "functions are evaluated in kernels here";
  }

  Result<std::unique_ptr<Evaluable>> build(const SourceSet& sources, const Evaluation& evaluation,
                                           std::string_view shader) override {
    HN_TRY(const auto text, expand(sources, evaluation.profile, shader));
    const std::string name = fmt::format("kernel{}", number_++);
    folder_.write(name + ".cpp", text.text);
    const auto object_path = folder_.path() / (name + ".so");
    // Its C library is in this process; linking it once more took half of the time.
    std::vector<std::string> arguments = options();
    arguments.insert(arguments.end(), {"-shared", "-nostdlib", "-include-pch", precompiled().string(),
                                       (folder_.path() / (name + ".cpp")).string(), "-o", object_path.string()});
    const auto compiled = run_process(
        {.program = kCompiler, .arguments = std::move(arguments), .output = folder_.path() / (name + ".log")});
    if (!compiled)
      return fail("the stand-in for Metal does not compile the kernel", text.translate(compiled.error().log));
    SharedObject object(object_path);
    auto* const kernel = reinterpret_cast<Kernel*>(object.find("evaluate_point"));
    if (!kernel) return fail(fmt::format("{} does not define evaluate_point", object_path.string()));
    return std::make_unique<CompiledKernel>(std::move(object), kernel);
  }

  bool is_lost() const override { return false; }
  const Context* context() const override { return nullptr; }

 private:
  std::filesystem::path header() const { return folder_.path() / "metal_stdlib"; }
  std::filesystem::path precompiled() const { return folder_.path() / "metal_stdlib.pch"; }

  // -O0: what takes longer to compile than to run.
  std::vector<std::string> options() const {
    return {"-std=c++14",           "-O0", "-fPIC", "-ffp-contract=off", "-Wno-unknown-attributes", "-I",
            folder_.path().string()};
  }

  TemporaryFolder folder_;
  ContextInfo info_;
  int number_ = 0;  // of kernels so far
};

}  // namespace

Result<std::unique_ptr<Evaluator>> create_metal_evaluator() {
  auto evaluator = std::make_unique<MetalEvaluator>();
  const auto found = evaluator->find_compiler();
  if (!found) return fail(fmt::format("it needs {}: {}", kCompiler, found.error().text()));
  return evaluator;
}

}  // namespace hn
