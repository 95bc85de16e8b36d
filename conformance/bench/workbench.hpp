// A context set up for measuring: the library's files with those it is compared with, and the tables bound.
#pragma once

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

}  // namespace hn
