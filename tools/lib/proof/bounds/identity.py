"""The text is the contract's: in exact arithmetic each function returns the exact value.

Only where this is so are errors of the text errors of the noise. Doubles stand for exact arithmetic, and
constants keep their decimals. The exact values are the oracle's, in the golden files: edges and drawn places, seeds,
periods, phases, metrics, jitters and settings.

How many places are enough? Without roundings a function is made of pieces: polynomials, roots or waves of the place,
with coefficients from the hashes of a cell. Two such pieces that differ are equal in a set without volume. So one place
that is drawn in a piece finds a wrong constant, sign, power or axis there, if the coefficients of its cell matter: each
branch wants a few. The golden files have 48 to 300 places of each function, and identity_test.py has mutants, which are
found at many of them.

The results differ far less than floats do:

    DOUBLES  of the largest result. Doubles are 2^29 times as fine as floats.
    ANGLES   of the largest result of waves: the text cuts the phase of a wave, and a place's, to 2^-30 turns.

Some places are not compared, as the text cuts numbers there, which the bounds take into account: positions of the
octaves of sums to its integers, and phases to 2^-30 turns (cuts). Nor is a jitter that no double adds to a cell. The
suite compares the text in floats with the golden files there.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from base import golden_values
from base.golden_values import head_of
from base.tree import GOLDEN
from catalog.tables.configurations import DEFAULT_HASH
from catalog.tables.functions import Function, read_functions
from proof.bounds.rounded import EXACT, SINES, Text

SETTINGS = {DEFAULT_HASH: (), f"{DEFAULT_HASH}+sine": (SINES,)}  # macros
DOUBLES, ANGLES = 1e-12, 2.0**-25
LEAST_JITTER = 2.0**-40
DIGITS = 24  # binary ones, of the fraction of an octave's position in integers
Columns = Mapping[str, np.ndarray]


def column(kind: str, words: list[int]) -> np.ndarray:
    whole = np.array(words, np.uint64)
    if kind == "f64":
        return whole.view(float)
    narrow = whole.astype(np.uint32)
    return narrow.view(np.float32).astype(float) if kind == "f32" else (
        narrow.view(np.int32) if kind == "i32" else narrow).astype(np.int64)


def digits(x: np.ndarray) -> np.ndarray:
    """Their number behind the point, DIGITS + 1 at most."""
    return sum((x * 2.0**k % 1 != 0).astype(int) for k in range(DIGITS + 1))


def cuts(function: Function, columns: Columns) -> np.ndarray | bool:
    """Where the text cuts a phase, or the positions of a sum's octaves: each has the digits of the one before and of
    the lacunarity, and turns by 1/32."""
    of_phase = "phase" in columns and "wave" not in function.takes and columns["phase"] * 2.0**30 % 1 != 0
    if function.form != "sum" or not function.has_place:
        return of_phase
    places = [columns[name] for name in columns if name in ("x", "y", "z", "w", "fx", "fy", "fz", "fw")]
    tiled = np.any([columns[name] != 0 for name in columns if name in ("px", "py", "pz", "pw")], axis=0)
    each = np.where(tiled, 0, digits(np.clip(columns["lacunarity"], 0, 255)) + 5 * (function.axes - 1))
    octaves = np.clip(columns["octaves"], 1, 32)
    if function.bound == "warp_progressive":  # by the noise, too
        each = np.full(len(octaves), DIGITS + 1)
    return of_phase | (np.max([digits(np.clip(x, 0, 1) if function.has_cell else x) for x in places], axis=0) + each * (
        octaves - 1) > DIGITS)


def waves(setting: str, function: Function) -> bool:
    return "wave" in function.takes or function.bound == "gullies" or setting.endswith("sine")


@dataclass(frozen=True)
class Golden:
    """The exact values of a function that rounds, with a setting."""
    setting: str
    function: Function
    columns: Columns
    values: list[np.ndarray]  # of each output

    def most(self, values: np.ndarray) -> float:
        """By which others may differ from these."""
        return (ANGLES if waves(self.setting, self.function) else DOUBLES) * max(1.0, abs(values).max())


@functools.cache
def golden_files() -> list[Golden]:
    found = []
    for function in read_functions():
        path = GOLDEN / f"{function.id}.golden"
        if function.bound == "exact" or not path.exists():
            continue
        for setting in [setting for setting in head_of(path).settings if setting in SETTINGS]:
            read = golden_values.Golden(function.id, setting)
            columns, values = ({of.name: column(of.type, words) for of, words in zip(some, zip(*rows))}
                               for some, rows in ((function.inputs, read.inputs), (function.outputs, read.values)))
            found.append(Golden(setting, function, columns, list(values.values())))
    return found


def compared(golden: Golden) -> np.ndarray:
    jitter = golden.columns.get("jitter", 1.0)
    return ~np.broadcast_to(cuts(golden.function, golden.columns), len(golden.values[0])) & (
        (jitter <= 0) | (jitter > LEAST_JITTER))


def differing(text: Text, golden: Golden) -> tuple[int, int]:
    """How many places differ, of how many."""
    wrong = np.full(len(golden.values[0]), False)
    results = text(golden.function.id, EXACT, **golden.columns)
    for of, right, found in zip(golden.function.outputs, golden.values, results):
        wrong |= ~(abs(found - right) <= golden.most(right)) if of.type == "f64" else found != right.astype(np.uint32)
    here = compared(golden)
    return int((wrong & here).sum()), int(here.sum())


def wrong_texts() -> list[str]:
    """A message for each function that is not the contract's without roundings."""
    messages = []
    for setting, macros in SETTINGS.items():
        some = {golden.function.id: golden for golden in golden_files() if golden.setting == setting}
        text = Text(some, *macros)
        for id, golden in some.items():
            wrong, count = differing(text, golden)
            if wrong:
                messages.append(f"{id}: without roundings the text is not the contract's at {wrong} of {count} places "
                                f"of conformance/expected/golden/{id}.golden ({setting})")
    return messages
