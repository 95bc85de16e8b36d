#include "bake/ktx2.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <numeric>

namespace hn {
namespace {

static_assert(std::endian::native == std::endian::little);  // as the format is

constexpr std::array<unsigned char, 12> kIdentifier = {0xAB, 'K',  'T',  'X',  ' ',  '2',
                                                       '0',  0xBB, '\r', '\n', 0x1A, '\n'};
constexpr std::size_t kHeader = 80;  // with the index
constexpr std::size_t kLevel = 24;   // of the index of levels

// VkFormat, by the number of components.
constexpr std::uint32_t kUnorm16[] = {70, 77, 84, 91};      // VK_FORMAT_R16_UNORM, R16G16, R16G16B16, R16G16B16A16
constexpr std::uint32_t kFloat32[] = {100, 103, 106, 109};  // VK_FORMAT_R32_SFLOAT and so on

// Numbers of the Khronos Data Format.
constexpr std::uint8_t kRgbsda = 1;
constexpr std::uint8_t kNoPrimaries = 0;  // these are numbers, and no colours
constexpr std::uint8_t kLinear = 1;
constexpr std::uint8_t kChannels[] = {0, 1, 2, 15};  // red, green, blue, alpha
constexpr std::uint8_t kSignedFloat = 0x80 | 0x40;

template <typename T>
void append(std::string& bytes, T number) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof raw);
}
void append_word(std::string& bytes, std::size_t number) { append(bytes, static_cast<std::uint32_t>(number)); }
void append_long(std::string& bytes, std::size_t number) { append(bytes, static_cast<std::uint64_t>(number)); }

void pad(std::string& bytes, std::size_t to) { bytes.append((to - bytes.size() % to) % to, '\0'); }

// How a texel is made of bits.
template <typename T>
std::string descriptor(std::size_t components) {
  constexpr bool is_float = std::is_same_v<T, float>;
  const std::size_t block = 24 + 16 * components;
  std::string bytes;
  append_word(bytes, block + 4);  // with this word
  append_word(bytes, 0);          // Khronos, a basic descriptor
  append(bytes, std::uint16_t{2});
  append(bytes, static_cast<std::uint16_t>(block));
  for (const std::uint8_t byte : {kRgbsda, kNoPrimaries, kLinear, std::uint8_t{0}}) append(bytes, byte);
  append_word(bytes, 0);  // a block is a texel
  append_word(bytes, components * sizeof(T));
  append_word(bytes, 0);  // there is one plane
  for (std::size_t i = 0; i < components; ++i) {
    append(bytes, static_cast<std::uint16_t>(8 * sizeof(T) * i));
    append(bytes, static_cast<std::uint8_t>(8 * sizeof(T) - 1));
    append(bytes, static_cast<std::uint8_t>(kChannels[i] | (is_float ? kSignedFloat : 0)));
    append_word(bytes, 0);  // its position in the block
    append_word(bytes, is_float ? std::bit_cast<std::uint32_t>(-1.0f) : 0);
    append_word(bytes, is_float ? std::bit_cast<std::uint32_t>(1.0f) : 0xFFFF);
  }
  return bytes;
}

std::string texts_of(Texts texts) {
  std::ranges::sort(texts);  // the format wants them so
  std::string bytes;
  for (const auto& [name, text] : texts) {
    append_word(bytes, name.size() + text.size() + 2);
    bytes.append(name).append(1, '\0').append(text).append(1, '\0');
    pad(bytes, 4);
  }
  return bytes;
}

template <typename T>
void append_texels(std::string& bytes, const std::vector<std::vector<T>>& channels) {
  const std::size_t begin = bytes.size();
  const std::size_t texel = channels.size() * sizeof(T);
  bytes.resize(begin + channels.front().size() * texel);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    char* to = bytes.data() + begin + c * sizeof(T);
    for (const T value : channels[c]) {
      std::memcpy(to, &value, sizeof value);
      to += texel;
    }
  }
}

template <typename T>
std::string texture(const std::vector<std::vector<T>>& channels, std::span<const int> size, const Texts& texts) {
  const std::size_t components = channels.size();
  const std::size_t texel = components * sizeof(T);
  const std::string format = descriptor<T>(components);
  const std::string pairs = texts_of(texts);
  const std::size_t format_at = kHeader + kLevel;
  const std::size_t pairs_at = format_at + format.size();
  const std::size_t alignment = std::lcm(texel, std::size_t{4});
  const std::size_t texels_at = (pairs_at + pairs.size() + alignment - 1) / alignment * alignment;
  const std::size_t length = channels.front().size() * texel;

  std::string bytes(kIdentifier.begin(), kIdentifier.end());
  append_word(bytes, std::is_same_v<T, float> ? kFloat32[components - 1] : kUnorm16[components - 1]);
  append_word(bytes, sizeof(T));
  for (std::size_t axis = 0; axis < 3; ++axis)
    append_word(bytes, axis < size.size() ? static_cast<std::size_t>(size[axis]) : 0);
  append_word(bytes, 0);  // it is no array,
  append_word(bytes, 1);  // and no cube,
  append_word(bytes, 1);  // has one level,
  append_word(bytes, 0);  // and is not compressed
  for (const std::size_t number : {format_at, format.size(), pairs_at, pairs.size()}) append_word(bytes, number);
  append_long(bytes, 0);
  append_long(bytes, 0);
  for (const std::size_t number : {texels_at, length, length}) append_long(bytes, number);
  bytes += format;
  bytes += pairs;
  bytes.append(texels_at - bytes.size(), '\0');
  append_texels(bytes, channels);
  return bytes;
}

}  // namespace

std::string ktx2(const std::vector<std::vector<std::uint16_t>>& channels, std::span<const int> size,
                 const Texts& texts) {
  return texture(channels, size, texts);
}

std::string ktx2(const std::vector<std::vector<float>>& channels, std::span<const int> size, const Texts& texts) {
  return texture(channels, size, texts);
}

}  // namespace hn
