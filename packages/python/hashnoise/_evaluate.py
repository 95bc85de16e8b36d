"""Checks arguments, and evaluates fields: the work of every function of the package."""

import functools
import inspect
import math
import operator
import reprlib

import numpy as np

from . import _core

ARITHMETICS = {"fast": 1, "precise": 2, "fixed": 3}  # the values of HN_FAST and so on
# The numbers of HN_METRIC_EUCLIDEAN and so on:
# tools/make catalog: metrics
METRICS = {"euclidean": 1, "squared": 2, "manhattan": 3, "chebyshev": 4, "hybrid": 5}
# tools/make catalog: end
AXES = "xyzw"

_FLOAT32 = np.dtype(np.float32)
_INT32 = np.dtype(np.int32)
_UINT16 = np.dtype(np.uint16)
_BUFFER = 1 << 18  # points of arrays that do not lie in a row, which NumPy copies together
_MOST_SINGLE = 2.0**128 - 2.0**103  # from here on a number is infinite as a float32
_OF_GRIDS = (_FLOAT32, np.dtype(np.float16), _UINT16)


def evaluated(function, least, coordinates, *, points, cell, out, threads, noise=None, fractal="", **options):
    """A function's result: its field at the points of arrays.

    function     its name, for messages
    least        dimensions that it has
    coordinates  x, y, z and w; None for each that was left out
    points       in their place: an array whose last axis has the coordinates
    noise, fractal   as in field.hpp; without a noise a fractal sums its usual one, or those of its own
    options      those of the function, by name
    """
    check_labels(function, *coordinates, points, *(cell if isinstance(cell, tuple) else (cell,)))
    if points is not None:
        coordinates, cell = along_axes(function, coordinates, points, cell)
    dimensions = checked_dimensions(function, coordinates, 1 if points is not None else least)
    masks = []
    arrays = [_coordinate(function, axis, value, masks) for axis, value in zip(AXES, coordinates[:dimensions])]
    cells = [] if cell is None else _cells(function, cell, dimensions, masks)
    if dimensions == 1 and points is None:
        for name, array in zip(("x", "cell"), arrays + cells):
            refuse_points(function, name, array.shape)
    field = make_field(function, dimensions, noise, fractal, options)
    components = len(field.component_names)
    shape = _shape(function, arrays + cells)
    if cells:
        _check_fractions(function, arrays)
    wanted = shape if components == 1 else (components, *shape)
    if out is None:
        result = _empty(wanted, shape, arrays + cells)
    else:
        result = checked_out(function, out, wanted)
        if masks and not isinstance(out, np.ma.MaskedArray):
            raise TypeError(f"{function}: out must be a masked array, since a coordinate is one")
    values = np.asarray(result)  # without a mask
    fill(field, arrays, cells, values[np.newaxis] if components == 1 else values, checked_threads(function, threads))
    if masks or isinstance(out, np.ma.MaskedArray):
        return with_mask(result, masks, is_number=out is None and wanted == ())
    return float(result) if out is None and wanted == () else result


def fill(field, coordinates, cells, planes, threads):
    """Writes the field at points to planes of float32. The arrays are of any numbers, and broadcast to a plane."""
    if not planes.size:
        return
    planes = [planes[number, ...] for number in range(len(planes))]  # arrays, also of one point
    inputs = [*((array, _FLOAT32) for array in coordinates), *((array, _INT32) for array in cells)]
    dtypes = [*(dtype for _, dtype in inputs), *[_FLOAT32] * len(planes)]
    access = ["readonly"] * len(inputs) + ["writeonly"] * len(planes)
    with np.errstate(over="ignore"):
        # NumPy 1.23 reads a wrong number of an array that has no axes and another type.
        arrays = [array if array.ndim else array.astype(dtype) for array, dtype in inputs]
        with np.nditer([*arrays, *planes], ("external_loop", "buffered", "growinner", "copy_if_overlap"),
                       [(kind, "contig", "aligned", "nbo") for kind in access], dtypes, casting="unsafe",
                       buffersize=_BUFFER) as walk:
            for rows in walk:
                field.points(rows[:len(coordinates)], rows[len(coordinates):-len(planes)], rows[-len(planes):], threads)


