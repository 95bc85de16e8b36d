"""The bounds that the suite includes, rounded up: conformance/expected/bounds.inc."""

from __future__ import annotations

from dataclasses import dataclass, replace
from decimal import ROUND_CEILING, Decimal
from functools import cache
from pathlib import Path

from tables.inc import read_rows
from tree import BOUNDS

PATH = BOUNDS

HEAD = """\
// What is proven of each noise, rounded up. Written by tools/bounds --write; docs/accuracy.md tells what it means.
//
//   NOISE_BOUNDS(noise, dimensions, gradient, cell_error, error, lipschitz, limit, fixed_error, fixed_limit)
//
//   gradient      octahedral, sine, or none for a noise that has no gradients
//   cell_error    of floats, from a cell and a fraction; error, from a position
//   lipschitz     how fast the noise changes: the error per error of the position
//   limit         how large it can be, exact as well as computed in floats
//   fixed_...     the same of fixed arithmetic
//
//   SINE_BOUNDS(error, fixed_error)    of a component of the sine gradient

"""


@dataclass(frozen=True)
class Bounds:
    """A row of the table: a noise in a number of dimensions, with a kind of gradient."""
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
        """As the table has it."""
        numbers = {name: float(rounded_up(getattr(self, name), digits)) for name, digits in DIGITS.items()}
        return replace(self, **numbers)


DIGITS = {"cell_error": 3, "error": 3, "lipschitz": 3, "limit": 6, "fixed_error": 3, "fixed_limit": 6}


@dataclass(frozen=True)
class SineBounds:
    error: float
    fixed_error: float


def rounded_up(value: float, digits: int) -> Decimal:
    """To a number of significant digits."""
    exact = Decimal(value)
    return exact.quantize(Decimal((0, (1,), exact.adjusted() - digits + 1)), ROUND_CEILING)


def scientific(value: float, digits: int = 3) -> str:
    """Rounded up, as 3.24e-6."""
    return f"{rounded_up(value, digits):.{digits - 1}e}"


def shortest(value: float, digits: int) -> str:
    """Rounded up, without zeros at the end."""
    text = f"{rounded_up(value, digits):f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def noise_row(bounds: Bounds) -> str:
    """A line of the table, of bounds that are not rounded yet."""
    fields = [f'"{bounds.noise}"', str(bounds.dimensions), bounds.gradient, scientific(bounds.cell_error),
              scientific(bounds.error), str(rounded_up(bounds.lipschitz, 3)), str(bounds.rounded().limit),
              scientific(bounds.fixed_error), str(bounds.rounded().fixed_limit)]
    return f"NOISE_BOUNDS({', '.join(fields)})\n"


def sine_row(bounds: SineBounds) -> str:
    return f"SINE_BOUNDS({bounds.error.hex().replace('1.0000000000000p', '1p')}, {scientific(bounds.fixed_error)})\n"


def read(path: Path = PATH) -> list[Bounds]:
    """The rows of the table, which hold rounded numbers."""
    lines = []
    for row in read_rows(path, "NOISE_BOUNDS", 9, frozenset({"SINE_BOUNDS"})):
        lines.append(Bounds(row.text(0), int(row.word(1)), row.word(2), *map(float, row.arguments[3:])))
    return lines


def read_sine(path: Path = PATH) -> SineBounds:
    row, = read_rows(path, "SINE_BOUNDS", 2, frozenset({"NOISE_BOUNDS"}))
    return SineBounds(float.fromhex(row.arguments[0]), float(row.arguments[1]))


@cache
def bounds_of(noise: str, dimensions: int, gradient: str) -> Bounds:
    """The row of a noise with a kind of gradient, or of a noise that has none."""
    for bounds in read():
        if (bounds.noise, bounds.dimensions) == (noise, dimensions) and bounds.gradient in (gradient, "none"):
            return bounds
    raise LookupError(f"{PATH} has no bounds of {noise} in {dimensions}D with the gradient {gradient}: write "
                      f"tools/lib/bounds/noises/{noise}.py, then run tools/bounds --write")
