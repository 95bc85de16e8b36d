// A context set up for measuring: the library's files with those it is compared with, and the tables bound.
#pragma once

#include "bench/subject.hpp"
#include "bench/tables.hpp"
#include "gpu.hpp"

namespace hn {

class Workbench {
 public:
  Workbench(const Context& context, const SourceSet& sources);

  // The program of a fragment shader of subject.hpp, with the quad's vertex shader; its tables attached.
  Result<Program> build(const std::string& fragment);

  const Context& context;
  const SourceSet sources;

 private:
  NoiseTables tables_;
};

}  // namespace hn
