# Made by tools/make catalog from catalog/noises.toml and settings.toml.
"""The noises: each is a function of arrays of coordinates. help(hashnoise) describes their common options."""

from ._evaluate import functions_of

__all__ = ["perlin", "perlin_d", "value", "value_d", "value_cubic", "simplex", "simplex_d", "simplex_smooth",
           "cellular", "cellular_three", "cellular_d", "cellular_smooth", "cell_border", "curl", "value_vector",
           "perlin_vector", "phasor", "random"]

_noise = functions_of(__name__, "noise")

perlin = _noise("perlin", 1, 4, phase=None, doc="""\
Perlin noise, in 1D to 4D: gradient noise on the square lattice, with hashed gradients.

Positions are in cells, and a cell has about one hill or valley. At whole positions the noise is 0, so multiply pixels
by a frequency.

phase    in 2D and 3D: how far the gradients rotate, in turns. The field changes in place, and loops after one turn
returns  [-1, 1], mean 0, 0 at lattice points, twice continuously differentiable
source   Valdenegro-Toro and Pincheira, sec. 5; Perlin, "Improving noise", 2002; for the phase Perlin and Neyret, "Flow
         noise", 2001

>>> hashnoise.perlin(0.5, 0.25, seed=7, arithmetic="fixed")
-0.5934820175170898
""")

perlin_d = _noise("perlin_d", 1, 4, phase=None, doc="""\
Perlin noise and its slope, in 1D to 4D.

phase    in 2D and 3D: as of `perlin`
returns  planes: the value of `perlin`, and its derivatives along each axis, per cell, once continuously differentiable:
         in [-2.69, 2.69] in 1D, [-2.91, 2.91] in 2D, [-3.61, 3.61] in 3D and [-3.62, 3.62] in 4D, without a phase
source   the product rule on the interpolation; docs/reference/contract.md, section 10

>>> hashnoise.perlin_d(0.5, 0.25, seed=7, arithmetic="fixed")
array([-0.593482  , -0.35161018, -0.6617737 ], dtype=float32)
""")

value = _noise("value", 1, 4, doc="""\
Value noise on the square lattice, in 1D to 4D: cheaper than `perlin`, and coarser.

Its values are large at lattice points.

returns  [-1, 1], mean 0, at lattice points any multiple of 2^-22, twice continuously differentiable
source   Perlin, "Improving noise", 2002, for the interpolant

>>> hashnoise.value(0.5, 0.25, seed=7, arithmetic="fixed")
-0.22854185104370117
""")

value_d = _noise("value_d", 1, 4, doc="""\
Value noise and its slope, in 1D to 4D.

returns  planes: the value of `value`, and its derivatives along each axis, per cell, in [-3.76, 3.76], once
         continuously differentiable
source   the product rule on the interpolation; docs/reference/contract.md, section 10

>>> hashnoise.value_d(0.5, 0.25, seed=7, arithmetic="fixed")
array([-0.22854185,  1.6006794 ,  0.8712158 ], dtype=float32)
""")

value_cubic = _noise("value_cubic", 1, 3, doc="""\
Cubic value noise, in 1D to 3D: a uniform cubic B-spline over hashed numbers.

It is the smoothest of the lattice noises: it does not show the cells, has no creases in its slopes, and stays between
the numbers around it. The price is contrast: the spline blurs.

returns  [-1, 1], mean 0, twice continuously differentiable
source   de Boor, "A Practical Guide to Splines", 1978, for the spline

>>> hashnoise.value_cubic(0.5, 0.25, seed=7, arithmetic="fixed")
-0.04660987854003906
""")

simplex = _noise("simplex", 2, 4, phase=None, doc="""\
Simplex noise, in 2D to 4D: gradient noise on a lattice of triangles, or of simplices.

It does not prefer the axes. There are several lattice points to a cell, so its features are smaller than those of
`perlin`: on the plane about half as large.

phase    in 2D and 3D: how far the gradients rotate, in turns. The field changes in place, and loops after one turn
returns  [-1, 1], mean 0, 0 at lattice points, twice continuously differentiable
source   Perlin, "Noise hardware", 2001, for the sum over the corners of a simplex; docs/reference/contract.md, section
         13; for the phase Perlin and Neyret, "Flow noise", 2001

>>> hashnoise.simplex(0.5, 0.25, seed=7, arithmetic="fixed")
-0.6683130264282227
""")

