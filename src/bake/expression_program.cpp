#include "bake/expression_program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "bake/compile_errors.hpp"
#include "bake/glsl_text.hpp"
#include "base/process.hpp"
#include "base/strings.hpp"
#include "base/text.hpp"

namespace hn {
namespace {

// The names of the texts in #line; the user's own names may have any characters.
constexpr std::string_view kExpressionName = "hn-bake-expression";
constexpr std::string_view kSourceName = "hn-bake-source";

// In one dimension to four.
struct Types {
  std::string_view position;
  std::string_view place;
  std::string_view cell;
};
constexpr Types kTypes[] = {{"float", "hn_place1", "int"},
                            {"vec2", "hn_place2", "ivec2"},
                            {"vec3", "hn_place3", "ivec3"},
                            {"vec4", "hn_place4", "ivec4"}};

struct Texts {
  CppText expression;
  std::optional<CppText> source;
};

Result<Texts> texts_of(const Expression& expression) {
  Texts texts;
  HN_TRY(texts.expression, cpp_of_expression({"--expression", expression.text}));
  if (expression.source.empty()) return texts;
  HN_TRY(texts.source,
         cpp_of_functions({fmt::format("--source {}", expression.source.string()), expression.source_text}));
  return texts;
}

// The period as the expression has it: an int, or a vector of them.
std::string period_of(const BakeOptions& options) {
  const auto end = options.settings.period.begin() + static_cast<std::ptrdiff_t>(options.size.size());
  return fmt::format("{}({})", kTypes[options.size.size() - 1].cell,
                     fmt::join(options.settings.period.begin(), end, ", "));
}

bool has_period(const BakeOptions& options) {
  return std::ranges::any_of(options.settings.period, [](int period) { return period != 0; });
}

// The user's texts have a namespace of their own inside of the library's, so that they may have functions by the names
// of built-in ones. The names of the library end in it, too: `hashnoise` stands there for all.
std::string cpp_of(const BakeOptions& options, const Texts& texts) {
  constexpr std::string_view kArithmetics[] = {"HN_FAST", "HN_PRECISE", "HN_FIXED"};
  const auto& [position, place, cell] = kTypes[options.size.size() - 1];
  std::string text = fmt::format(
      "#define HN_ARITHMETIC {}\n"
      "#include \"runner.hpp\"\n"
      "namespace hashnoise::of_the_user {{\n",
      kArithmetics[static_cast<std::size_t>(options.settings.arithmetic) - 1]);
  if (texts.source) text += fmt::format("#line 1 \"{}\"\n{}\n", kSourceName, texts.source->text);
  text += fmt::format(
      "inline auto expression({} p, {} place, {} period, uint seed) {{\n"
      "return (\n"
      "#line 1 \"{}\"\n{}\n);\n"
      "#line 1 \"hn-bake\"\n"
      "}}\n"
      "}}\n",
      position, place, cell, kExpressionName, texts.expression.text);
  const std::string exact = has_period(options) ? "hn_tile(hn_place(cell, f), period)" : "hn_place(cell, f)";
  text += fmt::format(
      "int main(int count, char** words) {{\n"
      "  using namespace hashnoise;\n"
      "  const int size[] = {{{}}};\n"
      "  return hn_bake::run<{}>(count, words, size, []({} cell, {} f, {} p) {{\n"
      "    const {} period = {};\n"
      "    return of_the_user::expression(p, {}, period, {}u);\n"
      "  }});\n"
      "}}\n",
      fmt::join(options.size, ", "), options.size.size(), cell, position, position, cell, period_of(options), exact,
      options.settings.seed);
  return text;
}

// $CXX may have arguments, as in "ccache g++".
std::vector<std::string> compiler() {
  const char* const named = std::getenv("CXX");
  std::vector<std::string> words;
  for (const std::string_view word : split(named ? named : "", ' ')) {
    if (!word.empty()) words.emplace_back(word);
  }
  return words.empty() ? std::vector<std::string>{"c++"} : words;
}

// The compiler's temporary files stay in the folder, and its messages are English.
std::vector<std::string> environment_in(const std::filesystem::path& folder) {
  std::vector<std::string> variables = environment_without(std::vector<std::string_view>{"TMPDIR=", "LC_", "LANG"});
  variables.push_back(fmt::format("TMPDIR={}", folder.string()));
  variables.push_back("LC_ALL=C");
  return variables;
}

ProcessOptions compilation(const std::filesystem::path& folder, const std::filesystem::path& program) {
  std::vector<std::string> words = compiler();
  ProcessOptions options;
  options.program = words.front();
  options.arguments.assign(words.begin() + 1, words.end());
  // Every float is rounded on its own, and whole numbers wrap as in GLSL, so that all machines agree. A loop without an
  // end is one, and not left out. In GLSL a float is no int.
  for (const char* const flag : {"-std=c++20", "-O2", "-pipe", "-ffp-contract=off", "-fwrapv", "-fno-math-errno",
                                 "-fno-finite-loops", "-Wfloat-conversion", "-Werror=float-conversion",
                                 "-Werror=return-type", "-I" HN_BAKE_RUNNER, "-isystem" HN_BAKE_INCLUDE}) {
    options.arguments.emplace_back(flag);
  }
  options.arguments.push_back((folder / "expression.cpp").string());
  options.arguments.emplace_back("-o");
  options.arguments.push_back(program.string());
  options.environment = environment_in(folder);
  options.output = folder / "compiler.log";
  return options;
}

tl::unexpected<Refusal> wrong(const std::string& message) { return tl::unexpected(Refusal{kBadUsage, message}); }
tl::unexpected<Refusal> not_built(const std::string& message) { return tl::unexpected(Refusal{kNotBuilt, message}); }

tl::unexpected<Refusal> explain(const Error& error, const Texts& texts) {
  if (error.message.starts_with("cannot start")) {
    return not_built(
        fmt::format("--expression needs a compiler of C++20, and {}; install g++ or clang, or name one in "
                    "the variable CXX",
                    error.message));
  }
  const auto of_the_user = first_error(error.log, {kExpressionName, &texts.expression},
                                       {kSourceName, texts.source ? &*texts.source : nullptr});
  if (of_the_user) return wrong(*of_the_user);
  return not_built(
      fmt::format("--expression could not be compiled: {}\n{}", error.message, shortened(printable(error.log), 2000)));
}

}  // namespace

std::filesystem::path ExpressionProgram::path() const { return folder_.path() / "expression"; }

tl::expected<ExpressionProgram, Refusal> ExpressionProgram::make(const BakeOptions& options) {
  const auto texts = texts_of(*options.expression);
  if (!texts) return wrong(texts.error().text());
  if (!std::filesystem::exists(HN_BAKE_INCLUDE "/hashnoise/hashnoise.hpp")) {
    return not_built("--expression needs the library's text, and there is no " HN_BAKE_INCLUDE
                     "/hashnoise/hashnoise.hpp any more; build hn-bake where that is now");
  }
  ExpressionProgram program;
  program.folder_.write("expression.cpp", cpp_of(options, *texts));
  if (const auto made = run_process(compilation(program.folder_.path(), program.path())); !made) {
    return explain(made.error(), *texts);
  }
  const auto count = output_of(program.path().string(), {});
  if (!count) return not_built(fmt::format("the program of --expression does not run here: {}", count.error().text()));
  const int components = std::atoi(count->c_str());
  for (int i = 0; i < components; ++i)
    program.components_.emplace_back(components == 1 ? "value" : std::string(1, "xyzw"[i]));
  return program;
}

}  // namespace hn