def functions_of(module, kind):
    """Makes the functions of a module: each evaluates the noise or the fractal that has its name."""
    def function_of(name, least, most, *, doc, **own):
        """A function of `least` to `most` coordinates, with the options of its own and their defaults."""
        for option in own:
            _OWNERS.setdefault(option, []).append(name)
        own = {"period": None, **own} if kind == "noise" else {**own, "period": None}
        options = {"points": None, "seed": 0, **own, "cell": None, "arithmetic": "fast", "out": None, "threads": None,
                   "instruction_set": None}
        others = "help(hashnoise) explains the options that are not named here.\n\n>>> "
        return named_function(module, name, most, options, doc.replace(">>> ", others, 1),
                              functools.partial(evaluated, name, least, **{kind: name}))
    return function_of


def named_function(module, name, most, options, doc, evaluate):
    """A function of up to `most` coordinates with these options and their defaults: it calls evaluate(coordinates,
    **options)."""
    def called(*coordinates, **given):
        if len(coordinates) > most:
            raise TypeError(f"{name}: it takes up to {most} positional arguments, not {len(coordinates)}")
        for option in given:
            if option not in options:
                raise TypeError(f"{name}: there is no option {option}{no_option(option, options)}")
        return evaluate(coordinates, **{**options, **given})

    called.__module__, called.__name__, called.__qualname__, called.__doc__ = module, name, name, doc
    called.__kwdefaults__ = options  # for tools that list them, and so is the signature
    axes = [inspect.Parameter(axis, inspect.Parameter.POSITIONAL_ONLY, default=None) for axis in AXES[:most]]
    keywords = [inspect.Parameter(option, inspect.Parameter.KEYWORD_ONLY, default=value)
                for option, value in options.items()]
    called.__signature__ = inspect.Signature(axes + keywords)
    return called


def make_field(function, dimensions, noise, fractal, options):
    settings = _core.Settings()
    settings.noise = "" if noise is None else _noise(function, noise)
    settings.fractal = fractal
    for name, value in options.items():
        if value is not None:
            setattr(settings, name, _CHECKS[name](function, name, value, dimensions))
    try:
        return getattr(_core, f"Field{dimensions}")(settings)
    except ValueError as error:
        raise ValueError(f"{function}: {error}") from None


def whole_number(function, name, value, least, most):
    """`value` as an int, if it is one from `least` to `most`."""
    try:
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{function}: {name} must be a whole number, not {_shown(value)}") from None
    if not least <= number <= most:
        raise ValueError(f"{function}: {name} must be from {least} to {most}, not {number}")
    return number


def real_number(function, name, value):
    """`value` as a float, if it is finite."""
    try:
        # NumPy's version decides whether float() takes an array of one number.
        if isinstance(value, (bool, np.bool_, str, bytes)) or _is_sequence(value):
            raise TypeError
        number = float(value)
    except TypeError:
        raise TypeError(f"{function}: {name} must be a number, not {_shown(value)}") from None
    except OverflowError:
        raise ValueError(f"{function}: {name} must be finite, and is too large: {_shown(value)}") from None
    if not math.isfinite(number):
        raise ValueError(f"{function}: {name} must be finite, not {number}")
    return number


def single_number(function, name, value):
    """`value` as a float, if it is finite as a float32."""
    number = real_number(function, name, value)
    if abs(number) >= _MOST_SINGLE:
        raise ValueError(f"{function}: {name} must be at most 3.4e38, as a float32 is, not {number}")
    return number


def ruled_number(function, name, value):
    """`value` as an int, if it is one that the rules allow for the setting of that name."""
    return whole_number(function, name, value, *_core.rules[name])


def per_axis(function, name, value, dimensions, check):
    """A tuple with a value for each axis, of one such tuple or of a value for all of them."""
    if not _is_sequence(value):
        return (check(function, name, value),) * dimensions
    if len(value) != dimensions:
        raise ValueError(
            f"{function}: {name} must have a value for each of the {dimensions} axes, or be one value for all of them; "
            f"it is {_shown(value)}")
    return tuple(check(function, name, part) for part in value)


def checked_out(function, out, shape, dtype=_FLOAT32):
    if not isinstance(out, np.ndarray):
        raise TypeError(f"{function}: out must be an array of {dtype}, not {_shown(out)}")
    if out.dtype != dtype or out.shape != shape or not out.flags.writeable:
        kind = "a writeable" if out.flags.writeable else "a read-only"
        raise ValueError(f"{function}: out must be a writeable array of {dtype} of the shape {shape}, "
                         f"not {kind} one of {out.dtype} of the shape {out.shape}")
    return out


