// Compares what the listings compute on OSMesa with the library's hashes of the same names. The sine is left out
// wherever a value is looked at: GLSL leaves it open.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <hashnoise/hashnoise.hpp>
#include <memory>

#include "base/folder.hpp"
#include "bench/subject.hpp"
#include "expected/points.hpp"
#include "gpu/gpu.hpp"
#include "gpu/osmesa_fixture.hpp"
#include "paper/laboratory.hpp"

namespace hn {
namespace {

using hashnoise::hn_hash_fnv1;
using hashnoise::hn_hash_jenkins;
using hashnoise::hn_hash_murmur;
using hashnoise::hn_hash_partial_fnv1;
using hashnoise::hn_hash_partial_jenkins;

constexpr std::string_view kMeantMask = "#define PAPER_FNV1_MASK3 -16777216\n";
constexpr std::uint32_t kSignOfByte = 0xFFFFFF00u;  // what an arithmetic shift by 24 adds to a byte of 128 or more

std::vector<std::uint32_t> random_words() {
  std::vector<std::uint32_t> words(std::size_t{1} << 16);
  Random random(1, "published");
  for (std::uint32_t& word : words) word = random.word();
  return words;
}

bool negative(std::uint32_t word) { return word >> 31 != 0; }

std::uint32_t shift(std::uint32_t word, int by) { return static_cast<std::uint32_t>(std::bit_cast<int>(word) >> by); }

// The hashes of the listings, each as its difference from the library's hash where that has a short form.
std::uint32_t meant_fnv1(std::uint32_t key) { return hn_hash_fnv1(key) ^ (negative(key) ? kSignOfByte : 0u); }
std::uint32_t printed_fnv1(std::uint32_t key) { return meant_fnv1(key) ^ ((key >> 24) & 0x7Eu); }

std::uint32_t jenkins_step(std::uint32_t hash, std::uint32_t add) {
  const std::uint32_t h = (hash + add) * 1025u;
  return h ^ shift(h, 6);
}
std::uint32_t jenkins_end(std::uint32_t hash) {
  const std::uint32_t h = hash * 9u;
  return (h ^ shift(h, 11)) * 32769u;
}
std::uint32_t printed_partial_jenkins(std::uint32_t key) { return jenkins_end(jenkins_step(0u, key)); }
std::uint32_t printed_jenkins(std::uint32_t key) {
  std::uint32_t hash = 0u;
  for (const int byte : {0, 8, 16}) hash = jenkins_step(hash, (key >> byte) & 255u);
  return jenkins_end(jenkins_step(hash, shift(key, 24)));
}

std::uint32_t printed_murmur(std::uint32_t key) {
  constexpr std::uint32_t kM = 1540483477u;
  const std::uint32_t k = key * kM;
  return (10u * kM) ^ ((k ^ shift(k, 24)) * kM);
}

struct Listing {
  std::string_view macro;
  std::uint32_t (*printed)(std::uint32_t);
  std::uint32_t (*library)(std::uint32_t);
};
constexpr std::array kListings = {
    Listing{"FNV1", printed_fnv1, hn_hash_fnv1},
    Listing{"PARTIAL_FNV1", hn_hash_partial_fnv1, hn_hash_partial_fnv1},
    Listing{"JENKINS", printed_jenkins, hn_hash_jenkins},
    Listing{"PARTIAL_JENKINS", printed_partial_jenkins, hn_hash_partial_jenkins},
    Listing{"MURMUR", printed_murmur, hn_hash_murmur},
};

class Published : public OnOsmesa<> {
 protected:
  void SetUp() override {
    OnOsmesa::SetUp();
    if (HasFatalFailure()) return;
    laboratory_ = std::make_unique<Laboratory>(*context_, SourceSet::embedded(), reference_, folder_.path(), 3, false);
  }

  // The words that a body of main makes of the input words `in_a`.
  std::vector<std::uint32_t> evaluate(std::string_view macro, std::string_view knobs, std::string_view body,
                                      const std::vector<std::uint32_t>& inputs) {
    const auto program = laboratory_->build(
        fmt::format("{}#define PAPER_HASH PAPER_{}\n#include \"published.glsl\"\nuniform usampler2D input_a;\n"
                    "out uvec4 result;\nvoid main() {{\n  ivec4 a = ivec4(texelFetch(input_a, "
                    "ivec2(gl_FragCoord.xy), 0));\n  result = {};\n}}\n",
                    knobs, macro, body));
    if (!program) {
      ADD_FAILURE() << program.error().text();
      return {};
    }
    GridRenderer grid(*context_);
    const auto words = grid.evaluate(*program, inputs);
    EXPECT_TRUE(words) << words.error().text();
    return words.value_or(std::vector<std::uint32_t>{});
  }

