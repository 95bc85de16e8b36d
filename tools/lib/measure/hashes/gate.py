"""The gate lists the measurements of a hash: which windows, with which seeds, by which tests."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Callable, Iterable

import numpy as np

from measure.hashes import avalanche, bits, components, copies, directions, fourier, isotropy, near_returns
from measure.hashes.judgement import Finding, join
from measure.hashes.lattice import Lattice, cells_of, of_words, sample
from measure.hashes.library import Twin

GOLDEN = 0x9E3779B9  # between the seeds of octaves, docs/reference/contract.md section 7
WORD = 0xFFFFFFFF

# Around the origin, where people look, and where a hash may mirror; negative; at the end of what hn_perlin takes; and
# near the ends of int. They do not overlap, so that their values may be summed.
ORIGINS = {
    2: [(-512, -512), (-3000000, -70000), (8387584, 8387584), (2000000011, -1900000007)],
    3: [(-64, -64, -64), (-3000000, -70000, -12345), (8388480, 8388480, 8388480), (2000000011, -1900000007, 30000001)],
}
SIDES = {2: 1024, 3: 128}
SEEDS = [0, 1, 0xDEADBEEF]


@dataclass
class Effort:
    """How much of it: everything for the table; less where time is short."""
    origins: int = 4
    seeds: tuple[int, ...] = tuple(SEEDS)
    sides: dict[int, int] = field(default_factory=lambda: dict(SIDES))
    samples: int = 1 << 18   # cells of the tests that draw them
    windows: int = 32        # places in which only equal words are looked for
    pairs: int = 6           # of seeds
    # Two of the seeds at each origin, and the costly tests in one of two windows; else one seed, and the costly tests in
    # the first window alone.
    thorough: bool = True

    def windows_of(self, dimensions: int) -> list[tuple[tuple[int, ...], int, bool]]:
        """Origin and seed of each window, and whether it has the costly tests."""
        windows = []
        for i, origin in enumerate(ORIGINS[dimensions][:self.origins]):
            for k in range(min(2, len(self.seeds)) if self.thorough else 1):
                windows.append((origin, self.seeds[(i + k) % len(self.seeds)], k == 0 if self.thorough else i == 0))
        return windows


FULL = Effort()
QUICK = Effort(origins=2, seeds=(0, 0xDEADBEEF), samples=1 << 16, windows=12, pairs=3, thorough=False)
LEAST = Effort(origins=1, seeds=(7,), sides={2: 512, 3: 64}, samples=1 << 15, windows=6, pairs=1, thorough=False)

# In order of their names in the report; the costly ones apart.
Keep = Callable[[Lattice], None]  # is shown each window whose gradients are judged
WINDOW_TESTS: list[Callable[[Lattice], list[Finding]]] = [
    fourier.autocorrelation, bits.values, bits.pairs, bits.local, bits.numbers, directions.frequencies,
    copies.duplicates]
COSTLY_TESTS: list[Callable[[Lattice], list[Finding]]] = [fourier.bit_autocorrelation, bits.bit_pairs, bits.quads]
# Further components are judged in those of so many first windows that have costly tests. Their words have fewer bits,
# so that what counts equal words does not hold for them.
COMPONENT_WINDOWS = 4
COMPONENT_TESTS = [copies.consumed if test is copies.duplicates else test for test in WINDOW_TESTS]


def seed_pairs(count: int) -> list[tuple[int, int]]:
    """Pairs that somebody may use: consecutive, of octaves, with one bit or all bits changed, far apart."""
    pairs = [(0, 1), (0, GOLDEN), (7, 7 ^ 0x80000000), (1, 2), (0xDEADBEEF, (0xDEADBEEF + GOLDEN) & WORD),
             (123456789, 123456789 ^ WORD), (0, 1 << 16), (65536, 65537)]
    return pairs[:count]


def judge_window(lattice: Lattice, costly: bool = True) -> list[Finding]:
    findings = []
    for test in WINDOW_TESTS + (COSTLY_TESTS if costly else []):
        findings += test(lattice)
    return _placed(findings, lattice.place)


def _placed(findings: list[Finding], place: str) -> list[Finding]:
    for finding in findings:
        finding.where = f"{finding.where}; {place}" if finding.where else place
    return findings


def judge_words(words: np.ndarray, twin: Twin) -> list[Finding]:
    """All measures of a window of words alone."""
    lattice = of_words(words, twin)
    return judge_window(lattice) + avalanche.of_window(lattice)


def judge_gradients(lattice: Lattice) -> list[Finding]:
    """All measures of the gradients of a window, for gradients that are not the library's."""
    findings = [*fourier.autocorrelation(lattice), directions.others(lattice),
                isotropy.judge(isotropy.of_window(lattice), lattice.dimensions)]
    return _placed(findings, lattice.place)


def judge_twin(twin: Twin, dimensions: int, effort: Effort, keep: Keep = lambda lattice: None) -> list[Finding]:
    """Everything about a hash in the plane or in space."""
    findings = list(each_finding(twin, dimensions, effort, keep))
    return findings + pooled(findings)


def pooled(findings: list[Finding]) -> list[Finding]:
    """The windows of a hash together: what is weak everywhere shows in their sum, however little in each."""
    groups: dict[str, list[Finding]] = {}
    for finding in findings:
        if finding.scores is not None:
            groups.setdefault(finding.test, []).append(finding)
    together = [join(group) for group in groups.values() if len(group) > 1]
    for finding in findings:
        finding.scores = None  # they are as large as the windows
    return together


