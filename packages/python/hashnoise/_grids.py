"""Uniform grids, and their choices."""

import functools
import math
import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from . import _core, _noises, _sums
from ._evaluate import (
    AXES,
    checked_dtype,
    checked_out,
    checked_ranges,
    checked_threads,
    make_field,
    no_option,
    per_axis,
    real_number,
    ruled_number,
    single_number,
    suggesting,
    suggestion,
    whole_number,
)

MOST_POINTS = _core.rules["size"][1]
_PART = 1 << 15  # points of a grid that are converted at a time: they stay in a processor's caches


@suggesting
def grid(name, size, *, step, origin=0.0, cell=None, first=0, seed=0, noise=None, octaves=None, lacunarity=None,
         gain=None, strength=None, amplitude=None, detail=None, footprint=None, period=None, wave=None,
         bandwidth=None, phase=None, jitter=None, metric=None, arithmetic="fast", dtype=None, range=None, out=None,
         return_range=False, threads=None, instruction_set=None):
    """A noise or a fractal on a uniform grid: an image, or a volume. It needs no coordinates, and is fastest.

    name          which: "perlin", "fbm", ..., as the functions are called
    size          points along x, y and so on: (width, height). Sizes, steps, origins, cells and periods are all given
                  in the order x, y, z, w. The array has the order of images in NumPy, which is the other way round: of
                  size=(width, height) its shape is (height, width), and the point (x, y) is at array[y, x]
    step          from point to point, in cells: one number, or one for each axis
    origin        the first point, in cells; with a cell the fraction in it, in [0, 1]
    cell          the cell of the first point: one whole number, or one for each axis. Then the grid is exact however
                  far out: it is computed in whole numbers, and steps are rounded to multiples of 2^-32. Without a cell,
                  a point is the float32 nearest to origin + i * step
    first         the number of the first point, for each axis, which may be negative: the array is then that part of
                  one grid, with its bits, whatever the step is. first + size is at most 536870911
    dtype         what the array is of: "float32", "float16" or, for height maps, "uint16"; as `out` is, or else float32
    range         of uint16: the pair (least, greatest) of the values for which 0 and 65535 stand, as `--range` of
                  tools/bake has it. Values outside become the nearer end. Left out it is the range that the function
                  documents
    out           a writeable array to fill and return, of the shape of the result and of one of these types. It may lie
                  in memory in any order, also transposed
    return_range  whether to return a pair: the array, and the least and the greatest value (of the first plane), before
                  it becomes another type than float32

    The other options are those of the function that is called `name`, with its defaults; one that it does not have is a
    TypeError. If the function returns planes, the array has an axis of planes in front: (planes, height, width).

    >>> image = hashnoise.grid("perlin", (640, 480), step=0.01, seed=7)
    >>> image.shape
    (480, 640)
    >>> x, y = numpy.float32(0.01) * numpy.arange(640), numpy.float32(0.01) * numpy.arange(480)
    >>> numpy.allclose(image, hashnoise.perlin(x, y[:, numpy.newaxis], seed=7), atol=1e-5)
    True
    >>> hashnoise.grid("fbm", (512, 512), step=1 / 64, cell=(10**9, -(10**9)), octaves=8).shape
    (512, 512)
    >>> value, quadrature = hashnoise.grid("phasor", (512, 512), step=1 / 64, wave=(2.5, 1.5), phase=0.25)
    >>> part = hashnoise.grid("perlin", (64, 48), step=0.01, first=(576, 432), seed=7)
    >>> part.tobytes() == image[432:, 576:].tobytes()
    True
    >>> hashnoise.grid("ridged", (4, 2), step=0.3, seed=7, dtype="uint16", arithmetic="fixed")
    array([[47531, 32559, 23530, 50887],
           [57671, 25069,  8882, 18519]], dtype=uint16)
    >>> heights, (least, greatest) = hashnoise.grid("ridged", (64, 64, 64), step=0.1, return_range=True)
    >>> (least, greatest) == (heights.min(), heights.max())
    True
    """
    options = {"noise": noise, "octaves": octaves, "lacunarity": lacunarity, "gain": gain, "strength": strength,
               "amplitude": amplitude, "detail": detail, "footprint": footprint, "wave": wave,
               "bandwidth": bandwidth, "phase": phase, "jitter": jitter, "metric": metric, "seed": seed, "period": period,
               "arithmetic": arithmetic, "instruction_set": instruction_set}
    dimensions = len(size) if hasattr(size, "__len__") else 1
    if not 1 <= dimensions <= 4:
        raise ValueError(f"grid: size must have 1 to 4 numbers, not {dimensions}")
    size = per_axis("grid", "size", size, dimensions, ruled_number)
    step = per_axis("grid", "step", step, dimensions, real_number)
    origin = per_axis("grid", "origin", origin, dimensions, single_number)
    first = per_axis("grid", "first", first, dimensions, lambda function, name, value: whole_number(
        function, name, value, -MOST_POINTS, MOST_POINTS))
    for axis, (begin, points) in enumerate(zip(first, size)):
        if begin + points > MOST_POINTS:
            raise ValueError(f"grid: first + size must be at most {MOST_POINTS}, and is {begin + points} along "
                             f"{AXES[axis]}")
    if cell is not None:
        cell = per_axis("grid", "cell", cell, dimensions, ruled_number)
        if not all(0 <= place <= 1 for place in origin):
            raise ValueError(f"grid: with a cell, origin is the fraction in it and must be from 0 to 1, not {origin}")
        for along in step:
            if 0 < abs(along) < 2**-33:
                raise ValueError("grid: with a cell, steps are rounded to multiples of 2^-32 of a cell, and a step of "
                                 f"{along} would be 0")
    field = field_of("grid", name, dimensions, options)
    planes = len(field.component_names)
    shape = size[::-1] if planes == 1 else (planes, *size[::-1])
    dtype = checked_dtype("grid", dtype, out)
    ranges = checked_ranges("grid", name, range, dtype, field)
    values = np.empty(shape, dtype) if out is None else checked_out("grid", out, shape, dtype)
    planar = np.asarray(values)[np.newaxis] if planes == 1 else np.asarray(values)
    threads = checked_threads("grid", threads)
    fill = field.grid if cell is None else functools.partial(field.cell_grid, cell)
    fill = functools.partial(fill, origin, step)
    try:
        if planar.dtype == np.float32 and planar.flags.c_contiguous and planar.flags.aligned:
            extent = fill(size, first, planar, threads)
        else:
            extent = _fill_by_parts(fill, size, first, planar, ranges, threads)
    except ValueError as error:
        raise ValueError(f"grid: {error}") from None
    if isinstance(values, np.ma.MaskedArray):
        values.mask = np.ma.nomask  # all of it has been computed
    return (values, extent) if return_range else values


