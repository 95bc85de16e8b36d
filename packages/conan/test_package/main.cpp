#define HN_ARITHMETIC HN_FIXED
#include <cstdio>
#include <hashnoise/hashnoise.hpp>

int main() {
  const float value = hashnoise::hn_perlin(hashnoise::vec2(13.75f, -6.5f), 7u);
  std::printf("hn_perlin at (13.75, -6.5) is %a\n", static_cast<double>(value));
  return value == -0x1.007b3p-1f ? 0 : 1;  // HN_FIXED has these bits everywhere
}
