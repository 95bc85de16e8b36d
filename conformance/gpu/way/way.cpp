#include "gpu/way/way.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "base/process.hpp"
#include "base/text.hpp"

namespace hn {
namespace {

struct FormRow {
  std::string_view name;
  std::string_view ending;
};
// By Form.
constexpr std::array<FormRow, 10> kForms = {{{"glsl", ".comp.glsl"},
                                             {"gl", ".comp"},
                                             {"glsl-es", ".comp"},
                                             {"spirv", ".spv"},
                                             {"hlsl", ".hlsl"},
                                             {"slang", ".slang"},
                                             {"dxbc", ".dxbc"},
                                             {"dxil", ".dxil"},
                                             {"msl", ".metal"},
                                             {"wgsl", ".wgsl"}}};

struct Conversion {
  Form takes;
  Form gives;
  std::string_view arguments;
};

// The first number with a dot in the output of a program, or all of its first line.
enum class Printed { number, line };

struct Translator {
  std::string_view name;
  std::string_view program;
  std::string_view version;  // the option that prints it
  std::vector<Conversion> conversions;
  Printed printed = Printed::number;
  std::string_view least_for_hlsl = "";  // older ones read only parts of it
  bool repeats_decorations = false;
};

const std::vector<Translator>& translators() {
  using enum Form;
  static const std::vector<Translator> kTranslators = {
      {"spirv-opt", "spirv-opt", "--version", {{spirv, spirv, "-O {in} -o {out}"}}},
      {"spirv-cross",
       "spirv-cross",
       "--revision",
       {{spirv, glsl_es, "--version 310 --es {in} --output {out}"},
        {spirv, gl, "--version 430 --no-es {in} --output {out}"},
        {spirv, glsl, "--version 450 --vulkan-semantics {in} --output {out}"},
        {spirv, hlsl, "--hlsl --shader-model 50 --hlsl-force-storage-buffer-as-uav {in} --output {out}"},
        {spirv, msl, "--msl {in} --output {out}"}}},
      // It knows forms by the endings of files.
      {"naga",
       "naga",
       "--version",
       {{wgsl, spirv, "{in} {out}"},
        {wgsl, glsl_es, "--entry-point main --profile es310 {in} {out}"},
        {wgsl, gl, "--entry-point main --profile core430 {in} {out}"},
        {wgsl, hlsl, "{in} {out}"},
        {wgsl, msl, "{in} {out}"},
        {spirv, wgsl, "{in} {out}"},
        {spirv, spirv, "{in} {out}"},
        {spirv, glsl_es, "--entry-point main --profile es310 {in} {out}"},
        {spirv, gl, "--entry-point main --profile core430 {in} {out}"},
        {spirv, hlsl, "{in} {out}"},
        {spirv, msl, "{in} {out}"},
        {glsl, spirv, "{in} {out}"},
        {glsl, wgsl, "{in} {out}"},
        {glsl, hlsl, "{in} {out}"},
        {glsl, msl, "{in} {out}"}}},
      {"slang",
       "slangc",
       "-v",
       {{slang, spirv, "{in} -entry main -stage compute -fvk-u-shift 0 0 -emit-spirv-directly -target spirv -o {out}"},
        {slang, hlsl, "{in} -entry main -stage compute -target hlsl -o {out}"},
        {slang, glsl, "{in} -entry main -stage compute -fvk-u-shift 0 0 -target glsl -o {out}"},
        {slang, msl, "{in} -entry main -stage compute -target metal -o {out}"},
        {slang, wgsl, "{in} -entry main -stage compute -target wgsl -o {out}"},
        {hlsl, spirv, "{in} -entry main -stage compute -fvk-u-shift 0 0 -emit-spirv-directly -target spirv -o {out}"}}},
      // -Gis: IEEE's rules where the text has `precise`.
      {"dxc",
       "dxc",
       "--version",
       {{hlsl, spirv, "-spirv -fspv-target-env=vulkan1.1 -Gis -T cs_6_0 -E main -Fo {out} {in}"},
        {hlsl, dxil, "-Gis -T cs_6_0 -E main -Fo {out} {in}"}},
       Printed::line},
      {"fxc", "fxc", "--version", {{hlsl, dxbc, "-T cs_5_0 -E main -Fo {out} {in}"}}},
      // By way of what Direct3D takes. All of its buffers are storage buffers.
      {"vkd3d",
       "vkd3d-compiler",
       "--version",
       {{hlsl, dxbc, "-x hlsl -b dxbc-tpf -p cs_5_0 -e main -o {out} {in}"},
        {dxbc, spirv, "-x dxbc-tpf -b spirv-binary --buffer-uav=storage-buffer -o {out} {in}"},
        {dxil, spirv, "-x dxbc-dxil -b spirv-binary --buffer-uav=storage-buffer -o {out} {in}"}},
       Printed::number,
       "1.10",
       true},  // the type of all buffers has one for each
      {"glslang",
       "glslangValidator",
       "--version",
       {{glsl, spirv, "-V -S comp {in} -o {out}"}, {hlsl, spirv, "-V -D -S comp -e main {in} -o {out}"}}},
      {"glslc",
       "glslc",
       "--version",
       {{glsl, spirv, "-O -x glsl -fshader-stage=compute {in} -o {out}"},
        {hlsl, spirv, "-O -x hlsl -fshader-stage=compute -fentry-point=main {in} -o {out}"}}},
      {"tint",
       "tint",
       "--version",
       {{wgsl, spirv, "--format spirv {in} -o {out}"},
        {wgsl, glsl_es, "--format glsl {in} -o {out}"},
        {wgsl, hlsl, "--format hlsl {in} -o {out}"},
        {wgsl, msl, "--format msl {in} -o {out}"},
        {spirv, wgsl, "--format wgsl {in} -o {out}"}}},
  };
  return kTranslators;
}

const Translator* translator_named(std::string_view name) {
  const auto found = std::ranges::find_if(
      translators(), [&](const Translator& one) { return one.name == name || one.program == name; });
  return found == translators().end() ? nullptr : &*found;
}

// "2023.1" of "SPIRV-Tools v2023.1 unknown hash"; empty if there is no such number.
std::string version_number(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789";
  for (auto at = text.find_first_of(kDigits); at != text.npos; at = text.find_first_of(kDigits, at)) {
    const auto end = std::min(text.find_first_not_of("0123456789.", at), text.size());
    const std::string_view number = text.substr(at, end - at);
    if (const auto dot = number.find('.'); dot != number.npos && dot + 1 < number.size()) return std::string(number);
    at = end;
  }
  return "";
}

// The program that is named, or in the variable HN_SPIRV_OPT, or the usual one.
std::string program_of(const Translator& translator, const std::string& named) {
  if (!named.empty()) return named;
  std::string variable = "HN_" + in_upper_case(translator.program);
  std::ranges::replace(variable, '-', '_');
  const char* const set = std::getenv(variable.c_str());
  return set ? set : std::string(translator.program);
}

// A program is started for it once: a way to each driver is looked for, and may have the program twice.
const Result<std::string>& printed_version(const std::string& program, std::string_view option) {
  static std::map<std::pair<std::string, std::string_view>, Result<std::string>> known;
  const auto found = known.find({program, option});
  if (found != known.end()) return found->second;
  return known.emplace(std::pair{program, option}, output_of(program, {std::string(option)})).first->second;
}

Result<std::string> version_of(const Translator& translator, const std::string& program) {
  const auto& text = printed_version(program, translator.version);
  if (!text) return fail(fmt::format("{} cannot be run: {}", program, text.error().message));
  if (translator.printed == Printed::line) return text->substr(0, text->find('\n'));
  const std::string number = version_number(*text);
  if (!number.empty() || program != translator.program || text->find("Debian package") == text->npos) return number;
  // Debian's spirv-cross prints no version, and its package has the name of the program.
  return output_of("dpkg-query", {"-W", "-f=${Version}", program}).value_or("");
}

bool is_at_least(const std::string& version, std::string_view least) {
  const auto numbers = [](const std::string& text) {
    std::array<int, 2> found = {};
    return std::sscanf(text.c_str(), "%d.%d", &found[0], &found[1]) == 2 ? found : std::array{0, 0};
  };
  return numbers(version) >= numbers(std::string(least));
}

// A step that an option names, with all conversions that its translator may take.
struct Choice {
  Step step;  // without its forms
  std::vector<Conversion> conversions;
  std::string_view least_for_hlsl = "";
};

std::vector<std::string_view> names_of(const std::vector<Form>& forms) {
  std::vector<std::string_view> names;
  for (const Form form : forms) {
    if (std::ranges::find(names, name_of(form)) == names.end()) names.push_back(name_of(form));
  }
  return names;
}

std::vector<std::string_view> names_of(const Choice& choice, Form Conversion::*side) {
  std::vector<Form> forms;
  for (const Conversion& conversion : choice.conversions) forms.push_back(conversion.*side);
  return names_of(forms);
}

Result<Form> form_of(std::string_view name) {
  if (const auto form = form_named(name)) return *form;
  std::vector<std::string_view> all;
  for (const FormRow& row : kForms) all.push_back(row.name);
  return fail(fmt::format("there is no form {}; there are {}", in_quotes(name), fmt::join(all, ", ")));
}

Result<Choice> known(std::string_view spec) {
  const auto equals = spec.find('=');
  const std::vector<std::string_view> parts = split(spec.substr(0, equals), ':');
  const Translator* const translator = translator_named(parts.front());
  if (!translator) {
    std::vector<std::string_view> names;
    for (const Translator& one : translators()) names.push_back(one.name);
    return fail(fmt::format("there is no translator {}; there are {}, and any command with {{in}} and {{out}}",
                            in_quotes(parts.front()), fmt::join(names, ", ")));
  }
  if (parts.size() > 3) return fail(fmt::format("{} names more than two forms", in_quotes(spec)));
  const std::string program = program_of(*translator, std::string(equals == spec.npos ? "" : spec.substr(equals + 1)));
  Choice choice{{.name = std::string(translator->name),
                 .command = {program},
                 .takes = {},
                 .gives = {},
                 .version = {},
                 .spec = {},
                 .repeats_decorations = translator->repeats_decorations},
                translator->conversions,
                translator->least_for_hlsl};
  for (std::size_t i = 1; i < parts.size(); ++i) {
    HN_TRY(const Form form, form_of(parts[i]));
    const auto side = i + 1 == parts.size() ? &Conversion::gives : &Conversion::takes;
    const auto names = names_of(choice, side);
    std::erase_if(choice.conversions, [&](const Conversion& one) { return one.*side != form; });
    if (!choice.conversions.empty()) continue;
    return fail(fmt::format("{} {} no {}, but {}", translator->name, side == &Conversion::gives ? "gives" : "takes",
                            name_of(form), fmt::join(names, ", ")));
  }
  HN_TRY(choice.step.version, version_of(*translator, program));
  return choice;
}

// A command of the user's, which a shell runs.
Result<Choice> command(const std::string& text, const WayOptions& options, std::size_t number) {
  for (const std::string_view place : {"{in}", "{out}"}) {
    if (text.find(place) == text.npos) return fail(fmt::format("the command {} has no {}", in_quotes(text), place));
  }
  if (options.takes.size() <= number || options.gives.size() <= number) {
    return fail(fmt::format("the command {} needs a form that it takes (--takes) and one that it gives (--gives)",
                            in_quotes(text)));
  }
  HN_TRY(const Form takes, form_of(options.takes[number]));
  HN_TRY(const Form gives, form_of(options.gives[number]));
  const std::string program = text.substr(0, text.find_first_of(" \t"));
  return Choice{{.name = std::filesystem::path(program).filename().string(),
                 .command = {"/bin/sh", "-c", text},
                 .takes = takes,
                 .gives = gives,
                 .version = {},
                 .spec = {}},
                {{takes, gives, ""}}};
}

Result<std::vector<Choice>> choices_of(const WayOptions& options) {
  std::vector<Choice> choices;
  std::size_t commands = 0;
  for (const std::string& spec : options.through) {
    const bool is_command = spec.find_first_of(" \t") != spec.npos;
    HN_TRY(auto choice, is_command ? command(spec, options, commands++) : known(spec));
    choice.step.spec = spec;
    choices.push_back(std::move(choice));
  }
  if (options.takes.size() == commands && options.gives.size() == commands) return choices;
  return fail(fmt::format("--takes and --gives are for commands, one of each; the chain has {}",
                          commands == 1 ? "1 command" : fmt::format("{} commands", commands)));
}

// The profiles of the cases that a way takes which begins with this translator and form.
std::vector<std::string> sources_of(const std::string& translator, Form form) {
  switch (form) {
    case Form::spirv:
      return {"vulkan", "hlsl60"};
    case Form::glsl:
      return {"vulkan"};
    case Form::hlsl:
      if (translator == "fxc" || translator == "vkd3d") return {"hlsl50"};
      return {"hlsl60", "hlsl2021"};
    case Form::slang:
      return {"hlsl60", "hlsl2021", "slang"};
    case Form::wgsl:
      return {"wgsl"};
    default:
      return {};
  }
}

// Both ends of a way: the profiles of the cases, and the forms that the driver takes. Empty: any.
struct Ends {
  const std::vector<std::string>& profiles;
  std::span<const Form> driver;

