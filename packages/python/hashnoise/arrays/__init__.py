"""The functions of hashnoise over arrays of PyTorch, JAX, CuPy and NumPy, as expressions of arrays.

    >>> import hashnoise.arrays, numpy
    >>> x = numpy.linspace(0, 8, 1024, dtype=numpy.float32)
    >>> height = hashnoise.arrays.fbm(x, x[:, None], octaves=6, seed=7)  # x may be of torch, jax.numpy or cupy
    >>> height.shape, height.dtype
    ((1024, 1024), dtype('float32'))

The result is an array of the same library, on the device of the coordinates. The functions work below torch.compile,
jax.jit, jax.vmap and differentiation. For NumPy's arrays the functions of hashnoise itself are quicker.

Names, options and values are those of hashnoise, and help(hashnoise) explains them. These differ:

    arithmetic    "fast" or "fixed". "fast" can be differentiated, by positions and by settings, but not phasor, and
                  nothing by a phase or a wave: angles are whole numbers. "fixed" has the bits of HN_FIXED in every
                  library, and no derivatives: its result requires no gradient in torch, and jax.grad returns 0
    settings      phase, jitter, gain, strength, amplitude, lacunarity, footprint, wave, bandwidth and seed are
                  numbers, or arrays that broadcast against the coordinates. Their ranges are checked if they are numbers
    out, threads, instruction_set   there are none

Coordinates of float64 and of whole numbers are converted to float32.
"""

import contextlib
import functools
import operator

import numpy

from .. import _core, _noises, _sums
from .._evaluate import (
    AXES,
    METRICS,
    along_axes,
    check_labels,
    checked_dimensions,
    make_field,
    named_function,
    per_axis,
    refuse_points,
    ruled_number,
    suggestion,
    with_mask,
)

__all__ = [*_noises.__all__, *_sums.__all__]

_ARITHMETICS = ("fast", "fixed")
_ABSENT = ("out", "threads", "instruction_set")
_FLOATS = ("bandwidth", "phase", "jitter", "lacunarity", "gain", "strength", "amplitude", "footprint")
_ARRAYS = ("seed", "wave", *_FLOATS)  # settings that may be arrays
# The steps by which sums add an octave, where they are not called as the sum is.
_STEPS = {"fbm": "add", "clouds": "add", "billow": "add_turbulence", "fbm_d": "add", "warp": "add",
          "warp_progressive": "add_progressive"}


class _Space:
    """The library that the arrays of a call are of, and the text that is called with them."""

    def __init__(self, function, arithmetic, dimensions, arguments):
        self.function, self.dimensions = function, dimensions
        self.text = _text(arithmetic, dimensions)
        check_labels(function, *arguments)
        arrays = [one for one in arguments if _is_array(one)]
        spaces = {self.text._namespace(one): one for one in arrays}
        others = [one for one in arguments if not isinstance(one, (int, float, numpy.generic, type(None)))]
        if not spaces and others:
            raise TypeError(f"{function}: pass arrays, of PyTorch, JAX, CuPy or NumPy, as numpy.asarray(x) is, not a "
                            f"{type(others[0]).__name__}")
        if not spaces:
            raise TypeError(f"{function}: x must be an array, of PyTorch, JAX, CuPy or NumPy; of numbers alone "
                            f"hashnoise.{function.removeprefix('arrays.')} makes a number")
        names = sorted(xp.__name__.removesuffix(".numpy") for xp in spaces)
        if labelled := [xp.__name__ for xp in spaces if not hasattr(xp, "float32")]:
            raise TypeError(f"{function}: what is of {labelled[0]} must be made an array first, as in x.to_numpy(), "
                            f"or passed by what keeps its labels, as in xarray.apply_ufunc(hashnoise.{function}, x, y)")
        if len(spaces) > 1:
            raise TypeError(f"{function}: arrays of {' and '.join(names)} do not go together; convert one, as in "
                            "torch.from_numpy(x) or jax.numpy.asarray(x)")
        (self.xp, one), = spaces.items()
        self.is_numpy = self.xp is numpy
        self.is_number = self.is_numpy and not any(array.ndim for array in arrays)
        self.device = {"device": one.device} if names == ["torch"] else {}
        self.finite = []  # for each array of floats, and for coordinates
        self.masks = []

    def call(self, name, *arguments, form=""):
        """A function of the text, by its name without the dimensions."""
        return getattr(self.text, f"_{name}{self.dimensions}{form}")(self.xp, *arguments)

    def floats(self, name, value):
        array = self._array("f", name, value, self.xp.float32)
        if _is_array(value) or name in AXES:
            self.finite.append(self.xp.isfinite(array))
        return array

    def words(self, name, value):
        return self._array("u", name, self.text._word(value), self.xp.int32)

    def _array(self, kind, name, value, dtype):
        if isinstance(value, numpy.ma.MaskedArray):
            self.masks.append(numpy.ma.getmaskarray(value))
            value = value.filled(0)
        if not _is_array(value):
            value = self.xp.asarray(value, dtype=dtype, **self.device)
        else:
            self.text._check(self.function, kind, name, value)
            value = value if value.dtype == dtype else self.text._cast(value, dtype)
        # NumPy warns of a single word that wraps around.
        return value.reshape(1) if self.is_numpy and not value.ndim else value

    def result(self, values):
        """An array, or planes; NaN where a coordinate is no number."""
        finite = functools.reduce(operator.and_, self.finite)
        planes = [self.text._where(self.xp, finite, value, float("nan")) for value in _parts(values)]
        whole = self.xp.stack(planes) if len(planes) > 1 else planes[0]
        whole = whole[..., 0] if self.is_number else whole
        return with_mask(whole, self.masks, is_number=False) if self.masks else whole


