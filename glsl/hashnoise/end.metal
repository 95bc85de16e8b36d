// hashnoise: the end of what begin.metal began.
// SPDX-License-Identifier: MIT

}  // namespace hashnoise
#include "detail/vectors_end.h"
#undef uintBitsToFloat
#undef floatBitsToUint