  bool has_source(const std::vector<std::string>& sources) const {
    return profiles.empty() ? !sources.empty() : std::ranges::find_first_of(sources, profiles) != sources.end();
  }
};

// The first conversions that fit, from a step on; how far any came is in `reached`.
bool fit(const std::vector<Choice>& choices, std::size_t at, const Ends& ends, std::vector<const Conversion*>& found,
         std::size_t& reached) {
  reached = std::max(reached, at);
  if (at == choices.size()) {
    return ends.driver.empty() || std::ranges::count(ends.driver, found.back()->gives) != 0;
  }
  for (const Conversion& conversion : choices[at].conversions) {
    if (at > 0 && found.back()->gives != conversion.takes) continue;
    if (at == 0 && !ends.has_source(sources_of(choices[0].step.name, conversion.takes))) continue;
    found.push_back(&conversion);
    if (fit(choices, at + 1, ends, found, reached)) return true;
    found.pop_back();
  }
  return false;
}

// "--through spirv-cross:hlsl --through dxc": the choices with one of the translators that are here before them, behind
// them, or at both ends, so that they fit. Empty if none does.
std::string chain_around(const std::vector<Choice>& choices, const Ends& ends) {
  std::vector<std::vector<Choice>> others = {{}};
  for (const Translator& translator : translators()) {
    if (auto choice = known(translator.name)) {
      choice->step.spec = translator.name;
      others.push_back({*std::move(choice)});
    }
  }
  for (const auto& before : others) {
    for (const auto& after : others) {
      std::vector<Choice> chain = before;
      chain.insert(chain.end(), choices.begin(), choices.end());
      chain.insert(chain.end(), after.begin(), after.end());
      std::vector<const Conversion*> found;
      std::size_t reached = 0;
      if (!fit(chain, 0, ends, found, reached)) continue;
      std::vector<std::string> words;
      for (const Choice& choice : chain) words.insert(words.end(), {"--through", choice.step.spec});
      for (std::size_t i = 0; i < chain.size(); ++i) {
        if (chain[i].step.spec.find("{in}") == std::string::npos) continue;
        words.insert(words.end(), {"--takes", std::string(name_of(found[i]->takes)), "--gives",
                                   std::string(name_of(found[i]->gives))});
      }
      return command_line(words);
    }
  }
  return "";
}

Error misfit(const std::vector<Choice>& choices, std::size_t reached, const Ends& ends) {
  const std::string chain = chain_around(choices, ends);
  const std::string better = chain.empty() ? "" : fmt::format("; this chain works: {}", chain);
  if (reached == 0) {
    std::vector<std::string> sources;
    for (const Conversion& conversion : choices[0].conversions) {
      for (const std::string& name : sources_of(choices[0].step.name, conversion.takes)) {
        if (std::ranges::count(sources, name) == 0) sources.push_back(name);
      }
    }
    const auto why = sources.empty() ? "which the suite does not write"
                                     : fmt::format("which cases of {} have, and these cases are of {}",
                                                   fmt::join(sources, ", "), fmt::join(ends.profiles, ", "));
    return {fmt::format("step 1, {}, takes {}, {}{}", choices[0].step.name,
                        fmt::join(names_of(choices[0], &Conversion::takes), ", "), why, better),
            {}};
  }
  const Choice& giver = choices[reached - 1];
  const auto gives = fmt::format("step {}, {}, gives {}", reached, giver.step.name,
                                 fmt::join(names_of(giver, &Conversion::gives), ", "));
  if (reached == choices.size()) {
    const std::vector<Form> driver(ends.driver.begin(), ends.driver.end());
    return {fmt::format("{}, and the driver takes {}{}", gives, fmt::join(names_of(driver), ", "), better), {}};
  }
  return {fmt::format("{}, and step {}, {}, takes {}{}", gives, reached + 1, choices[reached].step.name,
                      fmt::join(names_of(choices[reached], &Conversion::takes), ", "), better),
          {}};
}

}  // namespace

std::string_view name_of(Form form) { return kForms.at(static_cast<std::size_t>(form)).name; }
std::string_view ending_of(Form form) { return kForms.at(static_cast<std::size_t>(form)).ending; }

std::optional<Form> form_named(std::string_view name) {
  const auto found = std::ranges::find(kForms, name, &FormRow::name);
  if (found == kForms.end()) return std::nullopt;
  return static_cast<Form>(found - kForms.begin());
}

std::string Step::text() const { return version.empty() ? name : fmt::format("{} {}", name, version); }

std::vector<std::string> Step::command_for(const std::string& in, const std::string& out) const {
  std::vector<std::string> words = command;
  for (std::string& word : words) {
    for (const auto& [place, file] : {std::pair{std::string("{in}"), in}, std::pair{std::string("{out}"), out}}) {
      for (auto at = word.find(place); at != word.npos; at = word.find(place, at + file.size())) {
        word.replace(at, place.size(), file);
      }
    }
  }
  return words;
}

std::string Way::text() const {
  std::string text;
  for (const Step& step : steps) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", step.text());
    if (step.gives != step.takes) text += fmt::format(" to {}", name_of(step.gives));
  }
  return text;
}

