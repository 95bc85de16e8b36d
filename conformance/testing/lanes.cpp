// Prints digests of what the functions of the library are at random points, with the scalar twin or, if LANES is
// defined, with several points at a time. The two print the same. (lanes_test.py compiles it with both.) With
// --faulty-lane a lane takes the value of another.
#include <bit>
#include <cstdio>

static bool faulty_lane = false;

#ifdef LANES
#include <hashnoise/lanes.hpp>

using namespace hashnoise::lanes;
constexpr int kLanes = kCount;
#if defined(HN_LANES_PORTABLE) || defined(_MSC_VER)
static_assert(std::is_class_v<decltype(hn_float().v)> && kCount == 4);
#else
static_assert(!std::is_class_v<decltype(hn_float().v)>);
#endif

#ifdef UNFIT
HN_FN hn_uint unfit(hn_uint x, [[maybe_unused]] hn_uint y) { return UNFIT; }
#endif

float lane(hn_float value, int i) { return value[i]; }
template <typename Number, typename Function>
Number points(Function function) {
  Number numbers;
  for (int i = 0; i < kLanes; ++i) numbers.v[i] = function();
  if (faulty_lane) numbers.v[3] = numbers.v[2];
  return numbers;
}
#else
#include <hashnoise/hashnoise.hpp>

using namespace hashnoise;
constexpr int kLanes = 1;

float lane(hn_float value, int) { return value; }
// lanes::select, for a number.
template <typename Number>
Number select(bool condition, Number a, Number b) {
  return condition ? a : b;
}
template <typename Number, typename Function>
Number points(Function function) {
  return function();
}
#endif

namespace {

#ifdef FEW_POINTS
constexpr int kPoints = 1 << 10;
#else
constexpr int kPoints = 1 << 16;
#endif

// Each number has a generator of its own, so that it does not matter how many points are taken at a time.
class Generator {
 public:
  explicit Generator(std::uint32_t state) : state_(state) {}
  std::uint32_t word() {
    state_ ^= state_ << 13u;
    state_ ^= state_ >> 17u;
    return state_ ^= state_ << 5u;
  }
  float position() {
    return static_cast<float>(static_cast<std::int32_t>(word())) * (1.0f / 4194304.0f);
  }  // [-512, 512)
  float fraction() { return static_cast<float>(word() >> 8u) * (1.0f / 16777216.0f); }

 private:
  std::uint32_t state_;
};

struct Point {
  hn_float x, y, z;
  hn_int cx, cy, cz;
  hn_float fx, fy, fz;
  hn_uint seed;
};

// FNV-1a of the words of a float at each point.
template <typename Function>
void print_digest(const char* name, Function function) {
  Generator x(1u), y(2u), z(3u), cx(4u), cy(5u), cz(6u), fx(7u), fy(8u), fz(9u), seed(10u);
  std::uint64_t digest = 0xCBF29CE484222325u;
  const auto cell_of = [](Generator& g) { return points<hn_int>([&] { return static_cast<std::int32_t>(g.word()); }); };
  const auto position_of = [](Generator& g) { return points<hn_float>([&] { return g.position(); }); };
  const auto fraction_of = [](Generator& g) { return points<hn_float>([&] { return g.fraction(); }); };
  for (int first = 0; first < kPoints; first += kLanes) {
    const Point point{position_of(x),  position_of(y),
                      position_of(z),  cell_of(cx),
                      cell_of(cy),     cell_of(cz),
                      fraction_of(fx), fraction_of(fy),
                      fraction_of(fz), points<hn_uint>([&] { return seed.word(); })};
    const hn_float value = function(point);
    for (int i = 0; i < kLanes; ++i) {
      digest = (digest ^ std::bit_cast<std::uint32_t>(lane(value, i))) * 0x100000001B3u;
    }
  }
  std::printf("%s %016llx\n", name, static_cast<unsigned long long>(digest));
}

}  // namespace

