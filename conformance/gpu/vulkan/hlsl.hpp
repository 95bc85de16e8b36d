// Compilers of HLSL: Microsoft's own for shader model 6, where it is installed, and for shader model 5 vkd3d-compiler,
// by way of Direct3D's own code: it makes what Direct3D 11 takes, and SPIR-V of that.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "library/source.hpp"

namespace hn {

struct HlslCompiler {
  std::string program;
  std::string version;
  // Compiles a compute shader by the program, with all of its buffers as storage buffers.
  Result<std::vector<std::uint32_t>> (*spirv)(const std::string& program, const ShaderText& shader);
};

// For shader model 6 the program that the environment variable HN_DXC names, or dxc. An error gives the reason why
// there is none.
Result<HlslCompiler> find_dxc();
// Whether the variable is set, so that another compiler must not stand in.
bool is_dxc_named();
// For shader model 5 the program that HN_VKD3D_COMPILER names, or vkd3d-compiler. An error gives the reason why there
// is none that reads HLSL.
Result<HlslCompiler> find_vkd3d();

// "1.10" from the output of vkd3d-compiler --version; empty if it has no version.
std::string vkd3d_version(const std::string& text);
// Whether a version reads HLSL well enough: from 1.10 on.
bool reads_hlsl(const std::string& version);

}  // namespace hn
