#include "bake/glsl_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/text.hpp"

namespace hn {
namespace {

// Each list has a blank before and behind each word.
bool is_in(std::string_view words, std::string_view word) {
  return words.find(fmt::format(" {} ", word)) != std::string_view::npos;
}

// Words without a meaning in C++: precisions, and parameters that are only read.
constexpr std::string_view kLeftOut = " in highp mediump lowp precise ";
constexpr std::string_view kOfGlsl =
    " asm class union enum typedef template this goto inline noinline public static extern external interface long "
    "short half fixed unsigned superp sizeof cast namespace using volatile ";
constexpr std::string_view kOfCpp =
    " alignas alignof and and_eq auto bitand bitor catch char char8_t char16_t char32_t compl concept consteval "
    "constexpr constinit const_cast co_await co_return co_yield decltype delete dynamic_cast explicit export friend "
    "mutable new noexcept not not_eq nullptr operator or or_eq private protected register reinterpret_cast requires "
    "signed static_assert static_cast std thread_local throw try typeid typename virtual wchar_t xor xor_eq ";
constexpr std::string_view kOfShaders =
    " uniform varying attribute layout buffer shared discard subroutine sampler2D sampler3D texture ";
constexpr std::string_view kNotInTwin =
    " double dvec2 dvec3 dvec4 bvec2 bvec3 bvec4 mat2 mat3 mat4 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 "
    "mat4x3 mat4x4 ";
constexpr std::string_view kLeftOutDirectives = " version extension line pragma ";
constexpr std::string_view kDirectives = " define undef if ifdef ifndef else elif endif error ";
constexpr std::string_view kPunctuation = "()[]{}.,;:?+-*/%<>=!&|^~ \t\r\n";

constexpr std::string_view kSwizzle = "swizzled<";  // builtins.hpp has it

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_of_word(char c) { return is_letter(c) || is_digit(c); }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

// "yx" of ".yx": 1, 0. Nothing for a member by another name, and for a single component, which C++ has as well.
std::vector<std::size_t> swizzle_of(std::string_view member) {
  if (member.size() < 2 || member.size() > 4) return {};
  for (const std::string_view set : {"xyzw", "rgba", "stpq"}) {
    std::vector<std::size_t> components;
    for (const char c : member) {
      if (const std::size_t index = set.find(c); index != std::string_view::npos) components.push_back(index);
    }
    if (components.size() == member.size()) return components;
  }
  return {};
}

class Translator {
 public:
  Translator(GlslText glsl, bool is_expression) : is_expression_(is_expression) {
    cpp_.glsl = std::move(glsl);
    in_ = cpp_.glsl.text;
  }

  Result<CppText> run() {
    while (at_ < in_.size() && !problem_) step();
    if (problem_) return tl::unexpected(*problem_);
    if (is_expression_ && !open_.empty()) refuse(open_.back(), "this bracket is not closed");
    if (is_expression_ && !has_value_) refuse(0, "there is no expression");
    if (problem_) return tl::unexpected(*problem_);
    return std::move(cpp_);
  }

 private:
  void refuse(std::size_t offset, const std::string& message) {
    if (!problem_) problem_ = Error{cpp_.glsl.at(offset, message), {}};
  }

  bool next_is(std::string_view text) const { return in_.substr(at_).starts_with(text); }
  // The word that begins there, if one does.
  std::string_view word_at(std::size_t offset) const {
    std::size_t end = offset;
    while (end < in_.size() && is_of_word(in_[end])) ++end;
    return in_.substr(offset, end - offset);
  }

  void put(char c, std::size_t origin) {
    cpp_.text += c;
    cpp_.origins.push_back(static_cast<std::uint32_t>(origin));
  }
  void copy(std::size_t count) {
    // Compilers count the columns of a tab in several ways.
    for (; count > 0; --count, ++at_) put(in_[at_] == '\t' || in_[at_] == '\r' ? ' ' : in_[at_], at_);
  }
  void leave_out(std::size_t count) {
    for (; count > 0 && at_ < in_.size(); --count, ++at_) put(in_[at_] == '\n' ? '\n' : ' ', at_);
  }
  void leave_out_up_to(char last) { leave_out(std::min(in_.find(last, at_), in_.size() - 1) - at_ + 1); }
  void insert(std::size_t place, std::string_view text) {
    const std::uint32_t origin = place < cpp_.origins.size() ? cpp_.origins[place] : static_cast<std::uint32_t>(at_);
    cpp_.text.insert(place, text);
    cpp_.origins.insert(cpp_.origins.begin() + static_cast<std::ptrdiff_t>(place), text.size(), origin);
  }

