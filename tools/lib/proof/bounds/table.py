"""The bounds that the suite includes, rounded up: conformance/expected/bounds.inc."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from decimal import ROUND_CEILING, Decimal
from functools import cache
from pathlib import Path

from base.tree import BOUNDS

PATH = BOUNDS

HEAD = """\
// The bounds of each noise, rounded up. Written by tools/make bounds; docs/measured/accuracy.md explains them.
//
//   NOISE_BOUNDS(noise, dimensions, gradient, cell_error, error, lipschitz, limit, fixed_error, fixed_limit)
//
//   gradient      octahedral, sine, or none for a noise that has no gradients
//   cell_error    of floats, from a cell and a fraction; error, from a position
//   lipschitz     how fast the noise changes: the error per error of the position. INFINITY if it jumps
//   limit         how large it can be, exact as well as computed in floats
//   fixed_...     the same of fixed arithmetic
//
//   SLOPE_BOUNDS(the same fields)      of each component of a derivative, with its own units
//
//   SINE_BOUNDS(error, fixed_error)    of a component of the sine gradient
//
//   UNIFORM_BOUNDS(value, slope, reach, coefficient, fixed_value, fixed_slope, fixed_reach, fixed_coefficient)
//
//   value         the error of hn_uniform; slope, that of its derivative, times the reach
//   reach         that of the first number of hn_distribution_fbm, divided by the reach; coefficient, that of another one
//
"""


@dataclass(frozen=True)
class Bounds:
    """A row of the table: a noise in a number of dimensions, with a kind of gradient, or its derivatives."""
    noise: str
    dimensions: int
    gradient: str
    cell_error: float
    error: float
    lipschitz: float
    limit: float
    fixed_error: float
    fixed_limit: float

    def rounded(self) -> Bounds:
        numbers = {name: float(rounded_up(getattr(self, name), digits)) for name, digits in DIGITS.items()}
        return replace(self, **numbers)


DIGITS = {"cell_error": 3, "error": 3, "lipschitz": 3, "limit": 6, "fixed_error": 3, "fixed_limit": 6}


def rounded_up(value: float, digits: int) -> Decimal:
    """To a number of significant digits."""
    exact = Decimal(value)
    if exact.is_infinite():
        return exact
    return exact.quantize(Decimal((0, (1,), exact.adjusted() - digits + 1)), ROUND_CEILING)


def scientific(value: float, digits: int = 3) -> str:
    """Rounded up, as 3.24e-6."""
    if value == 0:
        return "0.0"
    return f"{rounded_up(value, digits):.{digits - 1}e}"


def shortest(value: float, digits: int) -> str:
    """Rounded up, without zeros at the end."""
    text = f"{rounded_up(value, digits):f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def plain(value: float, digits: int) -> str:
    """Rounded up, as a number of C++ that is not an integer: 3.24, 119.0, INFINITY."""
    if math.isinf(value):
        return "INFINITY"
    text = f"{rounded_up(value, digits):f}"
    return text if "." in text else f"{text}.0"


def row(macro: str, *fields: str) -> str:
    """A line of the table."""
    return f"{macro}({', '.join(fields)})\n"


def row_of(macro: str, bounds: Bounds) -> str:
    """A line with bounds that are not rounded yet."""
    return row(macro, f'"{bounds.noise}"', str(bounds.dimensions), bounds.gradient, scientific(bounds.cell_error),
               scientific(bounds.error), plain(bounds.lipschitz, 3), str(bounds.rounded().limit),
               scientific(bounds.fixed_error), str(bounds.rounded().fixed_limit))


def _rows(path: Path, macro: str) -> list[list[str]]:
    """The fields of its rows; each row is a line."""
    start = f"{macro}("
    rows = [line.removeprefix(start).removesuffix(")").split(", ")
            for line in path.read_text(encoding="utf-8").splitlines() if line.startswith(start)]
    if not rows:
        raise LookupError(f"{path}: no row of {macro}")
    return rows


def read(path: Path = PATH, macro: str = "NOISE_BOUNDS") -> list[Bounds]:
    """The rows of the table, which hold rounded numbers: of values, or with SLOPE_BOUNDS of derivatives."""
    return [Bounds(noise.strip('"'), int(dimensions), gradient, *map(float, fields))
            for noise, dimensions, gradient, *fields in _rows(path, macro)]


@cache
def bounds_of(noise: str, dimensions: int, gradient: str, macro: str = "NOISE_BOUNDS") -> Bounds:
    """The row of a noise with a kind of gradient, or of a noise that has none."""
    for bounds in read(macro=macro):
        if (bounds.noise, bounds.dimensions) == (noise, dimensions) and bounds.gradient in (gradient, "none"):
            return bounds
    raise LookupError(f"{PATH} has no bounds of {noise} in {dimensions}D with the gradient {gradient}: write "
                      "a proof in tools/lib/proof/bounds/noises, then run tools/make bounds")


def slope_bounds_of(noise: str, dimensions: int) -> Bounds:
    """The row of the derivatives of a noise."""
    return bounds_of(noise, dimensions, "octahedral", "SLOPE_BOUNDS")
