// Perlin's noise of 2002 in 2D and 3D over any gradient at a lattice point. Included by the files beside it.
//
// PERLIN_NAME: the functions to declare. PERLIN_GRADIENT(cell): a vec2 or vec3 for an ivec2 or ivec3. Both are undefined
// again at the end.

float PERLIN_NAME(vec2 p) {
  ivec2 cell = ivec2(floor(p));
  vec2 f = p - floor(p);
  vec2 t = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float n00 = dot(PERLIN_GRADIENT(cell), f);
  float n10 = dot(PERLIN_GRADIENT(cell + ivec2(1, 0)), f - vec2(1.0, 0.0));
  float n01 = dot(PERLIN_GRADIENT(cell + ivec2(0, 1)), f - vec2(0.0, 1.0));
  float n11 = dot(PERLIN_GRADIENT(cell + ivec2(1, 1)), f - vec2(1.0, 1.0));
  return mix(mix(n00, n10, t.x), mix(n01, n11, t.x), t.y);
}

float PERLIN_NAME(vec3 p) {
  ivec3 cell = ivec3(floor(p));
  vec3 f = p - floor(p);
  vec3 t = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  float n000 = dot(PERLIN_GRADIENT(cell), f);
  float n100 = dot(PERLIN_GRADIENT(cell + ivec3(1, 0, 0)), f - vec3(1.0, 0.0, 0.0));
  float n010 = dot(PERLIN_GRADIENT(cell + ivec3(0, 1, 0)), f - vec3(0.0, 1.0, 0.0));
  float n110 = dot(PERLIN_GRADIENT(cell + ivec3(1, 1, 0)), f - vec3(1.0, 1.0, 0.0));
  float n001 = dot(PERLIN_GRADIENT(cell + ivec3(0, 0, 1)), f - vec3(0.0, 0.0, 1.0));
  float n101 = dot(PERLIN_GRADIENT(cell + ivec3(1, 0, 1)), f - vec3(1.0, 0.0, 1.0));
  float n011 = dot(PERLIN_GRADIENT(cell + ivec3(0, 1, 1)), f - vec3(0.0, 1.0, 1.0));
  float n111 = dot(PERLIN_GRADIENT(cell + ivec3(1, 1, 1)), f - vec3(1.0, 1.0, 1.0));
  float n0 = mix(mix(n000, n100, t.x), mix(n010, n110, t.x), t.y);
  float n1 = mix(mix(n001, n101, t.x), mix(n011, n111, t.x), t.y);
  return mix(n0, n1, t.z);
}

#undef PERLIN_NAME
#undef PERLIN_GRADIENT
