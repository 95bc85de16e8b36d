// hashnoise: version, knobs and what each language needs. Included by every other file; it declares no function.
// SPDX-License-Identifier: MIT
//
// Knobs are macros that you may define before the first include of any hashnoise file.
//
//   HN_HASH          which hash: one of the HN_HASH_... below. Default HN_HASH_LATTICE.
//   HN_HASH_FN(k)    with HN_HASH_CUSTOM: your hash, which takes and returns a uint.
//   HN_GRADIENT      how the noise makes a gradient from a hash: HN_GRADIENT_OCTAHEDRAL (the default), or
//                    HN_GRADIENT_SINE, the paper's gradient, for those who want its noise.
//   HN_ARITHMETIC    how the noise is computed. HN_FAST (the default): in floats, within a stated error. HN_PRECISE:
//                    in floats with the bits of IEEE arithmetic, from GLSL 4.00 and GLSL ES 3.20 on. HN_FIXED: in
//                    integers, with the same bits on every driver.

#ifndef HN_CONFIG_GLSL
#define HN_CONFIG_GLSL

#define HN_VERSION_MAJOR 1
#define HN_VERSION_MINOR 1
#define HN_VERSION_PATCH 0

// ---------------------------------------------------------------------------------------------------------------------
// The language and its version are distinguished here, and nowhere else:
//
//   HN_FN              stands before every function
//   HN_I_BITCAST       whether uintBitsToFloat exists; else the same values are computed by exact arithmetic
//   HN_I_HAS_PRECISE   whether HN_PRECISE is possible. HN_I_KEYWORD then stands before what is rounded on its own
//   HN_I_OUT(type)     a parameter that the function sets, and HN_I_INOUT(type), one that it changes
//   HN_I_NEW(type, x)  declares a struct x, whose members are set one by one
//   HN_I_MADE(type)    stands in the struct of a place. In C++ no list of numbers is a place then: in
//                      hn_perlin({x, y}, 7u) they are a position
//   HN_I_HIGHP         stands before every type. GLSL ES has three precisions. In fragment shaders an int is mediump,
//                      with 16 bits, unless the declaration has highp. Your own default precision stays as it is.
//                      Elsewhere it is empty: nothing is needed, and glslang would warn
//   HN_I_HIGHP_HERE    makes highp the default precision of floats to the end of the function it begins (word.glsl)
//
// begin.hlsl and begin.metal name their languages. __VERSION__ is read only where it is a number: DXC defines a string,
// and so do the preprocessors of GCC and Clang (for an older GLSL: cpp -undef -D__VERSION__=130). A compiler without it
// counts as a new one. In glslang, which defines the GL_GOOGLE name, it has a value although it is not "defined".

#ifdef __cplusplus
#define HN_I_BITCAST 1
#define HN_I_HIGHP_HERE
#define HN_I_KEYWORD  // the compiler's flags decide, and Metal has no such keyword
#ifdef HN_I_METAL
#define HN_FN inline
#define HN_I_OUT(type) thread type&
#define HN_I_INOUT(type) thread type&
#define HN_I_NEW(type, name) type name
#define HN_I_MADE(type)
#define HN_I_HAS_PRECISE 0
#else
// Compilers vectorize a loop over a noise only if the whole noise is inlined into it. A small program calls it.
#if defined(HN_I_CALLED)
#define HN_FN static
#else
#define HN_FN HN_I_INLINE  // glsl.hpp
#endif
#define HN_I_OUT(type) type&
#define HN_I_INOUT(type) type&
// clang-format off
#define HN_I_NEW(type, name) type name{}  // without the braces -Weffc++ warns
#define HN_I_MADE(type) HN_I_INLINE type() : cell(), fraction(), rest(), period(), tiled() {}
// clang-format on
#define HN_I_HAS_PRECISE 1
#endif
#else
#define HN_FN
#define HN_I_OUT(type) out type
#define HN_I_INOUT(type) inout type
#define HN_I_NEW(type, name) type name
#define HN_I_MADE(type)
#define HN_I_KEYWORD precise
#if (!defined(__VERSION__) && !defined(GL_GOOGLE_cpp_style_line_directive)) || defined(__GNUC__) || defined(HN_I_HLSL)
#define HN_I_VERSION 460
#else
#define HN_I_VERSION __VERSION__
#endif
#ifdef GL_ES
#if HN_I_VERSION < 300
#error hashnoise needs GLSL ES 3.00 or later: the version line has to be 300 es
#endif
#define HN_I_BITCAST 1
#define HN_I_HAS_PRECISE (HN_I_VERSION >= 320)
#define HN_I_HIGHP highp
#define HN_I_HIGHP_HERE precision highp float;
#else
#if HN_I_VERSION < 130
#error hashnoise needs GLSL 1.30 or later: the version line has to be 130
#endif
#define HN_I_BITCAST (HN_I_VERSION >= 330)
#define HN_I_HAS_PRECISE (HN_I_VERSION >= 400)
#define HN_I_HIGHP
#define HN_I_HIGHP_HERE
#endif
#endif

