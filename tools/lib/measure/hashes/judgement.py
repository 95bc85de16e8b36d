"""From a statistic to a verdict: every threshold comes from the distribution of the statistic on a random lattice."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Callable

import numpy as np
from scipy import stats

# The chance that a random lattice fails one test: what SMHasher3 calls a failure. A full run makes some thousands of
# tests, so a random library passes all of them with a probability above 0.99.
ALPHA = 2.0 ** -20


@dataclass
class Sums:
    """The values behind a finding, by comparison: standard normal ones, or tables of counts."""
    values: np.ndarray
    counts: bool
    name: Callable[..., str] | None
    scale: float = 1.0


@dataclass
class Finding:
    test: str
    statistic: float
    floor: float        # what the statistic exceeds with a probability of 1/2 on a random lattice
    threshold: float    # what it exceeds with a probability of ALPHA
    p: float            # the probability that it is at least as far out on a random lattice
    samples: int        # values that each comparison rests on
    comparisons: int    # the statistic is the largest of so many
    where: str = ""
    lower: float | None = None  # the threshold below, if the statistic may not be too small either
    scores: Sums | None = None  # what may be summed over windows, if that makes sense

    @property
    def passed(self) -> bool:
        return bool(self.p >= ALPHA)


def _single(p: float, comparisons: int) -> float:
    """The probability that each of so many independent comparisons may have, if p is that of the largest."""
    return -math.expm1(math.log1p(-p) / comparisons)


def peak(test: str, statistic: float, null: Any, samples: int, comparisons: int, where: str = "",
         two_sided: bool = False) -> Finding:
    """A verdict on the largest of several values, each distributed as null (of scipy) on a random lattice.

    Of two sides, the statistic is the largest magnitude, and null is symmetric about 0. The values need not be
    independent: the bound of Bonferroni holds anyway.
    """
    sides = 2 if two_sided else 1
    statistic = float(statistic)
    p = min(1.0, float(null.sf(statistic)) * comparisons * sides) if math.isfinite(statistic) else 0.0
    return Finding(test, statistic, float(null.isf(_single(0.5, comparisons) / sides)),
                   float(null.isf(ALPHA / comparisons / sides)), p, int(samples), int(comparisons), where)


def normal(test: str, z: np.ndarray, samples: int, where=None, scale: float = 1.0, pool: bool = True) -> Finding:
    """A verdict on standard normal values: the largest magnitude, shown times scale."""
    z = np.asarray(z, np.float32)
    magnitude = np.abs(z)
    at = np.unravel_index(np.argmax(magnitude), z.shape)
    finding = peak(test, magnitude[at] * scale, stats.norm(scale=scale), samples, z.size, where(*at) if where else "",
                   two_sided=True)
    if pool:
        finding.scores = Sums(z, False, where, scale)
    return finding


def join(findings: list[Finding]) -> Finding:
    """The verdict on windows together, from the sums of their values."""
    sums = [finding.scores for finding in findings]
    samples = sum(finding.samples for finding in findings)
    name = f"{findings[0].test}, all"
    total = sum(s.values for s in sums)
    if sums[0].counts:
        found = chi_square(name, total, sums[0].name)
    else:
        # Windows of different sizes are not mixed: the sum of k standard normal values has the variance k.
        found = normal(name, total / np.sqrt(len(sums)), samples, sums[0].name, sums[0].scale / np.sqrt(len(sums)))
    found.scores = None
    found.where = f"{found.where}; {len(sums)} together"
    return found


def two_tails(test: str, statistic: float, null: Any, samples: int, comparisons: int = 1, where: str = "") -> Finding:
    """A verdict on a value that may be neither too large nor too small: too even is as wrong as too uneven."""
    statistic = float(statistic)
    # With a discrete distribution reaching a value counts, not only exceeding it.
    discrete = isinstance(null.dist, stats.rv_discrete)
    reach = null.sf(statistic - 1 if discrete else statistic)
    tail = min(float(reach), float(null.cdf(statistic)))
    q = ALPHA / 2 / comparisons
    return Finding(test, statistic, float(null.median()), float(null.isf(q)), min(1.0, tail * 2 * comparisons),
                   int(samples), int(comparisons), where, float(null.ppf(q)))


def chi_square(test: str, counts: np.ndarray, where=None) -> Finding:
    """A verdict on tables of counts (the last axis) whose bins are equally likely: the most unlikely table."""
    counts = np.atleast_2d(np.asarray(counts, float))
    samples = counts.sum(axis=-1, keepdims=True)
    expected = samples / counts.shape[-1]
    statistics = ((counts - expected) ** 2 / expected).sum(axis=-1).reshape(-1)
    null = stats.chi2(counts.shape[-1] - 1)
    worst = int(np.argmin(np.minimum(null.sf(statistics), null.cdf(statistics))))
    finding = two_tails(test, statistics[worst], null, int(samples.max()), statistics.size,
                        where(worst) if where else "")
    finding.scores = Sums(counts, True, where)
    return finding


def poisson(test: str, count: int, expected: float, samples: int, where: str = "") -> Finding:
    """A verdict on how many rare things happened, against the expected number: neither too many nor too few."""
    return two_tails(test, count, stats.poisson(expected), samples, 1, where)
