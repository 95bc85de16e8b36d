"""Somebody's noise, sampled: GLSL that is rendered at places of our choice by Mesa's software renderer."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from base.renderer import Renderer
from measure.likeness import source

COUNT = 512 * 512  # places in one drawing
# To measure what a value costs, there are more of them in a drawing, elsewhere, whose sum is drawn.
AGAIN = """  for (int judge_turn = 1; judge_turn < {times}; ++judge_turn) {{
    p += 13.7;
    judge_value += {expression};
  }}
"""
# Places are on a grid, or drawn from a box: origin + along * u, moved by `up`. `setup` is the seed, how often was drawn
# before (0: a grid), and whether the gradient is written in place of the first coordinates.
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
    for (int i = 0; i < 3; ++i) q[i] = origin[i] + along[i] * judge_unit(state);
    q.xyz += up.xyz;
  }}
  vec{n} p = q.{axes};
  uint seed = uint(setup.x);
  vec{n} slope = vec{n}(0.0);
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
        slope = "vec3(slope, 0.0)" if n == 2 else "slope"
        main = MAIN.format(n=n, axes="xyz"[:n], expression=self.expression, again=again, slope=slope)
        return f"#version 450\n{self.text}\n{main}"


def read(file: Path) -> str:
    return source(file)


class Sampler:
    """A noise that is compiled. Values and places are float32, as the shader has them."""

    def __init__(self, subject: Subject, renderer: Renderer | None = None, times: int = 1) -> None:
        self.subject = subject
        self.renderer = renderer or Renderer()
        self._program = self.renderer.program(subject.shader(times))

    def draw(self, origin: np.ndarray, along: np.ndarray, up: np.ndarray, turn: int = 0, seed: int = 0,
             gradient: bool = False) -> np.ndarray:
        """The pixels of a drawing: value and place, or value and gradient, one after another."""
        def four(vector: np.ndarray) -> tuple[float, ...]:
            return (*map(float, vector), *(0.0,) * (4 - len(vector)))

        pixels = self.renderer.draw(self._program, origin=four(origin), along=four(along), up=four(up),
                                     setup=(float(seed), float(turn), float(gradient), 0.0))
        return np.frombuffer(pixels, np.float32).reshape(COUNT, 4)

    def grid(self, origin: np.ndarray, along: np.ndarray, up: np.ndarray, seed: int = 0) -> np.ndarray:
        """A square of values; axis 0 goes up."""
        return self.draw(origin, along, up, seed=seed)[:, 0].reshape(512, 512)

    def random(self, low: float, high: float, turn: int, moved: np.ndarray | None = None, seed: int = 0
               ) -> tuple[np.ndarray, np.ndarray]:
        """Values at random places of a cube, and the places. The same turn has the same places."""
        n = self.subject.dimensions
        moved = np.zeros(n) if moved is None else moved
        pixels = self.draw(np.full(n, low), np.full(n, high - low), moved, turn + 1, seed)
        return pixels[:, 0], pixels[:, 1:1 + n]

    def slopes(self, low: float, high: float, turn: int) -> np.ndarray:
        """The claimed gradients at the places of random()."""
        n = self.subject.dimensions
        return self.draw(np.full(n, low), np.full(n, high - low), np.zeros(n), turn + 1, gradient=True)[:, 1:1 + n]