std::vector<std::string> Way::sources() const {
  return empty() ? std::vector<std::string>{} : sources_of(steps.front().name, steps.front().takes);
}

std::string Way::contracts() const {
  for (const Step& step : steps) {
    if (step.name == "naga") return step.text();
    for (const Form form : {step.takes, step.gives}) {
      if (form == Form::glsl_es || form == Form::wgsl) return std::string(name_of(form));
    }
  }
  return "";
}

Result<Way> find_way(const WayOptions& options, std::span<const Form> driver_takes) {
  HN_TRY(auto choices, choices_of(options));
  const Ends ends{options.profiles, driver_takes};
  std::vector<const Conversion*> found;
  std::size_t reached = 0;
  if (!choices.empty() && !fit(choices, 0, ends, found, reached)) {
    return tl::unexpected(misfit(choices, reached, ends));
  }
  Way way;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    Step& step = choices[i].step;
    step.takes = found[i]->takes;
    step.gives = found[i]->gives;
    const std::string_view least = step.takes == Form::hlsl ? choices[i].least_for_hlsl : "";
    if (!least.empty() && !is_at_least(step.version, least)) {
      return fail(fmt::format("{} is version {}, and HLSL needs {}", step.command.front(),
                              step.version.empty() ? "unknown" : step.version, least));
    }
    for (const std::string_view argument : split(found[i]->arguments, ' ')) {
      if (!argument.empty()) step.command.emplace_back(argument);
    }
    way.steps.push_back(std::move(step));
  }
  return way;
}

std::vector<KnownTranslator> known_translators() {
  std::vector<KnownTranslator> known;
  for (const Translator& translator : translators()) {
    std::string text;
    std::optional<Form> takes;
    for (const Conversion& conversion : translator.conversions) {
      text += takes == conversion.takes ? fmt::format(", {}", name_of(conversion.gives))
                                        : fmt::format("{}{} to {}", text.empty() ? "" : "; ", name_of(conversion.takes),
                                                      name_of(conversion.gives));
      takes = conversion.takes;
    }
    const std::string program = program_of(translator, "");
    known.push_back({std::string(translator.name), std::move(text), program, version_of(translator, program)});
  }
  return known;
}

}  // namespace hn