def checked_dtype(function, dtype, out):
    """The type of the numbers of a grid: the chosen one, or else that of `out`, or else float32."""
    if dtype is None:
        return out.dtype if isinstance(out, np.ndarray) and out.dtype in _OF_GRIDS else _FLOAT32
    try:
        chosen = np.dtype(dtype)
    except TypeError:
        chosen = None
    if chosen not in _OF_GRIDS:
        raise ValueError(f"{function}: dtype must be float32, float16 or uint16, not {_shown(dtype)}"
                         f"{suggestion(dtype, [known.name for known in _OF_GRIDS])}")
    return chosen


def checked_ranges(function, name, range, dtype, field):
    """The values that 0 and 65535 stand for, for each plane: the caller's, or else the documented ones."""
    if dtype != _UINT16:
        if range is not None:
            raise ValueError(f"{function}: a range sets the values that 0 and 65535 stand for, and is "
                             f"for dtype=\"uint16\" alone, not for {dtype}")
        return []
    if range is None:
        if None in field.ranges:
            plane = field.component_names[field.ranges.index(None)]
            raise ValueError(f"{function}: {name} documents no range of its plane {plane!r}; name what 0 and "
                             "65535 stand for, by range=(least, greatest)")
        return field.ranges
    if not _is_sequence(range) or len(range) != 2:
        raise TypeError(f"{function}: range must be a pair, (least, greatest), not {_shown(range)}")
    least, greatest = (real_number(function, "range", end) for end in range)
    if not least < greatest:
        raise ValueError(f"{function}: range must have a least end below its greatest, not {_shown(range)}")
    if greatest - least == float("inf"):
        raise ValueError(f"{function}: the ends of range are too far apart, {_shown(range)}; values are floats, of "
                         "3.4e38 at most")
    return [(least, greatest)] * len(field.component_names)


# Functions by their names in packages of Python, beside those that the compiled part knows from other libraries; in
# lower case and without the dimensions at the end.
_NAMES = {"perlinnoise": "perlin", "noise": "simplex", **{f"noise{axes}array": "grid" for axes in (2, 3, 4)}}


def suggestion(word, names):
    """ (did you mean perlin?), or nothing."""
    if not isinstance(word, str):
        return ""
    elsewhere = _NAMES.get(word.lower().rstrip("1234d"))
    return f" (here it is {elsewhere})" if elsewhere in names else _core.suggestion(word, list(names))


# Options by their names in other libraries: of a function, and of a grid.
_FREQUENCY = ("multiply the coordinates by the frequency, since they are in cells",
              "step is the frequency, the cells from point to point")
_SCALE = ("divide the coordinates by the scale, since they are in cells; if you multiply by it, multiply",
          "step is 1 / scale, the cells from point to point; if you multiply by it, step is the scale")
_PERIOD = ("period is after how many cells the field repeats",) * 2
_ELSEWHERE = {
    "frequency": _FREQUENCY, "freq": _FREQUENCY, "scale": _SCALE, "wavelength": _SCALE, "zoom": _FREQUENCY,
    "persistence": ("gain is the persistence, of fractals such as fbm",) * 2,
    **dict.fromkeys(("repeat", "tile", "tileable", "tile_sizes", "repeatx", "repeaty", "repeatz"), _PERIOD),
    "base": ("seed takes the place of the base",) * 2,
    "points": ("", "a grid has none; the functions have them, as in hashnoise.fbm(points=...)"),
    **dict.fromkeys(AXES, ("coordinates have no names: pass them first", "size, step and origin set the coordinates")),
    **dict.fromkeys(("octaves", "lacunarity", "gain"), ("fractals such as fbm have that, over any noise",) * 2),
    **dict.fromkeys(("fractal", "fractal_type"), ("the fractals are functions, such as fbm and ridged",
                                                  "the first argument names the fractal, such as \"fbm\"")),
    "noise_type": ("the noises are functions; noise is what a fractal such as fbm takes",
                   "the first argument names the noise; noise is what a fractal such as \"fbm\" takes"),
    "distance_function": ("metric is the distance function, of cellular",) * 2,
    "cellular_jitter": ("jitter is that, of cellular noises",) * 2,
    **dict.fromkeys(("ping_pong_strength", "weighted_strength"),
                    ("strength is that, of the functions ping_pong and weighted",) * 2),
    **dict.fromkeys(("domain_warp_amp", "warp_amplitude"),
                    ("amplitude is that in cells, of the functions warp and warp_progressive",) * 2),
    "offset": ("add the offset to the coordinates", "origin is the first point, in cells"),
    "start": ("the coordinates begin where you begin them",
              "first is the number of the first point (did you mean first?), and origin its position in cells"),
    "shape": ("the result has the shape of the coordinates", "size is (width, height), the shape the other way round"),
}
_OWNERS = {}  # the functions with an option that not all have, by its name