simplex_d = _noise("simplex_d", 2, 4, phase=None, doc="""\
Simplex noise and its slope, in 2D to 4D.

phase    in 2D and 3D: as of `simplex`
returns  planes: the value of `simplex`, and its derivatives along each axis, per cell, once continuously
         differentiable: in [-8.46, 8.46] in 2D, [-4.81, 4.81] in 3D and [-6.06, 6.06] in 4D, without a phase
source   the product rule on weight and ramp; docs/reference/contract.md, section 13

>>> hashnoise.simplex_d(0.5, 0.25, seed=7, arithmetic="fixed")
array([-0.668313  , -0.03768539, -0.7655754 ], dtype=float32)
""")

simplex_smooth = _noise("simplex_smooth", 2, 3, doc="""\
Smooth simplex noise, in 2D and 3D: its kernel is larger than `simplex`'s, so the field is calmer.

returns  [-1, 1], mean 0, 0 at lattice points, twice continuously differentiable
source   Perlin, "Noise hardware", 2001, for the sum over the corners of a simplex; docs/reference/contract.md, section
         13

>>> hashnoise.simplex_smooth(0.5, 0.25, seed=7, arithmetic="fixed")
-0.7580738067626953
""")

cellular = _noise("cellular", 2, 3, phase=None, jitter=1.0, metric="euclidean", doc="""\
Cellular noise, in 2D and 3D: distances to the two nearest of points that are scattered, one in each cell.

They are Worley's F1 and F2, and those of the whole infinite field.

jitter   how far the points are from the centres of their cells, from 0, which makes a regular lattice, to 1
metric   "euclidean", "squared" (the square of it), "manhattan" (the sum of the sizes along the axes), "chebyshev" (the
         largest of them) or "hybrid" (Manhattan and squared, added)
phase    how far the points circle, in turns. They come back after one turn; with it the metric is Euclidean, and a
         jitter of 1 is 7/8 of what it is without one in 2D, and 25/32 in 3D
returns  planes: the two distances, in cells, ascending and continuous. With the Euclidean metric the first is in [0,
         1.1181] in 2D and [0, 1.2248] in 3D, and the second in [0, 1.5001]
source   Worley, "A cellular texture basis function", 1996; docs/reference/contract.md, section 16

>>> hashnoise.cellular(0.5, 0.25, seed=7, arithmetic="fixed")
array([0.5304756, 0.8378334], dtype=float32)
""")

cellular_three = _noise("cellular_three", 2, 3, jitter=1.0, metric="euclidean", doc="""\
Cellular noise, in 2D and 3D: distances to the three nearest points, Worley's F1, F2 and F3.

jitter   as of `cellular`
metric   as of `cellular`
returns  planes: the three distances, in cells, ascending. The first two are those of `cellular`; with the Euclidean
         metric the third is in [0, 1.5812]
source   Worley, "A cellular texture basis function", 1996; docs/reference/contract.md, section 16

>>> hashnoise.cellular_three(0.5, 0.25, seed=7, arithmetic="fixed")
array([0.5304756, 0.8378334, 0.883934 ], dtype=float32)
""")

cellular_d = _noise("cellular_d", 2, 3, jitter=1.0, doc="""\
The distance to the nearest feature point and its gradient, in 2D and 3D.

jitter   as of `cellular`
returns  planes: the distance, which is the first of `cellular`, and its derivatives along each axis: a vector of length
         1 away from the point, and 0 at the point. It jumps where another point becomes the nearest
source   docs/reference/contract.md, section 16

>>> hashnoise.cellular_d(0.5, 0.25, seed=7, arithmetic="fixed")
array([ 0.5304756 ,  0.7234807 , -0.69034433], dtype=float32)
""")

cellular_smooth = _noise("cellular_smooth", 2, 3, jitter=1.0, doc="""\
Cellular noise with rounded valleys, in 2D and 3D: it has no creases between cells.

jitter   as of `cellular`
returns  a distance that takes all points within 1 into account, a little below the first of `cellular`: in [-0.1937,
         7/8] in 2D and [-0.198, 7/8] in 3D, continuously differentiable but for the points themselves
source   docs/reference/contract.md, section 16

>>> hashnoise.cellular_smooth(0.5, 0.25, seed=7, arithmetic="fixed")
0.5278301239013672
""")

