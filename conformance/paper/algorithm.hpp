// The paper's seven algorithms, each hash in three forms.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/subject.hpp"

namespace hn {

enum class AlgorithmForm {
  published,  // the listing as printed: published.glsl
  intended,   // the library with HN_GRADIENT_SINE and the paper's period
  ours,       // the library's own gradient, with the same hash
  table,      // no hash: Perlin/Float and Perlin/Integer
};
std::string_view name_of(AlgorithmForm form);
// A title for readers: "as published".
std::string_view title_of(AlgorithmForm form);

struct Algorithm {
  std::string_view name;   // in ids
  std::string_view title;  // as in the paper and in printed.csv: "Perlin/FNV1"
  std::string_view macro;  // the end of HN_HASH_... and PAPER_...; none for a table
  bool printed;            // the paper has it
};

// In the paper's order. The library's default hash is not in the paper and comes last.
std::span<const Algorithm> all_algorithms();
const Algorithm& algorithm_named(std::string_view name);  // it must exist

struct Entry {
  const Algorithm* algorithm;
  AlgorithmForm form;

  std::string id() const;  // "fnv1.published"
};

// Every algorithm in every form that it has.
std::vector<Entry> all_entries();

enum class Picture { noise, turbulence, clouds };
std::string_view name_of(Picture picture);

// The paper's limit of the period, in cells.
inline constexpr std::uint32_t kPaperPeriod = std::uint32_t{1} << 20;
// A picture as a subject: the algorithm's noise, or one of the library's octave sums over it. period: of the library's
// noise in our form, in cells; 0 for none.
Subject subject_of(const Entry& entry, int dimensions, Picture picture = Picture::noise, std::uint32_t period = 0);

// The files, and the paper's listings, which the published form includes.
SourceSet with_published_listings(SourceSet sources);

}  // namespace hn
