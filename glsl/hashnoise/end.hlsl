// hashnoise: the end of what begin.hlsl began.
// SPDX-License-Identifier: MIT

#include "detail/vectors_end.h"
#undef uintBitsToFloat
#undef floatBitsToUint
