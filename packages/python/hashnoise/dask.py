"""Grids that are larger than a machine, as Dask arrays: the same bits however they are cut, on any cluster.

    >>> import hashnoise.dask
    >>> world = hashnoise.dask.grid("fbm", (200_000, 200_000), step=1 / 256, cell=(0, 0), octaves=8, seed=7)
    >>> world.shape, world.dtype, world.chunksize
    ((200000, 200000), dtype('float32'), (2048, 2048))
    >>> world[100_000, 100_000:100_003].compute()  # computes one of 9,604 blocks
    array([-0.00582933, -0.00729895, -0.01051855], dtype=float32)

A block is hashnoise.grid(..., first=...), so it has the bits that one call for the whole area would give, had a machine
the memory for it. A block that is lost with its worker is computed again, by another one, and is the same.

This module wants Dask, and data_array wants xarray: pip install dask distributed xarray zarr installs them, with what
writes files and what runs clusters.
"""

import functools
import math
from fractions import Fraction

import numpy as np

from . import __version__
from ._evaluate import AXES, checked_ranges, per_axis, real_number, ruled_number
from ._grids import components, field_of
from ._grids import grid as _grid

_INSTALLS = "pip install dask distributed xarray zarr"

try:
    import dask.array as _arrays
    from dask.array.core import normalize_chunks as _normalize_chunks
    from dask.base import tokenize as _tokenize
except ImportError as error:
    raise ImportError(f"hashnoise.dask wants Dask, which cannot be imported ({error}): {_INSTALLS}") from error

__all__ = ["data_array", "grid"]

_OF_GRIDS = ("cell", "dtype", "origin", "range", "step", "threads")  # options that are not of a field
_BLOCK = 22  # 2^22 points: 16 MiB of float32, which take long beside what a task costs Dask


def grid(name, size, *, step, chunks="auto", arithmetic="fixed", threads=1, **options):
    """A noise or a fractal on a uniform grid, as a lazy Dask array.

    name, size, step  as of hashnoise.grid, and so are the other options, without `first`, `out` and `return_range`
    chunks            the blocks: as Dask has them, for each axis of the array but that of planes, which is never cut.
                      (rows, columns), one number for all axes, or the sizes of all blocks. They may begin anywhere, and
                      no bit depends on them. Left out they have about 2^22 points, and sides that are powers of two:
                      with a step such as 1 / 256 each then begins where the first one does, in another cell, so a
                      shader that knows the cell can make it alone
    arithmetic        "fixed" if it is left out, or "precise": the same bits on every processor. "fast" may differ in
                      its last bits between processors with other instructions, so it wants workers of one kind
    threads           of each task; 1 if it is left out, since Dask runs as many tasks as a worker has threads

    A wrong argument raises TypeError or ValueError here, and not on a worker. Workers need the same version of
    hashnoise, and report another one.

    >>> terrain = hashnoise.dask.grid("fbm", (1000, 600), step=0.01, chunks=(256, 300), seed=7)
    >>> whole = hashnoise.grid("fbm", (1000, 600), step=0.01, seed=7, arithmetic="fixed")
    >>> terrain.compute().tobytes() == whole.tobytes()
    True
    >>> hashnoise.dask.grid("perlin_d", (1000, 600), step=0.01).shape
    (3, 600, 1000)
    """
    return _lazy("dask.grid", name, size, chunks,
                 {"step": step, "arithmetic": arithmetic, "threads": threads, **options})


def data_array(name, size, *, step, cell_size=1.0, unit="cells", chunks="auto", **options):
    """The grid as an xarray.DataArray, with coordinates: to cut by place, and to write as Zarr.

    cell_size  the side of a cell in the unit of the coordinates: with step=1 / 256 and cell_size=256 points are 1 apart
    unit       its name, as in "m"; the attribute `units` of the coordinates

    The coordinate of point i along an axis is (cell + origin + i * step) * cell_size, in float64. The point itself is
    rounded as in hashnoise.grid.

    The other arguments are those of `grid`. The axes are called x, y, z and w, and that of planes "component", whose
    coordinates are the names that hashnoise.components gives. The attributes state how it was made. For uint16 they
    have `scale_factor` and `add_offset`, by which xarray makes values of words when it opens a file; so planes that
    have other ranges each, as those of cellular, want a `range`.

    >>> land = hashnoise.dask.data_array("fbm", (1000, 600), step=1 / 256, cell_size=256, unit="m", seed=7)
    >>> land.dims, float(land.x[0]), float(land.x[-1]), land.x.units
    (('y', 'x'), 0.0, 999.0, 'm')
    >>> land.sel(x=slice(100, 199), y=slice(0, 49)).shape
    (50, 100)
    """
    try:
        import xarray
    except ImportError as error:
        raise ImportError(f"hashnoise.dask.data_array wants xarray, which cannot be imported ({error}): "
                          f"{_INSTALLS}") from error
    cell_size = real_number("dask.data_array", "cell_size", cell_size)
    if cell_size <= 0:
        raise ValueError(f"dask.data_array: cell_size must be more than 0, not {cell_size}")
    if not isinstance(unit, str):
        raise TypeError(f"dask.data_array: unit must be a name, as in \"m\", not {unit!r}")
    options = {"step": step, "arithmetic": "fixed", "threads": 1, **options}
    values = _lazy("dask.data_array", name, size, chunks, options)
    size = _size("dask.data_array", size)
    axes = AXES[:len(size)]
    coordinates = {axis: (axis, positions, {"units": unit})
                   for axis, positions in zip(axes, _positions(size, options, cell_size))}
    dims = tuple(reversed(axes))
    if values.ndim > len(size):
        coordinates["component"] = list(components(name, len(size), noise=options.get("noise")))
        dims = ("component", *dims)
    attributes = _attributes(name, values.dtype, len(size), options)
    return xarray.DataArray(values, coordinates, dims, name, attributes)


