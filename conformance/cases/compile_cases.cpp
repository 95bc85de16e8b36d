// Cases that only compile: every file with every hash in every version, by glslang and by the driver; and shaders that
// the library must refuse, or must not.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <hashnoise/hashnoise.hpp>
#include <iterator>
#include <span>

#include "cases/case.hpp"
#include "gpu/gpu.hpp"
#include "gpu/spirv.hpp"
#include "library/files.hpp"
#include "library/shaders.hpp"

namespace hn {
namespace {

std::string_view stem(std::string_view file) {
  const std::string_view name = file.substr(file.rfind('/') + 1);
  return name.substr(0, name.find('.'));
}

// These cases compile whole files, so exact functions get no separate case.
CaseName name_of(std::string_view file, const Configuration& configuration, Stage stage, const Profile& profile,
                 std::string_view check) {
  return {.function = fmt::format("{}.all", stem(file)),
          .configuration = std::string(configuration.name_without_arithmetic()),
          .arithmetic = std::string(name_of(configuration.arithmetic)),
          .stage = stage,
          .profile = std::string(profile.name),
          .check = std::string(check)};
}

// Names a case about the knobs themselves, whatever their values are.
CaseName name_of_setting(std::string_view name, std::string_view profile, std::string_view check) {
  return {.function = fmt::format("config.{}", name),
          .configuration = "any",
          .arithmetic = "fast",
          .stage = Stage::fragment,
          .profile = std::string(profile),
          .check = std::string(check)};
}

Outcome outcome_of(const Result<void>& result) {
  return result ? Outcome{} : outcome_with(Status::fail, result.error());
}

Outcome check_with_glslang(const Suite& suite, const Profile& profile, const std::string& text, Stage stage) {
  const auto source = expand(suite.sources, profile, text);
  return source ? outcome_of(suite.reference.check(*source, profile, stage))
                : outcome_with(Status::fail, source.error());
}

// Drivers compile this in every version: noise, fractals and the files below both, a tenth of the whole text.
constexpr std::string_view kFileForDrivers = "fbm2d.glsl";

// glslang tries every file alone with every arithmetic; drivers, which take longer, all of them together.
bool is_for_drivers(std::string_view file, const Configuration& configuration) {
  if (configuration.fast() || file == kFileForDrivers) return file != "detail/arithmetic.glsl";
  return file == "hashnoise.glsl" && !configuration.sine();
}

// Every hash is other code, and so is each other knob by itself; combinations are not, but for a gradient in another
// arithmetic. Hashes have no arithmetic; what no function of the table names is tried in full by what includes it.
bool selects_code(std::string_view file, const Configuration& configuration) {
  const bool by_arithmetic = configuration.default_but_for_arithmetic();
  const auto names_it = [&](const Function& function) { return function.file == file; };
  if (file != "hashnoise.glsl" && std::ranges::none_of(all_functions(), names_it)) return by_arithmetic;
  if (!configuration.fast()) {
    const bool sine = configuration.name_without_arithmetic() == "lattice+sine";
    return file != "hash.glsl" && (by_arithmetic || (sine && file == "hashnoise.glsl"));
  }
  return configuration.hash_only() || configuration.name == "lattice+sine";
}

// Elsewhere the library must refuse it.
bool can_compile(const Configuration& configuration, const Profile& profile) {
  return configuration.arithmetic != Arithmetic::precise || profile.has_precise();
}

std::span<const Stage> stages_of(const Profile& profile) {
  static constexpr std::array kStages = {Stage::fragment, Stage::vertex, Stage::compute};
  const bool has_compute = profile.version >= (profile.es ? 310 : 430);
  return std::span(kStages).first(has_compute ? 3 : 2);
}

// A file by itself is compiled as SPIR-V, which shows more than that it compiles, once in each arithmetic: the cases
// highp and uncontracted. So the rest to compile are the versions and the stages, with the whole library: each
// version in one stage and one arithmetic, in turn; and each hash and the sine gradient, with the file that has them.
bool is_chosen(std::string_view file, const Configuration& configuration, const Profile& profile, Stage stage) {
  if (file != "hashnoise.glsl") {
    const bool selected = file == "hash.glsl" || (file == "gradient.glsl" && configuration.sine());
    return selected && profile.name == "gl330" && stage == Stage::fragment && configuration.fast();
  }
  std::vector<const Configuration*> settings;
  for (const Configuration& one : all_configurations()) {
    if (one.default_but_for_arithmetic() && can_compile(one, profile)) settings.push_back(&one);
  }
  const auto stages = stages_of(profile);
  const auto turn = static_cast<std::size_t>(&profile - all_profiles().data());
  return &configuration == settings[turn % settings.size()] && stage == stages[turn / settings.size() % stages.size()];
}

// A driver compiles the whole library in its main version. In each other one it compiles one file, in the
// arithmetic of the version's turn.
Extent extent_on_drivers(std::string_view file, const Configuration& configuration, const Profile& profile) {
  if (configuration.is_default() && (profile.name == "gl330" || profile.name == "es300")) {
    return file == "hashnoise.glsl" ? Extent::every_driver : Extent::thorough;
  }
  if (file != kFileForDrivers) return Extent::thorough;
  const bool in_turn = std::ranges::any_of(
      stages_of(profile), [&](Stage stage) { return is_chosen("hashnoise.glsl", configuration, profile, stage); });
  return in_turn ? Extent::one_driver : Extent::thorough;
}

// A file of the library with one configuration in one version.
void add_file_cases(std::vector<Case>& cases, std::string_view file, const Configuration& configuration,
                    const Profile& profile, Scope scope) {
  const auto is_wanted = [&](Extent extent) { return scope == Scope::thorough || extent != Extent::thorough; };
  // A file that includes others must not lose one.
  const Callees callees = configuration.is_default() ? Callees::of_each_file : Callees::of_each_family;
  const auto add_glslang = [&](Stage stage) {
    const Extent extent = is_chosen(file, configuration, profile, stage) ? Extent::one_driver : Extent::thorough;
    if (!is_wanted(extent)) return;
    cases.push_back({name_of(file, configuration, stage, profile, profile.spirv ? "spirv" : "glslang"),
                     ReferenceKind{[=, &configuration, &profile](const Suite& suite) {
                       return check_with_glslang(suite, profile,
                                                 calling_shader(file, configuration, profile, stage, callees), stage);
                     }},
                     extent});
  };
  for (const Stage stage : stages_of(profile)) add_glslang(stage);
  if (profile.spirv || !is_for_drivers(file, configuration)) return;
  const Extent extent = extent_on_drivers(file, configuration, profile);
  if (!is_wanted(extent)) return;
  const CompilationKind compilation{&profile, [=, &configuration, &profile] {
                                      return calling_shader(file, configuration, profile, Stage::fragment,
                                                            Callees::few);
                                    }};
  cases.push_back({name_of(file, configuration, Stage::fragment, profile, "driver"), compilation, extent});
}

// The oldest version of ES that glslang makes SPIR-V of.
const Profile& es_to_spirv(const Configuration& configuration) {
  static constexpr Profile kEs310{"es310", "#version 310 es", 310, true, true};
  static constexpr Profile kEs320{"es320", "#version 320 es", 320, true, true};
  return can_compile(configuration, kEs310) ? kEs310 : kEs320;
}

// In ES, a number that is not declared highp has 16 bits on some machines, and nobody notices on the others. So glslang
// compiles the ES shader with a default precision of mediump, and nothing in its SPIR-V may be of relaxed precision.
std::string without_highp(std::span<const std::uint32_t> words) {
  const std::vector<std::string> relaxed = relaxed_precision(words);
  if (relaxed.empty()) return "";
  return fmt::format("{} values are not highp, of these with a name: {}", relaxed.size(), fmt::join(relaxed, " "));
}

// A driver that contracts shows a forgotten `precise` only if the bits happen to differ, and the software drivers of
// most machines never contract. So every operation that rounds must be marked in glslang's SPIR-V. In a few functions
// results are exact, contracted or not.
std::string without_precise(std::span<const std::uint32_t> words) {
  std::vector<std::string> found = contractible(words);
  std::erase_if(found, [](const std::string& name) {
    constexpr std::array<std::string_view, 3> kExact = {"hn_snorm(", "hn_i_angle(", "hn_i_in_units("};
    return std::ranges::any_of(kExact, [&](std::string_view exact) { return name.starts_with(exact); });
  });
  return found.empty() ? "" : fmt::format("not precise: {}", fmt::join(found, " "));
}

// The SPIR-V of all that a file declares, and what faults there are in it.
void add_spirv_case(std::vector<Case>& cases, std::string_view file, const Configuration& configuration,
                    const Profile& profile, std::string_view check, bool chosen,
                    std::string (*faults_in)(std::span<const std::uint32_t>)) {
  const auto judge = [=, &configuration, &profile](const Suite& suite) {
    const auto source = expand(suite.sources, profile, calling_shader(file, configuration, profile, Stage::fragment));
    if (!source) return outcome_with(Status::fail, source.error());
    const auto words = suite.reference.spirv(*source, Stage::fragment);
    if (!words) return outcome_with(Status::fail, words.error());
    const std::string faults = faults_in(*words);
    return faults.empty() ? Outcome{} : outcome_with(Status::fail, {faults, {}});
  };
  cases.push_back({name_of(file, configuration, Stage::fragment, profile, check), ReferenceKind{judge},
                   chosen ? Extent::one_driver : Extent::thorough});
}

// A shader that must be refused: by the library, with an #error that names the right value; or by the compiler, since
// it defines a knob a second time.
struct Refusal {
  std::string_view name;
  std::string_view profile;
  std::string knobs;
  std::string_view expected;  // a word of the message
  std::string after = {};     // behind the include
};

// The last hash of the library that this program was built with is the custom one.
const std::string kHashBeyondTheLast = fmt::format("#define HN_HASH {}\n", HN_HASH_CUSTOM + 1);

const std::string kFixed = "#define HN_ARITHMETIC HN_FIXED\n";
const std::string kOtherHash = "#define HN_HASH HN_HASH_PCG\n";

// Sums over noises of the library and over some of the user's, in one shader.
const std::string kOtherSums = R"(#include "hashnoise.glsl"
#ifdef GL_ES
precision mediump float;
precision mediump int;
#endif
float mine(hn_place1 place, uint seed) { return hn_position(place) - 0.5; }
float mine(hn_place2 place, uint seed) { return hn_position(place).x - float(place.cell.y); }
float mine(hn_place3 place, uint seed) { return hn_position(place).x - float(place.cell.z); }
float mine(hn_place4 place, uint seed) { return hn_position(place).x - float(place.cell.w); }
vec3 mine_d(hn_place2 place, uint seed) { return vec3(mine(place, seed), 1.0, -1.0); }
vec4 mine_d(hn_place3 place, uint seed) { return vec4(mine(place, seed), 1.0, 0.0, -1.0); }
float on_a_line(hn_octaves1 o) {
  hn_octaves1 other = o;
  do hn_add(o, mine(o.place, o.seed)); while (hn_next(o));
  do hn_add_weighted(other, hn_value(other.place, other.seed), 1.0); while (hn_next(other));
  return hn_mean(o) + hn_mean(other);
}
float on_a_plane(hn_octaves2 o) {
  hn_octaves2 size = o;
  hn_octaves2 wave = o;
  do hn_add(o, hn_simplex(o.place, o.seed)); while (hn_next(o));
  do hn_add_turbulence(size, mine(size.place, size.seed)); while (hn_next(size));
  do hn_add_ping_pong(wave, hn_value_cubic(wave.place, wave.seed), 2.0); while (hn_next(wave));
  return hn_mean(o) + hn_mean(size) + hn_mean(wave);
}
float in_space(hn_octaves3 o) {
  hn_octaves3 bent = o;
  do hn_add_ridged(o, hn_value(o.place, o.seed)); while (hn_next(o));
  do hn_add_weighted(bent, hn_cellular(bent.place, bent.seed).x, 1.0); while (hn_next(bent));
  return hn_mean(o) + hn_mean(bent);
}
float in_4d(hn_octaves4 o) {
  hn_octaves4 wave = o;
  do hn_add_ridged(o, hn_simplex(o.place, o.seed)); while (hn_next(o));
  do hn_add_ping_pong(wave, mine(wave.place, wave.seed), 2.0); while (hn_next(wave));
  return hn_mean(o) + hn_mean(wave);
}
float limited(vec2 p) {
  hn_octaves1 line = hn_octaves(p.x, 4.5, 2.0, 0.5, 7u);
  do hn_add_detail(line, mine(line.place, line.seed)); while (hn_next(line));
  hn_octaves2 plane = hn_octaves(p, 0.01, 5, 2.0, 0.5, 7u);
  do hn_add_footprint(plane, hn_value(plane.place, plane.seed)); while (hn_next(plane));
  hn_octaves4 more = hn_octaves(vec4(p, p), 0.01, 5, 2.0, 0.5, 7u);
  do hn_add_footprint(more, mine(more.place, more.seed)); while (hn_next(more));
  return hn_mean(line) + hn_mean(plane) + hn_mean(more);
}
vec3 with_slopes(hn_octaves2 o) {
  hn_octaves2 eroded = o;
  hn_slopes2 s = hn_slopes(o);
  do hn_add(o, s, hn_simplex_d(o.place, o.seed)); while (hn_next(o));
  hn_slopes2 e = hn_slopes(eroded);
  do hn_add_eroded(eroded, e, mine_d(eroded.place, eroded.seed), 1.0); while (hn_next(eroded));
  return hn_mean(o, s) + hn_mean(eroded);
}
vec4 with_slopes(hn_octaves3 o) {
  hn_octaves3 eroded = o;
  hn_slopes3 s = hn_slopes(o);
  do hn_add(o, s, mine_d(o.place, o.seed)); while (hn_next(o));
  hn_slopes3 e = hn_slopes(eroded);
  do hn_add_eroded(eroded, e, hn_value_d(eroded.place, eroded.seed), 1.0); while (hn_next(eroded));
  return hn_mean(o, s) + hn_mean(eroded);
}
vec2 shifted(hn_octaves2 o) {
  hn_octaves2 moving = o;
  hn_shifts2 s = hn_shifts(o, 1.0);
  do hn_add(o, s, vec2(hn_simplex(o.place, o.seed), mine(o.place, o.seed))); while (hn_next(o));
  hn_shifts2 m = hn_shifts(moving, 1.0);
  do hn_add_progressive(moving, m, hn_curl(moving.place, moving.seed)); while (hn_next(moving));
  return hn_mean(o, s) + hn_mean(moving, m);
}
vec2 flowing(hn_octaves2 o) {
  hn_flows2 s = hn_flows(o);
  do hn_add(o, s, vec2(mine(o.place, o.seed))); while (hn_next(o));
  return hn_mean(o, s);
}
vec3 flowing(hn_octaves3 o) {
  hn_flows3 s = hn_flows(o);
  do hn_add(o, s, hn_curl(o.place, 0.25, o.seed)); while (hn_next(o));
  return hn_mean(o, s);
}
vec3 shifted(hn_octaves3 o) {
  hn_octaves3 moving = o;
  hn_shifts3 s = hn_shifts(o, 1.0);
  do hn_add(o, s, vec3(mine(o.place, o.seed))); while (hn_next(o));
  hn_shifts3 m = hn_shifts(moving, 1.0);
  do hn_add_progressive(moving, m, hn_curl(moving.place, moving.seed)); while (hn_next(moving));
  return hn_mean(o, s) + hn_mean(moving, m);
}
float all_of_them(vec2 p) {
  hn_place2 place = hn_place(ivec2(p), p - floor(p));
  vec3 p3 = vec3(p, 0.5);
  vec4 p4 = vec4(p, p);
  float sum = on_a_line(hn_octaves(p.x, 5, 2.0, 0.5, 7u)) + on_a_line(hn_octaves(hn_tile(p.x, 4), 5, 2.0, 0.5, 7u));
  sum += on_a_plane(hn_octaves(p, 5, 2.0, 0.5, 7u)) + on_a_plane(hn_octaves(place, 5, 2.0, 0.5, 7u));
  sum += on_a_plane(hn_octaves(hn_tile(place, ivec2(4)), 5, 2.0, 0.5, 7u));
  sum += in_space(hn_octaves(p3, 5, 2.0, 0.5, 7u)) + in_space(hn_octaves(hn_tile(p3, ivec3(4)), 5, 2.0, 0.5, 7u));
  sum += in_4d(hn_octaves(p4, 5, 2.0, 0.5, 7u)) + in_4d(hn_octaves(hn_tile(p4, ivec4(4)), 5, 2.0, 0.5, 7u));
  vec3 slopes = with_slopes(hn_octaves(p, 5, 2.0, 0.5, 7u)) + with_slopes(hn_octaves(place, 5, 2.0, 0.5, 7u));
  vec4 more = with_slopes(hn_octaves(p3, 5, 2.0, 0.5, 7u));
  vec2 shift = shifted(hn_octaves(p, 5, 2.0, 0.5, 7u)) + shifted(hn_octaves(place, 5, 2.0, 0.5, 7u));
  vec3 further = shifted(hn_octaves(p3, 5, 2.0, 0.5, 7u)) + flowing(hn_octaves(p3, 5, 2.0, 0.5, 7u));
  shift += flowing(hn_octaves(p, 5, 2.0, 0.5, 7u)) + flowing(hn_octaves(hn_tile(place, ivec2(4)), 5, 2.0, 0.5, 7u));
  return sum + limited(p) + slopes.x + slopes.y + more.x + more.w + shift.x + shift.y + further.x + further.z;
}
)";

const Refusal kRefusals[] = {
    {"version_120", "gl120", "", "GLSL 1.30"},
    {"version_es100", "es100", "", "GLSL ES 3.00"},
    {"hash_0", "gl330", "#define HN_HASH 0\n", "HN_HASH_PARTIAL_JENKINS"},
    {"hash_beyond_the_last", "gl330", kHashBeyondTheLast, "HN_HASH_PARTIAL_JENKINS"},
    {"hash_beyond_the_last", "es300", kHashBeyondTheLast, "HN_HASH_PARTIAL_JENKINS"},
    {"hash_misspelt", "gl330", "#define HN_HASH HN_HASH_FNV\n", "HN_HASH_PARTIAL_JENKINS"},
    // In ES an undefined name in #if is an error of its own, which names it.
    {"hash_misspelt", "es300", "#define HN_HASH HN_HASH_FNV\n", "HN_HASH"},
    {"gradient_3", "gl330", "#define HN_GRADIENT 3\n", "HN_GRADIENT_SINE"},
    {"gradient_misspelt", "gl330", "#define HN_GRADIENT HN_GRADIENT_SIN\n", "HN_GRADIENT_SINE"},
    {"arithmetic_0", "gl330", "#define HN_ARITHMETIC 0\n", "HN_FIXED"},
    {"arithmetic_4", "gl330", "#define HN_ARITHMETIC 4\n", "HN_FIXED"},
    {"arithmetic_4", "es300", "#define HN_ARITHMETIC 4\n", "HN_FIXED"},
    {"arithmetic_misspelt", "gl330", "#define HN_ARITHMETIC HN_FIX\n", "HN_FIXED"},
    {"precise_too_early", "gl330", "#define HN_ARITHMETIC HN_PRECISE\n", "GLSL 4.00"},
    {"precise_too_early", "es300", "#define HN_ARITHMETIC HN_PRECISE\n", "GLSL ES 3.20"},
    {"precise_too_early", "es310", "#define HN_ARITHMETIC HN_PRECISE\n", "GLSL ES 3.20"},
    {"custom_without_function", "gl330", "#define HN_HASH HN_HASH_CUSTOM\n", "HN_HASH_FN"},
    // Behind the include they would change nothing.
    {"hash_after_the_include", "gl330", "", "HN_HASH", kOtherHash},
};

// A shader that the library must accept.
struct Acceptance {
  std::string_view name;
  std::string knobs;        // before the include
  std::string after = {};   // behind it
  bool everywhere = false;  // in every version, since it is GLSL of its own kind
  std::string_view file() const { return everywhere ? "hashnoise.glsl" : "config.glsl"; }
};

std::vector<Acceptance> acceptances() {
  return {
      {"other_sums", "", kOtherSums, true},
      {"fixed_other_sums", kFixed, kOtherSums, true},
      // It has to be that of the library that this program was built with.
      {"version", "",
       fmt::format("#if HN_VERSION_MAJOR != {} || HN_VERSION_MINOR != {} || HN_VERSION_PATCH != {}\n"
                   "#error this is another version\n#endif\n",
                   HN_VERSION_MAJOR, HN_VERSION_MINOR, HN_VERSION_PATCH)},
      // An undefined name in #if is an error by the letter, and 0 in most compilers.
      {"macros", "",
       "#if !defined(HN_VERSION_MAJOR) || !defined(HN_VERSION_MINOR) || !defined(HN_VERSION_PATCH)\n#error version\n"
       "#endif\n#if !defined(HN_I_BITCAST) || !defined(HN_HASH) || !defined(HN_GRADIENT)\n"
       "#error knobs\n#endif\n#if !defined(HN_ARITHMETIC)\n#error knobs\n#endif\n"},
  };
}

void add_acceptance_cases(std::vector<Case>& cases, const Acceptance& acceptance) {
  constexpr std::array<std::string_view, 3> kSome = {"gl140", "gl330", "es300"};  // without and with bit casts, and ES
  for (const Profile& profile : all_profiles()) {
    const bool some = std::ranges::find(kSome, profile.name) != kSome.end();
    if (!some && !acceptance.everywhere) continue;
    // The sums are long: integers in ES, and floats where there are no bit casts.
    const bool fixed = acceptance.knobs == kFixed;
    const bool chosen = acceptance.everywhere ? profile.name == (fixed ? "es300" : "gl140") : some;
    const std::string fragment =
        fmt::format("{}#include \"{}\"\n{}void main() {{}}\n", acceptance.knobs, acceptance.file(), acceptance.after);
    const CompilationKind compilation{&profile, [fragment] { return fragment; }};
    cases.push_back({name_of_setting(acceptance.name, profile.name, "glslang"), ReferenceKind{[=](const Suite& suite) {
                       return check_with_glslang(suite, *compilation.profile, compilation.fragment(), Stage::fragment);
                     }},
                     chosen ? Extent::one_driver : Extent::thorough});
    if (profile.spirv) continue;
    cases.push_back({name_of_setting(acceptance.name, profile.name, "driver"), compilation,
                     chosen ? Extent::one_driver : Extent::thorough});
  }
}

Outcome expect_refusal(const CompilationKind& compilation, const Result<void>& compiled) {
  const std::string_view expected = compilation.refusal;
  if (compiled) {
    return outcome_with(Status::fail, {fmt::format("it compiles, but an error should name {}", expected), {}});
  }
  if (compiled.error().log.find(expected) != std::string::npos) return {};
  return outcome_with(Status::fail,
                      {fmt::format("the shader is refused, but no message names {}", expected), compiled.error().log});
}

void add_refusal_cases(std::vector<Case>& cases, const Refusal& refusal) {
  const std::string fragment = fmt::format("{}#include \"{}\"\n{}void main() {{}}\n", refusal.knobs,
                                           refusal.after.empty() ? "config.glsl" : "hashnoise.glsl", refusal.after);
  const CompilationKind compilation{&profile_named(refusal.profile), [fragment] { return fragment; }, refusal.expected,
                                    refusal.name.starts_with("version") || refusal.profile == "es310"};
  cases.push_back(
      {name_of_setting(refusal.name, refusal.profile, "refused_by_glslang"), ReferenceKind{[=](const Suite& suite) {
         const auto text = expand(suite.sources, *compilation.profile, compilation.fragment());
         if (!text) return outcome_with(Status::error, text.error());
         return expect_refusal(compilation, suite.reference.check(*text, *compilation.profile, Stage::fragment));
       }}});
  cases.push_back(
      {name_of_setting(refusal.name, refusal.profile, "refused_by_driver"), compilation, Extent::one_driver});
}

Outcome check_compiles(Session& session, const CompilationKind& compilation) {
  const Profile& profile = *compilation.profile;
  if (const auto reason = unsupported_reason(profile, session.info().languages); !reason.empty()) {
    return outcome_with(Status::unsupported, {reason, {}});
  }
  const auto vertex = expand(session.sources, profile, vertex_shader());
  const auto fragment = expand(session.sources, profile, compilation.fragment());
  if (!vertex) return outcome_with(Status::error, vertex.error());
  if (!fragment) return outcome_with(Status::fail, fragment.error());
  const auto program = Program::build(*session.evaluator->context(), *vertex, *fragment);
  return program ? Outcome{} : outcome_with(Status::fail, program.error());
}

Outcome check_refused(Session& session, const CompilationKind& compilation) {
  const auto text = expand(session.sources, *compilation.profile, compilation.fragment());
  if (!text) return outcome_with(Status::error, text.error());
  const auto compiled = compile_only(*session.evaluator->context(), *text, Stage::fragment);
  auto outcome = expect_refusal(compilation, compiled);
  const bool refused_unread = !compiled && outcome.status == Status::fail && compilation.too_old;
  if (refused_unread) outcome.status = Status::unsupported;
  return outcome;
}

}  // namespace

