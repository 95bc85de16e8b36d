// clang-format off
#include /node_modules/hashnoise/glsl/perlin2d.glsl
#include /node_modules/hashnoise/glsl/fbm2d.glsl
#include /node_modules/hashnoise/glsl/cellular3d.glsl
// clang-format on
