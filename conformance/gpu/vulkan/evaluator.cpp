#include "gpu/evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "gpu/spirv.hpp"
#include "gpu/vulkan/device.hpp"
#include "gpu/way/translate.hpp"

namespace hn {
namespace {

using Words = std::vector<std::uint32_t>;

constexpr std::uint32_t kNothing = 0xDEADBEEF;
constexpr const char* kShaderModel5 = "hlsl50";
constexpr const char* kShaderModel6 = "hlsl60";
constexpr auto kUnlimited = std::chrono::hours(24);  // the case has a limit

class RunningKernel final : public Evaluable {
 public:
  RunningKernel(VulkanDevice& device, std::unique_ptr<VulkanKernel> kernel)
      : device_(device), kernel_(std::move(kernel)) {}

  // Whole groups of points are evaluated, and those beyond the last one, which see zeros, thrown away. A result that
  // the shader does not write is kNothing.
  Result<Words> evaluate(std::span<const std::uint32_t> inputs) override {
    const std::size_t points = inputs.size() / kInputWords;
    if (points > kGridSide * kGridSide) throw std::logic_error(fmt::format("too many points: {}", points));
    const std::size_t groups = (points + kComputeGroup - 1) / kComputeGroup;
    Words padded(inputs.begin(), inputs.end());
    padded.resize(groups * kComputeGroup * kInputWords);
    Words results(groups * kComputeGroup * kOutputWords, kNothing);
    const std::array<std::uint32_t, 2> shared = {uniforms.trips, uniforms.variant_seed};
    HN_DO(device_.run(*kernel_, padded, shared, static_cast<std::uint32_t>(groups), results));
    results.resize(points * kOutputWords);
    return results;
  }

 private:
  VulkanDevice& device_;
  std::unique_ptr<VulkanKernel> kernel_;
};

// The way of a language that glslang does not stand for.
Result<Way> way_by(std::vector<std::string> translators) {
  constexpr std::array kSpirv = {Form::spirv};
  return find_way({.through = std::move(translators)}, kSpirv);
}

class VulkanEvaluator final : public Evaluator {
 public:
  VulkanEvaluator(std::unique_ptr<VulkanDevice> device, const ReferenceCompiler& compiler)
      : device_(std::move(device)), compiler_(compiler) {
    const VulkanDeviceInfo& found = device_->info();
    info_.vendor = found.driver;
    info_.renderer = found.name;
    info_.gl_version = fmt::format("{}, glslang {}{}", found.version, reference_compiler_version(),
                                   found.validated ? ", with validation layers" : "");
    info_.languages.profiles = {"vulkan", kShaderModel6};
    if (dxc_) info_.gl_version += ", " + dxc_->steps.front().text();
    if (vkd3d_) {
      info_.languages.profiles.push_back(kShaderModel5);
      info_.gl_version += fmt::format(", vkd3d-compiler {}", vkd3d_->steps.front().version);
    }
  }

  const ContextInfo& info() const override { return info_; }

  std::string unsupported(const Profile& profile, Stage stage) const override {
    if (profile.name == kShaderModel5 && !vkd3d_) return vkd3d_.error().message;
    if (profile.name == kShaderModel6 && !dxc_ && std::getenv("HN_DXC")) return dxc_.error().message;
    if (auto reason = unsupported_to_run(profile, info_.languages); !reason.empty()) return reason;
    return stage == Stage::compute ? "" : "functions are evaluated in compute shaders here";
  }

  Result<std::unique_ptr<Evaluable>> build(const SourceSet& sources, const Evaluation& evaluation,
                                           std::string_view shader) override {
    HN_TRY(const auto text, expand(sources, evaluation.profile, shader));
    HN_TRY(const auto words, spirv(text, evaluation.profile));
    return run(words);
  }

  std::vector<Form> takes() const override { return {Form::spirv, Form::glsl_es, Form::gl, Form::glsl, Form::hlsl}; }

  Result<std::unique_ptr<Evaluable>> load(const Code& code) override {
    if (code.form == Form::spirv) return run(spirv_of(code.bytes));
    const Profile& profile = profile_named(code.form == Form::hlsl ? kShaderModel6 : "vulkan");
    HN_TRY(const auto words, spirv(ShaderText{code.bytes, {}}, profile));
    return run(words);
  }

  bool is_lost() const override { return device_->is_lost(); }
  const Context* context() const override { return nullptr; }

 private:
  Result<std::unique_ptr<Evaluable>> run(const Words& words) {
    if (!device_->info().validated) HN_DO(validate_spirv(words));
    HN_TRY(auto kernel, device_->build(words));
    return std::make_unique<RunningKernel>(*device_, std::move(kernel));
  }

  Result<Words> spirv(const ShaderText& text, const Profile& profile) const {
    if (profile.name == kShaderModel6 && dxc_) return spirv(*dxc_, text);
    if (profile.name != kShaderModel5) return compiler_.spirv(text, profile, Stage::compute);
    // vkd3d's own preprocessor takes a macro's expansion of an argument for one argument of the next.
    HN_TRY(const auto plain, compiler_.preprocessed(text, profile, Stage::compute));
    return spirv(*vkd3d_, plain);
  }

  static Result<Words> spirv(const Way& way, const ShaderText& text) {
    std::vector<Code> given;
    const auto done = translate(way.steps, {Form::hlsl, text.text}, kUnlimited, given);
    if (!done) return fail(done.error().error.message, text.translate(done.error().error.log));
    return spirv_of(given.back().bytes);
  }

  std::unique_ptr<VulkanDevice> device_;
  const ReferenceCompiler& compiler_;
  const Result<Way> dxc_ = way_by({"dxc"});  // in place of glslang
  const Result<Way> vkd3d_ = way_by({"vkd3d", "vkd3d"});
  ContextInfo info_;
};

}  // namespace

Result<std::unique_ptr<Evaluator>> create_vulkan_evaluator(int number, const ReferenceCompiler& compiler) {
  HN_TRY(auto device, open_vulkan_device(number));
  return std::make_unique<VulkanEvaluator>(std::move(device), compiler);
}

}  // namespace hn