def no_option(option, options, is_grid=False):
    """The end of a message about an option that there is not: what takes its place, who has it, or the others."""
    if option in _ELSEWHERE:
        return f"; {_ELSEWHERE[option][is_grid]}"
    if option in _OWNERS:
        *others, last = _OWNERS[option]
        return f"; {', '.join(others)} and {last} have that" if others else f"; {last} has that"
    return suggestion(option, options) or f"; the options are {', '.join(options)}"


def suggesting(function):
    """The function, with a TypeError that names for an option that it has not the nearest that it has, or what takes
    the place of an option of other libraries."""
    code = function.__code__
    options = code.co_varnames[code.co_posonlyargcount:code.co_argcount + code.co_kwonlyargcount]

    @functools.wraps(function)
    def called(*arguments, **given):
        try:
            return function(*arguments, **given)
        except TypeError:
            unknown = [option for option in given if option not in options]
            if not unknown:
                raise
            raise TypeError(f"{function.__name__}: there is no option {unknown[0]}"
                            f"{no_option(unknown[0], options, 'step' in options)}") from None

    called.__kwdefaults__ = function.__kwdefaults__  # for tools that list the options
    return called


def checked_threads(function, threads):
    """0 for None: as many as are worth it."""
    return 0 if threads is None else ruled_number(function, "threads", threads)


def checked_dimensions(function, coordinates, least):
    given = [value is not None for value in coordinates]
    dimensions = given.index(False) if False in given else len(given)
    if any(given[dimensions:]):
        raise TypeError(f"{function}: {AXES[dimensions]} is left out, but a later coordinate is not")
    if dimensions < least:
        raise TypeError(f"{function}: {AXES[dimensions]} is missing, a number or an array of numbers; of an array of "
                        "points with their coordinates along its last axis, pass points=")
    return dimensions


def check_labels(function, *arrays):
    """Refuses arrays of pandas and xarray that their labels would join in another way than places do, and arrays of Dask,
    which are not computed yet."""
    first = None
    for array in arrays:
        if array is None or isinstance(array, (int, float)):
            continue
        if hasattr(array, "__dask_graph__") and array.__dask_graph__() is not None:
            raise TypeError(
                f"{function}: an array of Dask is not computed yet: pass x.compute(), or call the function for each block, "
                f"as dask.array.map_blocks(hashnoise.{function}, x, y) does, and of xarray's arrays "
                f"xarray.apply_ufunc(hashnoise.{function}, x, y, dask=\"parallelized\", output_dtypes=[\"float32\"])")
        if not hasattr(array, "to_numpy"):
            continue
        labels = [(name, getattr(array, "indexes", {}).get(name)) for name in array.dims] if hasattr(array, "dims") else [
            ("", index) for index in getattr(array, "axes", ())]
        first = first or labels
        if labels and ([name for name, _ in labels] != [name for name, _ in first] or any(
                a is not None and b is not None and not a.equals(b) for (_, a), (_, b) in zip(labels, first))):
            raise ValueError(
                f"{function}: arrays are joined by their places, and the labels of these differ: pass x.to_numpy(), or join "
                f"them by their labels first, as xarray.apply_ufunc(hashnoise.{function}, x, y) does, and x.align(y) of pandas")


