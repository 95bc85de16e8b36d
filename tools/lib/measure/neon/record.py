"""The page and the record of tools/measure neon."""

from __future__ import annotations

from typing import NamedTuple

from catalog.tables.markdown import table

SCHEMA = 1
ARITHMETICS = ("fast", "fixed", "precise")
OTHER = "FastNoise2"
# Quotients as hn-bench-cpu has them, by its names: more than 1 says that the first of the two in the title is cheaper.
RATIOS = {"grids": ("HN_FAST beside FastNoise2", OTHER, "fast"), "fixed": ("HN_FIXED beside HN_FAST", "fast", "fixed"),
          "precise": ("HN_PRECISE beside HN_FAST", "fast", "precise")}


class Run(NamedTuple):
    date: str
    command: str
    compiler: str
    emulator: str
    library: str  # its version
    note: str
    points: int  # of a grid
    step: float  # from point to point, in cells
    fills: dict[str, dict[str, int]]  # instructions of a fill, by subject, and by arithmetic or OTHER


def ratios(fill: dict[str, int]) -> dict[str, float]:
    return {name: fill[above] / fill[below] for name, (_, above, below) in RATIOS.items()
            if above in fill and below in fill}


def three_digits(number: float) -> str:
    # From here on three digits are those before the point, which the other format would write.
    return f"{number:.0f}" if number >= 99.95 else f"{number:#.3g}"


def record(run: Run) -> dict[str, object]:
    """For JSON."""
    head = {name: value for name, value in run._asdict().items() if name != "fills"}
    return {"schema": SCHEMA, **head,
            "measurements": [{"id": subject, "instructions": "neon", "executed": fill, "ratios": ratios(fill)}
                             for subject, fill in run.fills.items()]}


def page(run: Run) -> str:
    known = ratios(next(iter(run.fills.values())))
    counted = [*(f"HN_{name.upper()}" for name in ARITHMETICS), *([OTHER] if "grids" in known else [])]
    counts = [[f"`{subject}`", *(three_digits(number / run.points) for number in fill.values())]
              for subject, fill in run.fills.items()]
    quotients = [[f"`{subject}`", *(f"{ratio:.2f}" for ratio in ratios(fill).values())]
                 for subject, fill in run.fills.items()]
    note = f" {run.note}" if run.note else ""
    return f"""\
# hashnoise::grid with NEON, in instructions

{run.compiler} for ARM, {run.emulator}, hashnoise {run.library}, {run.date}.{note} By `{run.command}`.

QEMU counted the instructions that filling a grid takes, by one thread. They are no times: a processor executes some \
of them side by side, and waits for others. A grid has 1024 x 1024 or 128 x 128 x 64 points, {run.step} cells from \
each other, and sums have six octaves.

## Beside each other

How many times as fast the first would be if each instruction took the same time.

{table(["noise", *(RATIOS[name][0] for name in known)], quotients)}
## Instructions a point

`cellular` has two distances at each point, and FastNoise2 one.

{table(["noise", *counted], counts)}"""
