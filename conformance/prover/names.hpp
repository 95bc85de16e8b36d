// GLSL's names of the types and vectors of Float, Int and Uint: both texts of numbers include this in their namespaces.

using vec2 = hashnoise::Vector2<Float>;
using vec3 = hashnoise::Vector3<Float>;
using vec4 = hashnoise::Vector4<Float>;
using uint = Uint;
using ivec2 = hashnoise::Vector2<Int>;
using ivec3 = hashnoise::Vector3<Int>;
using ivec4 = hashnoise::Vector4<Int>;
using uvec2 = hashnoise::Vector2<Uint>;
using uvec3 = hashnoise::Vector3<Uint>;
using uvec4 = hashnoise::Vector4<Uint>;
using hn_float = Float;
using hn_vec2 = vec2;
using hn_vec3 = vec3;
using hn_vec4 = vec4;
using hn_int = Int;
using hn_ivec2 = ivec2;
using hn_ivec3 = ivec3;
using hn_ivec4 = ivec4;
using hn_uint = Uint;
using hn_uvec2 = uvec2;
using hn_uvec3 = uvec3;
using hn_uvec4 = uvec4;
inline vec2 floor(vec2 v) { return {floor(v.x), floor(v.y)}; }
inline vec3 floor(vec3 v) { return {floor(v.x), floor(v.y), floor(v.z)}; }
inline vec4 floor(vec4 v) { return {floor(v.x), floor(v.y), floor(v.z), floor(v.w)}; }
inline vec3 uintBitsToFloat(uvec3 v) { return {uintBitsToFloat(v.x), uintBitsToFloat(v.y), uintBitsToFloat(v.z)}; }
inline uvec3 floatBitsToUint(vec3 v) { return {floatBitsToUint(v.x), floatBitsToUint(v.y), floatBitsToUint(v.z)}; }

// The bodies of rows of the suite's table read and return words.
#define SEEDED(s) , s
#define SEED(s) s
inline Float float_of(const Uint& bits) { return uintBitsToFloat(bits); }
inline Uint bits_of(const Float& x) { return floatBitsToUint(x); }
