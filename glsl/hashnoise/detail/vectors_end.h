// hashnoise: the end of what vectors_begin.h began.
// SPDX-License-Identifier: MIT

#undef vec2
#undef vec3
#undef vec4
#undef ivec2
#undef ivec3
#undef ivec4
#undef uvec2
#undef uvec3
#undef uvec4
