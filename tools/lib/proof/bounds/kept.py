"""kept.csv: what 1.1.0 derived and nothing derives now. The Lipschitz constants of noises and of their derivatives, which
kept_test.py compares with the text in doubles, and the limits of values as they are computed: some are less than the range
and the error, as 1.1.0 bounded the last steps of HN_FIXED by themselves."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from proof.bounds.table import rounded_up

PATH = Path(__file__).with_name("kept.csv")


@dataclass(frozen=True)
class Kept:
    lipschitz: float
    limit: float | None  # of floats; None for what is newer
    fixed_limit: float | None

    def limits(self, name: str, least: float, promise: float, errors: tuple[float, float]) -> tuple[float, float]:
        """Of floats and of HN_FIXED: from the range `least` to that and an error, or to the contract's promise."""
        found = []
        for limit, error in zip((self.limit, self.fixed_limit), errors):
            most = max(promise, float(rounded_up(least + error, 6)))
            found.append(min(limit or most, most))
        if min(found) < least:
            raise LookupError(f"{PATH.name}: {name} has the limit {min(found)}, which is less than its range, {least:.6g}")
        return found[0], found[1]


@cache
def read(path: Path = PATH) -> dict[tuple[str, int, str, str], Kept]:
    """By noise, dimensions, gradient and result."""
    with path.open(encoding="utf-8", newline="") as file:
        return {(row["name"], int(row["dims"]), row["gradient"], row["result"]): Kept(
            float(row["lipschitz"]), *(float(row[name]) if row[name] else None for name in ("limit", "fixed_limit")))
            for row in csv.DictReader(file)}


def kept(name: str, dims: int, gradient: str, result: str) -> Kept:
    try:
        return read()[name, dims, gradient, result]
    except KeyError:
        raise LookupError(f"{PATH.name} has no row of {name}, {dims}D, {gradient}, {result}: write one, with a Lipschitz constant and "
                          "no limits") from None
