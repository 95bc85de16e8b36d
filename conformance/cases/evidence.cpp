#include "cases/evidence.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "base/folder.hpp"
#include "base/process.hpp"
#include "cases/bugs/bugs.hpp"
#include "cases/value_checks.hpp"
#include "expected/golden.hpp"
#include "expected/points.hpp"
#include "expected/tolerance.hpp"
#include "expected/twin.hpp"

namespace hn {
namespace {

// A second one, since the first of a function's cases may fail for another reason.
constexpr std::size_t kMostPerFunction = 2;
// With its pictures one takes about 50 kB.
constexpr int kMostPerDriver = 40;

constexpr std::string_view kNoShader = "There is no shader that stands alone: such a shader is made for OpenGL.";

// The right value at a point, and the tolerance of a float unless every bit counts.
struct Reference {
  std::array<std::uint32_t, kOutputWords> words;
  std::array<double, kOutputWords> allowed;
  bool every_bit;
};

bool is_row_of_bugs(std::string_view id) { return id.starts_with("bugs.") || id.starts_with("check."); }

std::string renderer_of(const ContextInfo& info) {
  return fmt::format("{}, {}, GLSL {} ({})", info.renderer, info.gl_version, info.glsl_version, info.vendor);
}

using Colour = Result<std::array<std::uint8_t, 4>>;

bool is_red(const Colour& colour) { return colour && (*colour)[0] > (*colour)[1]; }
bool is_green(const Colour& colour) { return colour && (*colour)[1] > (*colour)[0]; }

// A shader, and the colour in which it draws here.
struct Drawn {
  std::string shader;
  Colour colour;
};

Drawn drawn(const Session& session, const Profile& profile, std::string shader) {
  const auto draw = [&]() -> Colour {
    HN_TRY(const auto vertex, expand(session.sources, profile, vertex_shader()));
    const Context& context = *session.evaluator->context();
    HN_TRY(const auto program, Program::build(context, vertex, {shader, {"the shader"}}));
    return draw_pixel(context, program);
  };
  Colour colour = draw();
  return {std::move(shader), std::move(colour)};
}

// The shader as tools/pick writes it, where that is at hand.
Result<std::string> picked(const Session& session, const ShaderFacts& facts, const std::string& shader) {
  // For a known bug the shader is the expression that fails, and tools/pick may write another one.
  if (session.pick.empty() || is_row_of_bugs(facts.id)) return fail("there is nothing to shorten it by");
  const TemporaryFolder folder;
  folder.write("shader", shader);
  return output_of(session.pick.string(), {"shader", (folder.path() / "shader").string()});
}

// Whether a shader fails as the longer one does: with the same error, or with the value that the suite got.
bool fails_alike(const Session& session, const Profile& profile, const ShaderFacts& facts, const Drawn& shown,
                 const Drawn& longer) {
  if (!longer.colour) return !shown.colour && shown.colour.error().message == longer.colour.error().message;
  if (!is_red(shown.colour)) return false;
  // No number is near NaN.
  const auto is_finite = [](std::uint32_t word) { return std::isfinite(number_of(word)); };
  return !(facts.every_bit || std::ranges::all_of(facts.got, is_finite)) ||
         is_green(drawn(session, profile, expecting_got(shown.shader, facts)).colour);
}

// The shortest form of the shader that shows the fault.
template <typename Shows>
Result<Drawn> shortest(const Session& session, const Evaluation& evaluation, const ShaderFacts& facts, Shows shows) {
  const Profile& profile = evaluation.profile;
  if (auto text = stand_alone_shader(session.sources, evaluation, facts, &session.reference)) {
    auto brief = drawn(session, profile, *std::move(text));
    if (shows(brief.colour)) {
      auto shorter = picked(session, facts, brief.shader);
      if (!shorter) return brief;
      auto shown = drawn(session, profile, *std::move(shorter));
      return fails_alike(session, profile, facts, shown, brief) ? shown : brief;
    }
  }
  HN_TRY(auto whole, stand_alone_shader(session.sources, evaluation, facts));
  return drawn(session, profile, std::move(whole));
}

// The shader, if it shows the fault.
void keep_shader(Evidence& evidence, const Session& session, const Evaluation& evaluation, const ShaderFacts& facts) {
  auto shader = shortest(session, evaluation, facts, is_red);
  if (!shader) return;
  if (!shader->colour) {
    evidence.note += fmt::format("The shader could not be drawn here: {}.", shader->colour.error().message);
  } else if (is_red(shader->colour)) {
    evidence.note += "The shader is red on this driver.";
  } else {
    evidence.note +=
        "A shader of this point alone is green on this driver: the fault needs the surroundings of the case.";
    return;
  }
  evidence.shader = std::move(shader->shader);
}

class Examiner {
 public:
  Examiner(Session& session, const Case& test, const Outcome& outcome)
      : session_(session),
        id_(test.id),
        outcome_(outcome),
        // The other shapes and stages of a shader have other results, or no pixels. Elsewhere than in OpenGL there is
        // one stage, and nothing is drawn.
        evaluation_{.function = test.evaluation()->function,
                    .configuration = test.evaluation()->configuration,
                    .profile = test.evaluation()->profile,
                    .variant = {.seeded = test.evaluation()->variant.seeded, .knobs = test.evaluation()->variant.knobs},
                    .stage = session.evaluator->context() ? Stage::fragment : test.evaluation()->stage} {}