  void step() {
    const char c = in_[at_];
    const bool begins_line = begins_line_;
    if (!is_space(c)) begins_line_ = false;
    if (c == '\n') begins_line_ = true;
    if (next_is("//")) {
      leave_out(std::min(in_.find('\n', at_), in_.size()) - at_);
    } else if (next_is("/*")) {
      const std::size_t end = in_.find("*/", at_ + 2);
      if (end == std::string_view::npos) return refuse(at_, "this comment has no end");
      begins_line_ = begins_line;
      leave_out(end + 2 - at_);
    } else if (c == '#') {
      directive(begins_line);
    } else if (is_digit(c) || (c == '.' && at_ + 1 < in_.size() && is_digit(in_[at_ + 1]))) {
      number();
    } else if (is_letter(c)) {
      word();
    } else {
      punctuation(c);
    }
  }

  void directive(bool begins_line) {
    if (is_expression_ || !begins_line) return refuse(at_, "# belongs to the beginning of a line of a --source file");
    std::size_t begin = at_ + 1;
    while (begin < in_.size() && (in_[begin] == ' ' || in_[begin] == '\t')) ++begin;
    const std::string_view name = word_at(begin);
    const std::string_view line = in_.substr(at_, in_.find('\n', at_) - at_);
    if (name == "include") {
      if (line.find("hashnoise/") == std::string_view::npos) {
        return refuse(at_, "--source has no other files; the library's own are there without an #include");
      }
      return leave_out(line.size());
    }
    if (is_in(kLeftOutDirectives, name)) return leave_out(line.size());
    if (!is_in(kDirectives, name)) return refuse(at_, fmt::format("there is no #{}", in_quotes(name)));
    const std::size_t defined = std::min(in_.find_first_not_of(" \t", begin + name.size()), in_.size());
    if ((name == "define" || name == "undef") && word_at(defined).starts_with("HN_")) {
      return refuse(at_,
                    "a knob of hashnoise comes too late here; --arithmetic names it, and others have their default");
    }
    copy(begin + name.size() - at_);
  }

  void number() {
    const std::size_t begin = at_;
    std::size_t end = at_;
    const auto digits = [&] {
      while (end < in_.size() && is_digit(in_[end])) ++end;
    };
    bool is_float = false;
    if (next_is("0x") || next_is("0X")) {
      end += 2;
      while (end < in_.size() && std::string_view("0123456789abcdefABCDEF").find(in_[end]) != std::string_view::npos)
        ++end;
    } else {
      digits();
      if (end < in_.size() && in_[end] == '.') {
        is_float = true;
        ++end;
        digits();
      }
      if (end < in_.size() && (in_[end] == 'e' || in_[end] == 'E')) {
        is_float = true;
        ++end;
        if (end < in_.size() && (in_[end] == '+' || in_[end] == '-')) ++end;
        digits();
      }
    }
    const std::string_view suffix = word_at(end);
    const std::string_view all = in_.substr(begin, end + suffix.size() - begin);
    if (suffix == "lf" || suffix == "LF") return refuse(begin, fmt::format("{} is a double; the twin has floats", all));
    const bool fits =
        is_float ? suffix.empty() || suffix == "f" || suffix == "F" : suffix.empty() || suffix == "u" || suffix == "U";
    if (!fits) return refuse(begin, fmt::format("{} is no number of GLSL; write 1.0, 1 or 1u", in_quotes(all)));
    has_value_ = true;
    copy(all.size());
    if (is_float && suffix.empty()) insert(cpp_.text.size(), "f");
  }

  void word() {
    const std::string_view word = word_at(at_);
    const auto known = [&](std::string_view words) { return is_in(words, word); };
    has_value_ = true;
    if (known(kLeftOut)) return leave_out(word.size());
    if (word == "precision") return leave_out_up_to(';');
    if (word == "out" || word == "inout") {
      is_reference_ = true;
      return leave_out(word.size());
    }
    if (known(kOfGlsl)) return refuse(at_, fmt::format("GLSL reserves the word {}; take another", word));
    if (known(kOfCpp)) return refuse(at_, fmt::format("C++ reserves the word {}; take another", word));
    if (known(kOfShaders) || word.starts_with("gl_")) {
      return refuse(at_, fmt::format("{} belongs to a shader; hn-bake has functions of numbers alone", word));
    }
    if (known(kNotInTwin)) {
      return refuse(at_, fmt::format("there is no {} here; there are float, int, uint, bool, vec2 to vec4, ivec2 to "
                                     "ivec4 and uvec2 to uvec4",
                                     word));
    }
    if (const auto components = swizzle_of(word); !components.empty() && follows_dot())
      return swizzle(word, components);
    copy(word.size());
    if (is_reference_ && word != "const") {
      is_reference_ = false;
      insert(cpp_.text.size(), "&");  // out float a: float& a
    }
  }

  bool follows_dot() const {
    const std::size_t last = cpp_.text.find_last_not_of(" \n");
    return last != std::string::npos && cpp_.text[last] == '.';
  }

