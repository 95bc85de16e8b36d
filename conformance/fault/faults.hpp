// Faults that drivers have had, made on a healthy one: the code of each shader is rewritten, so that it calls functions
// with the same mistake. glsl/ stays as it is.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fault/rewriter.hpp"
#include "fault/shims.hpp"
#include "library/source.hpp"

namespace hn {

struct Fault {
  std::string_view name;      // for --inject
  std::string_view fault;     // what drivers did
  std::string_view reported;  // where
  std::string_view injected;  // a text on the injection
  std::string_view remark;    // allowed by the specification, and so only a warning; often nothing
  std::function<std::string(const ShimLanguage&)> shim;
  Rules rules;
  // The versions that have the fault.
  std::function<bool(const ShimLanguage&)> concerns = [](const ShimLanguage&) { return true; };
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

void add_integer_faults(std::vector<Fault>& faults);
void add_float_faults(std::vector<Fault>& faults);
void add_flow_faults(std::vector<Fault>& faults);

}  // namespace hn