Outcome check_compilation(Session& session, const CompilationKind& compilation) {
  if (!session.evaluator->context()) {
    return outcome_with(Status::unsupported, {"this driver has no compiler of GLSL", {}});
  }
  return compilation.refusal.empty() ? check_compiles(session, compilation) : check_refused(session, compilation);
}

void add_compile_cases(std::vector<Case>& cases, Scope scope) {
  std::vector<Case> all;
  for (const auto& [file, text] : kLibraryFiles) {
    if (!file.ends_with(".glsl")) continue;  // needed by other languages besides
    for (const Configuration& configuration : all_configurations()) {
      if (!selects_code(file, configuration)) continue;
      for (const Profile& profile : all_profiles()) {
        if (can_compile(configuration, profile)) add_file_cases(all, file, configuration, profile, scope);
      }
      const bool precise = configuration.arithmetic == Arithmetic::precise;
      const bool usual = configuration.default_but_for_arithmetic();
      // HN_PRECISE is declared like HN_FAST, and has a case of its own.
      add_spirv_case(all, file, configuration, es_to_spirv(configuration), "highp", usual && !precise, without_highp);
      if (!precise) continue;
      add_spirv_case(all, file, configuration, profile_named("vulkan"), "uncontracted", usual, without_precise);
    }
  }
  for (const Acceptance& acceptance : acceptances()) add_acceptance_cases(all, acceptance);
  for (const Refusal& refusal : kRefusals) add_refusal_cases(all, refusal);
  const auto is_wanted = [&](const Case& test) { return scope == Scope::thorough || test.extent != Extent::thorough; };
  std::ranges::copy_if(all, std::back_inserter(cases), is_wanted);
}

}  // namespace hn