  std::optional<Evidence> run() {
    const Words first = wrong_point();
    window_ = window_around(function(), first);
    reference_ = evaluate_twin(function(), evaluation_.configuration, window_);
    const auto got = evaluate(session_, evaluation_, window_);
    if (!got) return without_values(got.error());
    got_ = *got;
    std::size_t wrong = 0;
    std::size_t at = kMiddle * kPictureSide + kMiddle;
    const bool middle_is_wrong = is_wrong(at);
    for (std::size_t i = 0; i < kPictureSide * kPictureSide; ++i) {
      if (!is_wrong(i)) continue;
      if (wrong++ == 0 && !middle_is_wrong && !is_off_golden(at)) at = i;
    }
    Evidence evidence;
    if (wrong != 0) add_pictures(evidence, wrong);
    if (session_.evaluator->context()) {
      add_shader(evidence, at);
    } else if (!session_.evaluator->way()) {
      evidence.note += kNoShader;
    }
    return evidence;
  }

 private:
  const Function& function() const { return evaluation_.function; }

  // Where the case failed; or, if it names no point, any.
  Words wrong_point() const {
    const bool known = !outcome_.examples.empty() && outcome_.examples.front().words.size() == kInputWords;
    if (known) return outcome_.examples.front().words;
    return random_points(function(), 1, Random(session_.seed, id_));
  }

  std::array<double, kOutputWords> allowed_at(std::size_t i, decltype(tolerance) allowed_by) const {
    std::array<double, kOutputWords> allowed{};
    for (std::size_t word = 0; word < function().outputs.size(); ++word) {
      allowed[word] = allowed_by(function(), evaluation_.configuration, point(window_, i), word);
    }
    return allowed;
  }

  // As the twin has it; both may be off the exact value.
  Reference right_by_twin(std::size_t i) const {
    Reference right{{}, allowed_at(i, allowed_to_twin), has_same_bits(function(), evaluation_.configuration)};
    const auto words = result(reference_, i);
    std::copy(words.begin(), words.end(), right.words.begin());
    return right;
  }

  // As its golden file has it, if the point is in it.
  std::optional<Reference> right_by_golden(std::size_t i) const {
    const auto path = golden_path(session_.golden_directory, function());
    const auto golden = read_golden(path, function(), evaluation_.configuration);
    if (!golden) return std::nullopt;
    const auto words = point(window_, i);
    for (const GoldenRow& row : golden->rows) {
      if (!std::equal(row.inputs.begin(), row.inputs.end(), words.begin())) continue;
      Reference right{{}, allowed_at(i, tolerance), has_exact_values(function(), evaluation_.configuration)};
      for (std::size_t word = 0; word < row.values.size(); ++word) {
        right.words[word] = result_bits(function().outputs[word], row.values[word]);
      }
      return right;
    }
    return std::nullopt;
  }

  bool differs(std::size_t i, const Reference& right) const {
    for (std::size_t word = 0; word < function().outputs.size(); ++word) {
      const std::uint32_t got = result(got_, i)[word];
      if (right.allowed[word] == kUndecided) continue;
      if (right.every_bit || function().is_name(word)) {
        if (got != right.words[word]) return true;
      } else if (!(std::fabs(number_of(got) - number_of(right.words[word])) <= right.allowed[word])) {
        return true;
      }
    }
    return false;
  }

  bool is_wrong(std::size_t i) const { return differs(i, right_by_twin(i)); }
  bool is_off_golden(std::size_t i) const {
    const auto right = right_by_golden(i);
    return right && differs(i, *right);
  }

  void add_pictures(Evidence& evidence, std::size_t wrong) const {
    const Pictures pictures = draw_pictures(function(), got_, reference_);
    evidence.got = pictures.got;
    evidence.reference = pictures.reference;
    evidence.difference = pictures.difference;
    evidence.factor = pictures.factor;
    evidence.note = fmt::format("{} of the {} points of the pictures are wrong. {} ", wrong,
                                kPictureSide * kPictureSide, describe_window(function(), window_));
  }

  Reference right_at(std::size_t i) const {
    const auto golden = right_by_golden(i);
    return golden ? *golden : right_by_twin(i);
  }

