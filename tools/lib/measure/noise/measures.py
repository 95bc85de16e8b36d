"""Measures a noise. Each measure is a number, a sentence, and whether it fails what noise should be."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from measure.hashes.fields import harmonic, waves
from measure.noise.noise import COUNT, Sampler

# The limits. Lengths and jumps are in standard deviations of the noise.
OUTSIDE = 1e-4  # beyond the range that is claimed
JUMP = 0.003  # a step of 1/85 of a deviation shows as a line in a gradient of 8 bits over two deviations
SLOPE = 0.02  # of the root of the mean square of the derivatives
ALIKE = 0.9  # the correlation of a field with itself elsewhere, from which on it repeats
RELATED = 0.05  # of fields of two seeds, or of one field some cells away; chance leaves 0.002 at COUNT places
FAR = 0.2  # by how much the deviation may differ far out
DIRECTIONS = 0.35  # a harmonic of the spectrum, from which on a lattice shows
BITS = 1e-3  # between two compilers of the same machine
ANYWHERE = 1000.0  # cells: from where places are drawn
DRAWINGS = 16


@dataclass
class Finding:
    measure: str
    fails: bool | None  # None: a number, and no verdict
    number: float
    sentence: str
    more: dict[str, object] = field(default_factory=dict)


class Measured:
    """Samples that several measures need: a draw from everywhere."""

    def __init__(self, sampler: Sampler) -> None:
        self.sampler = sampler
        self.n = sampler.subject.dimensions
        self.values, self.places = sampler.random(-ANYWHERE, ANYWHERE, 0)
        finite = self.values[np.isfinite(self.values)]
        self.mean = float(finite.mean(dtype=float)) if finite.size else 0.0
        self.deviation = float(finite.std(dtype=float)) if finite.size else 0.0

    def axes(self) -> np.ndarray:
        return np.eye(self.n)


def spread(m: Measured) -> Finding:
    """Mean, deviation, and how far the values are from uniform between their ends."""
    values = np.sort(m.values[np.isfinite(m.values)].astype(float))
    low, high = values[[0, -1]] if values.size else (0.0, 0.0)
    ranks = (values - low) / max(high - low, 1e-30) - np.linspace(0, 1, len(values))
    uniform = np.abs(ranks).max(initial=0.0)
    counts = np.histogram(values, 64)[0]
    fails = m.deviation < 1e-6 or len(values) < COUNT
    return Finding("values", fails, m.deviation,
                   f"The mean is {m.mean:.4f} and the deviation {m.deviation:.4f}; "
                   f"the distribution is {100 * uniform:.1f}% from a uniform one."
                   + (" Not all values are finite." if len(values) < COUNT else ""),
                   {"mean": m.mean, "from uniform": float(uniform), "histogram": counts.tolist()})


def extremes(m: Measured) -> Finding:
    """The least and the greatest value: at places from everywhere, then around the best of them."""
    best: dict[int, list[tuple[float, np.ndarray]]] = {-1: [], 1: []}
    for turn in range(DRAWINGS):
        values, places = m.sampler.random(-ANYWHERE / 16, ANYWHERE / 16, 100 + turn)
        for sign, found in best.items():
            # Away from each other, since neighbours have the same peak.
            found += [(float(sign * values[i]), places[i]) for i in _largest(sign * np.nan_to_num(values), 4)]
    ends = {}
    for sign, found in best.items():
        found.sort(key=lambda one: -one[0])
        ends[sign] = max(_climbed(m.sampler, sign, value, place) for value, place in found[:12])
    low, high = -ends[-1], ends[1]
    claimed = m.sampler.subject.range
    beyond = max(claimed[0] - low, high - claimed[1]) if claimed else 0.0
    said = f"Values from {low:.4f} to {high:.4f} were found."
    if claimed:
        said += (f" They are {beyond:.4g} beyond [{claimed[0]:g}, {claimed[1]:g}]." if beyond > OUTSIDE else
                 f" All are in [{claimed[0]:g}, {claimed[1]:g}].")
    return Finding("range", beyond > OUTSIDE if claimed else None, max(-low, high), said,
                   {"least": low, "greatest": high})


def _largest(values: np.ndarray, count: int) -> np.ndarray:
    """The places of so many."""
    return np.argpartition(-values, count)[:count]


def _climbed(sampler: Sampler, sign: int, value: float, place: np.ndarray) -> float:
    """The greatest value near a place: in boxes of random places around it, which shrink."""
    size = 0.25
    for turn in range(4):
        n = len(place)
        pixels = sampler.draw(place.astype(float) - size / 2, np.full(n, size), np.zeros(n), 200 + turn)
        i = int(np.argmax(sign * np.nan_to_num(pixels[:, 0])))
        if sign * pixels[i, 0] > value:
            value, place = float(sign * pixels[i, 0]), pixels[i, 1:1 + n]
        size /= 6
    return value


def jumps(m: Measured) -> Finding:
    """The largest step between places that are a four-thousandth of a cell apart, looked at more closely: of a
    continuous function it becomes smaller with the distance, and a jump does not."""
    near, count, worst = 2.0 ** -12, 8, 0.0
    for turn in range(8):
        # Along each axis and a diagonal; and at the walls of cells, where noise is put together.
        way = turn % (m.n + 1)
        direction = m.axes()[way] if way < m.n else np.ones(m.n) / np.sqrt(m.n)
        values, places = m.sampler.random(-16, 16, 300 + turn)
        beside, _ = m.sampler.random(-16, 16, 300 + turn, moved=direction * near)
        steps = np.abs(beside - values)
        for i in _largest(np.nan_to_num(steps), count):
            worst = max(worst, _jump(m.sampler, places[i].astype(float), direction * near))
    for axis in range(m.n):
        worst = max(worst, _at_walls(m, axis))
    part = worst / max(m.deviation, 1e-30)
    return Finding("jumps", part > JUMP, worst,
                   f"It jumps by {worst:.2g}, {100 * part:.2g}% of its deviation." if part > JUMP else
                   f"No jump was found; steps between neighbours are smooth to {worst:.1g}.")


def _jump(sampler: Sampler, place: np.ndarray, step: np.ndarray) -> float:
    """The largest step of 512 between two places, less what the slope around it explains."""
    row = sampler.grid(place - 2 * step, 5 * step / 512, np.zeros(len(place)), 1)[0].astype(float)
    steps = np.abs(np.diff(row))
    i = int(np.argmax(steps))
    around = np.delete(steps[max(i - 4, 0):i + 5], min(i, 4))
    return max(float(steps[i] - np.median(around) * 3), 0.0)


def _at_walls(m: Measured, axis: int) -> float:
    """The difference of the values just before and just behind whole coordinates, less twice that of neighbours."""
    across = m.axes()[axis] * 2.0 ** -13
    along, up = [1 / 61 if i != axis else 0.0 for i in range(m.n)], [0.0] * m.n
    up[axis] = 1.0  # rows are walls
    start = np.full(m.n, 0.137)
    start[axis] = -256
    rows = [m.sampler.grid(start + k * across, np.array(along), np.array(up)).astype(float) for k in (-3, -1, 1, 3)]
    wall, beside = np.abs(rows[2] - rows[1]), np.maximum(np.abs(rows[1] - rows[0]), np.abs(rows[3] - rows[2]))
    return max(float(np.nanmax(wall - 2 * beside)), 0.0)


def slopes(m: Measured) -> Finding | None:
    """The derivatives that the noise claims, against differences."""
    if not m.sampler.subject.has_slope:
        return None
    step = 2.0 ** -8
    claimed = m.sampler.slopes(-8, 8, 400).astype(float)
    size = float(np.sqrt((claimed ** 2).mean()))
    errors = []
    for axis, direction in enumerate(m.axes()):
        # It takes four differences, so that the curvature does not count.
        at = [m.sampler.random(-8, 8, 400, moved=k * step * direction)[0].astype(float) for k in (-2, -1, 1, 2)]
        errors.append(np.abs((8 * (at[2] - at[1]) - (at[3] - at[0])) / (12 * step) - claimed[:, axis]))
    error = float(np.quantile(np.array(errors), 0.999)) / max(size, 1e-30)  # where the noise has kinks there is more
    return Finding("derivative", error > SLOPE, error,
                   f"The derivatives are {'not right: ' if error > SLOPE else ''}within {100 * error:.2g}% of "
                   "differences at 999 of 1,000 places, in parts of their own size.")


def repeats(m: Measured) -> Finding:
    """Whether the field comes again after a number of cells, along axes, diagonals and the sides of triangles."""
    n = m.n
    skew = (3 - np.sqrt(3)) / 6 if n == 2 else 1 / 6
    ways = {"an axis": m.axes()[0], "the other axis": m.axes()[-1], "a diagonal": np.ones(n),
            "a side of a simplex": m.axes()[0] - skew}
    found: list[tuple[int, str]] = []
    for way, direction in ways.items():
        # Rows are probes, and columns are numbers of cells.
        probe = np.array([0.731, 0.317, 0.513])[:n]
        for first in range(1, 2048, 512):
            block = m.sampler.grid(probe * 0.5 + first * direction, direction, probe)
            here = m.sampler.grid(probe * 0.5, np.zeros(n), probe)[:, 0]
            related = _correlations(block, here)
            same = np.flatnonzero(related > ALIKE)
            if same.size:
                found.append((first + int(same[0]), way))
                break
    if not found:
        return Finding("repeats", False, 0,
                       "It does not come again within 2,048 cells along axes, diagonals and sides.")
    cells, way = min(found, key=lambda one: one[0])
    return Finding("repeats", True, cells, f"It comes again after {cells} cells along {way}.")


def mirrors(m: Measured) -> Finding:
    """Whether the field is its own mirror image."""
    names = {"p and -p": -np.ones(m.n), "x and -x": 1 - 2 * m.axes()[0], "y and -y": 1 - 2 * m.axes()[1]}
    turn, worst, of = 500, 0.0, ""
    low = np.full(m.n, -50.0)
    for name, signs in names.items():
        here = m.sampler.draw(low, np.full(m.n, 100.0), np.zeros(m.n), turn)[:, 0]
        there = m.sampler.draw(low * signs, 100.0 * signs, np.zeros(m.n), turn)[:, 0]
        related = abs(float(_correlations(there[:, None].astype(float), here.astype(float))[0]))
        if related > worst:
            worst, of = related, name
    return Finding("mirrors", worst > ALIKE, worst,
                   f"It is alike at {of} (correlation {worst:.2f})." if worst > ALIKE else
                   f"No mirror was found (correlations up to {worst:.3f}).")


def _fixed(values: np.ndarray, places: np.ndarray) -> np.ndarray:
    """The part of values that is the same in each cell: the mean at their place in a cell. Ridges have it, since
    gradient noise is 0 at whole places. It is no relation of one cell, or of one seed, to another."""
    bins = 16 if places.shape[1] == 2 else 8
    index = np.zeros(len(values), int)
    for column in places.T.astype(float):
        index = index * bins + np.minimum((column - np.floor(column)) * bins, bins - 1).astype(int)
    count = np.bincount(index, minlength=bins ** places.shape[1])
    return (np.bincount(index, values, len(count)) / np.maximum(count, 1))[index]


def _correlations(columns: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Of each column with another one."""
    a = np.nan_to_num(columns.astype(float))
    b = np.nan_to_num(other.astype(float))
    a, b = a - a.mean(axis=0), b - b.mean()
    size = np.sqrt((a * a).sum(axis=0) * (b * b).sum())
    return (a * b[:, None]).sum(axis=0) / np.where(size > 0, size, np.inf)