def along_axes(function, coordinates, points, cell, rows=None):
    """The coordinates of points, and their cells, as arrays for each axis. `rows` makes an array of them."""
    rows = rows or _rows
    if any(value is not None for value in coordinates):
        raise TypeError(f"{function}: pass coordinates or points, not both")
    points = rows(function, "points", points)
    dimensions = points.shape[-1] if points.ndim else 0
    if not 1 <= dimensions <= len(AXES):
        found = f"the shape {points.shape}"
        if points.shape[:1] in ((2,), (3,), (4,)):
            found += f"; they are along the first: {function}(*points)"
        raise ValueError(f"{function}: points must have 1 to 4 coordinates along the last axis, as in shape (N, 3), "
                         f"not {found}")
    if isinstance(cell, tuple) and any(np.ndim(part) for part in cell):
        raise TypeError(f"{function}: with points a cell is a whole number, or an array with the cells of a point "
                        "along its last axis, not a tuple of arrays: numpy.stack(cell, axis=-1) makes such an array")
    if cell is not None and np.ndim(cell):
        cell = rows(function, "cell", cell)
        if cell.shape[-1] != dimensions:
            raise ValueError(f"{function}: cell must have a whole number for each of the {dimensions} coordinates of a "
                             f"point along the last axis, and is of the shape {cell.shape}")
        cell = tuple(cell[..., axis] for axis in range(dimensions))
    return tuple(points[..., axis] for axis in range(dimensions)), cell


def _rows(function, name, value):
    try:
        return value if isinstance(value, np.ma.MaskedArray) else np.asarray(value)
    except ValueError as error:  # rows of different lengths
        raise ValueError(f"{function}: {name} makes no array: {error}") from None


def refuse_points(function, name, shape):
    """An array of one coordinate for each point, that might be one of points, too."""
    if len(shape) < 2 or not {shape[0], shape[-1]} & {2, 3, 4}:
        return
    ways = [f"points={name}"] * (shape[-1] in (2, 3, 4)) + [f"*{name}"] * (shape[0] in (2, 3, 4))
    raise ValueError(f"{function}: {name} has the shape {shape}, and may have points, or numbers on a line. Of points "
                     f"pass {' or '.join(f'{function}({way})' for way in ways)}, and of numbers on a line "
                     f"{function}(points={name}[..., numpy.newaxis])")


def _coordinate(function, name, value, masks):
    array = _array(function, name, value, "fiub", f"{name} must be a number or an array of numbers, not of", masks)
    if array.dtype == object:
        array = np.array([real_number(function, name, number) for number in array.flat]).reshape(array.shape)
    return array


def _array(function, name, value, kinds, wanted, masks):
    """An array of numbers of these kinds. The mask of a masked one is put to the others, and 0 is where it is."""
    try:
        array = np.asarray(value)
    except ValueError as error:  # rows of different lengths
        raise ValueError(f"{function}: {name} makes no array: {error}") from None
    # NumPy makes an array of objects of whole numbers that no type of its own holds.
    is_large = array.dtype == object and array.size and all(isinstance(number, int) for number in array.flat)
    if array.dtype.kind not in kinds and not is_large:
        raise TypeError(f"{function}: {wanted} {array.dtype}")
    if isinstance(value, np.ma.MaskedArray):
        masks.append(np.ma.getmaskarray(value))
        array = np.where(masks[-1], array.dtype.type(0), array) if masks[-1].any() else array
    return array


def _check_fractions(function, arrays):
    """Fractions beyond a cell are in another one. NaN and infinity give NaN."""
    for axis, array in zip(AXES, arrays):
        if array.size == 0:
            continue
        least, most = (float(ufunc.reduce(array, axis=None)) for ufunc in (np.fmin, np.fmax))
        if least < 0 or most > 1:
            found = f"{least}" if least == most else f"from {least} to {most}"
            raise ValueError(f"{function}: with a cell the coordinates are the fractions in it, and must be from 0 to "
                             f"1; {axis} is {found}")


def with_mask(result, masks, is_number):
    """The result with the union of the masks, in all of its planes."""
    mask = np.ma.nomask
    for other in masks:
        mask = np.logical_or(mask, other)
    if is_number:
        return np.ma.masked if mask else float(result)
    if not isinstance(result, np.ma.MaskedArray):
        result = np.ma.MaskedArray(result)
    result.mask = np.broadcast_to(mask, result.shape)
    return result


def _is_sequence(value):
    return isinstance(value, (tuple, list)) or (isinstance(value, np.ndarray) and value.ndim > 0)


