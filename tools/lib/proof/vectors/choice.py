"""Which rows of a golden file become vectors: those that have something that few others have, such as a cell beside the
seam of a period, and usual ones between them."""

from __future__ import annotations

import math
from bisect import bisect
from collections import Counter
from collections.abc import Hashable, Iterator, Mapping, Sequence

COUNT = 50
USUAL = 15  # of them, whatever they have
# At most, of rows whose results are all 0, unless there are too few others: noise is 0 at whole positions, and so may a
# port be that is nothing else.
ZERO = 8
AXES = "xyzw"
NAMED = (0, 1, -1, 2**31 - 1, -2**31, 2**31, 2**32 - 1)  # integers that count by themselves
SIZES = (2.0**-20, 1, 16, 2.0**10, 2.0**19, 2.0**23, 2.0**31)  # beyond 2^23 a float has no fraction
NEAR = 2.0**-16  # to the border of a cell

Values = Mapping[str, float]  # of the columns


def size_of(value: float) -> int:
    """Among which numbers it is."""
    return bisect(SIZES, abs(value))


def kind_of(value: float) -> str:
    """Where in a cell it is."""
    fraction = value - math.floor(value)
    if fraction in (0, 0.5):
        return "whole" if fraction == 0 else "half"
    return "near" if min(fraction, 1 - fraction) < NEAR else "inside"


def sign_of(value: float) -> float:
    return math.copysign(1, value)


def periods_of(row: Values) -> Iterator[tuple[str, int, int]]:
    """For each axis with a period: the period, and which of its cells the row is in."""
    for axis in AXES:
        period = row.get(f"p{axis}", 0)
        if period > 0:
            yield axis, int(period), math.floor(row[f"c{axis}"] if f"c{axis}" in row else row[axis]) % int(period)


def features(row: Values) -> set[Hashable]:
    """Properties of inputs that distinguish rows."""
    found: set[Hashable] = set()
    for name, value in row.items():
        if isinstance(value, int):
            found.add((name, value if value in NAMED else (sign_of(value), value.bit_length() // 8)))
        else:
            found |= {(name, sign_of(value), size_of(value)), (name, sign_of(value), kind_of(value))}
            if name[0] == "f" and value in (0, 1):  # the ends of a fraction
                found.add((name, value))
    for axis, period, cell in periods_of(row):
        found.add((axis, "of a period", "first" if cell == 0 else "last" if cell == period - 1 else "within"))
    found.add(("signs", *(sign_of(row[axis]) for axis in AXES if axis in row)))
    return found


def chosen(inputs: Sequence[set[Hashable]], results: Sequence[Sequence[float]]) -> list[int]:
    """The numbers of so many rows, in their order; of all if there are fewer. The features are the inputs'."""
    said = [of_row | {("result", i, sign_of(value)) for i, value in enumerate(values)}
            for of_row, values in zip(inputs, results)]
    often = Counter(one for of_row in said for one in of_row)
    # The order in which a set is gone through changes from run to run, and fsum does not depend on it.
    order = sorted(range(len(said)), key=lambda i: -math.fsum(1 / often[one] for one in said[i]))
    seen: set[Hashable] = set()
    new: list[int] = []
    zeros = 0
    for i in order:
        is_zero = not any(results[i])
        if said[i] - seen and len(new) < COUNT - USUAL and (not is_zero or zeros < ZERO):
            new.append(i)
            seen |= said[i]
            zeros += is_zero
    rest = sorted(set(order) - set(new))
    for others in ([i for i in rest if any(results[i])], [i for i in rest if not any(results[i])]):
        missing = min(COUNT - len(new), len(others))
        new += [others[len(others) * i // missing] for i in range(missing)]
    return sorted(new)
