// The program that is made of an expression, and what it computes.
#pragma once

#include <string>
#include <vector>

#include "bake/options.hpp"
#include "bake/planes.hpp"
#include "base/result.hpp"
#include "base/temporary_folder.hpp"

namespace hn {

// Why there is no program.
struct Refusal {
  int status;  // of hn-bake: kBadUsage if the user's text is wrong, kNotBuilt if the compiler is missing or fails
  std::string message;
};

class ExpressionProgram {
 public:
  // Compiles the expression by $CXX, or else c++.
  static tl::expected<ExpressionProgram, Refusal> make(const BakeOptions& options);

  const std::vector<std::string>& components() const { return components_; }  // of the whole value
  std::filesystem::path path() const;
  std::filesystem::path axes() const { return folder_.path() / "axes"; }  // the points

 private:
  ExpressionProgram() = default;

  TemporaryFolder folder_;
  std::vector<std::string> components_;
};

// Computes the rows in several processes, so that none of them can do harm here, and all end with this process. The
// error describes how one of them ended, and in which rows. Throws as compute does for fields.
Result<Planes> compute(const ExpressionProgram& program, const BakeOptions& options, const RowsDone& rows_done);

}  // namespace hn
