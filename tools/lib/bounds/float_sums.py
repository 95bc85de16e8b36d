"""How far an octave sum of floats may be off: what the suite says of it, in C++, so that it is said once. The proofs are in
conformance/expected/sum_bounds.cpp."""

from __future__ import annotations

import atexit
import functools
import subprocess
import tempfile
from pathlib import Path

from bounds.sums import Sum
from bounds.table import Bounds
from tree import ROOT
from twin import compile_program

SOURCE = Path(__file__).with_name("octave_tolerance.cpp")


@functools.cache
def _program() -> subprocess.Popen[str]:
    """It runs as long as this one, and answers line by line."""
    folder = tempfile.TemporaryDirectory()
    program = Path(folder.name) / SOURCE.stem
    compile_program("what the suite says of sums", SOURCE, program, include=ROOT / "conformance")
    process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)

    def end() -> None:
        process.communicate()
        folder.cleanup()

    atexit.register(end)
    return process


def _told(what: str, s: Sum, *bounds: Bounds) -> float:
    footprint = -1.0 if s.footprint is None else s.footprint
    arguments = (s.p_max, s.octaves, s.lacunarity, s.gain, s.exact_positions, s.strength, footprint, s.turns, s.from_cell,
                 isinstance(s.octaves, float), s.amplitude)
    of_noise = [x for b in bounds for x in (b.dimensions, b.cell_error, b.error, b.lipschitz, b.limit)]
    process = _program()
    print(what, rule_of(s), *(float(x) if isinstance(x, float) else int(x) for x in (*arguments, *of_noise)),
          file=process.stdin)
    return float(process.stdout.readline())


def rule_of(s: Sum) -> str:
    """By the rule of which sum it adds octaves."""
    return s.kind


def octave_tolerance(s: Sum, noise: Bounds, slope: Bounds | None = None) -> float:
    """The largest error of an octave sum over a noise, or of a component of a warp. An erosion and a warp need what is
    proven of the derivatives of the noise."""
    return _told("value", s, noise, slope or noise)


def slope_tolerance(s: Sum, noise: Bounds, slope: Bounds) -> float:
    """The largest error of a derivative of hn_fbm_d."""
    return _told("slope", s, noise, slope)