// The types in declarations. Constructors have GLSL's own names. In C++ glsl.hpp defines these names, in HLSL and Metal
// vectors_begin.h.
#ifndef __cplusplus
#ifndef HN_I_HLSL
#define hn_float HN_I_HIGHP float
#define hn_vec2 HN_I_HIGHP vec2
#define hn_vec3 HN_I_HIGHP vec3
#define hn_vec4 HN_I_HIGHP vec4
#define hn_int HN_I_HIGHP int
#define hn_ivec2 HN_I_HIGHP ivec2
#define hn_ivec3 HN_I_HIGHP ivec3
#define hn_ivec4 HN_I_HIGHP ivec4
#define hn_uint HN_I_HIGHP uint
#define hn_uvec2 HN_I_HIGHP uvec2
#define hn_uvec3 HN_I_HIGHP uvec3
#define hn_uvec4 HN_I_HIGHP uvec4
#endif
#endif

// ---------------------------------------------------------------------------------------------------------------------
// The knobs.

#define HN_HASH_FNV1 1
#define HN_HASH_PARTIAL_FNV1 2
#define HN_HASH_JENKINS 3
#define HN_HASH_PARTIAL_JENKINS 4
#define HN_HASH_MURMUR 5
#define HN_HASH_PCG 6
#define HN_HASH_XXHASH32 7
#define HN_HASH_LATTICE 8
#define HN_HASH_CUSTOM 9

#ifndef HN_HASH
#define HN_HASH HN_HASH_LATTICE
#endif

#if HN_HASH < 1 || HN_HASH > 9
#error HN_HASH must be one of HN_HASH_FNV1, HN_HASH_PARTIAL_FNV1, HN_HASH_JENKINS, HN_HASH_PARTIAL_JENKINS, HN_HASH_MURMUR, HN_HASH_PCG, HN_HASH_XXHASH32, HN_HASH_LATTICE, HN_HASH_CUSTOM
#endif

#define HN_GRADIENT_OCTAHEDRAL 1
#define HN_GRADIENT_SINE 2

#ifndef HN_GRADIENT
#define HN_GRADIENT HN_GRADIENT_OCTAHEDRAL
#endif

#if HN_GRADIENT < 1 || HN_GRADIENT > 2
#error HN_GRADIENT must be HN_GRADIENT_OCTAHEDRAL or HN_GRADIENT_SINE
#endif

#define HN_FAST 1
#define HN_PRECISE 2
#define HN_FIXED 3

#ifndef HN_ARITHMETIC
#define HN_ARITHMETIC HN_FAST
#endif

#if HN_ARITHMETIC < 1 || HN_ARITHMETIC > 3
#error HN_ARITHMETIC must be one of HN_FAST, HN_PRECISE, HN_FIXED
#endif

#if HN_ARITHMETIC == HN_PRECISE && !HN_I_HAS_PRECISE
#error HN_PRECISE needs GLSL 4.00, GLSL ES 3.20, HLSL or C++: let the version line be 400 or 320 es, or take HN_FIXED
#endif

// Stands before the type of every computed float: each operation is rounded on its own, in the order that is written.
// The qualifier does not reach through a call, so it stands on the locals of every step.
#if HN_ARITHMETIC == HN_PRECISE
#define HN_I_PRECISE HN_I_KEYWORD
#else
#define HN_I_PRECISE
#endif

// Stands before the type of a float that no compiler may take apart. With HN_FAST compilers of SPIR-V turn (p - q) - 1
// into (p - 1) - q where p is a constant, and that is rounded far out; SPIRV-Tools does so unless p - q is precise, and
// NVIDIA's driver unless the difference from it is, too. No compiler of OpenGL was seen to do it.
#if HN_ARITHMETIC == HN_PRECISE || (defined(VULKAN) && HN_I_HAS_PRECISE)
#define HN_I_AS_WRITTEN HN_I_KEYWORD
#else
#define HN_I_AS_WRITTEN
#endif

#if HN_HASH == HN_HASH_CUSTOM && !defined(HN_HASH_FN)
#error HN_HASH_CUSTOM needs your hash: define HN_HASH_FN(k), which takes and returns a uint, before the include
#endif

#endif
