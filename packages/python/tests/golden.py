"""The golden files, by the functions of the package."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import numpy
from hashnoise.check import TYPES, Golden, askable, computed, different_bits, has, of_package  # noqa: F401

sys.path.append(str(Path(__file__).resolve().parents[3] / "tools" / "lib"))

from base import golden_values  # noqa: E402
from base.tree import BOUNDS, GOLDEN, ROOT  # noqa: E402, F401  (other tests take ROOT from here)


def names(setting: str) -> list[str]:
    """The functions that the package has and that have golden values with this setting: noise2d.perlin, ..."""
    found = []
    for id, _ in golden_values.ids(setting):
        head = golden_values.head_of(GOLDEN / f"{id}.golden")
        if has(head.calls, head.axes, {name for name, _ in head.columns + head.results}):
            found.append(id)
    return found


def read(name: str, setting: str, folder: Path = GOLDEN) -> Golden:
    file = golden_values.Golden(name, setting, folder)
    arguments, results = (
        {column: numpy.array(words, numpy.uint64 if kind == "f64" else numpy.uint32).view(TYPES[kind])
         for (column, kind), words in zip(columns, zip(*rows))}
        for columns, rows in ((file.head.columns, file.inputs), (file.head.results, file.values)))
    return askable(Golden(name, of_package(file.head.calls), file.head.axes, arguments, results))


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