  ShaderFacts facts_of(std::size_t i, const Reference& right) const {
    return {.id = id_,
            .renderer = renderer_of(session_.info()),
            .inputs = point(window_, i),
            .got = got_.empty() ? std::span<const std::uint32_t>{} : result(got_, i),
            .expected = right.words,
            .allowed = right.allowed,
            .every_bit = right.every_bit};
  }

  // The shader, if it shows the fault.
  void add_shader(Evidence& evidence, std::size_t i) {
    const Reference right = right_at(i);
    if (!differs(i, right)) {
      evidence.note +=
          "At this point and around it the driver agrees with the C++ twin: the fault is between values, in another "
          "value that the case compares, or in another stage or shape of the shader, and no shader of one point shows "
          "it.";
      return;
    }
    keep_shader(evidence, session_, evaluation_, facts_of(i, right));
  }

  // The driver refuses the shader, or fails to draw with it.
  std::optional<Evidence> without_values(const Outcome& why) const {
    if (why.status != Status::fail || !session_.evaluator->context()) return std::nullopt;
    constexpr std::size_t kAt = kMiddle * kPictureSide + kMiddle;
    auto shader = shortest(session_, evaluation_, facts_of(kAt, right_at(kAt)),
                           [](const Colour& colour) { return !colour.has_value(); });
    if (!shader) return std::nullopt;
    Evidence evidence;
    evidence.shader = std::move(shader->shader);
    evidence.note = fmt::format("There are no values to show: {}.", why.message.substr(0, why.message.find('\n')));
    return evidence;
  }

  Session& session_;
  const std::string& id_;
  const Outcome& outcome_;
  const Evaluation evaluation_;
  Words window_;
  Words got_;
  Words reference_;
};

// The evidence of a known bug, at its first point that is wrong.
std::optional<Evidence> evidence_of(Session& session, const Case& test, const BugKind& kind, const Outcome& outcome) {
  if (!session.evaluator->context() || outcome.examples.empty()) return std::nullopt;
  const Bug& bug = *kind.bug;
  const Mismatch& wrong = outcome.examples.front();
  const BugPoint& point = bug.points.at(wrong.point);
  const Evaluation evaluation = evaluation_of(bug, *kind.profile);
  const double allowed = bug.rule_in(*kind.profile).allowed;
  ShaderFacts facts{
      .id = test.id, .renderer = renderer_of(session.info()), .inputs = wrong.words, .every_bit = allowed == 0.0};
  std::ranges::copy(point.expected, facts.expected.begin());
  facts.allowed.fill(allowed);
  const auto got = evaluate(session, evaluation, wrong.words);
  if (got) facts.got = *got;
  Evidence evidence;
  keep_shader(evidence, session, evaluation, facts);
  return evidence;
}

}  // namespace

std::optional<Evidence> make_evidence(Session& session, const Case& test, const Outcome& outcome) {
  if (outcome.status != Status::fail) return std::nullopt;
  try {
    if (const auto* bug = std::get_if<BugKind>(test.kind.get())) return evidence_of(session, test, *bug, outcome);
    return test.evaluation() ? Examiner(session, test, outcome).run() : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;  // the case has its verdict
  }
}

Result<std::array<std::uint8_t, 4>> draw_pixel(const Context& context, const Program& program) {
  const GladGLContext& gl = context.gl();
  GLuint texture = 0;
  GLuint framebuffer = 0;
  GLuint vertex_array = 0;
  gl.GenTextures(1, &texture);
  gl.GenFramebuffers(1, &framebuffer);
  gl.GenVertexArrays(1, &vertex_array);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Viewport(0, 0, 1, 1);
  gl.ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.UseProgram(program.id());
  gl.BindVertexArray(vertex_array);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  std::array<std::uint8_t, 4> pixel{};
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  const GLenum error = gl.GetError();
  gl.DeleteFramebuffers(1, &framebuffer);
  gl.DeleteTextures(1, &texture);
  gl.DeleteVertexArrays(1, &vertex_array);
  if (error != GL_NO_ERROR) return fail(fmt::format("OpenGL error {:#06x}", error));
  if (pixel[3] == 0) return fail("nothing was drawn");
  return pixel;
}

bool EvidenceBudget::take(const CaseName& name) {
  auto& of_function = by_function_[name.function];
  // Known bugs come last, have no pictures, and explain the cases before them.
  const bool is_bug = is_row_of_bugs(name.function);
  if ((all_ >= kMostPerDriver && !is_bug) || of_function.size() >= kMostPerFunction) return false;
  // A fault in one version of the language is mostly in the others, too.
  CaseName in_any_version = name;
  in_any_version.profile.clear();
  if (!of_function.insert(in_any_version.id()).second) return false;
  all_ += is_bug ? 0 : 1;
  return true;
}

}  // namespace hn
