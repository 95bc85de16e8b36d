"""From a statistic to a verdict: every limit comes from the distribution of the statistic on a random lattice."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy import stats

# The chance that a random lattice fails one test: SMHasher3's limit, and about dieharder's. A whole run makes some
# thousands of tests, so a random library passes all of them with a probability above 0.99.
ALPHA = 2.0 ** -20


@dataclass
class Finding:
    test: str
    statistic: float
    limit: float     # what the statistic exceeds with a probability of ALPHA on a random lattice
    p: float         # the probability that it is as large on a random lattice
    where: str = ""

    @property
    def passed(self) -> bool:
        return bool(self.p >= ALPHA)

    def __str__(self) -> str:
        return f"{self.test}: {self.statistic:.4g} (allowed {self.limit:.4g}, p = {self.p:.2g}; {self.where})"


def peak(test: str, statistic: float, null: Any, comparisons: int, where: str = "") -> Finding:
    """A verdict on the largest of so many values, each distributed as null (of scipy) on a random lattice. They need
    not be independent: the bound of Bonferroni holds anyway."""
    p = min(1.0, float(null.sf(statistic)) * comparisons) if np.isfinite(statistic) else 0.0
    return Finding(test, float(statistic), _limit(null, ALPHA / comparisons), p, where)


def _limit(null: Any, q: float) -> float:
    if isinstance(null.dist, stats.rv_discrete):  # isf is wrong where q is below the precision of 1
        return float(np.argmax(null.sf(np.arange(1000)) <= q))
    return float(null.isf(q))


def normal(test: str, z: np.ndarray, where: Callable[..., str] = lambda *at: "", times: int = 1) -> Finding:
    """A verdict on standard normal values: the largest magnitude, of so many times as many."""
    at = np.unravel_index(np.argmax(np.abs(z)), z.shape)
    return peak(test, abs(z[at]), stats.halfnorm(), z.size * times, where(*map(int, at)))


def rare(test: str, count: int, expected: float, where: str = "") -> Finding:
    """A verdict on how many rare things happened."""
    null = stats.poisson(expected)
    return Finding(test, count, _limit(null, ALPHA), float(null.sf(count - 1)), where)


def worst(findings: list[Finding]) -> list[Finding]:
    """The most improbable finding of each test."""
    found: dict[str, Finding] = {}
    for finding in findings:
        before = found.setdefault(finding.test, finding)
        if (finding.p, -finding.statistic) < (before.p, -before.statistic):
            found[finding.test] = finding
    return [*found.values()]
