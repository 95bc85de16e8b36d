// Islands in the sun. The library stands above this text: main.c puts it there.
uniform vec2 corner;  // of the window, in pixels
uniform int seed;
out vec4 color;

void main() {
  vec3 land = hn_fbm_d((corner + gl_FragCoord.xy) / 128.0, 6, 2.0, 0.5, uint(seed));
  float light = clamp(0.75 + 0.2 * (land.y - land.z), 0.2, 1.2);  // y and z are the slopes along x and y
  vec3 sea = mix(vec3(0.02, 0.10, 0.25), vec3(0.10, 0.45, 0.60), smoothstep(-0.4, 0.0, land.x));
  vec3 rock = mix(vec3(0.35, 0.50, 0.20), vec3(1.0), smoothstep(0.15, 0.35, land.x));
  color = vec4(land.x < 0.0 ? sea : rock * light, 1.0);
}
