// hashnoise: all functions of the library in Metal's shading language, in namespace hashnoise. They are the text of the
// GLSL. See begin.metal for a part of them.
// SPDX-License-Identifier: MIT

#include <metal_stdlib>
#include "begin.metal"
#include "hashnoise.glsl"
#include "end.metal"