  // Where the operand of what follows begins, in the C++: v, f(p), v.x or a[1], which end at `end`.
  std::size_t begin_of_operand(const std::size_t dot) const {
    const std::string& text = cpp_.text;
    std::size_t at = dot;
    while (true) {
      at = before_brackets(before_space(at));
      const std::size_t behind_word = at;
      while (at > 0 && is_of_word(text[at - 1])) --at;
      if (text.substr(at, behind_word - at) == "return")
        return std::min(text.find_first_not_of(" \n", behind_word), dot);
      const std::size_t before = before_space(at);
      if (before == 0 || text[before - 1] != '.') return at;
      at = before - 1;
    }
  }

  std::size_t before_space(std::size_t at) const {
    while (at > 0 && is_space(cpp_.text[at - 1])) --at;
    return at;
  }

  // Before all pairs of brackets that end there, and before the digits of swizzled<21>(p).
  std::size_t before_brackets(std::size_t at) const {
    const std::string& text = cpp_.text;
    while (at > 0 && (text[at - 1] == ')' || text[at - 1] == ']')) {
      int depth = 0;
      do {
        --at;
        depth += text[at] == ')' || text[at] == ']';
        depth -= text[at] == '(' || text[at] == '[';
      } while (at > 0 && depth > 0);
      at = before_space(at);
    }
    const std::size_t digits = text.rfind(kSwizzle, at);
    if (at == 0 || text[at - 1] != '>' || digits == std::string::npos) return at;
    const std::size_t end = text.find_first_not_of("1234", digits + kSwizzle.size());
    return end == at - 1 ? digits + kSwizzle.size() - 1 : at;
  }

  // Whether = or += and the like stand behind this place.
  bool is_assigned_to(std::size_t at) const {
    while (at < in_.size() && is_space(in_[at])) ++at;
    const std::string_view rest = in_.substr(at);
    if (rest.starts_with('=')) return !rest.starts_with("==");
    return rest.size() > 1 && rest[1] == '=' && std::string_view("+-*/").find(rest[0]) != std::string_view::npos;
  }

  void swizzle(std::string_view member, const std::vector<std::size_t>& components) {
    if (is_assigned_to(at_ + member.size())) {
      return refuse(at_, fmt::format(".{} can only be read here; assign to one component at a time", member));
    }
    std::size_t dot = cpp_.text.find_last_of('.');
    std::string call(kSwizzle);  // the components as digits, since a comma would separate arguments of a macro
    for (const std::size_t component : components) call += static_cast<char>('1' + component);
    cpp_.text[dot] = ' ';
    leave_out(member.size());
    insert(cpp_.text.size(), ")");
    insert(begin_of_operand(dot), call + ">(");
  }

  void punctuation(char c) {
    const bool continues =
        c == '\\' && (in_.substr(at_ + 1).starts_with("\n") || in_.substr(at_ + 1).starts_with("\r\n"));
    if ((kPunctuation.find(c) == std::string_view::npos && !continues) || next_is("->") || next_is("::")) {
      return refuse(at_,
                    fmt::format("GLSL has no {}", in_quotes(in_.substr(at_, next_is("->") || next_is("::") ? 2 : 1))));
    }
    if (is_expression_ && (c == ';' || c == '{' || c == '}')) {
      return refuse(at_, fmt::format("an expression is one value without {}; functions stand in a --source file",
                                     in_quotes(std::string_view(&c, 1))));
    }
    if (c == '(' || c == '[') open_.push_back(at_);
    if (c == ')' || c == ']') {
      const bool fits = !open_.empty() && in_[open_.back()] == (c == ')' ? '(' : '[');
      if (!fits) return refuse(at_, "this bracket was not opened");
      open_.pop_back();
    }
    copy(1);
  }

  bool is_expression_;
  std::string_view in_;
  std::size_t at_ = 0;
  CppText cpp_;
  std::optional<Error> problem_;
  std::vector<std::size_t> open_;  // brackets
  bool begins_line_ = true;
  bool has_value_ = false;
  bool is_reference_ = false;  // an `out` was read, and its type comes next
};

}  // namespace

std::string GlslText::at(std::size_t offset, std::string_view message) const {
  offset = std::min(offset, text.size());
  const std::string_view before = std::string_view(text).substr(0, offset);
  const std::size_t begin = before.rfind('\n') + 1;  // 0 if there is none
  const std::string_view line = std::string_view(text).substr(begin, text.find('\n', begin) - begin);
  std::string marked = printable(line);
  std::replace(marked.begin(), marked.end(), '\t', ' ');
  return fmt::format("{}, line {}, column {}: {}\n  {}\n  {:>{}}", name,
                     std::count(before.begin(), before.end(), '\n') + 1, offset - begin + 1, message, marked, '^',
                     offset - begin + 1);
}

std::size_t CppText::origin(std::size_t line, std::size_t column) const {
  std::size_t begin = 0;
  for (; line > 1; --line) begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
  const std::size_t at = begin + column - 1;
  return at < origins.size() ? origins[at] : glsl.text.size();
}

Result<CppText> cpp_of_functions(GlslText glsl) { return Translator(std::move(glsl), false).run(); }
Result<CppText> cpp_of_expression(GlslText glsl) { return Translator(std::move(glsl), true).run(); }

}  // namespace hn
