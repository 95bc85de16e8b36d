"""Checks what users pass, and evaluates fields: what every function of the package does."""

import functools
import math
import operator
import reprlib

import numpy as np

from . import _core

ARITHMETICS = {"fast": 1, "precise": 2, "fixed": 3}  # the values of HN_FAST and so on
# Those of HN_METRIC_EUCLIDEAN and so on:
# tools/catalog: metrics
METRICS = {"euclidean": 1, "squared": 2, "manhattan": 3, "chebyshev": 4, "hybrid": 5}
# tools/catalog: end
AXES = "xyzw"

_FLOAT32 = np.dtype(np.float32)
_FLOAT64 = np.dtype(np.float64)
_INT32 = np.dtype(np.int32)
_INT64 = np.dtype(np.int64)
_UINT16 = np.dtype(np.uint16)
_OF_GRIDS = (_FLOAT32, np.dtype(np.float16), _UINT16)


def points(function, coordinates, cell, out, threads, *, noise="", sum="", **options):
    """What a function returns: its field at the points of arrays.

    function     its name, for messages
    coordinates  x, y, z and w; None for each that was left out
    noise, sum   as in field.hpp; a sum of noises of its own takes no noise
    options      those of the function, by name
    """
    dimensions = _dimensions(function, coordinates)
    arrays = [_coordinate(function, axis, value) for axis, value in zip(AXES, coordinates[:dimensions])]
    cells = [] if cell is None else _cells(function, cell, dimensions)
    field = make_field(function, dimensions, noise, sum, options)
    components = len(field.component_names)
    shape = _shape(function, arrays + cells)
    wanted = shape if components == 1 else (components, *shape)
    if out is None:
        result = _empty(wanted, shape, arrays + cells)
    else:
        result = checked_out(function, out, wanted)
        arrays = [array.copy() if np.may_share_memory(array, out) else array for array in arrays]
        cells = [array.copy() if np.may_share_memory(array, out) else array for array in cells]
    field.points(arrays, cells, result[np.newaxis] if components == 1 else result, checked_threads(function, threads))
    return float(result) if out is None and wanted == () else result


def make_field(function, dimensions, noise, sum, options):
    settings = _core.Settings()
    settings.noise = _text(function, "noise", noise)
    settings.sum = sum
    for name, value in options.items():
        if value is not None:
            setattr(settings, name, _CHECKS[name](function, name, value, dimensions))
    try:
        return _core.Field(dimensions, settings)
    except ValueError as error:
        raise ValueError(f"{function}: {error}") from None


