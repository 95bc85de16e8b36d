// hashnoise in C++: the end of what macros_begin.h began.
// SPDX-License-Identifier: MIT

#pragma pop_macro("None")
#pragma pop_macro("abs")
#pragma pop_macro("byte")
#pragma pop_macro("ceil")
#pragma pop_macro("cos")
#pragma pop_macro("exp")
#pragma pop_macro("log")
#pragma pop_macro("max")
#pragma pop_macro("min")
#pragma pop_macro("pow")
#pragma pop_macro("round")
#pragma pop_macro("sin")
#pragma pop_macro("swap")

#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic pop
#endif
