// hn-conform check: somebody's own function on drivers, at points and against values from files.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "base/csv.hpp"
#include "base/file.hpp"
#include "base/folder.hpp"
#include "base/text.hpp"
#include "base/worker.hpp"
#include "bench/foreign.hpp"
#include "cases/bugs/given.hpp"
#include "cli/command.hpp"
#include "gpu/reference_compiler.hpp"
#include "run/job.hpp"

namespace hn {
namespace {

constexpr std::size_t kMostRows = std::size_t{1} << 20;
constexpr std::string_view kAxes = "xyzw";

struct Scalar {
  std::string_view name;
  WordType type;
  std::string_view vector;     // of two to four of them
  std::string_view from_word;  // macros and constructors
  std::string_view to_word;
};
constexpr std::array kScalars = {Scalar{"float", WordType::f32, "vec", "float_of", "bits_of"},
                                 Scalar{"int", WordType::i32, "ivec", "int", "uint"},
                                 Scalar{"uint", WordType::u32, "uvec", "uint", "uint"}};

const Scalar& scalar_of(WordType type) { return *std::ranges::find(kScalars, type, &Scalar::type); }

std::string type_name(const Scalar& scalar, std::size_t components) {
  return components == 1 ? std::string(scalar.name) : fmt::format("{}{}", scalar.vector, components);
}

// --- Tables ---

struct Table {
  std::string path;
  std::vector<CsvRow> rows;  // the header, then the others

  std::string place(const CsvRow& row) const { return fmt::format("{}:{}", path, row.line); }
};

Result<Table> read_table(const std::string& path) {
  HN_TRY(const auto text, read_file(path));
  HN_TRY(auto rows, parse_csv(text, path));
  if (rows.size() > 1 && rows.size() <= kMostRows + 1) return Table{path, std::move(rows)};
  return fail(fmt::format("{}: there must be a header, and 1 to {} rows below it", path, kMostRows));
}

// A float is the nearest one, as a compiler takes a literal. Infinities and NaN are as most languages print them: inf,
// Infinity, NaN, -nan(ind), in any case.
template <typename Number>
Result<std::uint32_t> word_of(std::string_view field) {
  const std::string_view digits = field.substr(field.starts_with('+') ? 1 : 0);
  Number number{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool is_whole = end == digits.data() + digits.size() && !(digits.size() < field.size() && digits[0] == '-');
  if (error == std::errc() && is_whole) return std::bit_cast<std::uint32_t>(number);
  if constexpr (std::is_same_v<Number, float>) {
    if (error == std::errc::result_out_of_range && is_whole) {
      const float nearest = std::strtof(std::string(field).c_str(), nullptr);
      if (std::isfinite(nearest)) return std::bit_cast<std::uint32_t>(nearest);
      return fail("is beyond the largest float, 3.40282347e+38; write inf if it shall be infinite");
    }
    if (field.empty()) return fail("is no float; write nan where there is no number");
    if (field.find(',') != field.npos) return fail("is no float; write a point in place of the comma");
    return fail("is no float, as 0.5, -1e-3, inf and nan are");
  }
  return fail(error == std::errc::result_out_of_range && is_whole ? "is out of the range of its type"
                                                                  : "is no whole number in decimal digits");
}

Result<std::uint32_t> word_of(const Table& table, const CsvRow& row, std::size_t i, const GivenColumn& column) {
  const std::string& field = row.fields[i];
  const auto word = column.type == WordType::f32   ? word_of<float>(field)
                    : column.type == WordType::i32 ? word_of<std::int32_t>(field)
                                                   : word_of<std::uint32_t>(field);
  if (word) return *word;
  return fail(fmt::format("{}:{}: {} {} (column {}, {})", table.place(row), i + 1, in_quotes(field),
                          word.error().message, column.name, scalar_of(column.type).name));
}

// The rows below the header.
Result<std::vector<std::vector<std::uint32_t>>> words_of(const Table& table, const std::vector<GivenColumn>& columns) {
  std::vector<std::vector<std::uint32_t>> words;
  for (const CsvRow& row : std::span(table.rows).subspan(1)) {
    std::vector<std::uint32_t>& of_row = words.emplace_back();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      HN_TRY(const auto word, word_of(table, row, i, columns[i]));
      of_row.push_back(word);
    }
  }
  return words;
}

std::string field_of(WordType type, std::uint32_t word) {
  if (type == WordType::f32) return fmt::format("{}", std::bit_cast<float>(word));
  return type == WordType::i32 ? fmt::format("{}", static_cast<std::int32_t>(word)) : fmt::format("{}", word);
}

// --- Arguments: the names in the header of the points ---

struct Argument {
  std::string name;
  const Scalar* scalar;
  std::size_t components;

