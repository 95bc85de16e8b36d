// hashnoise: the end of what begin.hlsl began.
// SPDX-License-Identifier: MIT

#include "vectors_end.h"
#undef uintBitsToFloat
#undef floatBitsToUint
