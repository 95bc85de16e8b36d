#include "bench/tables.hpp"

#include <utility>
#include <vector>

#include "expected/points.hpp"

namespace hn {
namespace {

constexpr int kSize = 256;
constexpr GLuint kFirstUnit = kInputWords / 4;  // the first ones are the grid renderer's

// In the order of the texture units.
constexpr std::array kNames = {"table_gradient2",   "table_permutation2", "table_gradient3",
                               "table_permutation", "table_gradients2",   "table_gradients3"};

// The eight neighbours of a square, and Perlin's twelve edges of a cube (2002), four of them twice.
constexpr std::int8_t kGradients2[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
constexpr std::int8_t kGradients3[16][4] = {{1, 1, 0, 0}, {-1, 1, 0, 0}, {1, -1, 0, 0}, {-1, -1, 0, 0},
                                            {1, 0, 1, 0}, {-1, 0, 1, 0}, {1, 0, -1, 0}, {-1, 0, -1, 0},
                                            {0, 1, 1, 0}, {0, -1, 1, 0}, {0, 1, -1, 0}, {0, -1, -1, 0},
                                            {1, 1, 0, 0}, {-1, 1, 0, 0}, {0, -1, 1, 0}, {0, -1, -1, 0}};

template <std::size_t n>
std::array<std::int8_t, n> normalised(const std::int8_t (&gradient)[n]) {
  std::array<std::int8_t, n> texel;
  for (std::size_t i = 0; i < n; ++i) texel[i] = static_cast<std::int8_t>(gradient[i] * 127);  // 127 stands for 1
  return texel;
}

struct Image {
  GLint internal_format;
  int width;
  int height;
  GLenum format;
  GLenum type;
  std::vector<std::int8_t> bytes;

  template <std::size_t n>
  void add(const std::array<std::int8_t, n>& texel) {
    bytes.insert(bytes.end(), texel.begin(), texel.end());
  }
};

// The images for Perlin/Float: tables of tables.
std::array<Image, 3> float_images(const std::array<std::uint8_t, 256>& p) {
  Image gradient2{GL_RG8_SNORM, kSize, kSize, GL_RG, GL_BYTE, {}};
  Image permutation2{GL_RGBA8, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, {}};
  Image gradient3{GL_RGBA8_SNORM, kSize, 1, GL_RGBA, GL_BYTE, {}};
  const auto at = [&p](int x, int y) {
    return p[static_cast<std::size_t>((p[static_cast<std::size_t>(x & 255)] + y) & 255)];
  };
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      gradient2.add(normalised(kGradients2[at(x, y) & 7]));
      permutation2.add(std::array{static_cast<std::int8_t>(at(x, y)), static_cast<std::int8_t>(at(x + 1, y)),
                                  static_cast<std::int8_t>(at(x, y + 1)), static_cast<std::int8_t>(at(x + 1, y + 1))});
    }
  }
  for (const std::uint8_t number : p) gradient3.add(normalised(kGradients3[number & 15]));
  return {gradient2, permutation2, gradient3};
}

// The images for Perlin/Integer: each table twice behind itself, since the sum of two numbers below 256 is an index.
std::array<Image, 3> integer_images(const std::array<std::uint8_t, 256>& p) {
  Image permutation{GL_R8UI, 2 * kSize, 1, GL_RED_INTEGER, GL_UNSIGNED_BYTE, {}};
  Image gradients2{GL_RG8I, 2 * kSize, 1, GL_RG_INTEGER, GL_BYTE, {}};
  Image gradients3{GL_RGBA8I, 2 * kSize, 1, GL_RGBA_INTEGER, GL_BYTE, {}};
  for (int i = 0; i < 2 * kSize; ++i) {
    const std::uint8_t number = p[static_cast<std::size_t>(i & 255)];
    permutation.add(std::array{static_cast<std::int8_t>(number)});
    gradients2.add(std::to_array(kGradients2[number & 7]));
    gradients3.add(std::to_array(kGradients3[number & 15]));
  }
  return {permutation, gradients2, gradients3};
}

}  // namespace

std::array<std::uint8_t, 256> table_permutation() {
  std::array<std::uint8_t, 256> p{};
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = static_cast<std::uint8_t>(i);
  Random random(0, "permutation");
  for (std::size_t i = p.size() - 1; i > 0; --i) {
    std::swap(p[i], p[random.below(static_cast<std::uint32_t>(i + 1))]);
  }
  return p;
}

NoiseTables::NoiseTables(const Context& context) : gl_(context.gl()) {
  const auto permutation = table_permutation();
  std::vector<Image> images;
  for (Image& image : float_images(permutation)) images.push_back(std::move(image));
  for (Image& image : integer_images(permutation)) images.push_back(std::move(image));
  gl_.GenTextures(kCount, textures_.data());
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (std::size_t i = 0; i < kCount; ++i) {
    const Image& image = images[i];
    gl_.ActiveTexture(GL_TEXTURE0 + kFirstUnit + static_cast<GLenum>(i));
    gl_.BindTexture(GL_TEXTURE_2D, textures_[i]);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
      gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    }
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) gl_.TexParameteri(GL_TEXTURE_2D, wrap, GL_REPEAT);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, image.internal_format, image.width, image.height, 0, image.format, image.type,
                   image.bytes.data());
  }
}

NoiseTables::~NoiseTables() { gl_.DeleteTextures(kCount, textures_.data()); }

void NoiseTables::attach(const Program& program) const {
  gl_.UseProgram(program.id());
  for (std::size_t i = 0; i < kCount; ++i) {
    const GLint place = gl_.GetUniformLocation(program.id(), kNames[i]);
    if (place >= 0) gl_.Uniform1i(place, static_cast<GLint>(kFirstUnit + i));
  }
}

}  // namespace hn
