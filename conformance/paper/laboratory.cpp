#include "paper/laboratory.hpp"

#include <utility>

namespace hn {

Laboratory::Laboratory(const Context& context_, const SourceSet& sources_, const ReferenceCompiler& reference_,
                       std::filesystem::path out_, int rounds_, bool dump_)
    : Sampler(context_, with_published_listings(sources_)),
      reference(reference_),
      out(std::move(out_)),
      rounds(rounds_),
      dump(dump_),
      stopwatch(context_) {}

}  // namespace hn
