// A command over libdxcompiler.so or dxcompiler.dll, Microsoft's DXC, with all of its options.
#ifdef _WIN32
#include <windows.h>
// MinGW has no uuids of interfaces; the needed ones stand below.
#define CROSS_PLATFORM_UUIDOF(interface, spec) struct interface;
#define _Maybenull_
#else
#include <dlfcn.h>
#endif

#include "command.hpp"
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

std::string compiled(const std::vector<std::string>& options, const std::string& input, const std::string& text,
                     std::ostream& said) {
  const auto library = dlopen(HN_LIBRARY, RTLD_NOW);
  const auto create = library ? reinterpret_cast<DxcCreateInstanceProc>(dlsym(library, "DxcCreateInstance")) : nullptr;
  IDxcUtils* utils = nullptr;
  IDxcCompiler3* compiler = nullptr;
  IDxcIncludeHandler* includes = nullptr;
  if (!create || create(CLSID_DxcUtils, __uuidof(IDxcUtils), reinterpret_cast<void**>(&utils)) < 0 ||
      create(CLSID_DxcCompiler, __uuidof(IDxcCompiler3), reinterpret_cast<void**>(&compiler)) < 0 ||
      utils->CreateDefaultIncludeHandler(&includes) < 0)
    end(HN_LIBRARY " is no DXC");
  std::vector<std::wstring> words;
  for (const auto& option : options) words.emplace_back(option.begin(), option.end());
  words.emplace_back(input.begin(), input.end());
  std::vector<const wchar_t*> arguments;
  for (const auto& word : words) arguments.push_back(word.c_str());
  const DxcBuffer source = {text.data(), text.size(), DXC_CP_UTF8};
  IDxcResult* result = nullptr;
  HRESULT status = compiler->Compile(&source, arguments.data(), static_cast<UINT32>(arguments.size()), includes,
                                     __uuidof(IDxcResult), reinterpret_cast<void**>(&result));
  if (status < 0) end("DXC did not start");
  IDxcBlobUtf8* messages = nullptr;
  result->GetOutput(DXC_OUT_ERRORS, __uuidof(IDxcBlobUtf8), reinterpret_cast<void**>(&messages), nullptr);
  if (messages) said.write(messages->GetStringPointer(), static_cast<long>(messages->GetStringLength()));
  result->GetStatus(&status);
  IDxcBlob* made = nullptr;
  if (status >= 0) result->GetOutput(DXC_OUT_OBJECT, __uuidof(IDxcBlob), reinterpret_cast<void**>(&made), nullptr);
  return made ? std::string(static_cast<const char*>(made->GetBufferPointer()), made->GetBufferSize()) : "";
}
