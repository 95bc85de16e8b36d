"""Words of the lattice in several orders, as streams for dieharder, which tests generators of random numbers."""

from __future__ import annotations

import csv
import shutil
import subprocess
from collections.abc import Callable, Iterator
from contextlib import suppress

import numpy as np

from base.twin import NotBuilt
from measure.hashes.judgement import ALPHA, Finding

PROGRAM = "dieharder"
BATCH = 1 << 18  # cells at a time
SIDE = {2: 10, 3: 7}  # bits of the coordinates of a window, but of the last one
# By dieharder's -d: birthdays, ranks of 6 x 8 bits, bit stream, count of ones, runs; runs and the frequencies of up to
# sixteen bits (serial) of the STS. The others take fifty times as many words or more, or are not well founded.
TESTS = (0, 3, 4, 8, 15, 101, 102)


def _rows(i: np.ndarray, n: int) -> np.ndarray:
    """Cells of a window that grows along its last axis, x fastest."""
    side = SIDE[n]
    return np.stack([i >> side * axis & (1 << side if axis < n - 1 else 1 << 40) - 1 for axis in range(n)], axis=-1)


def _gray(i: np.ndarray, n: int) -> np.ndarray:
    """Cells in the order of a Gray code: each differs from the one before in one bit of one coordinate."""
    code = i ^ i >> 1
    return np.stack([sum((code >> n * bit + axis & 1) << bit for bit in range(20)) for axis in range(n)], axis=-1)


# Of a counter and the number of axes to cells; in the order of seeds it counts them, with eight cells for each.
ORDERS: dict[str, Callable[[np.ndarray, int], np.ndarray]] = {
    "rows": _rows, "strides": lambda i, n: _rows(i, n) << 12, "Gray": _gray, "seeds": lambda i, n: _gray(i & 7, n)}


def stream(hash_, dimensions: int, order: str) -> Iterator[bytes]:
    """The upper halves of words, without end."""
    for start in range(0, 1 << 40, BATCH):
        i = np.arange(start, start + BATCH, dtype=np.int64)
        words = hash_.words(ORDERS[order](i, dimensions), i >> 3 if order == "seeds" else 0)
        yield (words >> np.uint32(16)).astype(np.uint16).tobytes()


def p_values(test: int, samples: int, chunks: Iterator[bytes]) -> list[tuple[str, float]]:
    """The names of dieharder's tests, and for each the p-value of so many p-values."""
    command = [PROGRAM, "-g", "200", "-d", str(test), "-p", str(samples), "-c", ",",
               *(word for name in ("test_name", "ntuple", "pvalues") for word in ("-D", name))]
    if not shutil.which(PROGRAM):
        raise NotBuilt(f"there is no {PROGRAM}: apt-get install {PROGRAM}")
    printed = b""
    # It closes the pipe when it has what it needs.
    with suppress(BrokenPipeError), subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        with suppress(BrokenPipeError):
            for chunk in chunks:
                process.stdin.write(chunk)
        printed = process.stdout.read()
    if process.returncode or not printed.strip():
        raise NotBuilt(f"{PROGRAM} -d {test} ended with {process.returncode} and printed {len(printed)} bytes")
    return [(f"{name.strip()} {tuples.strip()}", float(p))
            for name, tuples, p in csv.reader(printed.decode().splitlines())]


def judge(hash_, dimensions: int, order: str, samples: int) -> list[Finding]:
    """Dieharder's p-values have eight digits, so the limit is the same number for each of its tests. A p-value near 1
    is no failure: of few samples the distribution of p-values is often too even."""
    return [Finding(f"dieharder {name}", p, ALPHA, p, f"in the order of {order}")
            for test in TESTS for name, p in p_values(test, samples, stream(hash_, dimensions, order))]