  std::string text() const { return fmt::format("{} {}", type_name(*scalar, components), name); }
};

// Appends NAME[.COMPONENT][:TYPE]. The components of a vector stand side by side.
Result<void> add_argument(std::vector<Argument>& arguments, std::string_view field, const std::string& place) {
  const auto wrong = [&](std::string_view what) {
    return fail(fmt::format("{}: {} {}", place, in_quotes(field), what));
  };
  const auto parts = split(field, ':');
  const auto scalar = parts.size() == 1 ? kScalars.begin() : std::ranges::find(kScalars, parts[1], &Scalar::name);
  if (parts.size() > 2 || scalar == kScalars.end()) return wrong("has no type of float, int and uint behind its colon");
  const auto names = split(parts[0], '.');
  if (names[0].empty()) return wrong("has no name; the header names the arguments, as in p.x,p.y");
  // glslang refuses other words that are no names.
  const bool is_name = std::ranges::all_of(names[0], [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (!is_name || std::isdigit(static_cast<unsigned char>(names[0][0]))) {
    return wrong("is no name of an argument; the first line that is no comment is the header, as in p.x,p.y");
  }
  const std::string name(names[0]);
  const bool first = names.size() == 1 || (names.size() == 2 && names[1] == "x");
  const auto continues = [&](const Argument& last) {
    return last.name == name && last.scalar == &*scalar && last.components < kAxes.size() && names.size() == 2 &&
           names[1] == kAxes.substr(last.components, 1);
  };
  if (!first && (arguments.empty() || !continues(arguments.back()))) {
    return wrong("does not follow the component before it: write p.x,p.y,p.z, of one type");
  }
  if (first && std::ranges::find(arguments, name, &Argument::name) != arguments.end()) return wrong("occurs twice");
  if (first) {
    arguments.push_back({name, &*scalar, 1});
  } else {
    ++arguments.back().components;
  }
  return {};
}

Result<std::vector<Argument>> arguments_in(const Table& points) {
  const CsvRow& header = points.rows.front();
  const std::string place = points.place(header);
  std::vector<Argument> arguments;
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    HN_DO(add_argument(arguments, header.fields[i], fmt::format("{}:{}", place, i + 1)));
  }
  if (header.fields.size() <= kInputWords) return arguments;
  return fail(fmt::format("{}: there are {} columns; a function gets at most {} numbers", place, header.fields.size(),
                          kInputWords));
}

void add_columns(std::vector<GivenColumn>& columns, const Argument& argument) {
  for (std::size_t i = 0; i < argument.components; ++i) {
    const std::string part = argument.components == 1 ? "" : fmt::format(".{}", kAxes[i]);
    columns.push_back({argument.name + part, argument.scalar->type});
  }
}

// --- The function as the suite runs it ---

std::string parameters_of(const std::vector<Argument>& arguments) {
  std::vector<std::string> texts;
  std::ranges::transform(arguments, std::back_inserter(texts), &Argument::text);
  return fmt::format("{}", fmt::join(texts, ", "));
}

// A function of our own keeps the user's names apart from ours. As in tools/measure noise, a noise may set `slope`.
std::string function_text(const SourceSet& sources, const Foreign& foreign, const std::vector<Argument>& arguments,
                          std::string_view result, std::string_view returned) {
  const auto p = std::ranges::find(arguments, "p", &Argument::name);
  const bool has_slope =
      p != arguments.end() && sources.find(foreign.expression)->text.find("slope") != std::string::npos;
  return fmt::format(
      "#ifdef GL_ES\nprecision highp float;\nprecision highp int;\n#endif\n#include \"{}\"\n#include \"config.glsl\"\n"
      "{} hn_check_value({}) {{\n{}  {}(\n#include \"{}\"\n  );\n}}\n",
      foreign.file, result, parameters_of(arguments),
      has_slope ? fmt::format("  {0} slope = {0}(0);\n", type_name(*p->scalar, p->components)) : "", returned,
      foreign.expression);
}

// The function's arguments from the words of evaluate, and the words of its value.
std::string body_of(const std::vector<Argument>& arguments, const Argument& value) {
  std::vector<std::string> passed;
  std::size_t word = 0;
  for (const Argument& argument : arguments) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < argument.components; ++i, ++word) {
      parts.push_back(fmt::format("{}({}.{})", argument.scalar->from_word, "abcd"[word / 4], kAxes[word % 4]));
    }
    passed.push_back(fmt::format("{}({})", type_name(*argument.scalar, argument.components), fmt::join(parts, ", ")));
  }
  std::vector<std::string> words;
  for (std::size_t i = 0; i < kOutputWords; ++i) {
    const std::string part = value.components == 1 ? "" : fmt::format(".{}", kAxes[i]);
    words.push_back(i < value.components ? fmt::format("{}(v{})", value.scalar->to_word, part) : "0u");
  }
  return fmt::format("{} v = hn_check_value({});\nreturn uvec4({});", type_name(*value.scalar, value.components),
                     fmt::join(passed, ", "), fmt::join(words, ", "));
}

// The type of the expression: the overload that glslang takes for it, by its line. An error has glslang's words.
Result<Argument> result_of(const SourceSet& sources, const Foreign& foreign, const std::vector<Argument>& arguments) {
  std::string text = "#line 2 0\n";
  std::vector<Argument> types;
  for (const Scalar& scalar : kScalars) {
    for (std::size_t components = 1; components <= kOutputWords; ++components) {
      types.push_back({"value", &scalar, components});
      text += fmt::format("void hn_check_type({}) {{}}\n", types.back().text());
    }
  }
  std::vector<std::string> zeros;
  for (const Argument& argument : arguments) {
    zeros.push_back(fmt::format("{}(0)", type_name(*argument.scalar, argument.components)));
  }
  text += fmt::format("{}void main() {{ hn_check_value({}); }}\n",
                      function_text(sources, foreign, arguments, "void", "hn_check_type"), fmt::join(zeros, ", "));
  const Profile& profile = profile_named(foreign.profile);
  HN_TRY(const auto expanded, expand(sources, profile, text));
  const auto lines = ReferenceCompiler().lines_of_called(expanded, profile, Stage::fragment);
  if (!lines) {
    return fail(fmt::format("check {}: this does not compile with {}; the expression must be a float, an int, a uint "
                            "or a vector of them, of the points' {}; NAME@450=FILE:EXPRESSION requires GLSL 4.50",
                            foreign.argument, profile.directive, parameters_of(arguments)),
                lines.error().log);
  }
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (lines->contains(2 + i)) return types[i];
  }
  throw std::logic_error("glslang calls none of the overloads");
}

