"""Asks the C++ of conformance/sums, which has the proofs, how far an octave sum of floats may be off."""

from __future__ import annotations

import atexit
import functools
import subprocess
import tempfile
from dataclasses import astuple
from pathlib import Path

from base.tree import CONFORMANCE
from base.twin import compile_program
from catalog import suite
from proof.bounds.sums import KINDS, Sum
from proof.bounds.table import Bounds, GulliesBounds

SOURCE = CONFORMANCE / "sums" / "answers.cpp"


@functools.cache
def _program() -> subprocess.Popen[str]:
    """It runs as long as this one, and answers line by line."""
    folder = tempfile.TemporaryDirectory()
    program = Path(folder.name) / SOURCE.stem
    suite.write(Path(folder.name))
    compile_program("the bounds of sums", SOURCE, program, f"-I{CONFORMANCE}", include=Path(folder.name))
    process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)

    def end() -> None:
        process.communicate()
        folder.cleanup()

    atexit.register(end)
    return process


def _answer(what: str, rule: str, s: Sum, *others: float) -> list[float]:
    footprint = -1.0 if s.footprint is None else s.footprint
    arguments = (s.p_max, s.octaves, s.lacunarity, s.gain, s.exact_positions, s.strength, footprint, s.rotates, s.from_cell,
                 isinstance(s.octaves, float), s.amplitude)
    process = _program()
    print(what, rule, *(float(x) if isinstance(x, float) else int(x) for x in (*arguments, *others)),
          file=process.stdin)
    answer = process.stdout.readline()
    try:
        return list(map(float, answer.split()))
    except ValueError:  # there is no proof
        raise LookupError(answer.strip()) from None


def _told(what: str, s: Sum, *bounds: Bounds) -> float:
    of_noise = [x for b in bounds for x in (b.dimensions, b.cell_error, b.error, b.lipschitz, b.limit)]
    number, = _answer(what, s.kind, s, *of_noise)
    return number


def octave_tolerance(s: Sum, noise: Bounds, slope: Bounds | None = None) -> float:
    """The largest error of an octave sum over a noise, or of a component of a warp. An erosion and a warp need what is
    proven of the derivatives of the noise."""
    if slope is None and s.kind not in (*KINDS, "fbm_d"):
        raise LookupError(f"the bound of {s.kind} follows from the bounds of derivatives, too")
    return _told("value", s, noise, slope or noise)


def slope_tolerance(s: Sum, noise: Bounds, slope: Bounds) -> float:
    """The largest error of a derivative of hn_fbm_d."""
    return _told("slope", s, noise, slope)


def gullies_tolerance(s: Sum, slope: float, depth: float, bounds: GulliesBounds) -> tuple[float, float]:
    """The largest error of the height and of a slope of hn_gullies in a tile, for a slope of that length."""
    height, added = _answer("gullies", "gullies", s, float(slope), float(depth), *astuple(bounds))
    return height, added
