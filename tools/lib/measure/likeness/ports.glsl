// Noises that pages of others show, in our words: two nodes of Unity's Shader Graph 12.1, and sums of value noise as
// snippets have them, which do not divide by the sum of their weights.

vec2 direction(vec2 corner) {
  corner = mod(corner, 289.0);
  float hash = mod((34.0 * corner.x + 1.0) * corner.x, 289.0) + corner.y;
  hash = mod((34.0 * hash + 1.0) * hash, 289.0);
  float turn = 2.0 * fract(hash / 41.0) - 1.0;
  return normalize(vec2(turn - floor(turn + 0.5), abs(turn) - 0.5));
}

float ramp(vec2 corner, vec2 offset, vec2 f) { return dot(direction(corner + offset), f - offset); }

float gradient_noise(vec2 p) {
  vec2 corner = floor(p), f = fract(p);
  vec2 blend = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec2 low = vec2(ramp(corner, vec2(0.0, 0.0), f), ramp(corner, vec2(0.0, 1.0), f));
  vec2 high = vec2(ramp(corner, vec2(1.0, 0.0), f), ramp(corner, vec2(1.0, 1.0), f));
  vec2 both = mix(low, high, blend.x);
  return 0.5 + mix(both.x, both.y, blend.y);
}

float random(vec2 corner) { return fract(43758.5453 * sin(dot(corner, vec2(12.9898, 78.233)))); }

float value_noise(vec2 p) {
  vec2 corner = floor(p), f = fract(p);
  vec2 blend = f * f * (3.0 - 2.0 * f);
  vec2 low = vec2(random(corner), random(corner + vec2(0.0, 1.0)));
  vec2 high = vec2(random(corner + vec2(1.0, 0.0)), random(corner + vec2(1.0, 1.0)));
  vec2 both = mix(low, high, blend.x);
  return mix(both.x, both.y, blend.y);
}

float simple_noise(vec2 p) { return 0.125 * value_noise(p) + 0.25 * value_noise(p / 2.0) + 0.5 * value_noise(p / 4.0); }

float value_noise(vec3 p) {
  vec3 corner = floor(p), f = fract(p);
  vec3 blend = f * f * (3.0 - 2.0 * f);
  float slices[2];
  for (int z = 0; z < 2; ++z) {
    vec2 next = corner.xy + 37.0 * (corner.z + float(z)) * vec2(1.0, 3.0);
    vec2 low = vec2(random(next), random(next + vec2(0.0, 1.0)));
    vec2 high = vec2(random(next + vec2(1.0, 0.0)), random(next + vec2(1.0, 1.0)));
    vec2 both = mix(low, high, blend.x);
    slices[z] = mix(both.x, both.y, blend.y);
  }
  return mix(slices[0], slices[1], blend.z);
}

float value_sum(vec2 p) {
  float sum = 0.0;
  for (float weight = 0.5; weight > 0.02; weight *= 0.5, p = 2.0 * p + 31.7) sum += weight * value_noise(p);
  return sum;
}

float value_sum(vec3 p) {
  float sum = 0.0;
  for (float weight = 0.5; weight > 0.02; weight *= 0.5, p = 2.0 * p + 31.7) sum += weight * value_noise(p);
  return sum;
}
