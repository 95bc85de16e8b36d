"""Hashes of shaders that are not ours, judged as lattices of words: rendered from their GLSL by Mesa's llvmpipe.

A hash is an expression of `c`, the cell as integers, or of `p`, the same as floats. A uint counts as a word. Of a
float, which should be in [0, 1), the ten highest bits count, since shaders use a float as a direction or a colour. The
next one, bit 21, is a sign of our gradients and would be judged like the highest bit, but Hoskins' hash has a
correlation of 0.18 in it, and of 0.02 in each of the ten. So the parity of the ten stands there, which is equal where
they are. All other bits are random.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from base.renderer import NotCompiled, Renderer
from measure import record, stamps
from measure.hashes import gate
from measure.hashes.judgement import Finding
from measure.hashes.library import Twin
from measure.hashes.report import HashResult, describe
from measure.likeness import source

SIDE = 1024  # of what is rendered at once
PARITY = 1 << 21  # below the ten bits
# Words of floats have 31 bits and the parity: twice as many are equal, and ten bits choose one of twelve gradients
# unevenly.
OF_WORDS = {"equal words", "directions: frequencies"}
# Around the origin; as far as scenes go; where a float has an eighth of a cell left; and far out.
ORIGINS = {2: ((-512, -512), (10000, 20000), (1000000, -2000000), (8000000, 7000000)),
           3: ((-64, -64, -64), (10000, 20000, 5000), (1000000, -2000000, 500000), (8000000, 7000000, 6000000))}
RECORD = ("hash", "dimensions", "origin", "failed", "of", "worst", "statistic", "allowed", "p")

# The pixel's cell: along x its column; the rows count the other axes.
FRAGMENT = """
uniform vec4 origin;
uniform vec4 side;
out vec4 halves;
void main() {{
  int row = int(gl_FragCoord.y) + int(side.y);
  ivec{n} c = ivec3(int(origin.x) + int(gl_FragCoord.x) % int(side.x), int(origin.y) + {row},
                    int(origin.z) + {slice}){part};
  vec{n} p = vec{n}(c);
  {kind} value = {expression};
  uint word = {word};
  halves = vec4(float(word >> 16u), float(word & 65535u), 0.0, 0.0);
}}
"""
KINDS = {"uint": "value", "float": "uint(clamp(value, 0.0, 0.99999994) * 1024.0) << 22u"}


class BadExpression(ValueError):
    pass


@dataclass(frozen=True)
class Other:
    """A hash of somebody else's: NAME=FILE:EXPRESSION, or NAME/2=... if it is for the plane alone."""
    name: str
    file: Path
    expression: str
    dimensions: tuple[int, ...] = (2, 3)

    @staticmethod
    def parse(text: str) -> Other:
        head, equals, rest = text.partition("=")
        name, slash, only = head.partition("/")
        file, colon, expression = rest.partition(":")
        if not (name and equals and file and colon and expression.strip()) or (slash and only not in ("2", "3")):
            raise argparse.ArgumentTypeError(f"{text} is not NAME=FILE:EXPRESSION, as in sine=random.glsl:random(p)")
        if not Path(file).is_file():
            raise argparse.ArgumentTypeError(f"there is no file {file}")
        return Other(name, Path(file), expression, (int(only),) if slash else (2, 3))


def shader(text: str, expression: str, n: int, kind: str) -> str:
    slices = n == 3
    return "#version 450\n" + text + FRAGMENT.format(
        n=n, part="" if slices else ".xy", kind=kind, expression=expression, word=KINDS[kind],
        row="row % int(side.x)" if slices else "row",
        slice="row / int(side.x) * (1024 / int(side.x)) + int(gl_FragCoord.x) / int(side.x)" if slices else "0")


def compiled(renderer: Renderer, other: Other, n: int) -> tuple[int, str]:
    """The program, and whether the expression is a uint or a float."""
    text, logs = source(other.file), []
    for kind in KINDS:
        try:
            return renderer.program(shader(text, other.expression, n, kind)), kind
        except NotCompiled as error:
            logs.append(str(error).strip())
    raise BadExpression(f"{other.name} in {n}D: {other.file} with {other.expression} is neither a uint nor a float of "
                        f"c and p: {logs[-1]}")


def parity(words: np.ndarray) -> np.ndarray:
    """Whether an odd number of the bits is set, as 0 or 1."""
    for shift in (16, 8, 4, 2, 1):
        words = words ^ words >> np.uint32(shift)
    return words & np.uint32(1)


def words_of(renderer: Renderer, program: int, kind: str, origin: tuple[int, ...]) -> np.ndarray:
    """The words of the window at that origin, as the gate takes it: axis 0 is x."""
    n = len(origin)
    side = gate.SIDES[n]
    rows = side ** n // SIDE
    found = []
    for first in range(0, rows, SIDE):
        pixels = np.array(renderer.draw(program, origin=(*map(float, origin), *(0.0,) * (4 - n)),
                                        side=(float(side), float(first), 0.0, 0.0)), np.float32)
        halves = pixels.reshape(SIDE, SIDE, 4)[..., :2].astype(np.uint32)
        found.append(halves[..., 0] << np.uint32(16) | halves[..., 1])
    words = np.concatenate(found)
    if n == 3:  # rows of a slice, and slices side by side
        beside = SIDE // side
        words = words.reshape(side // beside, side, beside, side).transpose(0, 2, 1, 3).reshape(side, side, side)
    if kind == "float":
        random = np.random.default_rng(0).integers(0, 1 << 32, words.shape, np.uint32) & np.uint32(PARITY - 1)
        words = words | parity(words) * np.uint32(PARITY) | random
    return np.ascontiguousarray(words.transpose())


@dataclass(frozen=True)
class Judged:
    """The measures of the window of a hash at an origin."""
    origin: tuple[int, ...]
    result: HashResult

    @property
    def place(self) -> str:
        return ", ".join(map(str, self.origin))


def findings_of(words: np.ndarray, kind: str, twin: Twin) -> list[Finding]:
    return [finding for finding in gate.judge_words(words, twin) if kind == "uint" or finding.test not in OF_WORDS]


def judge(other: Other, dimensions: Sequence[int], twin: Twin, renderer: Renderer) -> list[Judged]:
    """Every window."""
    found = []
    for n in dimensions:
        if n in other.dimensions:
            program, kind = compiled(renderer, other, n)
            found += [Judged(origin, HashResult(other.name, n, findings_of(
                words_of(renderer, program, kind, origin), kind, twin), None)) for origin in ORIGINS[n]]
    return found


def lines(found: Sequence[Judged]) -> list[str]:
    """For the terminal."""
    printed = []
    for judged in found:
        result = judged.result
        wrong = sorted((f for f in result.worst.values() if not f.passed), key=lambda f: f.p)
        head = f"{result.name} {result.dimensions}D at {judged.place}: "
        printed.append(head + (f"fails {len(wrong)} of {len(result.worst)} tests, such as {describe(wrong[0])}" if wrong
                            else f"passes {len(result.worst)} tests"))
    return printed


def write(found: Sequence[Judged], path: Path, by: str) -> None:
    rows = []
    for judged in found:
        result = judged.result
        findings = result.worst.values()
        worst = min(findings, key=lambda f: f.p)
        rows.append(dict(zip(RECORD, (
            result.name, result.dimensions, judged.place, sum(not f.passed for f in findings), len(findings), worst.test,
            f"{worst.statistic:.4g}", f"{worst.threshold:.4g}", f"{worst.p:.3g}"))))
    record.write(path, rows, RECORD)
    stamps.stamp(path, by)
