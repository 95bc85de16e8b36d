// Two translation units with different hashes, in one program.
#include <hashnoise/hashnoise.hpp>

float other_hash(float x, float y);

int main() {
  using namespace hashnoise;
  const float here = hn_perlin(vec2(1.25f, 2.375f));
  const float there = other_hash(1.25f, 2.375f);
  const float clouds = hn_clouds(vec3(ivec2(1, 2), 3.5f), 5, 2.0f, 0.5f, 7u);
  const vec4 p(1.25f, -1.5f, 3.75f, -3.875f);
  const vec4 q = hn_position(hn_place(ivec4(1, -2, 3, -4), vec4(0.25f, 0.5f, 0.75f, 0.125f)));
  const vec4 r = hn_position(hn_tile(p, ivec4(2)));
  const bool placed = q.x == p.x && q.y == p.y && q.z == p.z && q.w == p.w && r.x == p.x && r.w == p.w;
  const bool right = placed && here != there &&
                     here == hn_perlin(hn_place(ivec2(vec2(1.25f, 2.375f)), vec2(vec3(0.25f, 0.375f, 1.0f))), 0u) &&
                     clouds >= 0.0f && clouds <= 1.0f;
  return right ? 0 : 1;
}
