#include <fmt/format.h>

#include <algorithm>

#include "fault/faults.hpp"

namespace hn {
namespace {

struct Head {
  std::size_t length = 0;  // of the lines that must come first
  int next_line = 2;       // of the case's shader, whose first line is #version
};

// #version, #extension, and the #line between them.
Head head_of(std::string_view text) {
  Head head;
  for (;;) {
    const std::string_view rest = text.substr(head.length);
    const auto end = rest.find('\n');
    const bool extension = rest.starts_with("#extension");
    if (end == std::string_view::npos || !(extension || rest.starts_with("#version") || rest.starts_with("#line"))) {
      return head;
    }
    head.length += end + 1;
    if (extension) ++head.next_line;
  }
}

}  // namespace

const Fault* find_fault(std::string_view name) {
  const auto faults = all_faults();
  const auto found = std::find_if(faults.begin(), faults.end(), [&](const Fault& f) { return f.name == name; });
  return found == faults.end() ? nullptr : &*found;
}

std::string fault_names() {
  std::string names;
  for (const Fault& fault : all_faults()) names += fmt::format("{}{}", names.empty() ? "" : ", ", fault.name);
  return names;
}

std::string fault_list() {
  std::string text;
  for (const Fault& fault : all_faults()) {
    text += fmt::format("{}\n  fault: {}\n  reported in: {}\n  injected: {}\n", fault.name, fault.fault, fault.reported,
                        fault.injected);
    if (!fault.remark.empty()) text += fmt::format("  remark: {}\n", fault.remark);
  }
  return text;
}

Result<void> inject(const Fault& fault, const Profile& profile, ShaderText& shader) {
  if (!fault.concerns(profile)) return {};
  auto code = rewrite(shader.text, fault.rules);
  if (!code) return fail(fmt::format("the fault {} cannot be injected: {}", fault.name, code.error().message));
  std::string shims = fault.declared;
  for (const Shim& shim : fault.shims) shims += glsl_of(shim);
  // glslang warns about precision elsewhere than in ES.
  constexpr std::string_view kHighp = "highp ";
  for (auto at = shims.find(kHighp); !profile.es && at != shims.npos; at = shims.find(kHighp, at)) {
    shims.erase(at, kHighp.size());
  }
  const Head head = head_of(*code);
  const auto source = static_cast<int>(shader.paths.size());
  shader.paths.push_back(fmt::format("the injected fault {}", fault.name));
  code->insert(head.length, fmt::format("{}{}{}", line_directive(profile, source, 1), shims,
                                        line_directive(profile, 0, head.next_line)));
  shader.text = std::move(*code);
  return {};
}

Result<void> inject_into(SourceSet& sources, std::string_view name) {
  const Fault* const fault = find_fault(name);
  if (!fault) return fail(fmt::format("there is no fault \"{}\" to inject; there are: {}", name, fault_names()));
  sources.transform_with(
      [fault](ShaderText& shader, const Profile& profile) { return inject(*fault, profile, shader); });
  return {};
}

}  // namespace hn
