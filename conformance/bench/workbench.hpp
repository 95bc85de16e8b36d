// A context set up for measuring: the library's files with those it is compared with, the tables bound; and the values
// of what is measured.
#pragma once

#include <span>
#include <vector>

#include "bench/subject.hpp"
#include "bench/tables.hpp"
#include "gpu/gpu.hpp"
#include "library/profile.hpp"

namespace hn {

class Workbench {
 public:
  Workbench(const Context& context, const SourceSet& sources);

  // Empty if the context has the version of the language that a subject or a profile needs, else why not.
  std::string unsupported(const Subject& subject) const { return unsupported(subject.profile); }
  std::string unsupported(std::string_view profile) const;
  // The program of a fragment shader of subject.hpp, with the quad's vertex shader; its tables attached.
  Result<Program> build(const std::string& fragment, std::string_view profile = "gl330");

  const Context& context;
  const SourceSet sources;

 private:
  const LanguageSupport languages_;
  NoiseTables tables_;
};

struct Position {
  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
};

class Sampler : public Workbench {
 public:
  Sampler(const Context& context, const SourceSet& sources);

  // The subject's values at at most 2^20 positions, as the driver computes them.
  Result<std::vector<float>> values(const Subject& subject, std::span<const Position> positions);
  // The same with a program of value_shader, for those who ask more than once.
  Result<std::vector<float>> values(const Program& program, std::span<const Position> positions);

 private:
  GridRenderer grid_;
};

}  // namespace hn
