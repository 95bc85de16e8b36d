"""Asks the C++ of conformance/sums, which has the proofs of octave sums: how far floats may be off, and steps in
integers."""

from __future__ import annotations

import ctypes
import functools
import tempfile
from collections.abc import Sequence
from pathlib import Path

from base.tree import CONFORMANCE
from base.twin import SOON, compile_program
from catalog import suite

SOURCE = CONFORMANCE / "sums" / "answers.cpp"
MOST_OCTAVES = 32


@functools.cache
def library() -> ctypes.CDLL:
    with tempfile.TemporaryDirectory() as folder:
        suite.write(Path(folder))
        compiled = Path(folder, "answers.so")
        compile_program("the bounds of sums", SOURCE, compiled, *SOON, "-shared", "-fPIC", f"-I{CONFORMANCE}",
                        include=Path(folder))
        found = ctypes.CDLL(str(compiled))
    found.answer.restype = ctypes.c_char_p
    return found


def answer(what: str, sum_: str, numbers: Sequence[float]) -> list[float]:
    """As at the top of that file. Where there is no proof a LookupError has its sentence."""
    found = (ctypes.c_double * (1 + 2 * MOST_OCTAVES))()
    problem = library().answer(what.encode(), sum_.encode(), (ctypes.c_double * len(numbers))(*numbers), found)
    if problem:
        raise LookupError(problem.decode())
    return list(found)
