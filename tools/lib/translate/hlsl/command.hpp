// A command over the library of a compiler of HLSL, with options as DXC's own command has them.
//
//   PROGRAM [option]... -Fo OUTPUT INPUT     exit status: 0 compiled, 1 refused, 2 the library is not as expected
//   PROGRAM [option]... -each INPUT...       of each file it writes INPUT.code, if it compiles, and INPUT.messages
//   PROGRAM --version
#pragma once

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

// Compiles a text, the file's; its messages are written to `said`. The code is empty if it does not compile.
std::string compiled(const std::vector<std::string>& options, const std::string& input, const std::string& text,
                     std::ostream& said);

[[noreturn]] inline void end(const char* why) {
  std::fprintf(stderr, "%s\n", why);
  std::exit(2);
}

static bool compiles(const std::vector<std::string>& options, const std::string& input, const std::string& output,
                     std::ostream& said) {
  std::ifstream file(input, std::ios::binary);
  if (!file) end("there is no such INPUT");
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::string code = compiled(options, input, text, said);
  if (!code.empty()) std::ofstream(output, std::ios::binary) << code;
  return !code.empty();
}

int main(int argc, char** argv) {
  std::vector<std::string> options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--version") {
      std::puts(HN_VERSION);
      return 0;
    }
    if (word == "-Fo" && i + 2 < argc) return !compiles(options, argv[i + 2], argv[i + 1], std::cerr);
    if (word == "-each") {
      bool failed = false;
      while (++i < argc) {
        const std::string input = argv[i];
        std::ofstream messages(input + ".messages", std::ios::binary);
        failed = !compiles(options, input, input + ".code", messages) || failed;
      }
      return failed;
    }
    options.push_back(word);
  }
  end("there is no INPUT");
}
