// A command for Windows over d3dcompiler_47.dll, Microsoft's FXC, as programs call it that compile their own shaders.
// It needs the options -T PROFILE and -E ENTRY.
#include <d3dcompiler.h>
#include <windows.h>

#include <algorithm>

#include "command.hpp"

static std::string text_of(ID3DBlob* blob) {
  if (!blob) return "";
  std::string text(static_cast<const char*>(blob->GetBufferPointer()), blob->GetBufferSize());
  blob->Release();
  return text;
}

static const char* value_of(const std::vector<std::string>& options, const char* name) {
  const auto found = std::find(options.begin(), options.end(), name);
  if (options.end() - found < 2) end("-T PROFILE and -E ENTRY are missing");
  return found[1].c_str();
}

std::string compiled(const std::vector<std::string>& options, const std::string& input, const std::string& text,
                     std::ostream& said) {
  const HMODULE library = LoadLibraryA("d3dcompiler_47.dll");
  const auto compile =
      library ? reinterpret_cast<pD3DCompile>(reinterpret_cast<void*>(GetProcAddress(library, "D3DCompile"))) : nullptr;
  if (!compile) end("d3dcompiler_47.dll is no FXC");
  ID3DBlob* code = nullptr;
  ID3DBlob* messages = nullptr;
  const HRESULT status = compile(text.data(), text.size(), input.c_str(), nullptr, D3D_COMPILE_STANDARD_FILE_INCLUDE,
                                 value_of(options, "-E"), value_of(options, "-T"), 0, 0, &code, &messages);
  said << text_of(messages);
  const std::string made = text_of(code);
  return SUCCEEDED(status) ? made : "";
}