def _check_numbers(*arguments):
    """The checks of hashnoise, of those settings that are numbers."""
    make_field(*arguments)
    return True


# torch.compile calls it while it traces, and its result is a constant: no tracer sees into the compiled part. This is the
# mark of torch.compiler.assume_constant_result.
_check_numbers._dynamo_marked_constant = True


def _text(arithmetic, dimensions):
    """A module of the text. Programs that freeze others find imports that are written out."""
    if (arithmetic, dimensions) == ("fast", 1):
        from . import _fast1 as text
    elif (arithmetic, dimensions) == ("fast", 2):
        from . import _fast2 as text
    elif (arithmetic, dimensions) == ("fast", 3):
        from . import _fast3 as text
    elif (arithmetic, dimensions) == ("fast", 4):
        from . import _fast4 as text
    elif (arithmetic, dimensions) == ("fixed", 1):
        from . import _fixed1 as text
    elif (arithmetic, dimensions) == ("fixed", 2):
        from . import _fixed2 as text
    elif (arithmetic, dimensions) == ("fixed", 3):
        from . import _fixed3 as text
    else:
        from . import _fixed4 as text
    return text


def _evaluated(name, least, kind, coordinates, *, points, cell, seed, period, arithmetic, noise=None, **options):
    """A function's result, as `evaluated` of hashnoise has it."""
    function = f"arrays.{name}"
    if arithmetic not in _ARITHMETICS:
        raise ValueError(f"{function}: arithmetic must be one of {', '.join(_ARITHMETICS)}; not {arithmetic!r}"
                         f"{suggestion(arithmetic, _ARITHMETICS)}")
    if points is not None:
        coordinates, cell = along_axes(function, coordinates, points, cell, _checked_array)
    dimensions = checked_dimensions(function, coordinates, 1 if points is not None else least)
    coordinates, seed = coordinates[:dimensions], 0 if seed is None else _constant(seed)
    if dimensions == 1 and points is None:
        refuse_points(function, "x", tuple(numpy.shape(coordinates[0])))
    settings = {option: _constant(value) for option, value in options.items() if value is not None}
    numbers = {option: value for option, value in {**settings, "seed": seed}.items()
               if option not in _ARRAYS or not any(map(_is_array, _parts(value)))}
    periods = None if period is None else per_axis(function, "period", period, dimensions, ruled_number)
    _check_numbers(function, dimensions, *((name, "") if kind == "noise" else (noise, name)), {**numbers, "period": periods})
    if cell is not None:
        cell = (cell,) if dimensions == 1 and not isinstance(cell, tuple) else cell
        cell = per_axis(function, "cell", cell, dimensions, _whole)
    space = _Space(function, arithmetic, dimensions, [
        *coordinates, *(cell or ()), seed, *(part for value in settings.values() for part in _parts(value))])
    with numpy.errstate(all="ignore") if space.is_numpy else contextlib.nullcontext():
        settings.update((option, space.floats(option, settings[option])) for option in _FLOATS if option in settings)
        floats = [space.floats(axis, value) for axis, value in zip(AXES, coordinates)]
        seed = space.words("seed", seed)
        if arithmetic == "fast" and kind == "fractal" and (cell is not None or any(periods or ())):
            # Octaves are at whole numbers then, also by what moves them.
            refuse = functools.partial(_text("fast", 2)._no_slope, space.xp)
            floats = [*map(refuse, floats)]
            moving = ("lacunarity", "gain", "amplitude") if name == "warp_progressive" else ("lacunarity",)
            settings.update((option, refuse(settings[option])) for option in moving)
        place = cell and space.call("place_in_cell", *(space.words("cell", value) for value in cell), *floats)
        if any(periods or ()):
            periods = [space.words("period", value) for value in periods]
            place = space.call("tile", place, *periods, form="_place") if place else space.call("tile", *floats, *periods)
        if kind == "noise":
            return space.result(_noise(space, name, place or space.call("place_of", *floats), seed, settings))
        return space.result(_sum(space, name, noise, place, floats, seed, settings))


