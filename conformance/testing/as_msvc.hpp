// Makes Clang show the headers what MSVC shows them: lanes_test.py includes this first, by the flags of msvc.py. The
// C++ library of this machine is GCC's, so its headers come before, with macros that Clang leaves out as MSVC
// does.
#define __STRICT_ANSI__ 1
#define __GNUC_STDC_INLINE__ 1
#define __GCC_ATOMIC_TEST_AND_SET_TRUEVAL 1
#define __GCC_ATOMIC_BOOL_LOCK_FREE 2
#define __GCC_ATOMIC_CHAR8_T_LOCK_FREE 2
#define __GCC_ATOMIC_CHAR16_T_LOCK_FREE 2
#define __GCC_ATOMIC_CHAR32_T_LOCK_FREE 2
#define __GCC_ATOMIC_CHAR_LOCK_FREE 2
#define __GCC_ATOMIC_INT_LOCK_FREE 2
#define __GCC_ATOMIC_LLONG_LOCK_FREE 2
#define __GCC_ATOMIC_LONG_LOCK_FREE 2
#define __GCC_ATOMIC_POINTER_LOCK_FREE 2
#define __GCC_ATOMIC_SHORT_LOCK_FREE 2
#define __GCC_ATOMIC_WCHAR_T_LOCK_FREE 2

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <type_traits>
#ifdef AS_MSVC_WHOLE_LIBRARY  // not lanes alone
#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>
#endif

#undef __GNUC__
#undef __clang__
#undef __SSE2__  // MSVC has no macro for it
#undef __x86_64__
#undef __FAST_MATH__
#define _MSC_VER 1940

// MSVC has no attributes of this kind.
#define __attribute__(...) __attribute__ is not in MSVC
#define __builtin_convertvector __builtin_convertvector is not in MSVC
#define __builtin_memcpy __builtin_memcpy is not in MSVC
#define __builtin_sqrtf __builtin_sqrtf is not in MSVC
#define asm asm is not in MSVC
#define gnu hn_gnu_is_not_in_msvc  // [[gnu::always_inline]] and so on, which MSVC ignores with a warning
