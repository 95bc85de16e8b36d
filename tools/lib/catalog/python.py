"""The functions of the Python package: their code, their docstrings and their types."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from base.pieces import is_deleted
from base.tree import ROOT
from catalog.model import AXES, Catalog, CatalogError, Function, Noise, Sum
from catalog.sections import with_section

PACKAGE = "packages/python/hashnoise"
STUB = f"{PACKAGE}/__init__.pyi"
WIDTH = 120
PLACE = ("0.5", "0.25", "0.75", "0.125")  # of the examples: as many of them as an example has axes

NOISES = '''\
# Made by tools/make catalog from catalog/noises.toml and settings.toml.
"""The noises: each is a function of arrays of coordinates. help(hashnoise) describes their common options."""
'''
SUMS = '''\
# Made by tools/make catalog from catalog/sums.toml and settings.toml.
"""The fractals and the warps, over any noise. help(hashnoise) describes their common options."""
'''
ARRAYS_STUB = '''\
# Made by tools/make catalog from catalog/noises.toml, sums.toml and settings.toml.
"""The types of hashnoise.arrays. Arrays may be of any library, and settings may be arrays."""

from collections.abc import Sequence
from typing import Any, Literal

from .. import _Metric, _Noise, _Whole, _Wholes

'''
# Overloads of a grid in a stub: its array has the type of dtype, or of `out`.
GRID = ("name: _Name, size: _Wholes, *, step: _Numbers, origin: _Numbers = 0.0, cell: _Wholes | None = None, "
        "first: _Wholes = 0, seed: _Whole = 0, noise: _Noise | None = None, octaves: _Whole | None = None, "
        "lacunarity: _Number | None = None, gain: _Number | None = None, strength: _Number | None = None, "
        "amplitude: _Number | None = None, detail: _Number | None = None, footprint: _Number | None = None, "
        "period: _Wholes | None = None, wave: _Vector | None = None, bandwidth: _Number | None = None, "
        "phase: _Number | None = None, "
        'jitter: _Number | None = None, metric: _Metric | None = None, arithmetic: _Arithmetic = "fast", '
        "dtype: {dtype}, range: _Vector | None = None, out: {out}, return_range: {return_range}, "
        "threads: _Whole | None = None, instruction_set: str | None = None")
ARRAYS = (('Literal["float32"] | None = None', "None = None", "_Values"),
          ('Literal["float16"]', "None = None", "npt.NDArray[np.float16]"),
          ('Literal["uint16"]', "None = None", "npt.NDArray[np.uint16]"),
          ("type[_Kind] | np.dtype[_Kind]", "None = None", "npt.NDArray[_Kind]"),
          ("_Dtype | None = None", "npt.NDArray[_Kind]", "npt.NDArray[_Kind]"))
GRIDS = [*((dtype, out, result.format(array), return_range)
           for return_range, result in (("Literal[False] = False", "{0}"), ("Literal[True]", "tuple[{0}, _Extent]"))
           for dtype, out, array in ARRAYS),
         ("_Dtype | None = None", "npt.NDArray[Any] | None = None",
          "npt.NDArray[Any] | tuple[npt.NDArray[Any], _Extent]", "bool")]


def files(catalog: Catalog) -> dict[Path, str]:
    if is_deleted("python"):
        return {}
    functions = (*catalog.noises, *catalog.sums)
    noises = _module(NOISES, catalog.noises, "noise", "NOISES", catalog)
    sums = _module(SUMS, catalog.sums, "fractal", "SUMS", catalog)
    types = "".join(_types(function, catalog) for function in functions)
    stub = with_section(STUB, "metrics", _literal("_Metric", catalog.metrics))[1]
    names = _literal("_Noise", [noise.name for noise in catalog.noises]) + _literal(
        "_Fractal", [sum_.name for sum_ in catalog.sums])
    stub = with_section(STUB, "names", names, stub)[1]
    stub = with_section(STUB, "grid", "".join(_of_grid(*kind) for kind in GRIDS), stub)[1]
    arrays = ARRAYS_STUB + _list("__all__ = [", [f'"{function.name}"' for function in functions], "]") + "\n" + "".join(
        _types_of_arrays(function, catalog) for function in functions)
    return dict([(ROOT / PACKAGE / "arrays" / "__init__.pyi", arrays), (ROOT / PACKAGE / "_noises.py", noises), (ROOT / PACKAGE / "_sums.py", sums),
                 with_section(STUB, "functions", types, stub),
                 with_section(f"{PACKAGE}/_evaluate.py", "metrics", _metrics(catalog.metrics))])


@dataclass(frozen=True)
class _Option:
    """An option of a function, as its signature has it."""
    name: str
    default: str
    type: str  # that of arrays
    number_type: str = ""  # where coordinates are numbers, if it is another


_POINTS = _Option("points", "None", "npt.ArrayLike")  # in a stub it has overloads of its own
_PERIOD = _Option("period", "None", "_Wholes | None")
_WAVE = _Option("wave", "None", "_Vector | None")
_BANDWIDTH = _Option("bandwidth", "None", "_Number | None")
_PHASE = _Option("phase", "None", "_Number | None")
_SUM_IN_DETAIL = (_Option("detail", "None", "_Number | None"), _Option("footprint", "None", "_Number | None"))
_CELL = _Option("cell", "None", "_Cells | None", "_Whole | Sequence[_Whole] | None")
_ARITHMETIC = _Option("arithmetic", '"fast"', "_Arithmetic")
_LAST = (_Option("out", "None", "_Values | None", "None"),
         _Option("threads", "None", "_Whole | None"),
         _Option("instruction_set", "None", "str | None"))


def _options(function: Function, catalog: Catalog) -> tuple[_Option, ...]:
    """All of them, in the order of the signature."""
    own = _own_options(function, catalog)
    own = (*own, _PERIOD) if isinstance(function, Sum) else (_PERIOD, *own)
    options = (_POINTS, _setting("seed", catalog), *own, _CELL, _ARITHMETIC, *_LAST)
    if unknown := function.options.keys() - {option.name for option in options}:
        raise CatalogError(f"catalog: {function.name} has no option {min(unknown)} in Python")
    return options


def _own_options(function: Function, catalog: Catalog) -> Iterable[_Option]:
    """Options that not all functions have."""
    if isinstance(function, Sum):
        return _of_sum(function, catalog)
    known = (_WAVE, _BANDWIDTH, _PHASE, _setting("jitter", catalog), _Option("metric", f'"{catalog.metrics[0]}"', "_Metric"))
    return (option for option in known if option.name in function.options)


def _of_sum(function: Sum, catalog: Catalog) -> Iterable[_Option]:
    """Options that only sums have. Where a detail may stand in place of octaves, neither has a default."""
    in_detail = tuple(option for option in _SUM_IN_DETAIL if option.name in function.options)
    if function.takes_noise:
        yield _Option("noise", f'"{function.noise}"', "_Noise")
    yield _Option("octaves", "None", "_Whole | None") if in_detail else _setting("octaves", catalog)
    yield _setting("lacunarity", catalog)
    yield _setting("gain", catalog)
    if "phase" in function.options:
        yield _PHASE
    if function.strength:
        yield _Option(function.strength.name, repr(float(function.strength.default)), "_Number")
    yield from in_detail


def _setting(name: str, catalog: Catalog) -> _Option:
    setting = catalog.settings[name]
    if setting.default is None:
        raise CatalogError(f"catalog/settings.toml: {name} has no default")
    if setting.is_whole:
        return _Option(name, str(setting.default), "_Whole")
    return _Option(name, repr(float(setting.default)), "_Number")


def _module(head: str, functions: Sequence[Noise] | Sequence[Sum], kind: str, table: str, catalog: Catalog) -> str:
    names = _list("__all__ = [", [f'"{function.name}"' for function in functions], "]")
    code = "\n".join(_function(function, kind, catalog) for function in functions)
    made = f'from ._evaluate import functions_of\n\n{names}\n_{kind} = functions_of(__name__, "{kind}")\n'
    return (f"{head}\n{made}\n{code}\n"
            f"{table} = {{name: globals()[name] for name in __all__}}\n")


def _function(function: Function, kind: str, catalog: Catalog) -> str:
    own = [f"{option.name}={option.default}" for option in _own_options(function, catalog)]
    head = [f'"{function.name}"', str(function.first), str(function.last), *own, 'doc="""\\']
    return f'{_list(f"{function.name} = _{kind}(", head, "")}{_docstring(function)}""")\n'