def _lazy(function, name, size, chunks, options):
    """A grid as a Dask array. `options` are hashnoise.grid's."""
    for option in ("first", "out", "return_range"):
        if option in options:
            raise TypeError(f"{function}: {option} is an option of hashnoise.grid alone; cut the array in its place, "
                            "as in grid(...)[600:, 400:]")
    size = _size(function, size)
    try:  # one point, the last, which has all errors that the whole may have
        last = _grid(name, (1,) * len(size), first=tuple(max(points - 1, 0) for points in size), **options)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{function}: {str(error).removeprefix('grid: ')}") from None
    planes = last.shape[:last.ndim - len(size)]
    cut = _chunks(function, chunks, size, last.dtype)
    token = _tokenize("hashnoise", __version__, name, size, cut, options)
    chunks = (*((n,) for n in planes), *cut)
    return _arrays.map_blocks(functools.partial(_block, __version__, name, len(size), options), chunks=chunks,
                              dtype=last.dtype, meta=np.empty((0,) * last.ndim, last.dtype),
                              name=f"hashnoise-{name}-{token}")


def _block(version, name, dimensions, options, block_info=None):
    """A worker's part."""
    if version != __version__:
        raise RuntimeError(f"this worker has hashnoise {__version__}, and the array was made with {version}: other "
                           "versions may have other bits. Install the same version on all workers")
    place = block_info[None]["array-location"][-dimensions:][::-1]  # along x first
    return _grid(name, tuple(end - begin for begin, end in place), first=tuple(begin for begin, _ in place), **options)


def _size(function, size):
    return per_axis(function, "size", size, len(size) if hasattr(size, "__len__") else 1, ruled_number)


def _chunks(function, chunks, size, dtype):
    """The blocks along each axis of a plane."""
    shape = size[::-1]
    wanted = _usual_chunks(size) if isinstance(chunks, str) and chunks == "auto" else chunks
    try:
        cut = _normalize_chunks(wanted, shape=shape, dtype=dtype)
    except (TypeError, ValueError, ZeroDivisionError):
        cut = ()
    for points, blocks in zip(shape, cut):
        if sum(blocks) != points or not all(isinstance(n, (int, np.integer)) and n >= 0 for n in blocks):
            cut = ()
    if not cut:
        axes = ", ".join(reversed(AXES[:len(shape)]))
        raise ValueError(f"{function}: chunks must be a number of points of 1 or more, or a tuple with such a number, "
                         f"or with the sizes of all blocks, for each of the axes {axes}, along which there are {shape} "
                         f"points; not {chunks!r}")
    return cut


def _usual_chunks(size):
    """Blocks of about 2^22 points, whose sides are powers of two."""
    sides = [1] * len(size)
    room = _BLOCK
    # A short axis leaves more to the others.
    for rank, axis in enumerate(sorted(range(len(size)), key=size.__getitem__)):
        side = room // (len(size) - rank)
        room -= min(side, max(size[axis] - 1, 0).bit_length())
        sides[axis] = 1 << side
    return tuple(reversed(sides))


def _positions(size, options, cell_size):
    """The coordinates of the points along each axis."""
    dimensions = len(size)
    cell = 0 if options.get("cell") is None else options["cell"]
    starts = zip(per_axis("dask.data_array", "cell", cell, dimensions, ruled_number),
                 per_axis("dask.data_array", "origin", options.get("origin", 0.0), dimensions, real_number))
    step = per_axis("dask.data_array", "step", options["step"], dimensions, real_number)
    return [(cell + origin) * cell_size + _multiples(along * cell_size, points)
            for points, along, (cell, origin) in zip(size, step, starts)]


def _multiples(spacing, points):
    """0, `spacing`, and so on. A fraction such as 1/49 * 49 or 1/10 is meant exactly, so that `sel` finds its multiples
    by the numbers that users write."""
    exact = Fraction(spacing).limit_denominator(10**6)
    if not math.isclose(exact, spacing, rel_tol=1e-15, abs_tol=0.0):
        return spacing * np.arange(points)
    return np.arange(points) * float(exact.numerator) / exact.denominator


def _attributes(name, dtype, dimensions, options):
    """How an array was made, as Zarr can write it; and of words what they stand for."""
    attributes = {"hashnoise": __version__, "function": name, **options}
    made = {key: _plain(value) for key, value in attributes.items() if value is not None and key != "threads"}
    if dtype == np.uint16:
        settings = {key: value for key, value in options.items() if key not in _OF_GRIDS}
        ranges = set(checked_ranges("dask.data_array", name, options.get("range"), dtype,
                                    field_of("dask.data_array", name, dimensions, settings)))
        if len(ranges) > 1:
            raise ValueError(f"dask.data_array: the planes of {name} have other ranges each, and an array has one "
                             "scale_factor and one add_offset; name what 0 and 65535 stand for in all planes, by "
                             "range=(least, greatest)")
        least, greatest = ranges.pop()
        made["scale_factor"] = (greatest - least) / 65535
        made["add_offset"] = least
    return made


def _plain(value):
    """A value as JSON has it."""
    if isinstance(value, (tuple, list, np.ndarray)):
        return [_plain(part) for part in value]
    if isinstance(value, (str, bool)):
        return value
    if isinstance(value, (int, np.integer)):
        return int(value)
    return float(value) if isinstance(value, (float, np.floating)) else str(np.dtype(value))
