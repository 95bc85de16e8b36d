#include "gpu/evaluator.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <regex>
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

// The call of a kernel, which call_of writes: evaluates so many points, and returns its first operation that Metal
// leaves undefined, or an empty text.
using Call = const char*(void* const* buffers, std::uint32_t points);

class CompiledKernel final : public Evaluable {
 public:
  CompiledKernel(SharedObject object, Call* call, ShaderText text)
      : object_(std::move(object)), call_(call), text_(std::move(text)) {}

  Result<Words> evaluate(std::span<const std::uint32_t> inputs) override {
    const std::size_t points = inputs.size() / kInputWords;
    Words results(points * kOutputWords, kNothing);
    Words copied(inputs.begin(), inputs.end());
    std::array<std::uint32_t, 2> shared = {uniforms.trips, uniforms.variant_seed};
    // naga has the sizes of the buffers in another one, for arrayLength: here each is the largest.
    constexpr std::size_t kMostSizes = 16;
    Words sizes(kMostSizes, static_cast<std::uint32_t>(inputs.size_bytes()));
    const std::array<void*, 4> buffers = {results.data(), copied.data(), shared.data(), sizes.data()};
    const std::string undefined = call_(buffers.data(), static_cast<std::uint32_t>(points));
    if (!undefined.empty())
      return fail("Metal leaves an operation of the kernel undefined", text_.translate(undefined));
    return results;
  }

 private:
  SharedObject object_;
  Call* call_;
  ShaderText text_;
};

// v.yx becomes v.part<'y','x'>(), and v.yx = w becomes v.place<'y','x'>() = w, as the stand-in's vectors have them.
std::string with_called_parts(const std::string& text) {
  static const std::regex kParts(R"(\.([xyzw]{2,4})\b( (?==[^=]))?)");
  std::string called;
  std::smatch found;
  auto from = text.begin();
  for (; std::regex_search(from, text.end(), found, kParts); from = found[0].second) {
    called.append(from, found[0].first);
    called +=
        fmt::format(".{}<'{}'>(){}", found[2].matched ? "place" : "part", fmt::join(found.str(1), "','"), found.str(2));
  }
  return called.append(from, text.end());
}

// The argument for a parameter of a kernel. Names come before numbers: naga writes no numbers, and SPIRV-Cross counts
// in its own order by default.
Result<std::string> argument_for(const std::string& parameter) {
  constexpr std::array<std::pair<const char*, const char*>, 8> kArguments = {{{"thread_position_in_grid", "Position()"},
                                                                              {"results|outputs", "Buffer{buffers[0]}"},
                                                                              {"points|inputs", "Buffer{buffers[1]}"},
                                                                              {"uniforms", "Buffer{buffers[2]}"},
                                                                              {"buffer_?sizes", "Buffer{buffers[3]}"},
                                                                              {"buffer\\(0", "Buffer{buffers[0]}"},
                                                                              {"buffer\\(1", "Buffer{buffers[1]}"},
                                                                              {"buffer\\(2", "Buffer{buffers[2]}"}}};
  for (const auto& [name, argument] : kArguments) {
    if (std::regex_search(parameter, std::regex(name, std::regex::icase)))
      return fmt::format("metal::detail::{}", argument);
  }
  return fail(fmt::format("the stand-in for Metal has nothing for the parameter{}", parameter));
}

// A function that calls the text's kernel, "kernel void name(...)" or "[[kernel]] void name(...)", at all points.
Result<std::string> call_of(const std::string& text) {
  static const std::regex kKernel(R"(\bkernel(?:\]\])?\s+void\s+(\w+)\s*\(((?:[^()]|\(\w*\))*)\))");
  static const std::regex kParameter(R"([^,()]+(?:\(\w*\)[^,()]*)?)");
  const auto last = text.rfind("kernel void");  // the library's text is long
  std::smatch kernel;
  if (!std::regex_search(text.begin() + (last == text.npos ? 0 : static_cast<std::ptrdiff_t>(last)), text.end(), kernel,
                         kKernel))
    return fail("the stand-in for Metal finds no kernel in the text");
  std::vector<std::string> arguments;
  for (std::sregex_iterator at(kernel[2].first, kernel[2].second, kParameter), end; at != end; ++at) {
    HN_TRY(auto argument, argument_for(at->str()));
    arguments.push_back(std::move(argument));
  }
  return fmt::format(R"(
extern "C" const char* evaluate_points(void* const* buffers, uint points) {{
  metal::detail::undefined[0] = 0;
  for (metal::detail::point = 0; metal::detail::point < points; ++metal::detail::point) {}({});
  return metal::detail::undefined;
}}
)",
                     kernel.str(1), fmt::join(arguments, ", "));
}

class MetalEvaluator final : public Evaluator {
 public:
  MetalEvaluator() {
    folder_.write(header().filename().string(), text_of(kGpuFiles, "metal_stdlib.hpp"));
    std::filesystem::create_directory(folder_.path() / "simd");
    for (const char* const other : {"simd/simd.h", "metal_math", "metal_texture"}) folder_.write(other, "");
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
    HN_TRY(auto text, expand(sources, evaluation.profile, shader));
    return compile(std::move(text));
  }

  std::vector<Form> takes() const override { return {Form::msl}; }

  Result<std::unique_ptr<Evaluable>> load(const Code& code) override {
    // SPIRV-Cross has an array with functions for each address space; here they are one.
    static const std::regex kOtherSpaces(
        R"(\n *(constexpr const )?(device|constant|threadgroup) T& operator \[\] \(size_t pos\)[^{]*\{[^}]*\})");
    return compile({"#line 1 \"kernel\"\n" + with_called_parts(std::regex_replace(code.bytes, kOtherSpaces, "")), {}});
  }

  bool is_lost() const override { return false; }
  const Context* context() const override { return nullptr; }

 private:
  Result<std::unique_ptr<Evaluable>> compile(ShaderText text) {
    HN_TRY(const std::string call, call_of(text.text));
    const std::string name = fmt::format("kernel{}", number_++);
    folder_.write(name + ".cpp", text.text + call);
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
    auto* const evaluate = reinterpret_cast<Call*>(object.find("evaluate_points"));
    if (!evaluate) return fail(fmt::format("{} does not define evaluate_points", object_path.string()));
    return std::make_unique<CompiledKernel>(std::move(object), evaluate, std::move(text));
  }

  std::filesystem::path header() const { return folder_.path() / "metal_stdlib"; }
  std::filesystem::path precompiled() const { return folder_.path() / "metal_stdlib.pch"; }

  // -O0: what takes longer to compile than to run. Metal has no doubles. It takes the count of a shift modulo 32
  // (section 3.1), so only what is shifted can make one undefined. Slang calls a kernel main.
  std::vector<std::string> options() const {
    return {"-std=c++14",
            "-O0",
            "-fPIC",
            "-ffp-contract=off",
            "-fsanitize=signed-integer-overflow,shift-base",
            "-Xclang",
            "-cl-single-precision-constant",
            "-Wno-unknown-attributes",
            "-Dmain=main_",
            "-I",
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
