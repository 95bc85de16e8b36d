// hashnoise in C++: puts away what Arduino, X11 and windows.h define of the headers' names. macros_end.h ends it.
// SPDX-License-Identifier: MIT

#pragma push_macro("None")
#undef None
#pragma push_macro("abs")
#undef abs
#pragma push_macro("byte")
#undef byte
#pragma push_macro("ceil")
#undef ceil
#pragma push_macro("cos")
#undef cos
#pragma push_macro("exp")
#undef exp
#pragma push_macro("log")
#undef log
#pragma push_macro("max")
#undef max
#pragma push_macro("min")
#undef min
#pragma push_macro("pow")
#undef pow
#pragma push_macro("round")
#undef round
#pragma push_macro("sin")
#undef sin
#pragma push_macro("swap")
#undef swap

// Programs that enable such warnings shall not see ours: the text compares floats where it means to.
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wfloat-equal"
#endif