Result<GivenFunction> read_function(const CheckCommand& command) {
  HN_TRY(const auto points, read_table(command.points));
  HN_TRY(const auto arguments, arguments_in(points));
  SourceSet sources = SourceSet::embedded();
  HN_TRY(const auto foreign, read_foreign(command.function, sources, "check"));
  HN_TRY(const auto value, result_of(sources, foreign, arguments));
  GivenFunction function{
      .id = fmt::format("check.{}", foreign.name),
      .text = command.function,
      .file = fmt::format("against/{}/check", foreign.name),
      .body = body_of(arguments, value),
      // A text of a later version hardly compiles as ES.
      .profiles = fmt::format("{}{} vulkan", foreign.profile, foreign.profile == "gl330" ? " es300" : ""),
      .tolerance = command.tolerance};
  const std::string result = type_name(*value.scalar, value.components);
  sources.add(function.file, function_text(sources, foreign, arguments, result, "return "),
              sources.find(foreign.file)->path);
  for (const auto& [name, file] : sources.files()) {
    if (name.starts_with("against/")) function.files.push_back({name, file.text, file.path});
  }
  for (const Argument& argument : arguments) add_columns(function.inputs, argument);
  add_columns(function.outputs, value);
  HN_TRY(auto words, words_of(points, function.inputs));
  for (auto& of_point : words) function.points.push_back({std::move(of_point), {}});
  return function;
}

Result<void> read_expected(const std::string& path, GivenFunction& function) {
  HN_TRY(const auto table, read_table(path));
  const std::size_t columns = table.rows.front().fields.size();
  if (columns != function.outputs.size() || table.rows.size() != function.points.size() + 1) {
    return fail(
        fmt::format("{}: it has {} columns and {} rows below its header; the function returns {} numbers at "
                    "each of {} points",
                    path, columns, table.rows.size() - 1, function.outputs.size(), function.points.size()));
  }
  HN_TRY(const auto words, words_of(table, function.outputs));
  for (std::size_t i = 0; i < words.size(); ++i) function.points[i].expected = words[i];
  function.expected_from = path;
  function.expected_right = true;
  return {};
}