  std::vector<std::uint32_t> hashes(std::string_view macro, const std::vector<std::uint32_t>& keys,
                                    std::string_view knobs = "") {
    std::vector<std::uint32_t> inputs(keys.size() * kInputWords);
    for (std::size_t i = 0; i < keys.size(); ++i) inputs[i * kInputWords] = keys[i];
    const auto words = evaluate(macro, knobs, "uvec4(uint(paper_hash(a.x)), 0u, 0u, 0u)", inputs);
    std::vector<std::uint32_t> found(words.size() / kOutputWords);
    for (std::size_t i = 0; i < found.size(); ++i) found[i] = words[i * kOutputWords];
    return found;
  }

  TemporaryFolder folder_;
  ReferenceCompiler reference_;
  std::unique_ptr<Laboratory> laboratory_;
};

// Every listing, and with it what these tests take it for, bit by bit; FNV-1 also with the mask that is meant.
TEST_F(Published, ListingsAreReadRight) {
  std::vector<std::uint32_t> keys = random_words();
  for (std::uint32_t bit = 0; bit < 32; ++bit) {
    for (const std::uint32_t key : {1u << bit, (1u << bit) - 1u, 0u - (1u << bit)}) keys.push_back(key);
  }
  const auto expect_hashes = [&](const std::vector<std::uint32_t>& got, std::uint32_t (*hash)(std::uint32_t)) {
    ASSERT_EQ(got.size(), keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) ASSERT_EQ(got[i], hash(keys[i])) << keys[i];
  };
  for (const Listing& listing : kListings) {
    SCOPED_TRACE(listing.macro);
    expect_hashes(hashes(listing.macro, keys), listing.printed);
  }
  expect_hashes(hashes("FNV1", keys, kMeantMask), meant_fnv1);
}

// Of 65536 keys, and of coordinates, whose highest byte is 0. FNV-1 loses bits 25 to 30 of a key, which all but one of
// 64 keys have, and inverts the upper 24 bits for half of all; with the right mask it does only that. The others are
// wrong where a shift to the right is of a negative number: Murmur's one for half of the keys, Jenkins' several for
// more. Partial FNV-1 has no such shift.
TEST(PublishedHashes, DifferFromTheLibrarysForSoManyKeys) {
  const auto keys = random_words();
  using Hash = std::uint32_t(std::uint32_t);
  const auto differing = [&](Hash* hash, Hash* library, std::uint32_t mask) {
    return std::ranges::count_if(keys, [&](std::uint32_t key) { return hash(key & mask) != library(key & mask); });
  };
  std::vector<std::ptrdiff_t> counts;
  for (const Listing& listing : kListings) counts.push_back(differing(listing.printed, listing.library, ~0u));
  EXPECT_EQ(counts, (std::vector<std::ptrdiff_t>{65036, 0, 61118, 47210, 32631}));
  EXPECT_EQ(differing(printed_fnv1, meant_fnv1, ~0u), 64514);
  EXPECT_EQ(differing(meant_fnv1, hn_hash_fnv1, ~0u), 32741);
  EXPECT_EQ(differing(printed_fnv1, hn_hash_fnv1, 0x00FFFFFFu), 0);
}

// The words that paper_gradient takes the sine of, as floats: "sin" is a macro that returns them.
TEST_F(Published, GradientsAreTheSinesOfTheChain) {
  const auto words = random_words();
  std::vector<std::uint32_t> inputs(4096 * kInputWords);
  for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = words[i];
  // The first cells are a period's.
  for (std::size_t i = 0; i < 2048 * kInputWords; ++i) inputs[i] &= 1048575u;
  const auto bits = [](std::uint32_t word) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(std::bit_cast<int>(word)));
  };
  for (const Listing& listing : kListings) {
    const auto plane =
        evaluate(listing.macro, "#define sin(v) (v)\n", "uvec4(floatBitsToUint(paper_gradient(a.xy)), 0u, 0u)", inputs);
    const auto space =
        evaluate(listing.macro, "#define sin(v) (v)\n", "uvec4(floatBitsToUint(paper_gradient(a.xyz)), 0u)", inputs);
    ASSERT_EQ(plane.size(), 4096 * kOutputWords);
    ASSERT_EQ(space.size(), 4096 * kOutputWords);
    for (std::size_t i = 0; i < 4096; ++i) {
      const std::uint32_t* const cell = &inputs[i * kInputWords];
      const std::uint32_t x = listing.printed(cell[0]);
      const std::uint32_t y = listing.printed(x + cell[1]);
      const std::uint32_t z = listing.printed(y + cell[2]);
      ASSERT_EQ(plane[i * kOutputWords], bits(x + y)) << listing.macro;
      ASSERT_EQ(plane[i * kOutputWords + 1], bits(y + y)) << listing.macro;
      ASSERT_EQ(space[i * kOutputWords], bits(z + x)) << listing.macro;
      ASSERT_EQ(space[i * kOutputWords + 1], bits(z + y)) << listing.macro;
      ASSERT_EQ(space[i * kOutputWords + 2], bits(z + z)) << listing.macro;
    }
  }
}

