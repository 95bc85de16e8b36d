// Faults that drivers have had, made on a healthy one: the code of each shader is rewritten, so that it calls functions
// with the same mistake. glsl/ stays as it is.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fault/rewriter.hpp"
#include "fault/shims.hpp"
#include "library/source.hpp"

namespace hn {

struct Fault {
  std::string_view name;         // for --inject
  std::string_view fault;        // what drivers did
  std::string_view reported;     // where
  std::string_view injected;     // a text on the injection
  std::string_view remark = {};  // allowed by the specification, and so only a warning; often nothing
  std::string declared = {};     // GLSL before the shims
  std::vector<Shim> shims = {};
  Rules rules;
  // The versions that have the fault.
  bool (*concerns)(const Profile&) = [](const Profile&) { return true; };
};

std::span<const Fault> all_faults();
const Fault* find_fault(std::string_view name);
std::string fault_names();  // "abs_int, ..."
// For people, and for tools/make faults: the name of each, and below it lines such as "  injected: abs returns an int
// as it is".
std::string fault_list();

// The shader with the fault, its lines numbered as before.
Result<void> inject(const Fault& fault, const Profile& profile, ShaderText& shader);

// Every shader that is expanded from the set from now on has the fault of that name. An error if there is none.
Result<void> inject_into(SourceSet& sources, std::string_view name);

// The parts of all_faults().
std::vector<Fault> integer_faults();
std::vector<Fault> float_faults();
std::vector<Fault> flow_faults();

// + - and * of every type go through these functions, which return results x of `floats`, `ints` and `uints`.
inline const Rules::Names kArithmetic = {{"+", "hn_fault_add"}, {"-", "hn_fault_subtract"}, {"*", "hn_fault_multiply"}};
std::vector<Shim> arithmetic(std::string_view floats, std::string_view ints, std::string_view uints);

// A function of two operands whose code, of a and b, differs between scalars, two vectors, and a vector and a scalar.
std::string by_shape(std::string_view name, std::initializer_list<std::string_view> types, std::string_view scalars,
                     std::string_view vectors, std::string_view mixed);

}  // namespace hn
