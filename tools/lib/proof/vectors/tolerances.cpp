// How far results may be from the exact values, for tools/make vectors. It answers each line
//
//   CONFIGURATION FUNCTION WORD...     the input words of a point, in hexadecimal
//
// with the bound of each output, which is 0 where every bit is defined.
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

// The units of the suite that know it, in one: so it compiles in seconds, without twins and without CMake.
#include "expected/cellular.cpp"
#include "expected/tolerance.cpp"
#include "library/configurations.cpp"
#include "library/functions.cpp"
#include "library/profile.cpp"

int main() {
  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream fields(line);
    std::string configuration;
    std::string id;
    std::vector<std::uint32_t> inputs;
    fields >> configuration >> id >> std::hex;
    for (std::uint32_t word = 0; fields >> word;) inputs.push_back(word);
    const hn::Function& function = hn::find_function(id);
    if (inputs.size() != function.inputs.size()) {
      std::cerr << line << ": the function has " << function.inputs.size() << " inputs\n";
      return 2;
    }
    for (std::size_t i = 0; i < function.outputs.size(); ++i) {
      const double bound = hn::tolerance(function, hn::configuration_named(configuration), inputs, i);
      std::printf("%s%.17g", i == 0 ? "" : " ", bound);
    }
    std::printf("\n");
  }
  return 0;
}
