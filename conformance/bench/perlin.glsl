// Perlin's noise of 2002 in 2D and 3D from the gradients at the corners of a cell and the position in it. Included by
// the files beside it.

#ifndef HN_PAPER_PERLIN_GLSL
#define HN_PAPER_PERLIN_GLSL

float perlin_sum(vec2 f, vec2 g00, vec2 g10, vec2 g01, vec2 g11) {
  vec2 t = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float n00 = dot(g00, f);
  float n10 = dot(g10, f - vec2(1.0, 0.0));
  float n01 = dot(g01, f - vec2(0.0, 1.0));
  float n11 = dot(g11, f - vec2(1.0, 1.0));
  return mix(mix(n00, n10, t.x), mix(n01, n11, t.x), t.y);
}

float perlin_sum(vec3 f, vec3 g000, vec3 g100, vec3 g010, vec3 g110, vec3 g001, vec3 g101, vec3 g011, vec3 g111) {
  vec3 t = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float n000 = dot(g000, f);
  float n100 = dot(g100, f - vec3(1.0, 0.0, 0.0));
  float n010 = dot(g010, f - vec3(0.0, 1.0, 0.0));
  float n110 = dot(g110, f - vec3(1.0, 1.0, 0.0));
  float n001 = dot(g001, f - vec3(0.0, 0.0, 1.0));
  float n101 = dot(g101, f - vec3(1.0, 0.0, 1.0));
  float n011 = dot(g011, f - vec3(0.0, 1.0, 1.0));
  float n111 = dot(g111, f - vec3(1.0, 1.0, 1.0));
  float n0 = mix(mix(n000, n100, t.x), mix(n010, n110, t.x), t.y);
  float n1 = mix(mix(n001, n101, t.x), mix(n011, n111, t.x), t.y);
  return mix(n0, n1, t.z);
}

#endif
