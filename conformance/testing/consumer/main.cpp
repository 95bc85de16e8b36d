// Two translation units with different hashes, in one program.
#include <hashnoise/hashnoise.hpp>

float other_hash(float x, float y);

int main() {
  using namespace hashnoise;
  const float here = hn_perlin(vec2(1.25f, 2.5f));
  const float there = other_hash(1.25f, 2.5f);
  const float clouds = hn_clouds(vec3(ivec2(1, 2), 3.5f), 5, 2.0f, 0.5f, 7u);
  const bool right = here != there &&
                     here == hn_perlin(hn_place(ivec2(vec2(1.25f, 2.5f)), vec2(vec3(0.25f, 0.5f, 1.0f))), 0u) &&
                     clouds >= 0.0f && clouds <= 1.0f;
  return right ? 0 : 1;
}
