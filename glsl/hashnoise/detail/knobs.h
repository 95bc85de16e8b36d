// hashnoise in C++: compares the knobs with the knobs of the text that the translation unit has already. The headers
// include this each time, also where all else of them is there.
// SPDX-License-Identifier: MIT
//
// The text is in a translation unit once. A knob that another file of a unity build defines behind it would be lost,
// without a word. Numbers stand here, since a macro that names another would follow it.

#undef HN_CONFIG_GLSL  // it gives a knob that was undefined its default again
#include "../config.glsl"

#ifndef HN_I_FIRST_ARITHMETIC

#if HN_HASH == 1
#define HN_I_FIRST_HASH 1
#elif HN_HASH == 2
#define HN_I_FIRST_HASH 2
#elif HN_HASH == 3
#define HN_I_FIRST_HASH 3
#elif HN_HASH == 4
#define HN_I_FIRST_HASH 4
#elif HN_HASH == 5
#define HN_I_FIRST_HASH 5
#elif HN_HASH == 6
#define HN_I_FIRST_HASH 6
#elif HN_HASH == 7
#define HN_I_FIRST_HASH 7
#elif HN_HASH == 8
#define HN_I_FIRST_HASH 8
#else
#define HN_I_FIRST_HASH 9
#endif

#if HN_GRADIENT == 1
#define HN_I_FIRST_GRADIENT 1
#else
#define HN_I_FIRST_GRADIENT 2
#endif

#if HN_ARITHMETIC == 1
#define HN_I_FIRST_ARITHMETIC 1
#elif HN_ARITHMETIC == 2
#define HN_I_FIRST_ARITHMETIC 2
#else
#define HN_I_FIRST_ARITHMETIC 3
#endif

#endif

// 32-bit x86 without SSE: sums and products of floats are rounded once they are stored, and not before. It would be
// other bits without a word.
#if HN_ARITHMETIC == 2 && (__FLT_EVAL_METHOD__ == 1 || __FLT_EVAL_METHOD__ == 2)
#error HN_PRECISE needs floats that are rounded after each operation: compile with -msse2 -mfpmath=sse, or take HN_FIXED
#endif

#if HN_HASH != HN_I_FIRST_HASH
#error HN_HASH differs from that of the first include of hashnoise in this translation unit, whose text is in it once: give all files of a unity build the same HN_HASH, by -D, or leave this file out of it
#endif
#if HN_GRADIENT != HN_I_FIRST_GRADIENT
#error HN_GRADIENT differs from that of the first include of hashnoise in this translation unit, whose text is in it once: give all files of a unity build the same HN_GRADIENT, by -D, or leave this file out of it
#endif
#if HN_ARITHMETIC != HN_I_FIRST_ARITHMETIC
#error HN_ARITHMETIC differs from that of the first include of hashnoise in this translation unit, whose text is in it once: give all files of a unity build the same HN_ARITHMETIC, by -D, or leave this file out of it
#endif