// --- The values of a driver ---

// Expects the values of the first driver that has some, and returns its context.
Result<ContextInfo> record(const CheckCommand& command, const DriverChoice& choice, int stop_fd,
                           GivenFunction& function) {
  const TemporaryFolder scratch;
  const auto limit = std::chrono::milliseconds(static_cast<std::int64_t>(command.run.execution.timeout * 1000.0));
  std::string refusals;
  for (const std::string& name : choice.names) {
    const auto driver = find_driver(name);
    if (driver->is_reference_compiler()) continue;
    if (driver->browser) {
      refusals += fmt::format("\n{}: a browser reports no values", name);
      continue;
    }
    Job job{.task = Task::values, .driver = name, .suite = {}, .ids = {}};
    job.suite.given = function;
    if (!command.record.empty())
      job.suite.way = choice.way;  // else values behind a way are compared with those without
    const auto report = report_of(job, scratch.path(), limit, stop_fd);
    if (can_be_read(stop_fd)) return fail("");
    if (!report) {
      refusals += fmt::format("\n{}: {}", name, report.error().text());
      continue;
    }
    const auto values = report->at("values").get<std::vector<std::vector<std::uint32_t>>>();
    for (std::size_t i = 0; i < values.size(); ++i) function.points[i].expected = values[i];
    function.expected_from = fmt::format("{} in {}", name, report->at("profile").get<std::string>());
    return context_info_from(report->at("info"));
  }
  return fail(fmt::format("no driver returns values that others could be compared with:{}", refusals));
}

Result<void> write_record(const CheckCommand& command, const GivenFunction& function, const ContextInfo& info) {
  std::vector<std::string> header;
  for (const GivenColumn& column : function.outputs) {
    header.push_back(fmt::format("{}:{}", column.name, scalar_of(column.type).name));
  }
  std::vector<std::vector<std::string>> rows;
  for (const BugPoint& point : function.points) {
    std::vector<std::string>& row = rows.emplace_back();
    for (std::size_t i = 0; i < header.size(); ++i) {
      row.push_back(field_of(function.outputs[i].type, point.expected[i]));
    }
  }
  const Facts facts = {{"command", command.run.output.line},
                       {"driver", function.expected_from},
                       {"renderer", fmt::format("{}, {}", info.renderer, info.gl_version)},
                       {"date", now()}};
  return write_file(command.record, to_record(facts, header, rows));
}

// The function with its expected values; else the exit status, after a message.
tl::expected<GivenFunction, int> prepare(const CheckCommand& command, int stop_fd) {
  auto function = read_function(command);
  if (!function) return tl::unexpected(usage_error(function.error().text()));
  if (!command.expect.empty()) {
    const auto read = read_expected(command.expect, *function);
    if (!read) return tl::unexpected(usage_error(read.error().text()));
    return *std::move(function);
  }
  WayOptions way = command.run.execution.suite.way;
  way.profiles = {"vulkan"};  // of those that a way takes, the function's shaders have this one
  const auto choice = choose_drivers(command.run.selection.drivers, way, stop_fd);
  if (!choice) return tl::unexpected(usage_error(choice.error().text()));
  const auto info = record(command, *choice, stop_fd, *function);
  if (can_be_read(stop_fd)) return tl::unexpected(0);
  if (!info) {
    complain(printable(info.error().text()));
    return tl::unexpected(kNoDriver);
  }
  if (command.record.empty()) return *std::move(function);
  if (const auto written = write_record(command, *function, *info); !written) {
    complain(written.error().text());
    return tl::unexpected(kNotAsExpected);
  }
  say(fmt::format("{} values of {}: {}\n", function->points.size() * function->outputs.size(), function->expected_from,
                  command.record));
  return tl::unexpected(0);
}

}  // namespace

int run(const CheckCommand& command, Interruption& interruption) {
  interruption.note_the_first();
  auto function = prepare(command, interruption.fd());
  if (const int signal = interruption.signal(); signal != 0) {
    complain(farewell(signal));
    return kSignalled + signal;
  }
  if (!function) return function.error();
  RunCommand cases = command.run;
  if (cases.selection.filters.empty()) cases.selection.filters = {fmt::format("{}.*", function->id)};
  give(*function);
  cases.execution.suite.given = *std::move(function);
  return run(cases, interruption);
}

}  // namespace hn
