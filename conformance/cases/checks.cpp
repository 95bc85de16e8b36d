#include <array>

#include "cases/case.hpp"

namespace hn {
namespace {

constexpr auto kDescriptions = std::to_array<CheckDescription>({
    {"golden",
     "48 points or more have the oracle's values. For `hn_hash` and `hn_lattice` so has the digest of 16,384 more, "
     "and for what makes words of them that of 64 or 256."},
    {"twin",
     "Random points have the values of the C++ twin, in any stage: 65,536 with the defaults in the main version of "
     "desktop OpenGL, a quarter of them for octave sums, derivatives, noises in 4D and for other settings, and a "
     "quarter in other versions. With `--thorough` there are 262,144, and a sixteenth in other versions. On softpipe "
     "there are 4,096, with `--points N` there are N. The points are near, negative, at 2^20 cells and more, on "
     "lattice lines and beside them; for `precise` and `fixed` also subnormal, tiny, -0, huge and at the thresholds "
     "below which `precise` takes 0, and for octave sums of `precise` tiny with a lacunarity of 2^20 to 2^126."},
    {"range",
     "65,536 values (16,384 of octave sums, derivatives and noises in 4D) lie in the range that the library promises, "
     "and those of noises reach into its ends."},
    {"zero",
     "At as many lattice points the noise is 0. Half of those of simplex noise are no corners of cells, as far as "
     "floats hold them."},
    {"seams",
     "Pairs of neighbours, 4,096 of them 2^-16 or 2^-15 of a cell apart, have values and derivatives that differ by "
     "no more than the proven slope allows, and twice the tolerance. The pairs lie at the walls of cells and, for "
     "simplex noise, at the planes where other lattice points begin to count."},
    {"finite",
     "At the points of `range`, and at subnormal, tiny and huge coordinates up to 3.4e38 (2^96 for octave sums of "
     "floats), values are numbers in their range. Settings that are cut off are among the points. Where all "
     "coordinates are 2^23 or more, a gradient noise is 0. With `fixed` infinities have the bits of the nearest "
     "float, except for a phase, and NaN have a value in the range. So have octave sums with any arithmetic, also of "
     "up to 2^31 - 1 octaves, and where floats overflow; derivatives of floats are numbers."},
    {"seeds", "Fields of different seeds do not correlate, at 16,384 points."},
    {"mirror", "A field does not correlate with its reflections, at 16,384 points."},
    {"derivative",
     "At 512 points derivatives are those of the polynomial that the noise is along each axis of a cell, through "
     "seven values of the noise on the same driver, within the errors of both. A third of the points lie at an end of "
     "the cell. Simplex noise is no such polynomial: there the difference to both sides takes its place, with an "
     "error that follows from a bound on the third derivative. At 2,048 points the derivatives of octave sums of "
     "floats are those differences of the sum without derivatives: of up to three octaves within 16 cells of the "
     "origin."},
    {"divergence",
     "At 2,048 points the differences of the components of a curl, each along its own axis, sum to less than a "
     "hundredth of what is summed, on average. A sum of curls has up to three octaves there."},
    {"search",
     "At 2,048 points (512 of costly functions) cellular noise has the values that a search of 7 cells along each "
     "axis finds, in C++ and from the contract alone: bit by bit with `fixed`, else within the tolerance. Among the "
     "points are walls, middles, feature points, places halfway between two of them, and for third distances places "
     "that need cells two steps away. With floats, names, vectors and derivatives are left out where the two nearest "
     "points are within 2^-12 of equally near, and that may be one value in eight."},
    {"cell_names",
     "At as many points the name of the nearest point, the vector to it and the first distance belong together: the "
     "point of the cell of that name is where the vector leads, modulo the period, and at that distance. They are the "
     "same from a position, from its cell, and from the next cell with a fraction of 1 in place of 0."},
    {"returned", "At as many points a function that sets the nearest point returns what the form without it does."},
    {"border",
     "At as many points the distance to a border is between half the difference and half the sum of the two "
     "distances, and 0 halfway between the two nearest points."},
    {"derivative_value", "The value that comes with a derivative is that of the noise, or of the octave sum."},
    {"loop",
     "Phases that are whole turns apart, up to 2^16 of either sign, give the same bits, with every arithmetic."},
    {"half_turn", "Half a turn gives the negative within twice the tolerance."},
    {"phase_zero",
     "A phase of whole turns gives the noise without a phase, and its derivatives, within the tolerances of both; in "
     "space times 879/985 for Perlin noise, and 4902/4918 for simplex noise."},
    {"period",
     "4,096 points that are whole periods apart have the same bits, in cells beside the seam and anywhere, with "
     "periods from 1 to 2^31 - 1 and none. Simplex noise on the plane repeats after 2^31 cells without a period. "
     "Octave sums of a whole lacunarity repeat, too, `fixed` ones of up to 15 octaves; `fast` ones, and progressive "
     "warps of floats at positions, are the same within the tolerance."},
    {"wrapped",
     "Without a period along any axis, and where a cell reaches no seam, a tile has the values of the form without, "
     "at the cell modulo the period."},
    {"from_cell",
     "An octave sum from a cell and a fraction is that at the position that is their sum; `precise` as `fast`."},
    {"whole_detail", "With a float of octaves that is a whole number `hn_fbm` is that with an int of them."},
    {"small_footprint",
     "With a footprint of 0, and up to half a cell of the last octave, `hn_fbm` is that without one; `precise` as "
     "`fast`."},
    {"zero_strength", "With a strength of 0, or below, `hn_eroded` is `hn_fbm`; `precise` as `fast`."},
    {"zero_bandwidth", "With a bandwidth of 0, or below, `hn_phasor` is that without one."},
    {"constant_period",
     "4,096 points have the same values when the periods are constants of the shader, within twice the tolerance for "
     "`fast`."},
    {"unseeded",
     "The overloads without a seed have the words of those with the seed 0: of all functions of a file at 16 points "
     "each (`perlin2d.all`), with `--thorough` of each function within the tolerance of the twin, at as many as "
     "`range` takes."},
    {"other_noise",
     "An octave sum of the library over a constant noise has the value that follows by hand, at as many points as "
     "`range` takes; one that cuts off the noise of an octave, over a noise beyond 1 and one beyond -1, too, and one "
     "that cuts off its slopes, over steeper ones."},
    {"positions",
     "A place that is made of a cell and a fraction, of a cell alone, of a position, or of whole units has that "
     "position in the first octave of a sum, bit by bit, and with a fraction of 1 that cell: at 64 places of each "
     "kind in each dimension."},
    {"inlined",
     "4,096 random points have the same values when the function's body stands in main. For this check and the next "
     "five, `fast` values agree within twice the tolerance, all others bit by bit."},
    {"in_loop", "So they have in a loop whose number of trips is a uniform. Each trip leaves one word of the result."},
    {"constant_seed", "So they have when the seed is a constant of the shader."},
    {"uniform_seed", "So they have when the seed is a uniform."},
    {"folded", "4 points have the same values when they are constants of the shader, which the compiler may evaluate."},
    {"as_fragment",
     "4,096 random points have the same values in the vertex or the compute stage as in the fragment stage of GLSL "
     "3.30 or ES 3.00."},
    {"glslang", "The file, included twice, compiles without a warning from glslang."},
    {"spirv", "The file, included twice, compiles to SPIR-V that spirv-val accepts."},
    {"driver", "The file, included twice, compiles and links on the driver."},
    {"highp",
     "In the SPIR-V of the ES 3.10 shaders, whose default precision is mediump, nothing has relaxed precision."},
    {"uncontracted",
     "In the SPIR-V of the Vulkan shaders with `HN_PRECISE`, NoContraction marks every operation on floats that "
     "rounds."},
    {"refused_by_glslang",
     "Too old a version, a wrong knob, or one that is defined after the include, is an error of glslang that names "
     "it."},
    {"refused_by_driver", "The same, by the driver."},
    {"defined",
     "A few lines that some driver or translator got wrong have the words that the specification of the language fixes "
     "(in the file `bugs`)."},
    {"undefined",
     "A few lines whose words the specification leaves open have the natural ones. A difference is a warning."},
});

}  // namespace

std::span<const CheckDescription> check_descriptions() { return kDescriptions; }

}  // namespace hn
