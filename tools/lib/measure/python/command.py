"""Measures the Python package beside other packages of PyPI that compute noise.

    tools/measure python --python FILE [--out DIR] [--rounds N]

FILE is a Python that has the package and those to compare with (pip install pyfastnoiselite opensimplex vnoise
perlin-numpy noise). Functions that it lacks are left out. python.csv goes into DIR: the noise, the package and its
version, nanoseconds per point, that time in ours, and the spread of this quotient, half the distance between its
quartiles. All use one thread, in turns. Nothing else should run meanwhile. docs/measured/results/cpu/python.csv is such
a file; tools/make readme makes the table of docs/measured/measuring.md of it.

Exit status: 0 done, 1 the package is not in that Python or a call failed, 2 bad usage.
"""

from __future__ import annotations

import subprocess
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from base.usage import Parser, whole
from base.versions import version_of
from measure import stamps

CALLS = Path(__file__).with_name("calls.py")
COLUMNS = "noise,package,version,nanoseconds,ratio,spread\n"


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure python", __doc__)
    parser.add_argument("--python", type=Path, required=True, metavar="FILE", help="a Python that has the packages")
    parser.add_argument("--out", type=Path, default=Path("out"), metavar="DIR", help="for python.csv (out)")
    parser.add_argument("--rounds", type=partial(whole, least=3), default=9, metavar="N", help="samples of each time (9)")
    given = parser.parse_args(arguments)
    if not given.python.is_file():
        parser.error(f"--python: there is no {given.python}")
    done = subprocess.run([given.python, "-B", CALLS, str(given.rounds)], stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode:
        return 1
    given.out.mkdir(parents=True, exist_ok=True)
    record = given.out / "python.csv"
    record.write_text(COLUMNS + done.stdout, encoding="utf-8")
    stamps.stamp(record, version_of(given.python))
    print(record)
    return 0
