// hashnoise: all functions of the library in HLSL, from the text of the GLSL. See begin.hlsl for a part of them.
// SPDX-License-Identifier: MIT

#include "begin.hlsl"
#include "hashnoise.glsl"
#include "end.hlsl"
