"""Loops of a file of somebody else, which ask before each turn, for tests: their arguments and right results."""

from __future__ import annotations

import functools
import itertools
import struct

from translate.parsing.syntax import Function, Parser
from translate.parsing.tokens import tokens_of
from translate.pick.evaluate import Module

# A condition with a value that the body has, too; one that the body computes last; and one of the number that counts down.
GLSL = """float hn_first(float x, float y) {
  float s = 0.0f;
  int i = 0;
  while (x * x < y && i < 20) { s = s + x * x; x = x + 0.5f; i = i + 1; }
  return s;
}
float hn_until(float x, int n) {
  int i = 0;
  bool more = n > 0;
  while (more) { x = x * 1.5f + 1.0f; i = i + 1; more = i < n && x < 9.0f; }
  return x;
}
int hn_down(int x, int n) {
  int s = 0;
  for (int i = n; i > 0; i--) { s = s * x + i; }
  return s;
}
"""


def first(x: float, y: float) -> float:
    s = 0.0
    while x * x < y:
        s, x = s + x * x, x + 0.5
    return s


def until(x: float, n: int) -> float:
    for _ in range(n):
        x = x * 1.5 + 1
        if x >= 9:
            break
    return x


def down(x: int, n: int) -> int:
    return functools.reduce(lambda s, i: s * x + i, range(n, 0, -1), 0)


# By function: the types of its result and its arguments, and the arguments. Results are floats without a rounding, and
# integers that do not wrap.
POINTS = {first: ("f", "ff", [0.25 * i for i in range(8)], [float(i) for i in range(12)]),
          until: ("f", "fi", [0.5 * i for i in range(-6, 10)], [*range(-1, 5)]),
          down: ("i", "ii", [*range(-8, 8)], [*range(-1, 5)])}


@functools.cache
def module(splits: bool) -> Module:
    return Module(Parser(list(tokens_of(GLSL, "own.glsl", 1))).parse(), {}, splits=splits)


def cases(splits: bool, count: int) -> list[tuple[Function, bytes, bytes]]:
    """The functions with the words of their arguments at so many points, and of the results."""
    found = []
    for function, (of, (result, types, *columns)) in zip(module(splits).tree, POINTS.items()):
        points = [*itertools.islice(itertools.cycle(itertools.product(*columns)), count)]
        found.append((function, b"".join(struct.pack(f"<{types}", *point) for point in points),
                      b"".join(struct.pack(f"<{result}", of(*point)) for point in points)))
    return found
