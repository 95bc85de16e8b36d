"""Measures the Python package beside other packages of PyPI that compute noise.

    tools/measure python --python FILE [--out DIR] [--rounds N]

FILE is a Python that has the package and those to compare with (pip install pyfastnoiselite opensimplex vnoise
perlin-numpy noise jax torch). Functions that it lacks are left out. python.csv goes into DIR: the noise, the package and its
version, nanoseconds per point (the median of the rounds; in rows of memory MiB), that time in ours, and the spread of this quotient, half the
distance between its quartiles. All use one thread, in turns. Nothing else should run meanwhile.
docs/measured/results/cpu/python.csv is such a file; tools/make pages makes the table of docs/measured/measuring.md of
it.

Exit status: 0 done, 1 the package is not in that Python or a call failed, 2 bad usage.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from base.versions import version_of
from measure import packages, stamps

CALLS = Path(__file__).with_name("calls.py")


def main(arguments: Sequence[str] | None = None) -> int:
    parser = packages.parser_of("python", __doc__, rounds=9)
    parser.add_argument("--python", type=Path, required=True, metavar="FILE", help="a Python that has the packages")
    given = parser.parse_args(arguments)
    if not given.python.is_file():
        parser.error(f"--python: there is no {given.python}")
    lines = packages.printed(given.python, "-B", CALLS, given.rounds)
    if not lines:
        return 1
    stamps.keep(given.out / "python.csv", packages.rows_of(lines), version_of(given.python))
    return 0