def _docstring(function: Function) -> str:
    about = dict(function.options)
    if isinstance(function, Sum) and function.strength:
        about[function.strength.name] = function.strength.about
    about |= {"returns": function.returns, "source": function.source}
    width = max(map(len, about)) + 2
    axes = min(max(2, function.first), function.last)
    example = f'>>> hashnoise.{function.name}({", ".join(PLACE[:axes])}, seed=7, arithmetic="fixed")'
    parts = [_filled(function.sentence()), *([_filled(function.more)] if function.more else []),
             "".join(_filled(f"{name:{width}}{text}", width) for name, text in about.items()),
             f"{example}\n{function.example}".rstrip() + "\n"]
    return "\n".join(parts)


def _filled(text: str, indent: int = 0) -> str:
    """Lines of a docstring; those behind the first are indented by so much."""
    return textwrap.fill(text, WIDTH, subsequent_indent=" " * indent, break_long_words=False,
                         break_on_hyphens=False) + "\n"


def _types(function: Function, catalog: Catalog) -> str:
    """A function in a stub; one that returns a single value for a point returns a number for numbers."""
    points, *options = _options(function, catalog)
    of_axes = [replace(points, type="None"), *options]
    of_numbers = [replace(option, type=option.number_type or option.type) for option in of_axes]
    number = [_signature(function, _coordinates(function, "_Number"), of_numbers, "float")]
    # A default in the code has to be one in an overload, too.
    nothing = [*(f"{axis}: None = None" for axis in AXES[:function.last]), "/", "*", f"{points.name}: {points.type}"]
    return "".join([
        *(number if function.shape == "value" else []),
        _signature(function, _coordinates(function, "npt.ArrayLike"), of_axes, "_Values"),
        _signature(function, nothing, options, "_Values")])


