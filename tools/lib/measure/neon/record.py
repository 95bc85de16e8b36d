"""The page of tools/measure neon, of its record: neon.csv has the instructions of a fill, by noise and arithmetic."""

from __future__ import annotations

from collections.abc import Mapping

from catalog.tables.markdown import table
from measure.record import Record, three_digits

ARITHMETICS = ("fast", "fixed", "precise")
OTHER = "FastNoise2"
# Quotients as hn-bench-cpu has them: above 1 the first of the two in the title costs less.
RATIOS = {"HN_FAST beside FastNoise2": (OTHER, "fast"), "HN_FIXED beside HN_FAST": ("fast", "fixed"),
          "HN_PRECISE beside HN_FAST": ("fast", "precise")}


def ratios(row: Mapping[str, str]) -> dict[str, float]:
    return {name: int(row[above]) / int(row[below]) for name, (above, below) in RATIOS.items() if above in row}


def page(of: Record) -> str:
    facts = of.facts
    fills = list(of.rows[0])[1:]
    counts = [[f"`{row['noise']}`", *(three_digits(int(row[fill]) / int(facts["points"])) for fill in fills)]
              for row in of.rows]
    quotients = [[f"`{row['noise']}`", *(f"{ratio:.2f}" for ratio in ratios(row).values())] for row in of.rows]
    return f"""\
# hashnoise::grid with NEON, in instructions

{facts["compiler"]} for ARM, {facts["emulator"]}, hashnoise {facts["library"]} of the text {facts["text"]}, \
{facts["date"]}.\
{facts["note"] and " "}{facts["note"]} By `{facts["command"]}`.

QEMU counted the instructions that filling a grid takes, by one thread. They are no times: a processor executes some \
of them side by side, and waits for others. A grid has 1024 x 1024 or 128 x 128 x 64 points, {facts["step"]} cells from \
each other, and sums have six octaves.

## Beside each other

How many times as fast the first would be if each instruction took the same time.

{table(["noise", *ratios(of.rows[0])], quotients)}
## Instructions a point

`cellular` has two distances at each point, and FastNoise2 one.

{table(["noise", *(fill if fill == OTHER else f"HN_{fill.upper()}" for fill in fills)], counts)}"""
