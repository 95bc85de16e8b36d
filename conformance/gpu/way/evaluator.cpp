#include "gpu/way/evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/file.hpp"
#include "base/text.hpp"
#include "gpu/way/translate.hpp"

namespace hn {
namespace {

// A shader that gives back its input.
const Function& identity() {
  static const Function kIdentity = {.id = "way.identity",
                                     .file = "config.glsl",
                                     .call = "",
                                     .body = "return a;",
                                     .inputs = {{"x", WordType::u32}},
                                     .outputs = {{"x", WordType::u32}},
                                     .plain = ""};
  return kIdentity;
}
constexpr std::string_view kIdentityInWgsl =
    R"(@group(0) @binding(0) var<storage, read_write> results: array<vec4<u32>>;
@group(0) @binding(1) var<storage, read> points: array<vec4<u32>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
  results[id.x] = points[4u * id.x];
}
)";

// The languages in which drivers of one platform or another run functions over buffers.
constexpr std::array kOwnLanguages = {"vulkan", "gl430", "es310", "msl", "wgsl"};

// A shader before the first step, and the text that it was compiled from, or is.
struct Source {
  Code code;
  ShaderText text;
};

// Some translators do not know #line, and a reader of messages has the file that is kept.
std::string without_numbering(std::string_view text) {
  std::string kept;
  for (const std::string_view line : split(text, '\n')) {
    const auto directive = directive_of(line);
    if (!directive || directive->word != "line") kept += fmt::format("{}\n", line);
  }
  return kept;
}

class ThroughSteps final : public WayEvaluator {
 public:
  ThroughSteps(Way way, std::unique_ptr<Evaluator> inner, const ReferenceCompiler& compiler, WgslText wgsl,
               Translating translating)
      : way_(std::move(way)),
        inner_(std::move(inner)),
        compiler_(compiler),
        wgsl_(std::move(wgsl)),
        translating_(std::move(translating)),
        info_(inner_->info()),
        used_(way_.steps.size()) {
    info_.languages = {.gl130 = false, .bit_encoding = false, .profiles = way_.sources()};
  }

  const ContextInfo& info() const override { return info_; }
  bool is_lost() const override { return inner_->is_lost(); }
  const Context* context() const override { return nullptr; }
  WayEvaluator* way() override { return this; }
  const Way& steps() const override { return way_; }
  std::optional<FailedStep> failed_step() const override { return failed_; }

  std::string unsupported(const Profile& profile, Stage stage) const override {
    if (auto reason = unsupported_reason(profile, info_.languages); !reason.empty()) return reason;
    if (stage != Stage::compute) return "functions are evaluated in compute shaders here";
    const Trial& trial = tried(profile);
    return trial.error && !trial.failed ? trial.error->text() : "";
  }

  Result<std::unique_ptr<Evaluable>> build(const SourceSet& sources, const Evaluation& evaluation,
                                           std::string_view shader) override {
    failed_.reset();
    if (used_ == 0 && !is_taken(form_after(0))) return build_in_own_language(sources, evaluation, shader);
    if (evaluation.configuration.arithmetic == Arithmetic::precise && !way_.contracts().empty()) {
      failed_ = {StepEnd::not_completed, 1};
      return fail(fmt::format("{} knows no `precise`", way_.contracts()));
    }
    const Trial& trial = tried(evaluation.profile);
    failed_ = trial.failed;
    if (failed_) return tl::unexpected(*trial.error);
    HN_TRY(const Source source, written(sources, evaluation, shader));
    return build(source);
  }

  bool use_steps(std::size_t count, std::optional<std::size_t> without) override {
    used_ = count;
    without_ = without;
    return is_taken(form_after(count)) || (count == 0 && own_language());
  }

  void start(std::string_view name, bool keep_always) override {
    name_ = name;
    keep_always_ = keep_always;
  }

  std::string input_of(std::size_t number) const override {
    return (translating_.kept.filename() / name_ / file_of(number)).string();
  }

 private:
  // The simplest shader of a profile. Where a translator or the driver refuses even this, none of its cases can be run;
  // where a step fails in another manner, all of them would fail so.
  struct Trial {
    std::optional<Error> error;
    std::optional<FailedStep> failed;
  };

  const Trial& tried(const Profile& profile) const {
    const auto found = trials_.find(profile.name);
    return found != trials_.end() ? found->second : trials_.emplace(profile.name, attempt(profile)).first->second;
  }

  Trial attempt(const Profile& profile) const {
    const Evaluation evaluation{identity(), default_configuration(), profile, {}, Stage::compute};
    const auto source = profile.language == Language::wgsl
                            ? Source{{Form::wgsl, std::string(kIdentityInWgsl)}, {}}
                            : written(SourceSet::embedded(), evaluation, evaluation_shader(evaluation));
    if (!source) return {source.error(), {}};
    std::vector<Code> given;
    if (const auto done = translate(way_.steps, source->code, translating_.limit, given); !done) {
      const auto& [end, number, error] = done.error();
      if (end == StepEnd::refused) return {error, {}};
      keep(*source, given);
      return {error, FailedStep{end, number}};
    }
    const auto loaded = inner_->load(given.back());
    return {loaded ? std::optional<Error>() : loaded.error(), {}};
  }