// The cells of a period of 32768 in which the chain of the listing comes to other words than the library's, so to
// another gradient: all but one of 128 with FNV1, for either fault of its highest byte; three of four with Murmur,
// whose two hashes each differ for every other key.
TEST_F(Published, CellsWithOtherGradientsThanIntended) {
  const auto words = random_words();
  std::vector<std::size_t> differing;
  for (const Listing& listing : kListings) {
    std::size_t number = 0;
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
      const std::uint32_t x = words[i] & 1048575u;
      const std::uint32_t y = words[i + 1] & 1048575u;
      const std::uint32_t printed = listing.printed(x);
      const std::uint32_t library = listing.library(x);
      if (printed != library || listing.printed(printed + y) != listing.library(library + y)) ++number;
    }
    differing.push_back(number);
  }
  EXPECT_EQ(differing, (std::vector<std::size_t>{32512, 0, 32458, 27847, 24582}));
}

class PublishedNoise : public Published {
 protected:
  std::vector<float> noise(const Listing& listing, int dimensions, const std::vector<Position>& positions) {
    for (const Entry& entry : all_entries()) {
      if (entry.form != AlgorithmForm::published || entry.algorithm->macro != listing.macro) continue;
      const auto values = laboratory_->values(subject_of(entry, dimensions), positions);
      EXPECT_TRUE(values) << values.error().text();
      return values.value_or(std::vector<float>{});
    }
    ADD_FAILURE() << "no entry for " << listing.macro;
    return {};
  }

  // Multiples of 1/8 over some cells, so that the positions a period on are floats, too.
  static std::vector<Position> positions(std::uint32_t eighths) {
    Random random(1, "published");
    std::vector<Position> points(4096);
    const auto coordinate = [&] { return static_cast<float>(random.below(1u << 13) * eighths) / 8.0f - 512.0f; };
    for (Position& point : points) {
      point.x = coordinate();
      point.y = coordinate();
      point.z = coordinate();
    }
    return points;
  }
};

TEST_F(PublishedNoise, IsZeroAtLatticePoints) {
  for (const Listing& listing : kListings) {
    for (const int dimensions : {2, 3}) {
      const auto values = noise(listing, dimensions, positions(8));
      EXPECT_EQ(values, std::vector<float>(4096, 0.0f)) << listing.macro << ", " << dimensions << "D";
      const auto elsewhere = noise(listing, dimensions, positions(1));
      EXPECT_NE(elsewhere, std::vector<float>(4096, 0.0f)) << listing.macro << ", " << dimensions << "D";
    }
  }
}

TEST_F(PublishedNoise, RepeatsAfterThePeriodBitByBit) {
  const auto bits = [](const std::vector<float>& values) {
    std::vector<std::uint32_t> words;
    for (const float value : values) words.push_back(std::bit_cast<std::uint32_t>(value));
    return words;
  };
  const auto here = positions(1);
  for (const Listing& listing : kListings) {
    for (const int dimensions : {2, 3}) {
      const auto values = bits(noise(listing, dimensions, here));
      for (const auto axis : {&Position::x, &Position::y, &Position::z}) {
        const auto moved = [&](float by) {
          std::vector<Position> there = here;
          for (Position& position : there) position.*axis += by;
          return bits(noise(listing, dimensions, there));
        };
        EXPECT_EQ(values, moved(1048576.0f)) << listing.macro << ", " << dimensions << "D";
        if (dimensions == 2 && axis == &Position::z) continue;
        EXPECT_NE(values, moved(524288.0f)) << listing.macro << ", " << dimensions << "D";
      }
    }
  }
}

}  // namespace
}  // namespace hn
