// Compilers of HLSL: Microsoft's own for shader model 6, where it is installed, and for shader model 5 vkd3d-compiler,
// by way of Direct3D's own code: it makes what Direct3D 11 takes, and SPIR-V of that.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "library/source.hpp"

namespace hn {

class Dxc {
 public:
  // The program that the environment variable HN_DXC names, or dxc. An error gives the reason why there is none.
  static Result<Dxc> find();
  // Whether the variable is set, so that another compiler must not stand in.
  static bool is_named();
  // Compiles a compute shader of shader model 6.0.
  Result<std::vector<std::uint32_t>> spirv(const ShaderText& shader) const;

  const std::string& version() const { return version_; }  // the first line of its output

 private:
  Dxc(std::string program, std::string version) : program_(std::move(program)), version_(std::move(version)) {}
  std::string program_;
  std::string version_;
};

class Vkd3d {
 public:
  // The program that the environment variable HN_VKD3D_COMPILER names, or vkd3d-compiler. An error gives the reason why
  // there is none that reads HLSL.
  static Result<Vkd3d> find();
  // Compiles a compute shader, with all of its buffers as storage buffers.
  Result<std::vector<std::uint32_t>> spirv(const ShaderText& shader) const;

  const std::string& version() const { return version_; }  // "2.1"

 private:
  Vkd3d(std::string program, std::string version) : program_(std::move(program)), version_(std::move(version)) {}
  std::string program_;
  std::string version_;
};

// "1.10" from the output of vkd3d-compiler --version; empty if it has no version.
std::string vkd3d_version(const std::string& text);
// Whether a version reads HLSL well enough: from 1.10 on.
bool reads_hlsl(const std::string& version);

}  // namespace hn
