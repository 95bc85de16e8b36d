"""Looks in the Interactive Shader Format: what tools/pick writes, with the inputs that a program shows as controls."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

from base.tree import ROOT, version
from catalog.tables.markdown import table
from ship.packing import papers
from translate.pick.command import Choice, picker

PACKAGE = ROOT / "packages" / "isf"
LANGUAGE = "glsl"  # hosts compile a file as GLSL 3.30 and 4.00, and as GLSL ES 3.00


class Look(NamedTuple):
    said: str
    forms: tuple[str, ...]  # its calls
    code: str               # its value, of a position p and a seed, word; 0 has the first color, and 1 the second
    more: tuple[str, ...] = ()  # its inputs besides those of all


SUM = "octaves, 2.0, gain, word"
OCTAVES = ("octaves", "gain")
LOOKS = {
    "hills": Look("Soft hills: gradient noise", ("hn_perlin3",), "0.5 + contrast * hn_perlin(p, word)"),
    "clouds": Look("Octaves of gradient noise", ("hn_fbm3",), f"0.5 + 2.0 * contrast * hn_fbm(p, {SUM})", OCTAVES),
    "ridges": Look("Octaves with ridges", ("hn_ridged3",), f"2.0 * contrast * hn_ridged(p, {SUM})", OCTAVES),
    "smoke": Look("Octaves of the size of gradient noise", ("hn_turbulence3",),
                  f"4.0 * contrast * hn_turbulence(p, {SUM})", OCTAVES),
    "ink": Look("Clouds that a second noise bends", ("hn_fbm3", "hn_warp3"),
                f"0.5 + 2.0 * contrast * hn_fbm(p + hn_warp(p, 2, 2.0, 0.5, bend, word + 1u), {SUM})",
                (*OCTAVES, "bend")),
    "cells": Look("The distance to scattered points", ("hn_cellular3",), "2.0 * contrast * hn_cellular(p, word).x"),
    "stones": Look("How far the second of scattered points is behind the first", ("hn_cellular3",),
                   "4.0 * contrast * (hn_cellular(p, word).y - hn_cellular(p, word).x)"),
}
WHITE, BLACK = [1.0, 1.0, 1.0, 1.0], [0.0, 0.0, 0.0, 1.0]
INPUTS = {
    "size": {"TYPE": "float", "MIN": 1.0, "MAX": 64.0, "DEFAULT": 8.0, "LABEL": "Cells across the height"},
    "speed": {"TYPE": "float", "MIN": 0.0, "MAX": 4.0, "DEFAULT": 0.5, "LABEL": "Speed"},
    "contrast": {"TYPE": "float", "MIN": 0.0, "MAX": 2.0, "DEFAULT": 0.5, "LABEL": "Contrast"},
    "seed": {"TYPE": "float", "MIN": 0.0, "MAX": 100.0, "DEFAULT": 7.0, "LABEL": "Seed"},
    "octaves": {"TYPE": "long", "VALUES": [*range(1, 9)], "LABELS": [*map(str, range(1, 9))], "DEFAULT": 6,
                "LABEL": "Octaves"},
    "gain": {"TYPE": "float", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "LABEL": "Gain"},
    "bend": {"TYPE": "float", "MIN": 0.0, "MAX": 4.0, "DEFAULT": 1.0, "LABEL": "Bend"},
    "low": {"TYPE": "color", "DEFAULT": BLACK, "LABEL": "Low"},
    "high": {"TYPE": "color", "DEFAULT": WHITE, "LABEL": "High"},
}
COMMON = ("size", "speed", "contrast", "seed"), ("low", "high")
# The z of a position. A plane at one z would pulse once in each cell: at a whole z hills have a deviation of
# 0.24 and at half a z of 0.28, and the mean of cells is 0.55 and 0.46. A tilted plane passes through all depths at once,
# with 0.26 and 0.50 at any time.
DEPTH = "TIME * speed + 0.37 * at.x + 0.53 * at.y"


@cache
def pick():
    return picker()


def inputs(look: Look) -> list[str]:
    return [*COMMON[0], *look.more, *COMMON[1]]


def shader(name: str) -> str:
    """A file: a comment with JSON, which comes first, and GLSL."""
    look = LOOKS[name]
    described = {"DESCRIPTION": f"{look.said}, of hashnoise {version()}",
                 "CREDIT": "The hashnoise authors, MIT License", "ISFVSN": "2",
                 "CATEGORIES": ["Generator", "Noise"],
                 "INPUTS": [{"NAME": one, **INPUTS[one]} for one in inputs(look)]}
    text = pick()(look.forms, Choice(LANGUAGE))
    return f"""/*{json.dumps(described, indent=2)}*/

{text}
void main() {{
  highp uint word = uint(seed);
  highp vec2 at = size * (isf_FragNormCoord - 0.5) * vec2(RENDERSIZE.x / RENDERSIZE.y, 1.0);
  highp vec3 p = vec3(at, {DEPTH});
  gl_FragColor = mix(low, high, clamp({look.code}, 0.0, 1.0));
}}
"""


def interface() -> Iterator[tuple[str, str]]:
    """As of ship.blender."""
    for name, look in LOOKS.items():
        for one in inputs(look):
            of = {key: value for key, value in INPUTS[one].items() if not key.startswith("LABEL")}
            yield f"hn-{name}.{one}", json.dumps(of)


def node_table() -> str:
    return table(("file", "what it is", "inputs of its own"),
                 [(f"`hn-{name}.fs`", look.said, ", ".join(f"`{one}`" for one in look.more))
                  for name, look in LOOKS.items()])


@cache
def package() -> dict[str, str]:
    """All files, by their paths."""
    return {**papers(PACKAGE), **{f"hn-{name}.fs": shader(name) for name in LOOKS}}
