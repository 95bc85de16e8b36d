#version 330
#extension GL_GOOGLE_include_directive : require
// The same picture by a shader: glslangValidator -l -I../../glsl noise.frag
#define HN_ARITHMETIC HN_FIXED
#include "hashnoise/octaves2d.glsl"
#include "hashnoise/position.glsl"
#include "hashnoise/simplex2d.glsl"

uniform int frame;
out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);  // from the top, if the picture is drawn so
  hn_octaves2 octaves = hn_octaves(hn_place(pixel + ivec2(frame, 0), 1, 64), 4, 2.0, 0.5, 7u);
  do hn_add(octaves, hn_simplex(octaves.place, octaves.seed));
  while (hn_next(octaves));
  int level = (int(hn_mean(octaves) * 2097152.0) >> 13) + 128;
  color = vec4(vec3(float(clamp(level, 0, 255)) / 255.0), 1.0);
}
