// A command over libdxcompiler.so, Microsoft's DXC, as its own `dxc` is: the suite starts it by HN_DXC.
//
//   dxc [option of DXC]... -Fo OUTPUT INPUT     exit status: 0 compiled, 1 refused, 2 the library is not as expected
//   dxc [option of DXC]... -each INPUT...       of each file it writes INPUT.code, if it compiles, and INPUT.messages
//   dxc --version
#ifdef _WIN32
#include <windows.h>
// MinGW has no uuids of interfaces; the needed ones stand below.
#define CROSS_PLATFORM_UUIDOF(interface, spec) struct interface;
#define _Maybenull_
#else
#include <dlfcn.h>
#endif

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "dxcapi.h"

#ifdef _WIN32
__CRT_UUID_DECL(IDxcBlob, 0x8ba5fb08, 0x5195, 0x40e2, 0xac, 0x58, 0x0d, 0x98, 0x9c, 0x3a, 0x01, 0x02)
__CRT_UUID_DECL(IDxcBlobUtf8, 0x3da636c9, 0xba71, 0x4024, 0xa3, 0x01, 0x30, 0xcb, 0xf1, 0x25, 0x30, 0x5b)
__CRT_UUID_DECL(IDxcUtils, 0x4605c4cb, 0x2019, 0x492a, 0xad, 0xa4, 0x65, 0xf2, 0x0b, 0xb7, 0xd6, 0x7f)
__CRT_UUID_DECL(IDxcCompiler3, 0x228b4687, 0x5a6a, 0x4730, 0x90, 0x0c, 0x97, 0x02, 0xb2, 0x20, 0x3f, 0x54)
__CRT_UUID_DECL(IDxcResult, 0x58346cda, 0xdde7, 0x4497, 0x94, 0x61, 0x6f, 0x87, 0xaf, 0x5e, 0x06, 0x59)
const int RTLD_NOW = 0;
static HMODULE dlopen(const char* name, int) { return LoadLibraryA(name); }
static void* dlsym(HMODULE library, const char* name) { return reinterpret_cast<void*>(GetProcAddress(library, name)); }
#endif

// Whether it compiles: its code is written to `output`, and its messages to `said`.
static bool compiles(IDxcCompiler3& compiler, IDxcIncludeHandler* includes, std::vector<std::wstring> words,
                     const std::string& input, const std::string& output, std::ostream& said) {
  words.emplace_back(input.begin(), input.end());
  std::vector<const wchar_t*> arguments;
  for (const auto& word : words) arguments.push_back(word.c_str());
  std::ifstream file(input, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const DxcBuffer source = {text.data(), text.size(), DXC_CP_UTF8};
  IDxcResult* result = nullptr;
  HRESULT status = compiler.Compile(&source, arguments.data(), static_cast<UINT32>(arguments.size()), includes,
                                    __uuidof(IDxcResult), reinterpret_cast<void**>(&result));
  if (status < 0 || !file) {
    std::fprintf(stderr, "DXC did not start\n");
    std::exit(2);
  }
  IDxcBlobUtf8* messages = nullptr;
  result->GetOutput(DXC_OUT_ERRORS, __uuidof(IDxcBlobUtf8), reinterpret_cast<void**>(&messages), nullptr);
  if (messages) said.write(messages->GetStringPointer(), static_cast<long>(messages->GetStringLength()));
  result->GetStatus(&status);
  if (status < 0) return false;
  IDxcBlob* made = nullptr;
  result->GetOutput(DXC_OUT_OBJECT, __uuidof(IDxcBlob), reinterpret_cast<void**>(&made), nullptr);
  if (!made || !made->GetBufferSize()) return false;
  std::ofstream(output, std::ios::binary)
      .write(static_cast<const char*>(made->GetBufferPointer()), static_cast<long>(made->GetBufferSize()));
  result->Release();
  return true;
}

int main(int argc, char** argv) {
  const auto library = dlopen(HN_LIBRARY, RTLD_NOW);
  const auto create = library ? reinterpret_cast<DxcCreateInstanceProc>(dlsym(library, "DxcCreateInstance")) : nullptr;
  IDxcUtils* utils = nullptr;
  IDxcCompiler3* compiler = nullptr;
  IDxcIncludeHandler* includes = nullptr;
  if (!create || create(CLSID_DxcUtils, __uuidof(IDxcUtils), reinterpret_cast<void**>(&utils)) < 0 ||
      create(CLSID_DxcCompiler, __uuidof(IDxcCompiler3), reinterpret_cast<void**>(&compiler)) < 0 ||
      utils->CreateDefaultIncludeHandler(&includes) < 0) {
    std::fprintf(stderr, "%s is no DXC\n", HN_LIBRARY);
    return 2;
  }
  std::vector<std::wstring> words;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--version") {
      std::printf("libdxcompiler of " HN_PACKAGE "\n");
      return 0;
    }
    if (word == "-Fo" && i + 2 < argc)
      return !compiles(*compiler, includes, words, argv[i + 2], argv[i + 1], std::cerr);
    if (word == "-each") {
      bool failed = false;
      while (++i < argc) {
        const std::string input = argv[i];
        std::ofstream messages(input + ".messages", std::ios::binary);
        failed = !compiles(*compiler, includes, words, input, input + ".code", messages) || failed;
      }
      return failed;
    }
    words.emplace_back(word.begin(), word.end());
  }
  std::fprintf(stderr, "dxc: there is no INPUT\n");
  return 2;
}
