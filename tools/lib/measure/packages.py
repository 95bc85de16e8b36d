"""Times of a noise in packages of a language, ours among them: what tools/measure python and rust have in common."""

from __future__ import annotations

import statistics
import subprocess
from collections.abc import Iterable, Sequence
from functools import partial
from pathlib import Path

from base.usage import Parser, whole
from measure import record

OURS = "hashnoise"


def parser_of(command: str, description: str, rounds: int) -> Parser:
    parser = Parser(f"tools/measure {command}", description)
    parser.add_argument("--out", type=Path, default=Path("out"), metavar="DIR", help=f"for {command}.csv (out)")
    parser.add_argument("--rounds", type=partial(whole, least=3), default=rounds, metavar="N",
                        help="samples of each time (%(default)s)")
    return parser


def printed(*command: object, **options: object) -> list[list[str]] | None:
    """The lines of a program by their commas; nothing if it failed."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, text=True, check=False, **options)
    return None if done.returncode else [line.split(",") for line in done.stdout.splitlines()]


def rows_of(lines: Iterable[Sequence[str]], typical=statistics.median, **first: str) -> list[dict[str, str]]:
    """The lines are "noise, package, version, nanoseconds of each round"; a row has the typical of these, the time in
    ours, and its spread."""
    times = {(noise, package, number): [float(one) for one in some] for noise, package, number, *some in lines}
    ours = {noise: some for (noise, package, _), some in times.items() if package == OURS}
    rows = []
    for (noise, package, number), some in times.items():
        ratio = record.ratio(some, ours[noise])
        rows.append({**first, "noise": noise, "package": package, "version": number, "nanoseconds": f"{typical(some):.3g}",
                     "ratio": f"{ratio.value:.3g}", "spread": f"{ratio.spread:.2g}"})
    return rows
