#include "library/configurations.hpp"

#include <fmt/format.h>

#include <array>

#include "base/entry_named.hpp"

namespace hn {
namespace {

// For HN_HASH_CUSTOM; the same in twin.cpp.
constexpr std::string_view kCustomHash = "#define HN_HASH_FN(k) (((k) ^ ((k) >> 16u)) * 0x045D9F3Bu)\n";

constexpr Configuration kConfigurations[] = {
#include "library/configurations.inc"
};

}  // namespace

std::string_view name_of(Arithmetic arithmetic) {
  constexpr std::array<std::string_view, 3> kNames = {"fast", "precise", "fixed"};
  return kNames.at(static_cast<std::size_t>(arithmetic));
}

std::string_view Configuration::name_without_arithmetic() const {
  return fast() ? name : name.substr(0, name.rfind('+'));
}

std::span<const Configuration> all_configurations() { return kConfigurations; }

const Configuration& default_configuration() { return configuration_named("lattice"); }

const Configuration& configuration_named(std::string_view name) {
  return entry_named(kConfigurations, &Configuration::name, name, "configuration");
}

std::string knobs_of(const Configuration& configuration) {
  std::string knobs;
  if (configuration.hash != default_configuration().hash) {
    knobs += fmt::format("#define HN_HASH HN_HASH_{}\n", configuration.hash);
  }
  if (configuration.sine()) knobs += "#define HN_GRADIENT HN_GRADIENT_SINE\n";
  if (configuration.arithmetic == Arithmetic::precise) knobs += "#define HN_ARITHMETIC HN_PRECISE\n";
  if (configuration.arithmetic == Arithmetic::fixed) knobs += "#define HN_ARITHMETIC HN_FIXED\n";
  if (configuration.hash == "CUSTOM") knobs += kCustomHash;
  return knobs;
}

}  // namespace hn
