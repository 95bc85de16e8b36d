// Erosion by drops of water that run down a grid of heights, to compare hn_gullies with (docs/reference/fractals.md).
// No shader can do that at a point by itself, which is what gullies are for.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <hashnoise/hashnoise.hpp>
#include <vector>

namespace hashnoise {

// The hills that the pictures of gullies begin with.
inline vec3 uneroded(vec2 uv) { return hn_fbm_d(uv * 2.0f, 3, 2.0f, 0.35f, 7u); }

class ErodedGrid {
 public:
  ErodedGrid() : heights_(kSide * kSide) {
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) at(x, y) = uneroded(vec2(float(x), float(y)) * (1.0f / kSide)).x * kScale;
    }
    for (std::uint32_t drop = 0; drop < kDrops; ++drop) {
      const vec2 start = hn_unorm_two(hn_lattice(int(drop), 7u));
      run(start * float(kSide - 2));
    }
  }

  // How steep it is along x, per width of the picture.
  float slope(vec2 uv) const {
    const int x = std::clamp(int(uv.x * kSide), 1, kSide - 2);
    const int y = std::clamp(int(uv.y * kSide), 0, kSide - 1);
    return (at(x + 1, y) - at(x - 1, y)) * 0.5f * kSide / kScale;
  }

 private:
  static constexpr int kSide = 256;
  static constexpr std::uint32_t kDrops = 150'000;
  static constexpr int kSteps = 48;        // of a drop, each one point of the grid long
  static constexpr float kScale = 64.0f;   // heights are in units of the grid's points, for slopes near 1
  static constexpr float kInertia = 0.1f;  // how much of its direction a drop keeps
  static constexpr float kCapacity = 4.0f;
  static constexpr float kLeast = 0.01f;  // slope by which a capacity counts
  static constexpr float kErode = 0.3f;
  static constexpr float kSettle = 0.3f;
  static constexpr float kEvaporate = 0.02f;

  float& at(int x, int y) { return heights_[std::size_t(y) * kSide + std::size_t(x)]; }
  float at(int x, int y) const { return heights_[std::size_t(y) * kSide + std::size_t(x)]; }

  // The height at a place and its derivatives, between four points.
  vec3 height(vec2 p) const {
    const int x = int(p.x), y = int(p.y);
    const float u = p.x - float(x), v = p.y - float(y);
    const float a = at(x, y), b = at(x + 1, y), c = at(x, y + 1), d = at(x + 1, y + 1);
    return vec3((a * (1.0f - u) + b * u) * (1.0f - v) + (c * (1.0f - u) + d * u) * v,
                (b - a) * (1.0f - v) + (d - c) * v, (c - a) * (1.0f - u) + (d - b) * u);
  }

  void add(vec2 p, float amount) {
    const int x = int(p.x), y = int(p.y);
    const float u = p.x - float(x), v = p.y - float(y);
    at(x, y) += amount * (1.0f - u) * (1.0f - v);
    at(x + 1, y) += amount * u * (1.0f - v);
    at(x, y + 1) += amount * (1.0f - u) * v;
    at(x + 1, y + 1) += amount * u * v;
  }

  static bool is_inside(vec2 p) { return p.x >= 0.0f && p.y >= 0.0f && p.x < kSide - 1 && p.y < kSide - 1; }

  // A drop takes up ground as it speeds up, and leaves it where it slows down or must climb.
  void run(vec2 p) {
    vec2 direction(0.0f, 0.0f);
    float water = 1.0f, speed = 1.0f, load = 0.0f;
    for (int step = 0; step < kSteps; ++step) {
      const vec3 here = height(p);
      direction = direction * kInertia - vec2(here.y, here.z) * (1.0f - kInertia);
      const float length = std::sqrt(direction.x * direction.x + direction.y * direction.y);
      if (length < 1e-6f) return;
      direction = direction * (1.0f / length);
      const vec2 next = p + direction;
      if (!is_inside(next)) return;
      const float rise = height(next).x - here.x;
      const float capacity = std::max(-rise, kLeast) * speed * water * kCapacity;
      float left = (load - capacity) * kSettle;  // on the ground
      if (rise > 0.0f)
        left = std::min(rise, load);
      else if (load < capacity)
        left = -std::min((capacity - load) * kErode, -rise);
      load -= left;
      add(p, left);
      speed = std::sqrt(std::max(speed * speed - rise, 0.01f));
      water *= 1.0f - kEvaporate;
      p = next;
    }
  }

  std::vector<float> heights_;
};

inline float simulated_slope(vec2 uv) {
  static const ErodedGrid grid;
  return grid.slope(uv);
}

}  // namespace hashnoise
