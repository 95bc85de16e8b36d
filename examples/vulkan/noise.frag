#version 450
#extension GL_GOOGLE_include_directive : require
#define HN_ARITHMETIC HN_FIXED
#include "hashnoise/hashnoise.glsl"
#include "height.glsl"

layout(push_constant) uniform Push { ivec2 corner; };
layout(location = 0) out vec4 color;

void main() {
  float h = height(corner + ivec2(gl_FragCoord.xy));
  vec3 sea = mix(vec3(0.02, 0.10, 0.25), vec3(0.10, 0.45, 0.60), smoothstep(-0.4, 0.0, h));
  vec3 land = mix(vec3(0.35, 0.50, 0.20), vec3(1.0), smoothstep(0.05, 0.4, h));
  color = vec4(h < 0.0 ? sea : land, 1.0);
}
