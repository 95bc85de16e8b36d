"""Whether what the tests draw comes as often as it should."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Hashable, Iterable, Mapping

# Chi-square has the mean and half the variance of its degrees of freedom. By chance it is so many deviations above the
# mean in fewer than one of a thousand samples, if there are five degrees or more; what is not uniform is far above.
LIMIT = 5


def unevenness(found: Iterable[Hashable], chances: Mapping[Hashable, float]) -> float:
    """By how many deviations chi-square is above its mean."""
    counts = Counter(found)
    if not counts.keys() <= chances.keys():
        raise ValueError(f"no chance for {counts.keys() - chances.keys()}")
    total, freedom = counts.total(), len(chances) - 1
    square = sum((counts[cell] - total * chance)**2 / (total * chance) for cell, chance in chances.items())
    return (square - freedom) / math.sqrt(2 * freedom)


def equal_chances(cells: Iterable[Hashable]) -> dict[Hashable, float]:
    cells = list(cells)
    return {cell: 1 / len(cells) for cell in cells}
