"""The tables of measured costs in docs/measured/measuring.md and docs/measured/default-hash.md."""

from __future__ import annotations

import re
from collections.abc import Mapping

from base.tree import ROOT
from catalog.tables.markdown import table
from measure.gpu.chips import SHOWN, chip_named
from measure.gpu.record import COSTS, Row, read_costs
from measure.peers import CALLS, Call, dimensions, subject

RECORD = ROOT / "docs" / "measured" / "results" / "gpu"
# Functions that show the cost of a hash: the hash alone, and noises that are little more than hashes.
HASHED = {"hash.lattice2.lattice": "`hn_lattice` of an `ivec2`", "hash.lattice3.lattice": "`hn_lattice` of an `ivec3`",
          "noise2d.value.lattice": "value 2D", "noise3d.value.lattice": "value 3D", "noise2d.perlin.lattice": "Perlin 2D",
          "noise3d.perlin.lattice": "Perlin 3D", "noise2d.simplex.lattice": "simplex 2D",
          "noise3d.simplex.lattice": "simplex 3D"}
# The letters of the peers in cells.
LETTERS = {"fastnoiselite": "F", "wombat": "W", "materialx": "M", "webgl-noise": "S", "psrdnoise": "P",
           "terrain-erosion": "E", "phasor-noise": "T", "clay-john": "J"}
SUMS = "octaves"  # in the names of noises: those have loops
# Stripes and gullies of others, whose costs stay as they were measured.
STRIPES = (("stripes 2D", "noise2d.phasor", "terrain-erosion"), ("stripes 2D", "noise2d.phasor", "phasor-noise"),
           ("stripes 2D with derivatives", "noise2d.phasor_d", "clay-john"),
           ("gullies 2D, 5 octaves", "noise2d.gullies", "terrain-erosion"))
SHOWN_CALLS = (*(call for call in CALLS if SUMS not in call.noise), *(Call(*names, "", "") for names in STRIPES))
LOOPS = re.compile(r"\bLoops [1-9]")  # in the kinds of a row
TABLES = re.compile(r"\bmemory [1-9]")  # the same, where instructions are counted, and waits are not
WITNESS = "adreno740"  # of loops, for compilers that do not state whether they left one


def costs() -> dict[tuple[str, str], Row]:
    return read_costs(RECORD / COSTS) | read_costs(RECORD / "stripes.csv")


def shown(rows: Mapping[tuple[str, str], Row]) -> list[str]:
    """The chips of tables that a record has."""
    return [name for name in SHOWN if any(chip == name for _, chip in rows)]


def chip_table(rows: Mapping[tuple[str, str], Row]) -> str:
    """Ours with floats and with integers, then each peer; with a * where the shader has a loop, and a + where a wait
    for memory is not counted."""
    lines, chips = [], shown(rows)
    for noise in dict.fromkeys(call.noise for call in SHOWN_CALLS):
        calls = [call for call in SHOWN_CALLS if call.noise == noise]
        cells = []
        for chip in chips:
            ours = [_cost(rows, f"{calls[0].ours}.lattice{fixed}", chip) for fixed in ("", "+fixed")]
            theirs = [f"{LETTERS[call.peer]} {_cost(rows, subject(call) + str(dimensions(call)), chip)}"
                      for call in calls]
            cells.append(f"{' / '.join(ours)}; {', '.join(theirs)}")
        lines.append([noise, *cells])
    return table(("noise", *(_head(name) for name in chips)), lines)


def arithmetics_quote(rows: Mapping[tuple[str, str], Row]) -> str:
    """The costs of arithmetics in that of HN_FAST, least and largest of the chips."""
    def beside_fast(id: str, arithmetic: str) -> str:
        ratios = [float(rows[f"{id}+{arithmetic}", chip].cost) / float(rows[id, chip].cost)
                  for chip in shown(rows)]
        return f"{min(ratios):.1f} to {max(ratios):.1f} times"

    ids = ("noise2d.perlin.lattice", "noise3d.perlin.lattice")
    fixed, precise = ([beside_fast(id, arithmetic) for id in ids] for arithmetic in ("fixed", "precise"))
    return (f"By the compilers of GPUs, Perlin noise with `HN_FIXED` costs {fixed[0]} as much as with `HN_FAST` on the "
            f"plane and {fixed[1]} in space, and with `HN_PRECISE` {precise[0]} and {precise[1]}.\n")


def titled_table(rows: Mapping[tuple[str, str], Row], titles: Mapping[str, str]) -> str:
    """The costs of some subjects, each with its title."""
    chips = shown(rows)
    return table(("", *(_head(name) for name in chips)),
                 [[title, *(_cost(rows, id, chip) for chip in chips)] for id, title in titles.items()])


def _head(name: str) -> str:
    chip = chip_named(name)
    return f"{chip.title}: {chip.vendor.unit}"


def _cost(rows: Mapping[tuple[str, str], Row], id: str, chip: str) -> str:
    row = rows[id, chip]
    if row.problem:
        return "fails"
    counted = row if "Loops" in chip_named(chip).vendor.kinds else rows[id, WITNESS]
    waits = not chip_named(chip).vendor.is_driver and TABLES.search(row.kinds)
    return row.cost + "*" * bool(LOOPS.search(counted.kinds)) + "+" * bool(waits)
