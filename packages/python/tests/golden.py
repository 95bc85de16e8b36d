"""The golden files, by the functions of the package.

    python golden.py     compares a golden file of each noise in each dimension, and of each sum, with what the package
                         computes with arithmetic="fixed", bit for bit. Exit status: 0 the same, 1 not
"""

from __future__ import annotations

import math
import re
import sys
from dataclasses import dataclass
from pathlib import Path

import hashnoise
import numpy

sys.path.append(str(Path(__file__).resolve().parents[3] / "tools" / "lib"))

from base import golden_values  # noqa: E402
from base.tree import BOUNDS, GOLDEN, ROOT  # noqa: E402, F401  (other tests take ROOT from here)

TYPES = {"f32": numpy.float32, "i32": numpy.int32, "u32": numpy.uint32, "f64": numpy.float64}
METRICS = ("euclidean", "euclidean", "squared", "manhattan", "chebyshev", "hybrid")  # by HN_METRIC_...; 0 is Euclidean
# Limits of the package. In GLSL values beyond count as the nearer end, and golden files have that, too. Rows with fewer
# than 1 octave are left out.
RANGES = {"octaves": (1, 32), "bandwidth": (0, 16), "detail": (0, 32), "gain": (0, numpy.inf),
          "footprint": (0, numpy.inf), "jitter": (0, 1), "amplitude": (0, 64), "ping_pong": (0, 64), "weighted": (0, 1),
          "eroded": (0, 16)}
# Columns of what the package does not have: the cell of the nearest point and the way to it, and whole numbers as
# positions.
ABSENT = {"nx", "ox", "units"}


@dataclass
class Golden:
    """A golden file.

    name       noise2d.perlin_cell, fbm.fbm2
    function   the package's: perlin, fbm
    axes       how many
    arguments  an array for each column of arguments, by its name
    results    the same for each column of results, in their order
    """

    name: str
    function: str
    axes: int
    arguments: dict[str, numpy.ndarray]
    results: dict[str, numpy.ndarray]


def of_package(calls: str) -> str:
    """A function's name in the package. The phase of hn_cellular_phase is an option of cellular there."""
    return calls.removeprefix("hn_").removesuffix("_phase")


def names(setting: str) -> list[str]:
    """The functions that the package has and that have golden values with this setting: noise2d.perlin, ..."""
    found = []
    for id, _ in golden_values.ids(setting):
        head = golden_values.head_of(GOLDEN / f"{id}.golden")
        name, columns = of_package(head.calls), {name for name, _ in head.columns + head.results}
        if not columns & ABSENT and head.axes and name in hashnoise.noises(head.axes) + hashnoise.fractals(head.axes):
            found.append(id)
    return found


def read(name: str, setting: str, folder: Path = GOLDEN) -> Golden:
    file = golden_values.Golden(name, setting, folder)
    arguments, results = (
        {column: numpy.array(words, numpy.uint64 if kind == "f64" else numpy.uint32).view(TYPES[kind])
         for (column, kind), words in zip(columns, zip(*rows))}
        for columns, rows in ((file.head.columns, file.inputs), (file.head.results, file.values)))
    return askable(Golden(name, of_package(file.head.calls), file.head.axes, arguments, results))


def askable(golden: Golden) -> Golden:
    """Without the rows that sums of GLSL have and the package refuses: those of fewer than 1 octave, of a negative
    period, which may become a positive one in a late octave, and of a lacunarity below 1 in a tile. It is also without
    those of a tile that repeats along no axis: GLSL has such sums, whose octaves are not turned. In the package a sum
    that repeats along no axis is the one without a period."""
    if golden.function not in hashnoise.fractals(golden.axes):
        return golden
    periods = [values for name, values in golden.arguments.items() if name in ("px", "py", "pz", "pw")]
    kept = numpy.ones(len(golden.arguments["seed"]), bool)
    if "octaves" in golden.arguments:
        kept &= golden.arguments["octaves"] >= 1
    if periods:
        kept &= numpy.all([values >= 0 for values in periods], axis=0) & numpy.any(periods, axis=0)
        kept &= golden.arguments["lacunarity"] >= 1
    return Golden(golden.name, golden.function, golden.axes,
                  {name: values[kept] for name, values in golden.arguments.items()},
                  {name: values[kept] for name, values in golden.results.items()})


