#include "output/gzip.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

namespace hn {
namespace {

std::string unpacked(const std::string& packed) {
  z_stream stream = {};
  inflateInit2(&stream, MAX_WBITS + 16);  // gzip only
  std::string data(1 << 20, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(data.data());
  stream.avail_out = static_cast<uInt>(data.size());
  const int status = inflate(&stream, Z_FINISH);
  data.resize(stream.total_out);
  inflateEnd(&stream);
  return status == Z_STREAM_END ? data : "not gzip";
}

TEST(Gzip, UnpacksToTheSame) {
  std::string data;
  for (unsigned i = 0; i < 100'000; ++i) data += static_cast<char>(i * i % 251);
  for (const std::string& text : {std::string(), std::string("a"), std::string(3, '\0'), data}) {
    EXPECT_EQ(unpacked(to_gzip(text)), text);
  }
}

TEST(Gzip, MakesRepetitionsSmall) { EXPECT_LT(to_gzip(std::string(100'000, 'a')).size(), 500u); }

TEST(Gzip, IsTheSameEachTime) { EXPECT_EQ(to_gzip("the same"), to_gzip("the same")); }

}  // namespace
}  // namespace hn
