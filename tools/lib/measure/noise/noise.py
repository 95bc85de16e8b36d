"""Somebody's noise, sampled: GLSL that is rendered at places of our choice by Mesa's software renderer."""

from __future__ import annotations

import hashlib
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from base.renderer import Renderer

COUNT = 512 * 512  # places in one drawing
INCLUDE = re.compile(r'^\s*#include "(.*)"')
# To measure what a value costs, there are more of them in a drawing, elsewhere, whose sum is drawn.
AGAIN = """  for (int judge_turn = 1; judge_turn < {times}; ++judge_turn) {{
    p += 13.7;
    judge_value += {expression};
  }}
"""
# Places are on a grid, or drawn from a box: origin + along * u, moved by `up`. `setup` is the seed, how often was drawn
# before (0: a grid), whether the gradient is written in place of the first coordinates, and how far from the drawn place
# the place is, in any direction.
MAIN = """
uniform vec4 origin;
uniform vec4 along;
uniform vec4 up;
uniform vec4 setup;
out vec4 judge_pixel;
float judge_unit(inout uint state) {{  // a step of PCG with its output function (RXS M XS)
  state = state * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return float(((word >> 22u) ^ word) >> 8u) / 16777216.0;
}}
void main() {{
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 q = origin + float(at.x) * along + float(at.y) * up;
  if (setup.y > 0.0) {{
    uint state = uint(at.x + 512 * at.y) + uint(setup.y) * 262144u;
    judge_unit(state);
    for (int i = 0; i < {n}; ++i) q[i] = origin[i] + along[i] * judge_unit(state);
    q += up;
    vec4 away = vec4(0.0);  // normal numbers have no preferred direction, in any number of dimensions
    for (int i = 0; i < {n} && setup.w > 0.0; ++i) {{
      float radius = sqrt(-2.0 * log(judge_unit(state) + 1e-9));
      away[i] = radius * cos(6.2831853 * judge_unit(state));
    }}
    if (setup.w > 0.0) q += setup.w * normalize(away);
  }}
  {vector} p = q.{axes};
  uint seed = uint(setup.x);
  {vector} slope = {vector}(0.0);
  float judge_value = {expression};
{again}  judge_pixel = vec4(judge_value, setup.z > 0.0 ? {slope} : q.xyz);
}}
"""


@dataclass(frozen=True)
class Subject:
    """A noise: GLSL, and an expression of p and perhaps of seed, which may set `slope` to its derivatives."""
    name: str
    text: str
    expression: str
    dimensions: int
    range: tuple[float, float] | None = None

    @property
    def has_seed(self) -> bool:
        return re.search(r"\bseed\b", self.expression) is not None

    @property
    def has_slope(self) -> bool:
        return re.search(r"\bslope\b", self.expression) is not None

    def shader(self, times: int = 1) -> str:
        n = self.dimensions
        again = AGAIN.format(times=times, expression=self.expression) if times > 1 else ""
        slope = ("vec3(slope, 0.0, 0.0)", "vec3(slope, 0.0)", "slope", "slope.xyz")[n - 1]
        main = MAIN.format(n=n, vector=f"vec{n}" if n > 1 else "float", axes="xyzw"[:n], expression=self.expression,
                           again=again, slope=slope)
        return f"#version 450\n{self.text}\n{main}"


def read(file: Path) -> str:
    """GLSL without #version lines, and with the files that it includes."""
    lines = []
    for line in file.read_text(encoding="utf-8").splitlines():
        if included := INCLUDE.match(line):
            lines.append(read(file.parent / included[1]))
        elif not line.lstrip().startswith("#version"):
            lines.append(line)
    return "\n".join(lines)


def version(path: Path) -> str:
    """The commit of a file in a repository of git, or the name that git would give to its content."""
    printed = subprocess.run(["git", "-C", path.parent, "log", "-1", "--format=%h of %cs", "HEAD"],
                             capture_output=True, text=True, check=False)
    if printed.returncode == 0:
        return printed.stdout.strip()
    content = path.read_bytes()
    return f"blob {hashlib.sha1(b'blob %d%c' % (len(content), 0) + content).hexdigest()[:10]}"


class Sampler:
    """A noise that is compiled. Values and places are float32, as the shader has them."""

    def __init__(self, subject: Subject, renderer: Renderer | None = None, times: int = 1) -> None:
        self.subject = subject
        self.renderer = renderer or Renderer()
        self._program = self.renderer.program(subject.shader(times))

    def draw(self, origin: np.ndarray, along: np.ndarray, up: np.ndarray, turn: int = 0, seed: int = 0,
             gradient: bool = False, away: float = 0.0, rows: int = 512) -> np.ndarray:
        """The pixels of a drawing: value and place, or value and gradient, one after another."""
        def four(vector: np.ndarray) -> tuple[float, ...]:
            return (*map(float, vector), *(0.0,) * (4 - len(vector)))

        pixels = self.renderer.draw(self._program, rows, origin=four(origin), along=four(along), up=four(up),
                                    setup=(float(seed), float(turn), float(gradient), away))
        return np.frombuffer(pixels, np.float32).reshape(-1, 4)

    def grid(self, origin: np.ndarray, along: np.ndarray, up: np.ndarray, rows: int = 512) -> np.ndarray:
        """Rows of 512 values; axis 0 goes up."""
        return self.draw(origin, along, up, rows=rows)[:, 0].reshape(rows, 512)

    def random(self, low: float, high: float, turn: int, moved: np.ndarray | None = None, seed: int = 0,
               away: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
        """Values at random places of a cube, all moved, or away from there in any direction; and the places. The same
        turn has the same places."""
        n = self.subject.dimensions
        moved = np.zeros(n) if moved is None else moved
        pixels = self.draw(np.full(n, low), np.full(n, high - low), moved, turn + 1, seed, away=away)
        return pixels[:, 0], pixels[:, 1:1 + n]

    def slopes(self, low: float, high: float, turn: int) -> np.ndarray:
        """The claimed gradients at the places of random()."""
        n = self.subject.dimensions
        return self.draw(np.full(n, low), np.full(n, high - low), np.zeros(n), turn + 1, gradient=True)[:, 1:1 + n]