def _noise(space, name, place, seed, settings):
    passed, form = [settings[option] for option in ("phase", "jitter") if option in settings], "_place"
    if "metric" in settings and "phase" not in settings:
        passed.append(METRICS[settings["metric"]])
    if name == "phasor":
        wave = settings.get("wave", [3.0, *[0.0] * (space.dimensions - 1)])
        passed = [*(space.floats("wave", along) for along in wave), *(passed or [space.floats("phase", 0.0)])]
        if "bandwidth" in settings:
            passed, form = [*passed[:-1], settings["bandwidth"], passed[-1]], "_place_bandwidth"
    elif "jitter" not in settings and "phase" in settings:
        form = "_place_phase"
    elif "phase" in settings:
        name = f"{name}_phase"
    elif "jitter" in settings:
        form = "_place_jitter"
    return space.call(name, place, *passed, seed, form=form)


def _sum(space, name, noise, place, floats, seed, settings):
    """A loop over the octaves, as docs/reference/fractals.md has it."""
    octaves, scales = settings.get("octaves", 6), [settings["lacunarity"], settings["gain"]]
    where, form = ([place], "_place") if place else (floats, "")
    if name in ("perlin_worley", "curl_fbm"):
        phase = [settings["phase"]] if "phase" in settings else []
        return space.call(name, *where, *phase, octaves, *scales, seed, form=form + "_phase" * len(phase))
    step, strength = _STEPS.get(name, f"add_{name}"), [settings["strength"]] if "strength" in settings else []
    o = space.call("octaves_of", *where, octaves, *scales, seed, form=form)
    for option, passed in (("detail", []), ("footprint", [octaves])):
        if option in settings and place:
            raise ValueError(f"{space.function}: detail and footprint need positions, without a period and a cell")
        if option in settings:
            step = f"add_{option}"
            o = o._replace(sum=space.call("octaves_of", *floats, settings[option], *passed, *scales, seed,
                                          form=f"_{option}").sum)
    slopes = space.call("slopes_of", o) if name in ("fbm_d", "eroded") else None
    shifts = space.call("shifts_of", o, settings["amplitude"]) if "amplitude" in settings else None
    own = {"jitter": space.floats("jitter", 1.0)} if "jitter" in getattr(_noises, noise).__kwdefaults__ else {}
    while True:
        values = _parts(_noise(space, noise, o.place, o.seed, own))
        if slopes:
            o, slopes = space.call(step, o, slopes, *values, *strength, form="_slopes" if name == "fbm_d" else "")
        elif name == "warp":
            shifts = space.call(step, o, shifts, *values, form="_shifts")
        elif shifts:
            o, shifts = space.call(step, o, shifts, *values)
        else:
            at = o.sum.at
            o = space.call(step, o, *values, *strength)
            o = o._replace(sum=o.sum._replace(at=at))  # octaves finer than a footprint, an array, add 0
        if o.sum.at + 1 >= o.sum.octaves:
            break
        o = space.call("next", o)[1]
    if name == "fbm_d":
        return space.call("mean", o, slopes, form="_slopes")
    if shifts:
        return space.call("mean", o, shifts, form="_shifts")
    value = space.call("density" if name == "clouds" else "mean", o)
    return space.text._min(space.xp, 2.0 * value - 1.0, 1.0) if name == "billow" else value


def _is_array(value):
    """NumPy's numbers are none: they go with the arrays of all libraries."""
    return not isinstance(value, (int, float, numpy.generic)) and hasattr(value, "dtype")


def _checked_array(function, name, value):
    if not _is_array(value):
        raise TypeError(f"{function}: {name} must be an array, not {type(value).__name__}")
    return value


def _constant(value):
    """A number that changes from call to call is a symbol below torch.compile. Its checks want its number now."""
    if isinstance(value, tuple):
        return tuple(map(_constant, value))
    if isinstance(value, float):
        return float.fromhex(value.hex())
    return operator.index(value) if isinstance(value, int) and not isinstance(value, bool) else value


def _parts(value):
    return value if isinstance(value, (tuple, list)) else (value,)


def _whole(function, name, value):
    return value if _is_array(value) else ruled_number(function, name, value)


def _functions():
    for kind, functions in (("noise", _noises.NOISES), ("fractal", _sums.SUMS)):
        for name, of in functions.items():
            dimensions = [d for d in range(1, 5) if name in _core.noise_names(d) + _core.fractal_names(d)]
            options = {option: value for option, value in of.__kwdefaults__.items() if option not in _ABSENT}
            doc = of.__doc__.partition("help(hashnoise)")[0] + (
                "help(hashnoise.arrays) explains how arrays of PyTorch, JAX and CuPy are passed, and help(hashnoise) the "
                "options that are\nnot named here.")
            yield name, named_function(__name__, name, dimensions[-1], options, doc,
                                       functools.partial(_evaluated, name, dimensions[0], kind))


globals().update(_functions())