def computed(golden: Golden, arithmetic: str) -> numpy.ndarray:
    """The package's values for each row: planes of as many components as there are results. Rows that differ only
    in their points are computed together."""
    axes = "xyzw"[:golden.axes]
    has_cells = "cx" in golden.arguments
    points = [golden.arguments[f"f{axis}" if has_cells else axis] for axis in axes]
    points = [numpy.clip(point, 0, 1) for point in points] if has_cells else points
    cells = [golden.arguments[f"c{axis}"] for axis in axes] if has_cells else None
    periods = [f"p{axis}" for axis in axes if f"p{axis}" in golden.arguments]
    waves = [f"k{axis}" for axis in axes if f"k{axis}" in golden.arguments]
    options = [name for name in golden.arguments
               if name not in {*axes, *periods, *waves, *(f"{kind}{axis}" for kind in "cf" for axis in axes)}]
    rows: dict[tuple, list[int]] = {}
    for row in range(len(points[0])):
        rows.setdefault(tuple(golden.arguments[name][row].item() for name in options + waves + periods), []).append(row)
    function = getattr(hashnoise, golden.function)
    first = len(hashnoise.components(golden.function, golden.axes)) - len(golden.results)
    if golden.name.endswith("_value"):
        first = 0  # the other file of a noise in 4D has the derivatives
    results = numpy.empty((len(golden.results), len(points[0])), numpy.float32)
    for values, which in rows.items():
        chosen = dict(zip(options, values))
        for name, value in chosen.items():
            least, most = RANGES.get(name if name != "strength" else golden.function, (value, value))
            chosen[name] = min(max(value, least), most)
        if "lacunarity" in chosen and (arithmetic == "fixed" or has_cells):
            chosen["lacunarity"] = min(max(chosen["lacunarity"], 0), 255)
            chosen["lacunarity"] = math.floor(chosen["lacunarity"]) if periods else chosen["lacunarity"]
        if "gain" in chosen and arithmetic == "fixed":
            chosen["gain"] = min(chosen["gain"], 1)
        if waves:
            chosen["wave"] = [min(max(along, -16.0), 16.0) for along in values[len(options):len(options + waves)]]
        if periods:
            chosen["period"] = tuple(max(period, 0) for period in values[len(options + waves):])
        if "metric" in chosen:
            chosen["metric"] = METRICS[chosen["metric"] if 0 <= chosen["metric"] < len(METRICS) else 0]
        if cells is not None:
            chosen["cell"] = tuple(cell[which] for cell in cells)
        planes = function(*(point[which] for point in points), arithmetic=arithmetic, **chosen)
        planes = planes.reshape(-1, len(which))
        results[:, which] = planes[first:first + len(results)]
    return results


def different_bits(golden: Golden, results: numpy.ndarray) -> list[str]:
    """Faults of results that must have the bits of the golden file."""
    wrong = []
    for (column, expected), values in zip(golden.results.items(), results, strict=True):
        words = expected.astype(numpy.float32).view(numpy.uint32)
        for row in numpy.flatnonzero(words != values.view(numpy.uint32)):
            wrong.append(f"{golden.name}, row {row + 1}: {column} is {values[row]!r}, not {expected[row]!r}")
    return wrong


def too_far(golden: Golden, results: numpy.ndarray) -> list[str]:
    """Faults of results that must be as near to the exact values as the noise promises."""
    wrong = []
    for (column, expected), values in zip(golden.results.items(), results, strict=True):
        allowed = bound(golden, column)
        if golden.function == "cellular_d" and column.startswith("d"):
            allowed = numpy.minimum(allowed / numpy.maximum(golden.results["value"], allowed / 2), 2)
        distance = numpy.abs(values.astype(numpy.float64) - expected)
        for row in numpy.flatnonzero(~(distance <= allowed)):
            wrong.append(f"{golden.name}, row {row + 1}: {column} is {values[row]!r}, not {expected[row]!r}")
    return wrong


def bound(golden: Golden, column: str) -> float:
    """The error of a noise that the project has proven, of its value or of its derivatives."""
    has_other_form = "phase" in golden.arguments and "kx" not in golden.arguments  # what has a wave has a phase always
    noise = golden.function + "_phase" * has_other_form + "_bandwidth" * ("bandwidth" in golden.arguments)
    kind = "SLOPE_BOUNDS" if column in ("dx", "dy", "dz", "dw") else "NOISE_BOUNDS"
    row = re.search(rf'^{kind}\("{noise}", {golden.axes}, (?:octahedral|none), (\S+), (\S+),', BOUNDS.read_text(), re.M)
    if row is None:
        raise ValueError(f"{BOUNDS.name} has no {kind} of {noise} in {golden.axes}D")
    return float(row[1] if "cx" in golden.arguments else row[2])


def main() -> int:
    wrong = []
    for name in names("lattice+fixed"):
        if not re.search("_(cell|period|full)", name):
            golden = read(name, "lattice+fixed")
            wrong += different_bits(golden, computed(golden, "fixed"))
    print("\n".join(wrong[:20]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
