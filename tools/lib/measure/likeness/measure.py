"""Measures what a noise looks like: its mean, its deviation, and the size of its features."""

from __future__ import annotations

import math
from array import array
from collections.abc import Callable
from operator import mul
from typing import NamedTuple

from base.renderer import Renderer

# Places lie in a cube of this size, in cells: many features, and less than the 289 after which webgl-noise repeats.
CELLS = 250
# In which the size is looked for, in cells. It is doubled until the correlation is less than 1/2.
FIRST = 0.8
ROUNDS = 3  # of dividing by four: the size is then known to 1/64 of 0.4, and within that by a straight line

PLACES = """
uniform vec4 likeness_lags;  // three distances, and how many values are wanted: four
out vec4 likeness_values;

float likeness_random(inout uint state) {  // O'Neill's PCG
  state = state * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (float((word >> 22) ^ word) + 0.5) / 4294967296.0;
}

void main() {
  uint state = uint(gl_FragCoord.y) * 65536u + uint(gl_FragCoord.x);
  likeness_random(state);
  VECTOR p, direction;
  for (int i = 0; i < AXES; ++i) {
    p[i] = CELLS * likeness_random(state);
    // Normal numbers have no preferred direction, in any number of dimensions.
    float radius = sqrt(-2.0 * log(likeness_random(state)));
    direction[i] = radius * cos(6.2831853 * likeness_random(state));
  }
  direction = normalize(direction);
  // A loop that no compiler unrolls, since four copies of a noise take four times as long to compile.
  for (int i = 0; i < int(likeness_lags.w); ++i) {
    float lag = i == 0 ? 0.0 : likeness_lags[i - 1];
    likeness_values[i] = likeness_subject(p + lag * direction);
  }
}
"""


class Look(NamedTuple):
    mean: float
    deviation: float
    size: float  # the distance, in cells, at which the correlation of two values has fallen to 1/2


def vector(axes: int) -> str:
    return f"vec{axes}" if axes > 1 else "float"


def subject(source: str, expression: str, axes: int) -> str:
    """The beginning of a shader: the function likeness_subject, which evaluates an expression of p, or a body with a
    return in it."""
    body = expression if "return" in expression else f"return {expression};"
    return f"#version 450\n{source}\nfloat likeness_subject({vector(axes)} p) {{ {body} }}\n"


def at_places(source: str, expression: str, axes: int) -> str:
    """A shader that evaluates an expression of p in the source, which is GLSL without a #version line."""
    places = PLACES.replace("VECTOR", vector(axes)).replace("AXES", str(axes)).replace("CELLS", f"{CELLS}.0")
    return subject(source, expression, axes) + places


def look(renderer: Renderer, source: str, expression: str, axes: int) -> Look:
    program = renderer.program(at_places(source, expression, axes))
    first: list[tuple[float, float]] = []

    def correlations(*lags: float) -> list[float]:
        pixels = renderer.draw(program, likeness_lags=(*lags, 4.0))
        here, *there = (pixels[i::4] for i in range(4))
        mean, deviation = moments(here)
        if not first:
            first.append((mean, deviation))
        found = []
        for values in there:
            other_mean, other_deviation = moments(values)
            product = sum(map(mul, here, values)) / len(here)
            found.append((product - mean * other_mean) / (deviation * other_deviation))
        return found

    size = half(correlations)
    return Look(*first[0], size)


def moments(values: array[float]) -> tuple[float, float]:
    mean = sum(values) / len(values)
    return mean, math.sqrt(max(sum(map(mul, values, values)) / len(values) - mean * mean, 1e-30))


def half(correlations: Callable[..., list[float]]) -> float:
    """Where the correlation is 1/2, of a function that has it at three distances."""
    low, high, at_low, at_high = 0.0, FIRST, 1.0, correlations(FIRST, FIRST, FIRST)[0]
    while not at_high <= 0.5:
        if not high <= 1000.0 or math.isnan(at_high):
            raise ValueError("it does not vary, or is no number somewhere")
        low, high, at_low = high, 2.0 * high, at_high
        at_high = correlations(high, high, high)[0]
    for _ in range(ROUNDS):
        lags = [low + (high - low) * i / 4.0 for i in range(5)]
        values = [at_low, *correlations(*lags[1:4]), at_high]
        end = next(i for i in range(1, 5) if values[i] <= 0.5)
        low, high, at_low, at_high = lags[end - 1], lags[end], values[end - 1], values[end]
    return low + (high - low) * (at_low - 0.5) / (at_low - at_high)
