#include "bake/ktx2.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <map>

namespace hn {
namespace {

// A reader of its own, by https://registry.khronos.org/KTX/specs/2.0/ktxspec.v2.html; bake.ktx2 uses somebody else's.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  template <typename T>
  T at(std::size_t offset) const {
    T number{};
    if (offset + sizeof number <= bytes_.size()) std::memcpy(&number, bytes_.data() + offset, sizeof number);
    return number;
  }
  std::size_t word(std::size_t offset) const { return at<std::uint32_t>(offset); }

  // The error of the file; empty if there is none.
  std::string problem() const {
    if (bytes_.substr(0, 12) != std::string("\xABKTX 20\xBB\r\n\x1A\n", 12)) return "identifier";
    if (word(36) != 1 || word(40) != 1 || word(44) != 0) return "faces, levels or compression";
    const std::size_t descriptor = word(48);
    const std::size_t samples = (word(52) - 28) / 16;
    if (descriptor != 104 || word(descriptor) != word(52) || at<std::uint16_t>(descriptor + 10) != word(52) - 4) {
      return "descriptor";
    }
    if (word(56) != descriptor + word(52)) return "place of the pairs";
    const std::size_t texel = at<std::uint8_t>(descriptor + 20);
    if (texel != samples * word(16)) return "size of a texel";
    std::size_t texels = 1;
    for (const std::size_t offset : {20u, 24u, 28u}) texels *= std::max<std::size_t>(word(offset), 1);
    const auto level = at<std::uint64_t>(80);
    if (level % 4 != 0 || level % texel != 0 || level < word(56) + word(60)) return "place of the level";
    if (at<std::uint64_t>(88) != texels * texel || at<std::uint64_t>(96) != texels * texel) return "size of the level";
    return level + texels * texel == bytes_.size() ? "" : "size of the file";
  }

  std::map<std::string, std::string> pairs() const {
    std::map<std::string, std::string> found;
    for (std::size_t at = word(56); at < word(56) + word(60);) {
      const std::string pair = bytes_.substr(at + 4, word(at));
      const std::size_t end = pair.find('\0');
      found[pair.substr(0, end)] = pair.substr(end + 1);
      at += 4 + (word(at) + 3) / 4 * 4;
    }
    return found;
  }

 private:
  const std::string& bytes_;
};

const Texts kTexts = {{"hashnoise", "{}"}, {"KTXwriter", "a test"}};

TEST(Ktx2, OfWords) {
  const std::vector<std::uint16_t> x = {1, 2, 3, 4, 5, 6};
  const std::vector<std::uint16_t> y = {7, 8, 9, 10, 11, 12};
  const std::uint32_t formats[] = {70, 77, 84, 91};
  for (std::size_t components = 1; components <= 4; ++components) {
    std::vector<std::vector<std::uint16_t>> channels(components, x);
    channels.back() = y;
    const std::string bytes = ktx2(channels, std::vector<int>{3, 2}, kTexts);
    const Reader reader(bytes);
    ASSERT_EQ(reader.problem(), "") << components;
    EXPECT_EQ(reader.word(12), formats[components - 1]);
    EXPECT_EQ(reader.word(20), 3u);
    EXPECT_EQ(reader.word(24), 2u);
    EXPECT_EQ(reader.word(28), 0u);
    const auto level = reader.at<std::uint64_t>(80);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_EQ(reader.at<std::uint16_t>(level + 2 * (components * (i + 1) - 1)), y[i]);
    }
    const std::size_t sample = 104 + 28 + 16 * (components - 1);
    EXPECT_EQ(reader.at<std::uint16_t>(sample), 16 * (components - 1));
    EXPECT_EQ(reader.at<std::uint8_t>(sample + 2), 15);
    EXPECT_EQ(reader.at<std::uint8_t>(sample + 3), components == 4 ? 15 : components - 1);
    EXPECT_EQ(reader.word(sample + 12), 65535u);
    EXPECT_EQ(reader.pairs().at("KTXwriter"), std::string("a test\0", 7));
    EXPECT_EQ(reader.pairs().at("hashnoise"), std::string("{}\0", 3));
  }
}

TEST(Ktx2, OfFloats) {
  const std::vector<float> values = {0.5f, -1.5f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f};
  const std::string bytes = ktx2(std::vector<std::vector<float>>{values}, std::vector<int>{2, 2, 2}, kTexts);
  const Reader reader(bytes);
  ASSERT_EQ(reader.problem(), "");
  EXPECT_EQ(reader.word(12), 100u);
  EXPECT_EQ(reader.word(28), 2u);
  const auto level = reader.at<std::uint64_t>(80);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(reader.at<float>(level + 4 * i), values[i]);
  EXPECT_EQ(reader.at<std::uint8_t>(104 + 28 + 3), 0xC0);
  EXPECT_EQ(std::bit_cast<float>(static_cast<std::uint32_t>(reader.word(104 + 28 + 8))), -1.0f);
  const std::string line = ktx2(std::vector<std::vector<float>>{values}, std::vector<int>{8}, kTexts);
  EXPECT_EQ(Reader(line).problem(), "");
  EXPECT_EQ(Reader(line).word(24), 0u);
}

TEST(Ktx2, AFaultIsNoticed) {
  const std::string right = ktx2(std::vector<std::vector<float>>{{1.0f, 2.0f}}, std::vector<int>{2}, kTexts);
  for (const std::size_t offset : {0u, 16u, 20u, 36u, 48u, 52u, 56u, 80u, 88u, 114u, 124u}) {
    std::string wrong = right;
    wrong[offset] = static_cast<char>(wrong[offset] + 1);
    EXPECT_NE(Reader(wrong).problem(), "") << offset;
  }
  EXPECT_NE(Reader(right.substr(0, right.size() - 1)).problem(), "");
}

}  // namespace
}  // namespace hn
