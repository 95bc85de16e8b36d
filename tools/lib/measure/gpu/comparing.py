"""Two records beside each other: how many times a noise costs what it did, on a chip of each vendor."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from statistics import fmean

from catalog.tables.markdown import table
from measure.gpu.chips import APPLE, NVIDIA, SHOWN, chip_named
from measure.gpu.record import Row
from measure.peers import CALLS

FLOATS, FIXED = ".lattice", ".lattice+fixed"
Rows = Mapping[tuple[str, str], Row]


def weight(row: Row) -> float:
    """The cost of a shader. NVIDIA's cycles are those of a schedule that waits, so its instructions count as much: it
    is their geometric mean. On Apple the unit of integers may be the one that others wait for: IC."""
    vendor, cost = chip_named(row.chip).vendor, float(row.cost)
    if vendor is NVIDIA:
        return math.sqrt(cost * float(row.instructions))
    if vendor is APPLE:
        integers = re.search(r"\bIC (\d+)", row.kinds)
        return max(cost, float(integers[1]) if integers else 0)
    return cost


def shown(rows: Rows) -> list[str]:
    """The chips of tables that a record has."""
    had = {chip for _, chip in rows}
    return [chip for chip in SHOWN if chip in had]


def page_table(before: Rows, now: Rows) -> str:
    """The noises that both records have on every chip that both have, in the order of the first. ValueError if there is
    none."""
    chips = [chip for chip in shown(before) if chip in shown(now)]

    def measured(rows: Rows, noise: str) -> bool:
        return all((noise + arithmetic, chip) in rows and not rows[noise + arithmetic, chip].problem
                   for arithmetic in (FLOATS, FIXED) for chip in chips)

    def change(noise: str, arithmetic: str) -> str:
        id = noise + arithmetic
        ratios = [weight(now[id, chip]) / weight(before[id, chip]) for chip in chips]
        return f"**{fmean(ratios):.2f}**: {', '.join(f'{ratio:.2f}' for ratio in ratios)}"

    noises = [noise for noise in dict.fromkeys(id.removesuffix(FLOATS) for id, _ in before if id.endswith(FLOATS))
              if measured(before, noise) and measured(now, noise)]
    if not chips or not noises:
        raise ValueError(f"the records have no noise with floats and with HN_FIXED on {', '.join(SHOWN)} in common")

    def fixed_to_floats(noise: str) -> str:
        return f"{fmean(weight(now[noise + FIXED, chip]) / weight(now[noise + FLOATS, chip]) for chip in chips):.2f}"

    return table(("noise", "floats", "`HN_FIXED`", "`HN_FIXED` to floats, now"),
                 [[title(noise), change(noise, FLOATS), change(noise, FIXED), fixed_to_floats(noise)]
                  for noise in noises])


def title(noise: str) -> str:
    """Perlin 2D of noise2d.perlin, as the table of peers has it, or as the id has it."""
    named = {call.ours: call.noise for call in CALLS}
    dimensions, _, name = noise.partition(".")
    return named.get(noise) or f"{name.replace('_', ' ')} {dimensions.removeprefix('noise').upper()}"
