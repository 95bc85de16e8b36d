// The overloads without a seed: that they are those with the seed 0.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>

#include "cases/value_checks.hpp"
#include "expected/points.hpp"
#include "expected/tolerance.hpp"
#include "expected/twin.hpp"

namespace hn {

// Checks one function, by the twin.
Judged check_unseeded(Session& session, const Evaluation& evaluation) {
  const Function& function = evaluation.function;
  Words inputs = random_points(function, property_points(session, function), Random(session.seed, "unseeded"));
  const auto seed = static_cast<std::size_t>(function.seed_word());
  for (std::size_t i = seed; i < inputs.size(); i += kInputWords) inputs[i] = 0;
  HN_TRY(const auto outputs,
         evaluate(session, {function, evaluation.configuration, evaluation.profile, {.seeded = false}}, inputs));
  const Words expected = evaluate_twin(function, evaluation.configuration, inputs);
  Comparison comparison(function, inputs);
  for (std::size_t i = 0; i < inputs.size() / kInputWords; ++i) {
    const auto in = point(inputs, i);
    std::array<double, kOutputWords> allowed{};
    for (std::size_t word = 0; word < function.outputs.size(); ++word) {
      allowed[word] = allowed_to_twin(function, evaluation.configuration, in, word);
    }
    compare_with_twin(comparison, evaluation, in, result(outputs, i), result(expected, i), allowed);
  }
  return comparison.finish();
}

namespace {

constexpr std::size_t kPointsOfEach = 16;

// The functions of a file that have such an overload. A form that takes all words of a point has none left to name
// the function that it is for.
std::vector<const Function*> unseeded_in(std::string_view file, const Configuration& configuration) {
  std::vector<const Function*> functions;
  for (const Function& function : all_functions()) {
    const bool fits = function.inputs.size() < kInputWords && has_same_bits(function, configuration);
    if (function.file == file && function.has_unseeded && covers(configuration, function) && fits) {
      functions.push_back(&function);
    }
  }
  return functions;
}

// Both overloads of each, and what differs between them: words that are all 0, which a compiler may see by itself, so
// that this costs a fraction of the programs of its functions.
std::string both_overloads(std::string_view file, std::span<const Function* const> functions) {
  std::string text = fmt::format("#include \"{}\"\n", file);
  for (const auto& [prefix, seeding] : {std::pair{"seeded", ", 0u"}, std::pair{"unseeded", ""}}) {
    text += fmt::format("#define SEEDED(s) {}\n#define SEED(s) 0u\n", seeding);
    for (std::size_t i = 0; i < functions.size(); ++i) {
      text += declared_evaluate(*functions[i], fmt::format("{}{}", prefix, i));
    }
    text += "#undef SEEDED\n#undef SEED\n";
  }
  return text;
}

// A fractal of two octaves: the second has a lacunarity and a gain. A compiler cannot see through a loop of unknown
// length.
std::string two_octaves(const Function& function) {
  const int word = function.input("octaves");
  return word < 0 ? "" : fmt::format("{}.{} = 2u; ", "abcd"[word / 4], "xyzw"[word % 4]);
}

std::string difference_of_both(std::span<const Function* const> functions) {
  std::string text = "hn_uvec4 r = uvec4(0u, 0u, 0u, 0u);\n";
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const auto argument = [](std::size_t parameter) { return std::string(1, static_cast<char>('a' + parameter)); };
    const std::string arguments = arguments_of(*functions[i], argument);
    text += fmt::format("if (d.w == {0}u) {{ {1}r = seeded{0}({2}) ^ unseeded{0}({2}); }}\n", i,
                        two_octaves(*functions[i]), arguments);
  }
  return text + "return r;";
}

// The functions of a file, as if they were one more row of the table.
struct Differences {
  std::string id;
  std::string knobs;
  std::string body;
  std::vector<const Function*> functions;
  Function function;
};

const Differences& differences_in(std::string_view file, const Configuration& configuration) {
  static std::map<std::pair<std::string_view, std::string_view>, Differences> known;
  const auto key = std::pair(file, configuration.name);
  if (const auto found = known.find(key); found != known.end()) return found->second;
  Differences& made = known[key];
  made.functions = unseeded_in(file, configuration);
  made.id = fmt::format("{}.all", file.substr(0, file.find('.')));
  made.knobs = both_overloads(file, made.functions);
  made.body = difference_of_both(made.functions);
  made.function = {.id = made.id,
                   .file = file,
                   .call = {},
                   .body = made.body,
                   .inputs = std::vector<Column>(kInputWords, {"word", WordType::u32}),
                   .outputs = std::vector<Column>(kOutputWords, {"difference", WordType::u32}),
                   .plain = {}};
  return made;
}

Judged check_unseeded_of_file(Session& session, const Evaluation& evaluation) {
  const Differences& both = differences_in(evaluation.function.file, evaluation.configuration);
  Words inputs;
  for (std::size_t i = 0; i < both.functions.size(); ++i) {
    Words points = random_points(*both.functions[i], kPointsOfEach, Random(session.seed, "unseeded"));
    for (std::size_t word = kInputWords - 1; word < points.size(); word += kInputWords) {
      points[word] = static_cast<std::uint32_t>(i);
    }
    inputs.insert(inputs.end(), points.begin(), points.end());
  }
  Evaluation way{evaluation};
  way.variant.knobs = both.knobs;
  HN_TRY(const auto outputs, evaluate(session, way, inputs));
  Comparison comparison(evaluation.function, inputs);
  for (std::size_t i = 0; i < inputs.size() / kInputWords; ++i) {
    for (std::size_t word = 0; word < kOutputWords; ++word) {
      comparison.bits(point(inputs, i), result(outputs, i)[word], 0, word);
    }
  }
  return comparison.finish();
}

}  // namespace

// With HN_PRECISE every bit counts, and it compiles faster than HN_FIXED.
std::vector<Case> unseeded_cases() {
  std::vector<Case> cases;
  std::vector<std::string_view> files;
  for (const Function& function : all_functions()) {
    // A case of the whole library calls functions of other files.
    const bool known = function.file == "hashnoise.glsl" || std::ranges::find(files, function.file) != files.end();
    if (!known) files.push_back(function.file);
  }
  for (const std::string_view file : files) {
    for (const std::string_view setting : {"lattice+precise", "lattice"}) {
      const Configuration& configuration = configuration_named(setting);
      if (unseeded_in(file, configuration).empty()) continue;
      const Evaluation evaluation{differences_in(file, configuration).function,
                                  configuration,
                                  main_profile(configuration, false),
                                  {},
                                  Stage::vertex};
      CaseName name = name_of(evaluation, "unseeded");
      name.configuration = configuration.name_without_arithmetic();
      name.arithmetic = arithmetic_name(*unseeded_in(file, configuration).front(), configuration);
      cases.push_back({std::move(name), CheckKind{evaluation, check_unseeded_of_file}, Extent::one_driver});
      break;
    }
  }
  return cases;
}

}  // namespace hn
