"""The pictures of the tutorial's steps: a sheet of them on the page, and on the site live ones below the steps, which the
reader's browser draws by the code that stands there."""

from __future__ import annotations

import html
import re
from collections.abc import Iterable

from base.tree import ROOT
from ship.pages import picture
from translate.single_file.files import text

PAGE = ROOT / "docs" / "guide" / "tutorial.md"
STEP = re.compile(r"^## (\d+)\. (.*)\n(?:(?!^## ).*\n)*?```glsl\n((?:.*\n)*?)```$", re.MULTILINE)
PLAYGROUND = re.compile(r"\*\*Playground\*\*: `(#[^`]+)`")
INCLUDE = re.compile(r'^#include "hashnoise/(\w+\.glsl)"\n', re.MULTILINE)
# The text around color_at in a shader of one's own; a picture uses the site's.
AROUND = re.compile(r"^(?:#|in |out |void main).*\n", re.MULTILINE)
SIDE = 120  # pixels of a tile: a file of less than 200 kB
MAIN = """uniform float size;
out vec4 color;
void main() { color = vec4(color_at(gl_FragCoord.xy / size * 8.0), 1.0); }
"""


def compact(code: str) -> str:
    """HTML within Markdown ends at an empty line."""
    return re.sub(r"\n{2,}", "\n", code)


def library(page: str) -> str:
    """The beginning of the shaders of all steps: whatever some of them include."""
    files = dict.fromkeys(INCLUDE.findall("".join(step[3] for step in STEP.finditer(page))))
    return compact(f"#version 300 es\nprecision highp float;\nprecision highp int;\n{text(list(files), minify=True)}")


def shader(code: str) -> str:
    """The rest of the shader of a step."""
    return compact(AROUND.sub("", code) + MAIN)


def in_cpp(page: str) -> dict[str, str]:
    """The steps for the C++ twin, which has the whole library, by the calls of their functions."""
    return {f"step_{number}(uv * 8.0)": picture.in_cpp(re.sub("uniform float time;.*", "const float time = 0.0;", AROUND.sub(
        "", code)).replace("color_at", f"step_{number}")) for number, _, code in STEP.findall(page)}


def sheet(steps: Iterable[str]) -> picture.Sheet:
    return picture.Sheet(picture.path_of("tutorial.png"), list(steps), columns=4, side=SIDE)


def figure(step: re.Match) -> str:
    number, title, code = step.groups()
    moves = " data-moves" if re.search(r"\buniform float time\b", code) else ""
    return (f'{step[0]}\n\n<figure class="live"{moves}>\n<canvas width="384" height="384" role="img" '
            f'aria-label="The picture of step {number}: {html.escape(title)}"></canvas>\n'
            f'<script type="text/plain">{shader(code)}</script>\n</figure>')


def with_pictures(page: str) -> str:
    """The tutorial with a picture below the code of each step, and with links to the playground."""
    shown = PLAYGROUND.sub(lambda link: f'**Playground**: <a href="../../playground.html{html.escape(link[1])}">'
                                        f"{html.escape(link[1])}</a>", STEP.sub(figure, page))
    return (f'{shown}\n<script type="text/plain" id="library">{library(page)}</script>\n'
            '<script src="../../live.js"></script>\n')