  // The shader in the form that the first step takes.
  Result<Source> written(const SourceSet& sources, const Evaluation& evaluation, std::string_view shader) const {
    const Form form = form_after(0);
    if (form == Form::wgsl) {
      HN_TRY(auto text, wgsl_(sources, evaluation));
      return Source{{form, text}, {std::move(text), {}}};
    }
    HN_TRY(auto text, expand(sources, evaluation.profile, shader));
    if (form == Form::spirv) {
      HN_TRY(const auto words, compiler_.spirv(text, evaluation.profile, evaluation.stage));
      return Source{{form, std::string(bytes_of(std::span<const std::uint32_t>(words)))}, std::move(text)};
    }
    // Preprocessors of others lack something (vkd3d-compiler's: see gpu/vulkan/evaluator.cpp).
    if (evaluation.profile.in_glsl() || evaluation.profile.name == "hlsl50") {
      HN_TRY(text, compiler_.preprocessed(text, evaluation.profile, evaluation.stage));
    }
    return Source{{form, without_numbering(text.text)}, std::move(text)};
  }

  Result<std::unique_ptr<Evaluable>> build(const Source& source) {
    std::vector<Code> given;
    std::vector<Step> steps(way_.steps.begin(), way_.steps.begin() + static_cast<std::ptrdiff_t>(used_));
    if (without_) steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(*without_ - 1));
    const auto done = translate(steps, source.code, translating_.limit, given);
    if (!done || keep_always_) keep(source, given);
    if (!done) {
      auto [end, number, error] = done.error();
      failed_ = {end, number};
      error.message += kept_at(number);
      return tl::unexpected(std::move(error));
    }
    auto loaded = inner_->load(given.empty() ? source.code : given.back());
    if (loaded) return loaded;
    keep(source, given);
    // glslang reads only a part of HLSL.
    if (used_ != 0 && form_after(used_) == Form::hlsl) failed_ = {StepEnd::not_completed, used_};
    return fail(fmt::format("{} is refused: {}{}",
                            used_ == 0 ? "the shader" : fmt::format("what {} gives", way_.steps[used_ - 1].text()),
                            loaded.error().message, kept_at(used_ + 1)),
                loaded.error().log);
  }

  Result<std::unique_ptr<Evaluable>> build_in_own_language(const SourceSet& sources, const Evaluation& evaluation,
                                                           std::string_view shader) {
    if (shader != evaluation_shader(evaluation)) return fail("this shader is in one language alone");
    const Evaluation own{evaluation.function, evaluation.configuration, *own_language(), evaluation.variant,
                         Stage::compute};
    return inner_->build(sources, own, evaluation_shader(own));
  }

  const Profile* own_language() const {
    for (const char* const name : kOwnLanguages) {
      const Profile& profile = profile_named(name);
      if (inner_->unsupported(profile, Stage::compute).empty()) return &profile;
    }
    return nullptr;
  }

  Form form_after(std::size_t count) const {
    return count == 0 ? way_.steps.front().takes : way_.steps[count - 1].gives;
  }

  bool is_taken(Form form) const {
    const auto forms = inner_->takes();
    return std::ranges::find(forms, form) != forms.end();
  }

  // "2-spirv-cross.spv", which that step gets, or "3-driver.comp".
  std::string file_of(std::size_t number) const {
    const bool is_step = number <= way_.steps.size();
    return fmt::format("{}-{}{}", number, is_step ? way_.steps[number - 1].name : "driver",
                       ending_of(form_after(number - 1)));
  }

  std::string kept_at(std::size_t number) const {
    return translating_.kept.empty() ? "" : fmt::format("; {} is its input", input_of(number));
  }

  void keep(const Source& source, const std::vector<Code>& given) const {
    if (translating_.kept.empty()) return;
    const auto folder = translating_.kept / name_;
    // A file that cannot be written is missing, and the verdict stands.
    const auto write = [&](const std::string& file, std::string_view bytes) { (void)write_file(folder / file, bytes); };
    if (source.code.form == Form::spirv)
      write(source.text.text.find("#version") == 0 ? "0-source.glsl" : "0-source.hlsl", source.text.text);
    write(file_of(1), source.code.bytes);
    for (std::size_t i = 0; i < given.size(); ++i) write(file_of(i + 2), given[i].bytes);
  }

  const Way way_;
  const std::unique_ptr<Evaluator> inner_;
  const ReferenceCompiler& compiler_;
  const WgslText wgsl_;
  const Translating translating_;
  ContextInfo info_;
  std::size_t used_;
  std::optional<std::size_t> without_;
  std::string name_ = "first";
  bool keep_always_ = false;
  std::optional<FailedStep> failed_;
  mutable std::map<std::string_view, Trial> trials_;
};

}  // namespace

std::unique_ptr<WayEvaluator> evaluator_through(Way way, std::unique_ptr<Evaluator> inner,
                                                const ReferenceCompiler& compiler, WgslText wgsl,
                                                Translating translating) {
  return std::make_unique<ThroughSteps>(std::move(way), std::move(inner), compiler, std::move(wgsl),
                                        std::move(translating));
}

}  // namespace hn
