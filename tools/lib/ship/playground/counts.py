"""How many instructions and registers compilers of GPUs count for the page's functions: from the record of
tools/measure gpu, one chip of each compiler."""

from __future__ import annotations

import re

from base.pieces import is_deleted
from base.tree import ROOT
from catalog.javascript import drawn
from catalog.model import read

RECORD = ROOT / "docs" / "measured" / "results" / "gpu"
CHIPS = ("sm90", "ampere", "navi31", "adreno740", "m1", "acm")
# These unroll every loop. A shader in which another one left a loop has no count: it would count one octave.
UNROLLING = ("sm90", "acm")
WITNESS = "adreno740"  # of loops
LOOPS = re.compile(r"\bLoops [1-9]")  # in the kinds of a row
CASE = re.compile(r"(?:noise([1-4])d|\w+)\.([a-z_]+)([1-4]?)\.lattice(\+fixed)?")


def subject(case: str) -> str | None:
    """The subject of a case at a position with the default hash: "perlin2", or "perlin2 fixed"."""
    found = CASE.fullmatch(case)
    return found and found[2] + (found[1] or found[3]) + " fixed" * bool(found[4])


def counts() -> dict:
    """chips: their titles; of: {subject: the instructions and registers of each chip, "-" where there is no count}."""
    if is_deleted("measuring"):
        return {"chips": [], "of": {}}
    from measure import record
    noises, sums = drawn(read())
    names = {one.name for one in (*noises, *sums)}
    titles = {row["chip"]: row["title"] for row in record.read(RECORD / "chips.csv").rows}
    found: dict[str, dict[str, dict[str, str]]] = {}
    for row in record.read(RECORD / "costs.csv").rows:
        name = subject(row["id"])
        if name and re.split(r"\d", name)[0] in names and row["chip"] in CHIPS and not row["problem"]:
            found.setdefault(name, {})[row["chip"]] = row

    def count(of: dict[str, dict[str, str]], chip: str) -> str:
        looped = LOOPS.search(of.get(WITNESS, {}).get("kinds", "")) and chip not in UNROLLING
        return "- -" if looped or chip not in of else f"{of[chip]['instructions']} {of[chip]['registers']}"

    return {"chips": [titles[chip] for chip in CHIPS],
            "of": {name: " ".join(count(of, chip) for chip in CHIPS) for name, of in sorted(found.items())}}
