"""Live pictures below the steps of the tutorial: the reader's browser draws each by the code that stands there."""

from __future__ import annotations

import html
import re
from functools import cache

from base.tree import GLSL
from translate.parsing.tokens import Unknown
from translate.pick.command import settings
from translate.pick.evaluate import Module
from translate.pick.program import Program, read
from translate.pick.shading import LANGUAGES

STEP = re.compile(r"^## (\d+)\. (.*)\n(?:(?!^## ).*\n)*?```glsl\n((?:.*\n)*?)```$", re.MULTILINE)
PLAYGROUND = re.compile(r"\*\*Playground\*\*: `(#[^`]+)`")
# The text around color_at in a shader of one's own; a picture uses the site's.
AROUND = re.compile(r"^(?:#|in |out |uniform |void main).*\n", re.MULTILINE)
# Functions of GLSL that the steps use and the library does not: in its words, and by other names.
GLSL_HAS = """
HN_FN hn_float live_smoothstep(hn_float a, hn_float b, hn_float x) {
  hn_float t = min(max((x - a) / (b - a), 0.0f), 1.0f);
  return t * t * (3.0f - 2.0f * t);
}
HN_FN hn_vec3 live_mix(hn_vec3 a, hn_vec3 b, hn_float t) { return a + (b - a) * t; }
"""
LANGUAGE = LANGUAGES["glsl"]
MAIN = """
uniform highp float time;
uniform highp float size;
out highp vec4 color;
void main() { color = vec4(color_at(gl_FragCoord.xy / size * 8.0, time), 1.0); }
"""


def in_words_of_the_library(code: str) -> str:
    text = re.sub(r"\b(float|vec2|vec3)(?= \w)", r"hn_\1", AROUND.sub("", code))
    text = text.replace("hn_vec3 color_at(hn_vec2 p)", "HN_FN hn_vec3 color_at(hn_vec2 p, hn_float time)")
    return re.sub(r"\b(smoothstep|mix)\(", r"live_\1(", text)


@cache
def library(steps: tuple[tuple[str, str], ...]) -> Module:
    """With the functions of these steps below it, each by a name of its own."""
    below = "".join(in_words_of_the_library(code).replace("color_at(", f"color_at_{step}(") for step, code in steps)
    return read(GLSL, settings("fast", "lattice"), below=GLSL_HAS + below)


def shader(steps: tuple[tuple[str, str], ...], step: str) -> str:
    """A fragment shader for WebGL2, of the code of one of the steps. It needs no other file."""
    try:
        function = library(steps).functions[f"color_at_{step}", ("vec2", "float")]
        text = Program(library(steps), [function]).text(LANGUAGE).replace(f"color_at_{step}(", "color_at(")
    except (KeyError, Unknown) as error:
        raise ValueError(f"docs/guide/tutorial.md: step {step} has no picture: {error}") from error
    return re.sub(r"\n{2,}", "\n", f"#version 300 es\n{text}{MAIN}")  # HTML within Markdown ends at an empty line


def figure(steps: tuple[tuple[str, str], ...], step: str, title: str, code: str) -> str:
    moves = " data-moves" if re.search(r"\buniform float time\b", code) else ""
    return (f'\n\n<figure class="live"{moves}>\n<canvas width="384" height="384" role="img" '
            f'aria-label="The picture of step {step}: {html.escape(title)}"></canvas>\n'
            f'<script type="text/plain">{shader(steps, step)}</script>\n</figure>')


def with_pictures(page: str) -> str:
    """The tutorial with a picture below the code of each step, and with links to the playground."""
    steps = tuple((step[1], step[3]) for step in STEP.finditer(page))
    text = STEP.sub(lambda step: step[0] + figure(steps, *step.groups()), page)
    text = PLAYGROUND.sub(lambda link: f'**Playground**: <a href="../../playground.html{html.escape(link[1])}">'
                                       f"{html.escape(link[1])}</a>", text)
    return text + '\n<script src="../../live.js"></script>\n'