cell_border = _noise("cell_border", 2, 3, jitter=1.0, doc="""\
The distance to the border of the cell of the nearest feature point, in 2D and 3D: cracks and tiles.

jitter   as of `cellular`
returns  the distance, in cells, continuous: in [0, 0.844] in 2D and [0, 0.883] in 3D
source   docs/reference/contract.md, section 16

>>> hashnoise.cell_border(0.5, 0.25, seed=7, arithmetic="fixed")
0.196044921875
""")

curl = _noise("curl", 2, 3, phase=None, doc="""\
Curl noise, in 2D and 3D: velocities of a flow without divergence, which neither gathers nor spreads what it carries.

phase    how far the gradients rotate, in turns; in 3D the second noise rotates twice as far. The flow changes in place,
         and loops after one turn
returns  planes: the velocity along each axis, once continuously differentiable. In 2D they are derivatives of
         `simplex`, in [-8.46, 8.46]; in 3D they are in [-31.1, 31.1], without a phase
source   Bridson, Hourihan, Nordenstam, "Curl-noise for procedural fluid flow", 2007; DeWolf, "Divergence-free noise",
         2005; for the phase Perlin and Neyret, "Flow noise", 2001

>>> hashnoise.curl(0.5, 0.25, seed=7, arithmetic="fixed")
array([-0.7655754 ,  0.03768539], dtype=float32)
""")

value_vector = _noise("value_vector", 2, 3, doc="""\
Independent value noises, one along each axis, in 2D and 3D, from one hash for each corner of a cell.

The first component is `value`. It costs less than as many noises with seeds of their own.

returns  planes: [-1, 1] along each axis, mean 0, twice continuously differentiable
source   Perlin, "Improving noise", 2002, for the interpolant; docs/reference/contract.md, section 22

>>> hashnoise.value_vector(0.5, 0.25, seed=7, arithmetic="fixed")
array([-0.22854185, -0.6436415 ], dtype=float32)
""")

perlin_vector = _noise("perlin_vector", 2, 3, doc="""\
Independent Perlin noises, one along each axis, in 2D and 3D, from one hash for each corner of a cell.

The first component is `perlin`. It costs less than as many noises with seeds of their own.

returns  planes: [-1, 1] along each axis, mean 0, 0 at lattice points, twice continuously differentiable
source   Perlin, "Improving noise", 2002; docs/reference/contract.md, section 22

>>> hashnoise.perlin_vector(0.5, 0.25, seed=7, arithmetic="fixed")
array([-0.593482  , -0.14647579], dtype=float32)
""")

phasor = _noise("phasor", 2, 3, wave=None, bandwidth=None, phase=None, doc="""\
Phasor noise, in 2D and 3D: stripes across a direction and with a wavelength of your choice.

The angle of both numbers, atan2(quadrature, value), grows across the stripes, so any profile can be made of it; the
length of both is how well the stripes agree.

wave       the direction across the stripes, times the number of waves per cell: from -16 to 16 for each axis, usually 2
           to 8 in all; 3 waves along x if it is left out
bandwidth  how far the wave of each lattice point is from that, in a direction of its own, in waves per cell: from 0 to
           16. With the wave 0 the stripes have all directions, as isotropic Gabor noise
phase      in turns: the stripes move along the wave as the phase falls, and loop after one turn
returns    planes: the value and its quadrature, the value a quarter of a turn of the phase earlier, each in [-1, 1],
           mean 0, twice continuously differentiable
source     Tricard et al., "Procedural phasor noise", 2019; Lagae et al., "Procedural noise using sparse Gabor
           convolution", 2009; docs/reference/contract.md, section 23

>>> hashnoise.phasor(0.5, 0.25, seed=7, arithmetic="fixed")
array([-0.18757296, -0.56310844], dtype=float32)
""")

random = _noise("random", 1, 4, doc="""\
A random number for each cell, in 1D to 4D: white noise.

It jumps from one cell to the next: place, colour and vary things with it.

returns  [0, 1), a multiple of 2^-24, mean 1/2, uniform
source   docs/reference/contract.md, section 17

>>> hashnoise.random(0.5, 0.25, seed=7, arithmetic="fixed")
0.16628092527389526
""")

NOISES = {name: globals()[name] for name in __all__}
