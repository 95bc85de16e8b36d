"""The gallery: recipes in GLSL, and the pictures that they make."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from base.tree import ROOT
from ship.pages import picture

PAGE = ROOT / "docs" / "guide" / "gallery" / "README.md"
SHEET = "sheet.png"  # all of them
SIDE = 512  # pixels of a picture, which the page shows at half the size: dense screens have two for one
RECIPE = re.compile(r'^<img src="(\w+)\.png" width="256" alt="[^"\n]+">\n\n(?:(?!```)[^<#\n][^\n]*\n\n)?```glsl\n(.*?)^```$',
                    re.MULTILINE | re.DOTALL)
SHADER = """#version 330
#extension GL_GOOGLE_include_directive : require
{code}
in vec2 uv;
out vec4 color;
void main() {{ color = vec4({call}, 1.0); }}
"""


@dataclass(frozen=True)
class Recipe:
    name: str  # of its function, and of its picture
    code: str

    @property
    def loops(self) -> bool:
        return f"vec3 {self.name}(vec2 uv, float time)" in self.code

    def call(self, time: str = "0.25") -> str:
        return f"{self.name}(uv, {time})" if self.loops else f"{self.name}(uv)"

    @property
    def shader(self) -> str:
        """The recipe in a whole shader."""
        return SHADER.format(code=self.code, call=self.call())

    @property
    def cpp(self) -> str:
        """The recipe for the C++ twin, which has the whole library."""
        return picture.in_cpp(re.sub(r"^#include.*\n", "", self.code, flags=re.MULTILINE))


def recipes(page: Path = PAGE) -> list[Recipe]:
    text = page.read_text(encoding="utf-8")
    found = [Recipe(*match) for match in RECIPE.findall(text)]
    if len(found) != text.count("```glsl"):
        raise ValueError(f"{page}: each block of code stands below its picture, and one paragraph at most between them")
    for recipe in found:
        if f"vec3 {recipe.name}(vec2 uv" not in recipe.code:
            raise ValueError(f"{page}: the code below {recipe.name}.png must define vec3 {recipe.name}(vec2 uv)")
    return found


def functions() -> str:
    """All recipes for the C++ twin."""
    return "\n".join(recipe.cpp for recipe in recipes())


def sheets() -> list[picture.Sheet]:
    calls = {recipe.name: recipe.call() for recipe in recipes()}
    return [picture.Sheet(PAGE.parent / SHEET, list(calls.values()), columns=7),
            *(picture.Sheet(PAGE.parent / f"{name}.png", [call], side=SIDE) for name, call in calls.items())]
