"""python -m hashnoise.check: the package holds itself to its vectors, whose rows are a part of the library's golden
values. It compares each bit of arithmetic="fixed", with each instruction set of this machine.

Exit status: 0 the same bits, 1 others, or this processor lacks all instruction sets, 2 this package has no vectors.
"""

from __future__ import annotations

import json
import math
import sys
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

import numpy

import hashnoise

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
    """A golden file, or the same rows of a file of vectors.

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


def has(calls: str, axes: int, columns: set[str]) -> bool:
    """Whether the package has the function with these columns."""
    return bool(not columns & ABSENT and axes
                and of_package(calls) in hashnoise.noises(axes) + hashnoise.fractals(axes))


def askable(golden: Golden) -> Golden:
    """Without the rows that sums of GLSL have and the package refuses: fewer than 1 octave, a negative period, which may
    become positive in a late octave, a lacunarity below 1 in a tile, and a tile that repeats along no axis. GLSL has
    such a tile, and does not turn its octaves. In the package it is the sum without a period."""
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


def computed(golden: Golden, arithmetic: str, **more: Any) -> numpy.ndarray:
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
        planes = function(*(point[which] for point in points), arithmetic=arithmetic, **chosen, **more)
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


def read(text: str) -> Golden | None:
    """The rows of a file of vectors with HN_FIXED, if the package has the function."""
    said = json.loads(text)
    columns = said["inputs"] + said["outputs"]
    names = {column["name"] for column in columns}
    axes = len(names & {"x", "y", "z", "w", "cx", "cy", "cz", "cw"})
    fixed = [one["rows"] for one in said["settings"] if one["name"] == "lattice+fixed"]
    if not fixed or not has(said["calls"], axes, names):
        return None
    values = zip(*(row["in"] + row["out"] for row in fixed[0]))
    arrays = {column["name"]: numpy.array(numbers, TYPES[column["type"]]) for column, numbers in zip(columns, values)}
    arguments = {column["name"]: arrays.pop(column["name"]) for column in said["inputs"]}
    return askable(Golden(said["function"], of_package(said["calls"]), axes, arguments, arrays))


def main() -> int:
    folder = files("hashnoise") / "vectors"
    if not folder.is_dir():
        print("hashnoise.check: this package was built without vectors, to which it would be held; a wheel of PyPI and a "
              "source distribution have them, and a clone once tools/make vectors has run", file=sys.stderr)
        return 2
    goldens = [golden for path in sorted(folder.iterdir(), key=lambda path: path.name) if path.name != "index.json"
               if (golden := read(path.read_text(encoding="ascii")))]
    sets = hashnoise.instruction_sets()
    wrong = [f"{instruction_set}: {fault}" for instruction_set in sets for golden in goldens
             for fault in different_bits(golden, computed(golden, "fixed", instruction_set=instruction_set))]
    count = sum(values.size for golden in goldens for values in golden.results.values())
    if not sets:
        wrong = ["hashnoise.check: this processor has no instruction set that the package was compiled for"]
    print("\n".join(wrong[:20]) or f"{count:,} values of {len(goldens)} vectors have their bits with {', '.join(sets)}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
