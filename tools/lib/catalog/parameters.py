"""The catalog's texts, ranges and defaults of the parameters of functions, for programs that show these to people."""

from __future__ import annotations

import re
from functools import cache
from typing import NamedTuple

from catalog.model import Catalog, read

COLUMNS = 90  # of a text that shows up beside a mouse, and in a line of OSL
WORDS = (-(1 << 31), (1 << 31) - 1)  # an int; a range that is no part of these is none for a menu


class About(NamedTuple):
    what: str
    least: float | None
    most: float | None
    default: float | None


@cache
def _read() -> Catalog:
    return read()


def about(function: str, parameter: str, is_fixed: bool) -> About | None:
    """The text on a parameter of a function such as hn_warp, or of a form such as hn_warp2; None if the catalog lacks
    it."""
    of = _read()
    if parameter == "metric":
        listed = ", ".join(f"{number} {name}" for number, name in enumerate(of.metrics, 1))
        return About(f"the distance: {listed}", 1, len(of.metrics), 1)
    name = re.sub(r"\Ahn_|\d.*", "", function)
    for sum_ in of.sums:
        if sum_.name == name and sum_.strength and sum_.strength.name == parameter:
            what = re.split(r"; |, in \[", sum_.strength.about.replace("`", ""))[0]
            return About(what if len(what) < COLUMNS else what.partition(":")[0], 0,
                         sum_.strength.most, sum_.strength.default)
    if along := re.fullmatch("wave_([xyz])", parameter):  # in a language without vectors; 3 along x is usual
        wave = of.settings["wave"]
        return About(f"waves in a cell along {along[1]}", wave.least, wave.most, 3 if along[1] == "x" else 0)
    if not (found := of.settings.get(parameter)):
        return None
    least, most = found.fixed if is_fixed else (found.least, found.most)
    if found.is_whole and not all(bound is None or WORDS[0] < bound < WORDS[1] for bound in (least, most)):
        least = most = None
    return About(found.about, least, most, found.default)
