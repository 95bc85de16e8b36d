"""Procedural noise on NumPy arrays: the values that hashnoise computes in shaders, with the processor's widest
instructions.

    >>> import hashnoise, numpy
    >>> x = numpy.linspace(0, 8, 1024, dtype=numpy.float32)
    >>> image = hashnoise.fbm(x, x[:, numpy.newaxis], octaves=6, seed=7)
    >>> image.shape, image.dtype
    ((1024, 1024), dtype('float32'))
    >>> image = hashnoise.grid("fbm", (1024, 1024), step=8 / 1023, octaves=6, seed=7)
    >>> value, dx, dy = hashnoise.perlin_d(x, 0.5)
    >>> hashnoise.fbm(points=[[0.5, 0.25, 0.75], [0.75, 0.125, 0.5]]).shape  # two points in space
    (2,)

Each function takes 1 to 4 coordinates: as many as the field has dimensions. They are arrays or numbers, and are
broadcast against each other. Positions are in cells, and are rounded to float32, as in a shader. So at x a point is off
by up to |x| * 2^-24 cells, and in each further octave by twice as much; from 2^23 on no fraction is left. With a `cell`
the field is exact however far out.

The result is an array of float32; of numbers alone it is a float. A function that returns several numbers for a point
returns planes, an array with an axis for them in front, which can be unpacked. Where a coordinate is NaN or infinite,
all numbers of the point are NaN. With masked arrays the result is one, masked where one of them is.

All functions have these options:

    points           in place of the coordinates: an array with 1 to 4 of them along its last axis, such as one of the
                     shape (N, 3). The result has its other axes. As the only coordinate an array that might have
                     points, since its first or last axis has 2 to 4 numbers, is an error: of numbers on a line pass
                     points=x[..., numpy.newaxis]
    seed             a whole number from 0 to 2^32 - 1; different seeds give independent fields
    period           the field repeats after so many cells: one whole number, or one for each axis, not negative; 0
                     for none
    cell             cells, whole numbers from -2^31 to 2^31 - 1: one for all axes, or a tuple with a number or an array
                     for each axis, or of points an array as they are. The coordinates are then the fractions in the
                     cells, from 0 to 1, and the field is exact however far out
    arithmetic       "fast": floats, within the error that the function states (docs/measured/accuracy.md); the last bits may
                     differ from processor to processor. "precise": floats with the bits of IEEE arithmetic. "fixed":
                     integers, with the bits of HN_FIXED in every shader
    out              a writeable array of float32 to fill and return, of the shape of the result
    threads          how many threads compute; without it one for a small result, and all cores for a large one. The
                     values do not depend on it. Other threads of Python run meanwhile
    instruction_set  one of instruction_sets(); without it the widest

Fractals (fbm and the others that fractals() names) also have these:

    noise            the noise of the sum: the name of one that returns a number for a point; of fbm_d and eroded one
                     with its slopes, and of the warps one with a number for each axis. perlin_worley and curl_fbm sum
                     their own
    octaves          how many, from 1 to 32; each costs one noise
    lacunarity       how much finer each octave is than the one before, usually 2. With a period it is a whole number
                     from 1 to 255; with a cell, and with arithmetic="fixed", from 0 to 255
    gain             how much weaker, usually 0.5; not negative, and with arithmetic="fixed" from 0 to 1

A wrong argument raises TypeError or ValueError, with the right ones in the message.
"""

from . import _noises, _sums
from ._core import version as __version__  # noqa: F401  (it is public, and is no name of import *)
from ._evaluate import suggestion as _suggestion
from ._grids import components, fractals, grid, instruction_sets, noises
from ._noises import *  # noqa: F403
from ._sums import *  # noqa: F403

__all__ = ["components", "fractals", "grid", "instruction_sets", "noises", *_noises.__all__, *_sums.__all__]


def __getattr__(name):
    """Called for a name that there is not: that of GLSL or of another package is meant, or the nearest one."""
    bare = name.removeprefix("hn_")
    if name in ("arrays", "dask"):
        meant = f"; import hashnoise.{name}"
    elif bare == "cellular_phase":
        meant = "; cellular has the option phase"
    elif bare.lower() in ("fastnoise", "fastnoiselite"):
        meant = "; call a function such as fbm, which has its settings as options"
    else:
        meant = _suggestion(bare, __all__)
    raise AttributeError(f"module 'hashnoise' has no attribute {name!r}{meant}")