int main(int count, char**) {
  faulty_lane = count > 1;
#ifdef UNFIT
  print_digest("unfit", [](const Point& p) { return hn_unorm(unfit(p.seed, p.seed * 3u)); });
#else
  print_digest("perlin2", [](const Point& p) { return hn_perlin(hn_vec2(p.x, p.y), p.seed); });
  print_digest("perlin3", [](const Point& p) { return hn_perlin(hn_vec3(p.x, p.y, p.z), p.seed); });
  print_digest("perlin2_cell",
               [](const Point& p) { return hn_perlin(hn_place(hn_ivec2(p.cx, p.cy), hn_vec2(p.fx, p.fy)), p.seed); });
  print_digest("perlin3_cell", [](const Point& p) {
    return hn_perlin(hn_place(hn_ivec3(p.cx, p.cy, p.cz), hn_vec3(p.fx, p.fy, p.fz)), p.seed);
  });
  print_digest("value1_cell", [](const Point& p) { return hn_value(hn_place(p.cx, p.fx), p.seed); });
  print_digest("value4", [](const Point& p) { return hn_value(hn_vec4(p.x, p.y, p.z, p.fx), p.seed); });
  print_digest("value_cubic3", [](const Point& p) { return hn_value_cubic(hn_vec3(p.x, p.y, p.z), p.seed); });
  print_digest("value_d3", [](const Point& p) { return hn_value_d(hn_vec3(p.x, p.y, p.z), p.seed).z; });
  print_digest("simplex2", [](const Point& p) { return hn_simplex(hn_vec2(p.x, p.y), p.seed); });
  print_digest("simplex4", [](const Point& p) { return hn_simplex(hn_vec4(p.x, p.y, p.z, p.fx), p.seed); });
  print_digest("simplex_smooth2", [](const Point& p) { return hn_simplex_smooth(hn_vec2(p.x, p.y), p.seed); });
  print_digest("simplex_smooth3", [](const Point& p) { return hn_simplex_smooth(hn_vec3(p.x, p.y, p.z), p.seed); });
  print_digest("simplex2_period",
               [](const Point& p) { return hn_simplex(hn_tile(hn_vec2(p.x, p.y), hn_ivec2(p.cx, p.cy)), p.seed); });
  print_digest("simplex_d3_phase", [](const Point& p) { return hn_simplex_d(hn_vec3(p.x, p.y, p.z), p.fx, p.seed).y; });
  print_digest("curl3", [](const Point& p) { return hn_curl(hn_vec3(p.x, p.y, p.z), p.seed).x; });
  print_digest("cellular2", [](const Point& p) { return hn_cellular(hn_vec2(p.x, p.y), p.seed).y; });
  print_digest("cellular3_manhattan", [](const Point& p) {
    hn_ivec3 nearest;
    hn_vec3 offset;
    const hn_vec2 distances = hn_cellular(hn_tile(hn_vec3(p.x, p.y, p.z), hn_ivec3(p.cx, p.cy, p.cz)), p.fx,
                                          HN_METRIC_MANHATTAN, p.seed, nearest, offset);
    // Not the sum of three floats, which -ffast-math may add in any order.
    return hn_unorm(hn_hash_pcg(floatBitsToUint(distances.y) ^ floatBitsToUint(offset.z) ^ hn_lattice(nearest)));
  });
  print_digest("cellular_three3", [](const Point& p) { return hn_cellular_three(hn_vec3(p.x, p.y, p.z), p.seed).z; });
  print_digest("cellular_d2", [](const Point& p) { return hn_cellular_d(hn_vec2(p.x, p.y), p.seed).y; });
  print_digest("cellular_smooth3", [](const Point& p) { return hn_cellular_smooth(hn_vec3(p.x, p.y, p.z), p.seed); });
  print_digest("cell_border2", [](const Point& p) { return hn_cell_border(hn_vec2(p.x, p.y), p.seed); });
  print_digest("cell_border3", [](const Point& p) { return hn_cell_border(hn_vec3(p.x, p.y, p.z), p.seed); });
  print_digest("perlin2_period",
               [](const Point& p) { return hn_perlin(hn_tile(hn_vec2(p.x, p.y), hn_ivec2(p.cx, p.cy)), p.seed); });
  print_digest("cell",
               [](const Point& p) { return hn_fraction(p.cx, p.cy, p.cz) + hn_unorm(hn_uint(hn_cell(p.cx, 3, 7))); });
  print_digest("select", [](const Point& p) {
    const hn_float folded = select(p.x < p.y && p.z < 0.0f, p.x, -1.5f);
    const hn_uint word = select(p.cx > p.cy, p.seed, 5u) + hn_uint(select(p.cz > 0, 3, p.cx));
    return folded + hn_unorm(word);
  });
#if HN_GRADIENT == HN_GRADIENT_OCTAHEDRAL
  print_digest("perlin1", [](const Point& p) { return hn_perlin(p.x, p.seed); });
  print_digest("perlin4", [](const Point& p) { return hn_perlin(hn_vec4(p.x, p.y, p.z, p.fx), p.seed); });
  print_digest("perlin_d3", [](const Point& p) { return hn_perlin_d(hn_vec3(p.x, p.y, p.z), p.seed).z; });
  print_digest("perlin_d4", [](const Point& p) {
    const auto n = hn_perlin_d(hn_vec4(p.x, p.y, p.z, p.fx), p.seed);
    return n.value + n.gradient.w;
  });
#endif
  print_digest("gradient3", [](const Point& p) { return hn_gradient(hn_ivec3(p.cx, p.cy, p.cz), p.seed).y; });
  print_digest("hash", [](const Point& p) { return hn_unorm(hn_hash(p.seed) ^ hn_lattice(hn_ivec2(p.cx, p.cy))); });
  print_digest("pcg3d", [](const Point& p) { return hn_unorm(hn_hash_pcg3d(hn_uvec3(p.cx, p.cy, p.seed)).z); });
  print_digest("gaussian", [](const Point& p) { return hn_gaussian(p.seed); });
  print_digest("ball", [](const Point& p) {
    const hn_vec3 point = hn_ball(p.seed);
    return point.x + 2.0f * point.y + 3.0f * point.z;
  });
  print_digest("sobol", [](const Point& p) {
    const hn_vec2 point = hn_sobol(hn_uint(p.cx), p.seed);
    return point.x + 2.0f * point.y;
  });
  // Numbers have any size: some points need more steps than others.
  print_digest("shuffle", [](const Point& p) {
    const hn_uint n = hn_uint(p.cy) >> (hn_uint(p.cz) & 31u);
    return hn_unorm(hn_shuffle(hn_uint(p.cx), n, p.seed) << 8u) + hn_unorm(hn_shuffle(hn_uint(p.cx), 1000u, p.seed));
  });
  print_digest("fbm2", [](const Point& p) { return hn_fbm(hn_vec2(p.x, p.y), 4, 2.0f, 0.5f, p.seed); });
  print_digest("fbm2_cell", [](const Point& p) {
    return hn_fbm(hn_place(hn_ivec2(p.cx, p.cy), hn_vec2(p.fx, p.fy)), 4, 2.0f, 0.5f, p.seed);
  });
  print_digest("ridged3", [](const Point& p) { return hn_ridged(hn_vec3(p.x, p.y, p.z), 4, 1.9f, 0.5f, p.seed); });
  print_digest("ping_pong3_cell", [](const Point& p) {
    return hn_ping_pong(hn_place(hn_ivec3(p.cx, p.cy, p.cz), hn_vec3(p.fx, p.fy, p.fz)), 4, 1.9f, 0.5f, 2.0f, p.seed);
  });
  print_digest("weighted2", [](const Point& p) { return hn_weighted(hn_vec2(p.x, p.y), 4, 2.0f, 0.5f, 0.5f, p.seed); });
  print_digest("turbulence3",
               [](const Point& p) { return hn_turbulence(hn_vec3(p.x, p.y, p.z), 3, 2.1f, 0.7f, p.seed); });
  print_digest("clouds2", [](const Point& p) { return hn_clouds(hn_vec2(p.x, p.y), 3, 1.9f, 0.5f, p.seed); });
#endif
}