def whole_number(function, name, value, least, most):
    """`value` as an int, if it is one from `least` to `most`."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{function}: {name} must be a whole number, not {_shown(value)}") from None
    if not least <= number <= most:
        raise ValueError(f"{function}: {name} must be from {least} to {most}, not {number}")
    return number


def real_number(function, name, value):
    """`value` as a float, if it is finite."""
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        number = float(value)
    except TypeError:
        raise TypeError(f"{function}: {name} must be a number, not {_shown(value)}") from None
    if not math.isfinite(number):
        raise ValueError(f"{function}: {name} must be finite, not {number}")
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
    """The type of the numbers of a grid: what is asked for, or else that of `out`, or else float32."""
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
    """What 0 and 65535 stand for, for each plane: what is asked for, or else what the function documents."""
    if dtype != _UINT16:
        if range is not None:
            raise ValueError(f"{function}: a range says what 0 and 65535 stand for, and is for dtype=\"uint16\" alone, "
                             f"not for {dtype}")
        return []
    if range is None:
        if None in field.ranges:
            plane = field.component_names[field.ranges.index(None)]
            raise ValueError(f"{function}: {name} documents no range of its plane {plane!r}; say with "
                             "range=(least, greatest) what 0 and 65535 stand for")
        return field.ranges
    if not _is_sequence(range) or len(range) != 2:
        raise TypeError(f"{function}: range must be a pair, (least, greatest), not {_shown(range)}")
    least, greatest = (real_number(function, "range", end) for end in range)
    if not least < greatest:
        raise ValueError(f"{function}: range must have a least end below its greatest, not {_shown(range)}")
    return [(least, greatest)] * len(field.component_names)


def suggestion(word, names):
    """ (did you mean perlin?), or nothing."""
    return _core.suggestion(word, list(names)) if isinstance(word, str) else ""


def suggesting(function):
    """The function, with a TypeError that names the nearest of its options for one that it has not."""
    code = function.__code__
    options = code.co_varnames[code.co_posonlyargcount:code.co_argcount + code.co_kwonlyargcount]

    @functools.wraps(function)
    def called(*arguments, **given):
        try:
            return function(*arguments, **given)
        except TypeError as error:
            unknown = [option for option in given if option not in options and f"'{option}'" in str(error)]
            # Python itself names the nearest from 3.13 on.
            meant = suggestion(unknown[0], options) if unknown and "mean" not in str(error) else ""
            if not meant:
                raise
            raise TypeError(f"{error}{meant}") from None

    called.__kwdefaults__ = function.__kwdefaults__  # for who asks what options there are
    return called


def checked_threads(function, threads):
    """0 for None: as many as are worth it."""
    return 0 if threads is None else ruled_number(function, "threads", threads)


def _dimensions(function, coordinates):
    given = [value is not None for value in coordinates]
    dimensions = given.index(False) if False in given else len(given)
    if dimensions == 0:
        raise TypeError(f"{function}: x must be a number or an array of numbers, not None")
    if any(given[dimensions:]):
        raise TypeError(f"{function}: {AXES[dimensions]} is left out, but a later coordinate is not")
    return dimensions


def _coordinate(function, name, value):
    array = _array(function, name, value)
    if array.dtype == _FLOAT32 or array.dtype == _FLOAT64:
        return array
    if array.dtype.kind not in "fiub":
        raise TypeError(f"{function}: {name} must be a number or an array of numbers, not of {array.dtype}")
    return array.astype(_FLOAT32)


def _array(function, name, value):
    try:
        return np.asarray(value)
    except ValueError as error:  # rows of different lengths
        raise ValueError(f"{function}: {name} makes no array: {error}") from None


def _is_sequence(value):
    return isinstance(value, (tuple, list)) or (isinstance(value, np.ndarray) and value.ndim > 0)


def _cells(function, cell, dimensions):
    if dimensions == 1 and not isinstance(cell, tuple):
        cell = (cell,)
    if not _is_sequence(cell) or len(cell) != dimensions:
        raise ValueError(
            f"{function}: cell must be a tuple of {dimensions}: the cells along {', '.join(AXES[:dimensions])}")
    arrays = []
    least, most = _core.rules["cell"]
    for axis, part in zip(AXES, cell):
        if isinstance(part, int):  # of which NumPy makes an array of objects, if it is large
            ruled_number(function, "cell", part)
        array = _array(function, "cell", part)
        if array.dtype.kind not in "iu":
            raise TypeError(f"{function}: the cells along {axis} must be whole numbers, not {array.dtype}")
        if array.dtype != _INT32 and array.size and not least <= array.min() <= array.max() <= most:
            raise ValueError(f"{function}: the cells along {axis} must be from {least} to {most}, and are from "
                             f"{array.min()} to {array.max()}")
        arrays.append(array if array.dtype in (_INT32, _INT64) else array.astype(_INT64))
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


def _text(function, name, value):
    if not isinstance(value, str):
        raise TypeError(f"{function}: {name} must be a name, not {_shown(value)}")
    return value


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
    return [real_number(function, name, part) for part in value]


def _whole(function, name, value, dimensions):
    return ruled_number(function, name, value)


def _real(function, name, value, dimensions):
    return real_number(function, name, value)


def _instruction_set(function, name, value, dimensions):
    if isinstance(value, str) and value in _core.instruction_sets():
        return value
    raise ValueError(f"{function}: instruction_set must be one of this processor's, which are "
                     f"{', '.join(_core.instruction_sets())}; not {_shown(value)}"
                     f"{suggestion(value, _core.instruction_sets())}")


def _shown(value):
    return f"{reprlib.repr(value)} ({type(value).__name__})"


_CHECKS = {
    **dict.fromkeys(("seed", "octaves"), _whole),
    "period": _period,
    "wave": _wave,
    "arithmetic": _one_of(ARITHMETICS),
    "metric": _one_of(METRICS),
    "instruction_set": _instruction_set,
    **dict.fromkeys(("phase", "jitter", "lacunarity", "gain", "strength", "amplitude", "detail", "footprint"), _real),
}