def _cells(function, cell, dimensions, masks):
    if not _is_sequence(cell) or (dimensions == 1 and not isinstance(cell, tuple)):
        cell = (cell,) * dimensions
    if len(cell) != dimensions:
        raise ValueError(f"{function}: cell must be a whole number, or a tuple of {dimensions}: the cells along "
                         f"{', '.join(AXES[:dimensions])}")
    if not isinstance(cell, tuple) and np.shape(cell[0]) and np.shape(cell[0])[-1] == dimensions:
        raise ValueError(f"{function}: cell has {dimensions} rows of {dimensions} numbers, and may have the cells of "
                         "axes, or of points. Of axes pass cell=tuple(cell), and of points the coordinates as points=")
    arrays = []
    least, most = _core.rules["cell"]
    for axis, part in zip(AXES, cell):
        if isinstance(part, int):
            ruled_number(function, "cell", part)
        array = _array(function, "cell", part, "iu", f"the cells along {axis} must be whole numbers, not", masks)
        if array.size and not least <= array.min() <= array.max() <= most:
            raise ValueError(f"{function}: the cells along {axis} must be from {least} to {most}, and are from "
                             f"{array.min()} to {array.max()}")
        arrays.append(array)
    return arrays


def _shape(function, arrays):
    shape = arrays[0].shape
    if all(array.shape == shape for array in arrays):
        return shape
    try:
        return np.broadcast_shapes(*(array.shape for array in arrays))
    except ValueError:
        shapes = ", ".join(str(array.shape) for array in arrays)
        raise ValueError(f"{function}: the coordinates have shapes that do not go together: {shapes}") from None


def _empty(wanted, shape, arrays):
    """An array for a result, which lies in memory as the coordinates do: transposed if they all are."""
    whole = [array for array in arrays if array.shape == shape]
    if len(shape) < 2 or not whole or not all(a.flags.f_contiguous and not a.flags.c_contiguous for a in whole):
        return np.empty(wanted, _FLOAT32)
    planes = wanted[:len(wanted) - len(shape)]
    return np.moveaxis(np.empty((*planes, *shape[::-1]), _FLOAT32).T, range(-len(planes), 0), range(len(planes)))


def _noise(function, noise):
    if not isinstance(noise, str):
        raise TypeError(f"{function}: noise must be a name, not {_shown(noise)}")
    if noise.lower() in ("", "none"):  # the compiled part takes the usual one for none
        raise ValueError(f"{function}: noise must be a name, not {noise!r}; leave it out for the usual one")
    return noise


def _one_of(names):
    def check(function, name, value, dimensions):
        if isinstance(value, str) and value in names:
            return names[value]
        raise ValueError(f"{function}: {name} must be one of {', '.join(names)}; not {_shown(value)}"
                         f"{suggestion(value, names)}")
    return check


def _period(function, name, value, dimensions):
    return (*per_axis(function, name, value, dimensions, ruled_number), 0, 0, 0)[:4]


def _wave(function, name, value, dimensions):
    if not _is_sequence(value):
        raise TypeError(f"{function}: {name} must be a number for each of the {dimensions} axes, as in "
                        f"{(2.5, 1.5, 0.0, 0.0)[:max(2, dimensions)]}, not {_shown(value)}")
    if len(value) != dimensions:
        raise ValueError(f"{function}: {name} must have a number for each of the {dimensions} axes, not {len(value)}; "
                         f"it is {_shown(value)}")
    return [single_number(function, name, part) for part in value]


def _whole(function, name, value, dimensions):
    return ruled_number(function, name, value)


def _single(function, name, value, dimensions):
    return single_number(function, name, value)


def _instruction_set(function, name, value, dimensions):
    known = _core.instruction_sets()
    if isinstance(value, str) and value in known:
        return known.index(value)
    raise ValueError(f"{function}: instruction_set must be one of this processor's, which are {', '.join(known)}; not "
                     f"{_shown(value)}{suggestion(value, known)}")


def _shown(value):
    return f"{reprlib.repr(value)} ({type(value).__name__})"


_CHECKS = {
    **dict.fromkeys(("seed", "octaves"), _whole),
    "period": _period,
    "wave": _wave,
    "arithmetic": _one_of(ARITHMETICS),
    "metric": _one_of(METRICS),
    "instruction_set": _instruction_set,
    **dict.fromkeys(("bandwidth", "phase", "jitter", "lacunarity", "gain", "strength", "amplitude", "detail",
                     "footprint"), _single),
}