def seeds(m: Measured) -> Finding | None:
    """Whether fields of two seeds are related."""
    if not m.sampler.subject.has_seed:
        return None
    fields = {}
    for seed in (0, 1, 2, 256, 65536):
        values, places = m.sampler.random(-ANYWHERE, ANYWHERE, 600, seed=seed)
        values = np.nan_to_num(values.astype(float))
        fields[seed] = values - _fixed(values, places)
    worst, pair = max((abs(float(_correlations(fields[a][:, None], fields[b])[0])), (a, b))
                      for a in fields for b in fields if a < b)
    return Finding("seeds", worst > RELATED, worst,
                   f"Fields of the seeds {pair[0]} and {pair[1]} are "
                   f"{'related' if worst > RELATED else 'the most alike'}: their correlation is {worst:.4f}.")


def cells(m: Measured) -> Finding:
    """Whether the field is related to itself some cells away."""
    here = np.nan_to_num(m.values.astype(float))
    fixed = _fixed(here, m.places)
    part = fixed.var() / max(here.var(), 1e-30)
    here = here - fixed
    related: dict[str, float] = {}
    for axis, direction in zip("xyz", m.axes()):
        for lag in (4, 5, 8, 16, 17, 64, 256, 1000):
            there, _ = m.sampler.random(-ANYWHERE, ANYWHERE, 0, moved=lag * direction)
            related[f"{lag} cells along {axis}"] = float(_correlations(there[:, None].astype(float), here)[0])
    where = max(related, key=lambda lag: abs(related[lag]))
    worst = abs(related[where])
    return Finding("cells", worst > RELATED, worst,
                   f"Places that are {where} apart are {'related' if worst > RELATED else 'the most alike'}: their "
                   f"correlation is {related[where]:.4f}. Of the variance {100 * part:.1f}% is the same in each cell.",
                   {"the same in each cell": float(part)})


