"""Tests that the components of a vector are independent noises, although one word of a lattice point makes the words of
all of them (docs/reference/contract.md, section 22)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import chain, combinations

import numpy as np
from scipy import stats

from measure.hashes import bits, copies, fourier
from measure.hashes.judgement import Finding, chi_square, normal, peak, poisson
from measure.hashes.lattice import Lattice, shifted
from measure.hashes.library import AXES, Twin

# The bits that decide most of a component, the weightiest first. Value noise takes the low 23 bits of a word as its
# number (section 9). Perlin noise takes three bits on the plane, and in space two signs and the size of the word, whose
# highest bits decide most (section 4).
NUMBER_BITS = 23
NUMBER = [*range(22, 16, -1)]
GRADIENT = {2: [31, 22, 21], 3: [31, 30, 22, 21, 29, 28]}

# How many of these bits of each component are compared, by dimensions and by how many components there are. They are 12
# at most together, as where neighbours are compared. A vector is made of the 24 good bits of one word, so 4096 of these
# make each combination of 12 bits. Of 15 bits together few factors would pass, and to the last bit none can.
TOGETHER = {"numbers": {2: {2: 6}, 3: {2: 6, 3: 4}}, "gradients": {2: {2: 3}, 3: {2: 6, 3: 4}}}

# The good bits of a word, which the further components are made of.
GOOD = 24

OFFSETS = 64       # that are drawn, beside 0
REACH = 3          # cells: how far they go along each axis
STEPS = 8          # of offsets, in a cell
PLACES_IN_CELL = 256
SPAN = {2: 1 << 15, 3: 1 << 11}  # cells along an axis on either side: so wide that few places come near each other


def gathered(words: np.ndarray, chosen: list[int]) -> np.ndarray:
    """The given bits of words as integers, the first one highest."""
    values = np.zeros_like(words)
    for bit in chosen:
        values = values << np.uint32(1) | words >> np.uint32(bit) & np.uint32(1)
    return values


def groups(components: int) -> list[tuple[int, ...]]:
    """Any two of them, and all three."""
    return [group for size in range(2, components + 1) for group in combinations(range(components), size)]


def named(group: tuple[int, ...]) -> str:
    return " and ".join(AXES[k] for k in group)


@dataclass
class Tables:
    """How often each combination of bits came at one point, for each group of components; over windows, too."""
    dimensions: int
    counts: dict[tuple[str, tuple[int, ...]], np.ndarray] = field(default_factory=dict)

    def add(self, components: list[np.ndarray]) -> None:
        """The words of each component in a window."""
        for quantity, chosen in (("numbers", NUMBER), ("gradients", GRADIENT[self.dimensions])):
            values = [gathered(words.reshape(-1), chosen) for words in components]
            for group in groups(len(components)):
                width = TOGETHER[quantity][self.dimensions][len(group)]
                key = np.zeros_like(values[0])
                for k in group:
                    key = key << np.uint32(width) | values[k] >> np.uint32(len(chosen) - width)
                counts = np.bincount(key, minlength=1 << width * len(group)).reshape((1 << width,) * len(group))
                self.counts[quantity, group] = self.counts.get((quantity, group), 0) + counts

    def judge(self) -> list[Finding]:
        findings = []
        for (quantity, group), counts in self.counts.items():
            how_many = "two" if len(group) == 2 else "three"
            made = [chi_square(f"{how_many} components: {quantity}", counts.reshape(1, -1))]
            made.append(waves(f"{how_many} components: waves", counts) if quantity == "numbers" else
                        parities(f"{how_many} components: parities", counts))
            for finding in made:
                finding.scores = None  # windows are together already
                finding.where = "; ".join(filter(None, (f"{named(group)}", finding.where)))
            findings += made
        return findings


def waves(test: str, counts: np.ndarray) -> Finding:
    """The largest ordinate of the spectrum of a table: the spectral test of congruential generators, measured. If
    numbers lie on few lines or planes, waves across these have it. Waves along an axis show nothing of independence."""
    spectrum = np.abs(np.fft.fftn(counts)) ** 2 / counts.sum()
    scores = fourier.ordinate_scores(spectrum)
    alone = _of_one(counts.shape)
    scores[alone] = 0
    at = np.unravel_index(np.argmax(scores), scores.shape)
    # Opposite frequencies have the same ordinate.
    return peak(test, scores[at], stats.expon(), counts.sum(), np.count_nonzero(~alone) // 2,
                f"frequency {fourier.signed(at, counts.shape)}")


def parities(test: str, counts: np.ndarray) -> Finding:
    """The parity of every choice of bits from two components or more: how often it is even, in standard deviations."""
    sums = counts.astype(float)
    for axis, size in enumerate(counts.shape):
        signs = 1 - 2 * (np.array([[(i & j).bit_count() for j in range(size)] for i in range(size)]) % 2)
        sums = np.moveaxis(np.tensordot(signs.astype(float), sums, (1, axis)), 0, axis)
    alone = _of_one(counts.shape)
    sums[alone] = 0
    z = sums / np.sqrt(counts.sum())
    at = np.unravel_index(np.argmax(np.abs(z)), z.shape)
    return peak(test, abs(z[at]), stats.norm(), counts.sum(), np.count_nonzero(~alone),
                "bits " + ", ".join(f"{i:b}" for i in at), two_sided=True)


def _of_one(shape: tuple[int, ...]) -> np.ndarray:
    """Where no more than one index is not 0."""
    return sum((i != 0).astype(int) for i in np.indices(shape, sparse=True)) < 2


def between(components: list[Lattice]) -> Iterator[Finding]:
    """Each component against each other at all distances: as two seeds are compared."""
    for a, b in combinations(range(len(components)), 2):
        first, second = components[a], components[b]
        made = [fourier.crossed("components: correlation", first.gradients, second.gradients),
                fourier.crossed("components: correlation of numbers", numbers(first), numbers(second)),
                pairs_of_bits(first, second), copies.common_runs("components: common runs", first, second)]
        for finding in made:
            finding.where = f"{named((a, b))}; {finding.where}"
        yield from made


def numbers(lattice: Lattice) -> np.ndarray:
    """Numbers for value noise, in (-1, 1), with one as a last axis."""
    low = lattice.words & np.uint32((1 << NUMBER_BITS) - 1)
    return ((low + 0.5) * 2.0 ** (1 - NUMBER_BITS) - 1).astype(np.float32)[..., None]


def pairs_of_bits(a: Lattice, b: Lattice) -> Finding:
    """Each consumed bit of one component with each of the other, at the same point and at the next ones along axes."""
    offsets = [(0,) * a.dimensions, *(tuple(map(int, row)) for row in np.eye(a.dimensions))]
    z = np.stack([bits.bit_products(a.words, shifted(b.words, offset), a.bits) for offset in offsets])
    return normal("components: pairs of bits", z, a.words.size,
                  lambda o, i, j: f"bits {a.bits[i]} and {a.bits[j]}, offset {offsets[o]}", pool=False)


def alone(components: list[Lattice], tests: list[Callable[[Lattice], list[Finding]]]) -> Iterator[Finding]:
    """The further components by tests of windows, and how many words come twice."""
    for name, lattice in zip(AXES[1:], components[1:]):
        n = lattice.words.size
        equal = copies.equal_pairs(lattice.words)
        yield poisson("one component: equal words", equal, n * (n - 1) / 2 * 2.0 ** -GOOD, n, name)
        for finding in chain.from_iterable(test(lattice) for test in tests):
            finding.test = f"one component: {finding.test}"
            finding.where = "; ".join(filter(None, (name, finding.where)))
            yield finding


def of_noise(twin: Twin, dimensions: int, seed: int, count: int) -> list[Finding]:
    """The noises of a vector at places in cells against each other, at the same place and at places around it."""
    rng = np.random.default_rng(80 + dimensions)
    span = SPAN[dimensions] * PLACES_IN_CELL
    places = rng.integers(-span, span, (count, dimensions)) / PLACES_IN_CELL
    drawn = rng.integers(-REACH * STEPS, REACH * STEPS + 1, (OFFSETS, dimensions)) / STEPS
    offsets = np.concatenate([np.zeros((1, dimensions)), drawn])
    pairs = [(a, b) for a in range(dimensions) for b in range(dimensions) if a != b]

    def named_pair(i: int, k: int) -> str:
        first, second = (AXES[c] for c in pairs[k])
        return f"{first}, and {second} at the offset {','.join(f'{c:g}' for c in offsets[i])}"

    findings = []
    for name in ("value", "perlin"):
        moved = (places + offsets[:, None]).reshape(-1, dimensions)
        there = twin.vectors(name, moved, seed).reshape(len(offsets), count, dimensions)
        z = np.empty((len(offsets), len(pairs)))
        for k, (a, b) in enumerate(pairs):
            products = there[0, :, a].astype(float) * there[:, :, b]
            # By their own spread, which is not that of a product of independent values: in the middle of a cell values
            # are smaller, and both places may be there.
            z[:, k] = products.sum(axis=1) / np.sqrt((products ** 2).sum(axis=1))
        findings.append(normal(f"components: {name} noise", z, count, named_pair, 1 / np.sqrt(count)))
    return findings
