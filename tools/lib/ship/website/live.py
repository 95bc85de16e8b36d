"""Live pictures below the steps of the tutorial: the reader's browser draws each by the code that stands there."""

from __future__ import annotations

import html
import re

from translate.single_file.files import text

STEP = re.compile(r"^## (\d+)\. (.*)\n(?:(?!^## ).*\n)*?```glsl\n((?:.*\n)*?)```$", re.MULTILINE)
PLAYGROUND = re.compile(r"\*\*Playground\*\*: `(#[^`]+)`")
INCLUDE = re.compile(r'^#include "hashnoise/(\w+\.glsl)"\n', re.MULTILINE)
# The text around color_at in a shader of one's own; a picture uses the site's.
AROUND = re.compile(r"^(?:#|in |out |void main).*\n", re.MULTILINE)
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
