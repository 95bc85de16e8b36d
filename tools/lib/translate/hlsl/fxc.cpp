// A command for Windows over d3dcompiler_47.dll, Microsoft's FXC, as programs call it that compile their own shaders.
//
//   fxc PROFILE ENTRY INPUT...    of each file it writes INPUT.code, if it compiles, and INPUT.messages
//
// Exit status: 0 all compile, 1 some do not, 2 there is no FXC.
#include <d3dcompiler.h>
#include <windows.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>

static void write(const std::string& path, ID3DBlob* blob) {
  std::ofstream file(path, std::ios::binary);
  if (blob) {
    const auto* const bytes = static_cast<const char*>(blob->GetBufferPointer());
    file.write(bytes, static_cast<std::streamsize>(blob->GetBufferSize()));
  }
}

int main(int argc, char** argv) {
  const HMODULE library = LoadLibraryA("d3dcompiler_47.dll");
  const auto compile =
      library ? reinterpret_cast<pD3DCompile>(reinterpret_cast<void*>(GetProcAddress(library, "D3DCompile"))) : nullptr;
  if (!compile) return 2;
  bool failed = false;
  for (int i = 3; i < argc; ++i) {
    const std::string path = argv[i];
    std::ifstream file(path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    ID3DBlob* code = nullptr;
    ID3DBlob* messages = nullptr;
    const HRESULT status = compile(text.data(), text.size(), path.c_str(), nullptr, D3D_COMPILE_STANDARD_FILE_INCLUDE,
                                   argv[2], argv[1], 0, 0, &code, &messages);
    failed = failed || FAILED(status);
    if (SUCCEEDED(status)) write(path + ".code", code);
    write(path + ".messages", messages);
    if (code) code->Release();
    if (messages) messages->Release();
  }
  return failed;
}