def _fill_by_parts(fill, size, first, planes, ranges, threads):
    """Planes of any numbers, in any order in memory. Returns the least and the greatest value."""
    points = math.prod(size)
    axis = max(range(len(size)), key=lambda axis: (size[axis] > 1, axis))
    each = max(_PART * size[axis] // max(points, 1), 1)

    def fill_part(begin):
        part, place = [*size], [*first]
        part[axis] = min(each, size[axis] - begin)
        place[axis] += begin
        values = np.empty((len(planes), *part[::-1]), np.float32)
        extent = fill(part, place, values, 1)
        there = planes[(..., slice(begin, begin + part[axis]), *[slice(None)] * axis)]
        if ranges:
            values = [words_of(plane.astype(np.float64), *ends) for plane, ends in zip(values, ranges)]
        with np.errstate(over="ignore"):  # of float16
            there[...] = values
        return extent

    with ThreadPoolExecutor(threads or (os.cpu_count() if points > _PART else 1)) as pool:
        least, greatest = zip(*pool.map(fill_part, range(0, max(size[axis], 1), each)))
    return min(least), max(greatest)


def words_of(values, least, greatest):
    """The nearest of 65,536 numbers; of two as near the greater one. `values` are float64.

    The least of the range becomes 0, the greatest 65535, and a value outside the nearer end."""
    if not greatest > least:
        return np.where(values > greatest, 65535, 0).astype(np.uint16)
    inside = np.fmin(np.fmax(values, least), greatest)  # NaN becomes the least
    return ((inside - least) / (greatest - least) * 65535 + 0.5).astype(np.uint16)


@suggesting
def components(name, dimensions, *, noise=None):
    """The planes of a function that is called `name`, in so many dimensions, over a noise.

    >>> hashnoise.components("perlin_d", 2)
    ('value', 'dx', 'dy')
    >>> hashnoise.components("perlin", 3)
    ('value',)
    """
    field = field_of("components", name, _dimensions("components", dimensions), {"noise": noise})
    return tuple(field.component_names)


def noises(dimensions):
    """The names of the noises that there are in so many dimensions, 1 to 4.

    >>> "curl" in hashnoise.noises(3), "curl" in hashnoise.noises(1)
    (True, False)
    """
    return tuple(_core.noise_names(_dimensions("noises", dimensions)))


def fractals(dimensions):
    """The names of the fractals that there are in so many dimensions, 1 to 4.

    >>> "warp" in hashnoise.fractals(3), "warp" in hashnoise.fractals(1)
    (True, False)
    """
    return tuple(_core.fractal_names(_dimensions("fractals", dimensions)))


def instruction_sets():
    """The instruction sets that this processor and the package have, of "avx512", "avx2", "sse4.1", "neon" and
    "generic".

    The widest is first, and is taken where `instruction_set` is left out.

    >>> widest = hashnoise.instruction_sets()[0]
    >>> hashnoise.perlin(0.5, 0.25, instruction_set=widest) == hashnoise.perlin(0.5, 0.25)
    True
    """
    return tuple(_core.instruction_sets())


def field_of(function, name, dimensions, options):
    """The field that the function called `name` is of, with its defaults for what is left out or None."""
    settings = options_of(function, name, {option: value for option, value in options.items() if value is not None})
    return make_field(function, dimensions, settings.pop("noise", None), settings.pop("fractal"), settings)


def options_of(function, name, given):
    """The noise, the fractal and the options that make the function called `name`: its defaults, and the given ones."""
    if isinstance(name, str) and name in _noises.NOISES:
        own, chosen = _noises.NOISES[name], {"noise": name, "fractal": ""}
    elif isinstance(name, str) and name in _sums.SUMS:
        own, chosen = _sums.SUMS[name], {"fractal": name}
    else:
        raise ValueError(f"{function}: {no_function(name, [*_noises.NOISES, *_sums.SUMS])}")
    defaults = {option: value for option, value in own.__kwdefaults__.items() if option != "points"}
    for option in given:
        if option not in defaults:
            raise TypeError(f"{function}: {name} has no option {option}{no_option(option, defaults)}")
    made = {option: value for option, value in defaults.items() if option not in ("cell", "out", "threads")}
    return {**made, **chosen, **given}


def no_function(name, names):
    return f"there is no function {name!r}{suggestion(name, names)}; there are {', '.join(names)}"


def _dimensions(function, dimensions):
    return whole_number(function, "dimensions", dimensions, 1, 4)