def _types_of_arrays(function: Function, catalog: Catalog) -> str:
    """A function of hashnoise.arrays in its stub."""
    known = {"arithmetic": 'Literal["fast", "fixed"]', "wave": "Sequence[Any] | None", "seed": "Any", "points": "Any",
             "cell": "Any"}
    options = [f"{one.name}: {known.get(one.name, one.type.replace('_Number', 'Any').replace('Any | None', 'Any'))} = "
               f"{one.default}" for one in _options(function, catalog) if one not in _LAST]
    places = [*(f"{axis}: Any = None" for axis in AXES[:function.last]), "/", "*"]
    return _list(f"def {function.name}(", [*places, *options], ") -> Any: ...")


def _coordinates(function: Function, type_: str) -> list[str]:
    return [*(f"{axis}: {type_}" + (" | None = None" if index >= function.first else "")
              for index, axis in enumerate(AXES[:function.last])), "/", "*"]


def _signature(function: Function, places: Iterable[str], options: Iterable[_Option], result: str) -> str:
    typed = [f"{option.name}: {option.type} = {option.default}" for option in options]
    return "@overload\n" + _list(f"def {function.name}(", [*places, *typed], f") -> {result}: ...")


def _of_grid(dtype: str, out: str, result: str, return_range: str) -> str:
    options = GRID.format(dtype=dtype, out=out, return_range=return_range).split(", ")
    return "@overload\n" + _list("def grid(", options, f") -> {result}: ...")


def _literal(name: str, names: Sequence[str]) -> str:
    return _list(f"{name}: TypeAlias = Literal[", [f'"{name}"' for name in names], "]")


def _metrics(metrics: Sequence[str]) -> str:
    return _list("METRICS = {", [f'"{name}": {number}' for number, name in enumerate(metrics, 1)], "}")


def _list(head: str, parts: Sequence[str], end: str) -> str:
    """Parts with commas between them, in lines that begin below the first part."""
    lines = [head]
    for index, part in enumerate(parts):
        part += end if index == len(parts) - 1 else ","
        if index and len(lines[-1]) + 1 + len(part) > WIDTH:
            lines.append(" " * len(head) + part)
        else:
            lines[-1] += f" {part}" if index else part
    return "\n".join(lines) + "\n"
