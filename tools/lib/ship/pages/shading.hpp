// The functions of GLSL that recipes of the gallery call, and the library does not, and the hills of pictures.
#pragma once

#include <cmath>
#include <hashnoise/hashnoise.hpp>

namespace hashnoise {

inline float sin(float x) { return std::sin(x); }
inline float cos(float x) { return std::cos(x); }
inline float asin(float x) { return std::asin(x); }
inline float pow(float x, float y) { return std::pow(x, y); }
inline float fract(float x) { return x - floor(x); }
inline vec2 fract(vec2 v) { return v - floor(v); }
inline float clamp(float x, float low, float high) { return min(max(x, low), high); }
inline float dot(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline float length(vec2 v) { return std::sqrt(dot(v, v)); }
inline float mix(float from, float to, float t) { return from * (1.0f - t) + to * t; }
inline vec3 mix(vec3 from, vec3 to, float t) { return from * (1.0f - t) + to * t; }
inline float smoothstep(float low, float high, float x) {
  const float t = clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

// The hills that the pictures of gullies begin with.
inline vec3 uneroded(vec2 uv) { return hn_fbm_d(uv * 2.0f, 3, 2.0f, 0.35f, 7u); }

}  // namespace hashnoise