def directions(m: Measured) -> Finding:
    """How much the spectrum of a slice prefers directions of a lattice."""
    window = np.hanning(512)[:, None] * np.hanning(512)
    total: dict[int, list[float]] = {order: [] for order in (2, 4, 6, 8)}
    powers = 0.0
    for i in range(4):
        origin = np.array([13.7, 7.1, 0.37])[:m.n] + 131.0 * i
        along, up = m.axes()[0] / 8, m.axes()[1] / 8
        field = m.sampler.grid(origin, along, up).astype(float)
        field = np.nan_to_num(field - field.mean()) * window
        vectors, power = waves(field)
        powers = powers + np.abs(np.fft.fftshift(np.fft.fft2(field))) ** 2
        for order, values in total.items():
            values.append(harmonic(vectors, power, order) if power.any() else 0.0)
    means = {order: float(np.mean(values)) for order, values in total.items()}
    worst = max(means, key=lambda order: abs(means[order]))
    size = abs(means[worst])
    return Finding("directions", size > DIRECTIONS, size,
                   f"Its waves prefer directions by {size:.3f} ({worst} of them alike); 0 is none, 1 is one alone.",
                   {"spectrum": powers, "harmonics": means})


def far(m: Measured) -> Finding:
    """How far out the noise is still there, with floats for positions."""
    # By distance, the deviation there beside that around the origin.
    there = {}
    for place in (-1e3, 1e4, 1e5, 1e6, 1e9):
        values = m.sampler.random(place, place + 256, 700)[0].astype(float)
        there[place] = float(np.std(values)) if np.isfinite(values).all() else np.nan
    odd = [m.sampler.draw(np.full(m.n, bad), np.zeros(m.n), np.zeros(m.n), 1, rows=1)[0, 0] for bad in (np.nan, np.inf)]
    parts = {place: value / max(m.deviation, 1e-30) for place, value in there.items()}
    good = [place for place, part in parts.items() if abs(part - 1) <= FAR]
    reach = max((place for place in good if place > 0), default=0.0)
    fails = abs(parts[-1e3] - 1) > FAR or not abs(parts[1e4] - 1) <= FAR
    said = ("; ".join(f"at {place:g} cells {100 * part:.0f}%" for place, part in parts.items())
            + ". At NaN it is " + ", at infinity ".join(f"{value:g}" for value in odd) + ".")
    return Finding("far", fails, reach, f"The deviation that remains: {said}", {"parts": parts})


def compilers(m: Measured, other: Callable[[], np.ndarray | None]) -> Finding | None:
    """Whether another compiler of the same shader gives the same bits: Mesa's softpipe, which interprets it."""
    there = other()
    if there is None:
        return None
    here = m.sampler.random(-ANYWHERE / 10, ANYWHERE / 10, 800)[0]
    both = np.isfinite(here) & np.isfinite(there)
    differ = float((here.view(np.uint32) != there.view(np.uint32)).mean())
    most = float(np.abs(here[both].astype(float) - there[both]).max()) if both.any() else np.inf
    part = most / max(m.deviation, 1e-30)
    return Finding("compilers", part > BITS, most,
                   f"Two compilers of Mesa differ in {100 * differ:.1f}% of the values, by {most:.2g} at most.",
                   {"differing": differ})
