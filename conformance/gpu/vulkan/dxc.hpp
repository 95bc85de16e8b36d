// HLSL by Microsoft's own compiler, where it is installed.
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

}  // namespace hn