def each_finding(twin: Twin, dimensions: int, effort: Effort,
                 keep: Keep = lambda lattice: None) -> Iterable[Finding]:
    side = effort.sides[dimensions]
    shape = (side,) * dimensions
    preferences = []
    for origin, seed, costly in effort.windows_of(dimensions):
        lattice = sample(twin, shape, origin, seed)
        keep(lattice)
        yield from judge_window(lattice, costly)
        yield _same_stage(lattice, twin)
        yield from _placed([directions.others(lattice)], lattice.place)
        preferences += isotropy.of_window(lattice)
    yield isotropy.judge(preferences, dimensions)
    yield isotropy.same_noise(twin, dimensions, effort.seeds[0])
    yield from each_of_choices(twin, dimensions, effort, keep)
    for seed in effort.seeds:
        # Fewer cells, since there are some hundred lags: with these it takes about as long as far pairs.
        found = near_returns.near_returns(twin, dimensions, seed, effort.samples >> 3)
        yield from _placed(found, f"seed {seed}")
    yield from many_windows(twin, dimensions, effort)
    yield from each_of_components(twin, dimensions, effort)


def each_of_choices(twin: Twin, dimensions: int, effort: Effort,
                    keep: Keep = lambda lattice: None) -> Iterable[Finding]:
    """Tests that choose their cells and seeds: avalanche, far pairs, seeds."""
    for seed in effort.seeds:
        yield from avalanche.of_twin(twin, dimensions, seed, effort.samples)
        yield from avalanche.far(twin, dimensions, seed, effort.samples)
    yield from avalanche.of_seeds(twin, dimensions, effort.samples)
    for a, b in seed_pairs(effort.pairs):
        shape = (effort.sides[dimensions],) * dimensions
        windows = [sample(twin, shape, ORIGINS[dimensions][0], seed) for seed in (a, b)]
        for lattice in windows:
            keep(lattice)
        yield from judge_seeds(*windows)


def judge_components(words: list[np.ndarray], twin: Twin) -> Iterable[Finding]:
    """All measures of the words of components in a window."""
    tables = components.Tables(words[0].ndim)
    tables.add(words)
    yield from tables.judge()
    lattices = [of_words(w, twin) for w in words]
    yield from components.between(lattices)
    yield from components.alone(lattices, COMPONENT_TESTS + COSTLY_TESTS)


def each_of_components(twin: Twin, dimensions: int, effort: Effort) -> Iterable[Finding]:
    """Everything about vectors, whose components are made of one word."""
    shape = (effort.sides[dimensions],) * dimensions
    tables = components.Tables(dimensions)
    for i, (origin, seed, costly) in enumerate(effort.windows_of(dimensions)):
        words = twin.words(cells_of(origin, shape), seed).reshape(shape)
        words_of_all = [words, *twin.further(words, dimensions)]
        tables.add(words_of_all)
        if costly and i < COMPONENT_WINDOWS:
            lattices = [of_words(w, twin) for w in words_of_all]
            tests = COMPONENT_TESTS + (COSTLY_TESTS if i == 0 else [])
            found = [*components.between(lattices), *components.alone(lattices, tests)]
            yield from _placed(found, replace(lattices[0], origin=origin, seed=seed).place)
    yield from tables.judge()
    for seed in effort.seeds:
        found = components.of_noise(twin, dimensions, seed, effort.samples >> 3)
        yield from _placed(found, f"seed {seed}")


def judge_seeds(a: Lattice, b: Lattice) -> list[Finding]:
    findings = [fourier.cross_correlation(a, b), _bits_of_seeds(a, b), *copies.between(a, b)]
    return _placed(findings, f"seeds {a.seed} and {b.seed}")


def _bits_of_seeds(a: Lattice, b: Lattice) -> Finding:
    z = bits.bit_products(a.words, b.words, a.bits)
    return bits.normal("seeds: pairs of bits", z, a.words.size, lambda i, j: f"bits {a.bits[i]} and {a.bits[j]}")


def many_windows(twin: Twin, dimensions: int, effort: Effort) -> Iterable[Finding]:
    """Equal words in windows anywhere: a hash may have clumps of them in some windows and not in others. In 3D the
    windows are long, since a short line that is a copy of another shows little."""
    rng = np.random.default_rng(64 + dimensions)
    shape = {2: (1024, 1024), 3: (32, 32, 1024)}[dimensions]
    counts = []
    for _ in range(effort.windows):
        origin = tuple(int(c) for c in rng.integers(-(1 << 31), (1 << 31) - max(shape), dimensions))
        lattice = sample_words(twin, shape, origin)
        number, *lines = copies.words(lattice)
        counts.append(int(number.statistic))
        longest = [line for line, side in zip(lines, shape) if side == max(shape)]
        for line in longest:
            line.test = "copied lines, windows"  # longer lines than those of the others: another threshold
        yield from _placed(longest, lattice.place)
        copied = copies.runs(lattice)
        copied.test = "copied runs, windows"
        yield from _placed([copied], lattice.place)
    yield copies.average(counts, lattice.words.size, lattice.varying)


def sample_words(twin: Twin, shape: tuple[int, ...], origin: tuple[int, ...]) -> Lattice:
    words = twin.words(cells_of(origin, shape), 0).reshape(shape)
    return Lattice(words, np.empty(0), twin.consumed(len(shape)), origin, 0)


def _same_stage(lattice: Lattice, twin: Twin) -> Finding:
    """hn_gradient of a cell is the gradient of its word, or else the tests of words show nothing of the noise."""
    staged = twin.stage(lattice.words.reshape(-1), lattice.dimensions).reshape(lattice.gradients.shape)
    wrong = int(np.count_nonzero((staged != lattice.gradients).any(axis=-1)))
    return Finding("gradient of the word", wrong, 0, 0, float(wrong == 0), lattice.words.size, 1, lattice.place)
