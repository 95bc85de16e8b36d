"""The proof by the text is one: no run of a random text, with any rounding, leaves the bounds of a box, and a mistake
that is planted in the engine is noticed here."""

import contextlib
import functools
import itertools
import math
import shutil
import subprocess
import tempfile
import time
import unittest
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path
from unittest import mock

import numpy as np

from base.thorough import THOROUGH, some
from base.twin import compile_program
from proof.bounds import prover, rounded
from proof.bounds.prover import ENGINE, Job, Proven, Prover
from proof.bounds.rounded import EXACT, Body, Rounding, Text

# Statements: they make a number of earlier ones p, q and r, a constant c, and words h and k.
STEPS = (
    "p", "c", "p + q", "p - q", "p * q", "p + c", "c - p", "p * c", "p * p", "-p", "p + q * r", "p * q - r",
    "p + q * (r - p)", "q * (r - p) + (p + c)", "abs(p)", "min(p, q)", "max(p, q)", "max(p, c)", "p - floor(p)",
    "p - floor(p * 3.0f - p - p - p)", "hn_i_select(p * 3.0f < p + p + p, q, r)",  # rounding decides
    "hn_i_select(p < q, p, q)", "hn_i_select(p < c, q, r)", "float(int(p * 2.0f))",
    "hn_i_select((h & 4u) != 0u, p, q)", "hn_i_select(h < 0x60000000u, p, -q)", "hn_i_select(h < 0x60000001u, q, p)",
    "hn_i_select((k >> 28u) == 3u, q, p)", "uintBitsToFloat((h >> 9u) | 0x40000000u) - 3.0f",
    "[&] { const float m = max(p, q); return hn_i_select(p < m, hn_i_select(q < m, c, r), q); }()",
    "uintBitsToFloat(floatBitsToUint(abs(p)) | (k & 0x80000000u))",
    "uintBitsToFloat(floatBitsToUint(p) ^ (h & 0x80000000u))", "float(k >> 20u) * 0.00390625f", "float(h & 0x30u)",
    "float(k)", "float((k & 0xFFu) << 4u)", "sqrt(p * p + q * q)", "p / (q * q + 1.0f)",
    "hn_i_wave(hn_i_angle(p), 0u)", "hn_i_wave((h << 2u) + hn_i_angle(p) + hn_i_angle(q), 0u)")
CONSTANTS = ("0.5f", "1.0f", "3.0f", "0.75f", "-0.25f", "0.000732421875f", "1.999755859375f", "1.99951171875f")
# Texts beside random ones, of steps and their p, q, r and c. Negative numbers count from the end.
TEXTS = (
    # A product that is fused in one sum and rounded in another; two equal sums, which round otherwise.
    (("p * q", 0, 1), ("p - q", -1, 1), ("p - q", -2, 1), ("p - q", -2, -1)),
    (("p * q", 0, 1), ("p + c", -1, 0, 0, 3), ("p + c", -2, 0, 0, 3), ("p - q", -1, -2)),
    (("p * q", 0, 1), ("p + q", -1, -1), ("p * c", -2, 0, 0, 1), ("p - q", -2, -1), ("p - q", -1, -2)),
    # A product that is fused is on no grid of floats.
    (("p * q - r", 0, 1, 0), ("p + c", -1, 0, 0, 3), ("p - q", -1, -2)),
    # Exact sums and products of few bits, and those of one more.
    (("uintBitsToFloat((h >> 9u) | 0x40000000u) - 3.0f", 0), ("p + c", -1, 0, 0, 2), ("p + c", -1, 0, 0, 2)),
    (("c", 0, 0, 0, 6), ("p * c", -1, 0, 0, 7)),
    # A length of a vector with an error along one axis, which is near 0.
    (("p * q", 0, 1), ("p + c", -1, 0, 0, 0), ("p - q", -1, -2), ("c - p", -1, 0, 0, 0), ("p * c", 1, 0, 0, 5),
     *(("p * c", -1, 0, 0, 5),) * 2, ("sqrt(p * p + q * q)", -4, -1)),
    (("hn_i_select(h < 0x60000001u, q, p)", 0, 1), ("hn_i_select(h < 0x60000000u, p, -q)", -1, -1)),
    # 0 up to 3/4, and then x - 3/4; but x is rounded before it decides.
    (("p + c", 0, 0, 0, 2), ("c - p", -1, 0, 0, 2), ("p + c", -1, 0, 0, 1), ("p + c", -1, 0, 0, 0), ("c", 0, 0, 0, 3),
     ("p - q", 0, -1), ("p - q", 0, 0), ("hn_i_select(p < c, q, r)", -4, -2, -1, 3)),
    # One of two numbers less than the larger of both.
    (("max(p, q)", 0, 1), ("hn_i_select(p < q, p, q)", 0, -1)),
    # The smaller one of numbers of two hashes: one of them may be far below 0.
    (("float(k >> 20u) * 0.00390625f", 0), ("hn_i_select((k >> 28u) == 3u, q, p)", -1, 0), ("p - q", 0, -1),
     ("hn_i_select((h & 4u) != 0u, p, q)", 0, 0), ("min(p, q)", -1, -2)),
    # The waves of a place that rounds.
    (("p * q", 0, 1), ("p + c", -1, 0, 0, 1), ("hn_i_wave(hn_i_angle(p), 0u)", -1)),
    (("p * q", 0, 1), ("hn_i_wave((h << 2u) + hn_i_angle(p) + hn_i_angle(q), 0u)", -1, -1)),
    # The third decision rounds.
    (("hn_i_select(p < q, p, q)", 0, 1), ("hn_i_select(p < q, p, q)", 1, 0),
     ("hn_i_select(p * 3.0f < p + p + p, q, r)", 0, 0, 1)),
    # The square of a square and so on is no float.
    (("float(k)", 0), *(("p * p", -1),) * 3),
)
STATEMENTS = 12
# A text is in words: each is the number of a step, and those of p, q, r and c. The last number is the result.
TEXT = Body.of(
    "x:f32 y:f32 h:u32 k:u32 " + " ".join(f"s{i}:u32" for i in range(STATEMENTS)), "v:f64", f"""
    float n[{STATEMENTS + 2}] = {{float_of(a.x), float_of(a.y)}};
    const float constants[] = {{{", ".join(f"float({c})" for c in CONSTANTS)}}};
    const uint h = a.z, k = a.w;
    unsigned i = 2;
    for (const uint& word : {{{", ".join(f"{v}.{axis}" for v in "bcd" for axis in "xyzw")}}}) {{
      const auto plain = [](const auto& x) {{ if constexpr (requires {{ x.value; }}) return x.value; else return x; }};
      const unsigned w = plain(word);
      const float p = n[w >> 6 & 15], q = n[w >> 10 & 15], r = n[w >> 14 & 15], c = constants[w >> 18 & 7];
      switch (w & 63) {{ {" ".join(f"case {i}: n[i] = {step}; break;" for i, step in enumerate(STEPS))} }}
      ++i;
    }}
    return uvec4(bits_of(n[i - 1]), 0u, 0u, 0u);""")
BOXES = ((0.0, 1.0), (0.5, 0.5), (0.25, 2.0**-10), (0.75, 2.0**-20), (1.0 - 2.0**-12, 2.0**-12), (-0.5, 1.0),
         (-2.0, 2.0**-6), (3.0, 2.0**-3), (0.0, 2.0**-30))
WORDS = (0x5FFFFFFF, 0x60000000, 0x3FFFFFFF, 0xFFFFFFFF, 0)
ROUNDINGS = [Rounding("up"), Rounding("down"), Rounding("random", 0, 0.5), Rounding("random", 1, 1.0)]
MEASURES = ("error", "most", "least")
COUNT = 4000 if THOROUGH else 1000


@dataclass(frozen=True)
class Case:
    """A text and a box, with the most that runs are off in there, and their range."""
    words: list[int]
    jobs: list[Job]
    off: float
    least: float
    most: float

    def share(self, error: Proven, most: Proven, least: Proven) -> float:
        """The error as a part of its bound: infinite, if a run leaves the range."""
        if error.bound == math.inf:
            return 0.0
        tiny = 1e-13 * max(1.0, self.most, -self.least)  # the rounding of doubles
        within = -least.bound - tiny <= self.least and self.most <= most.bound + tiny
        return self.off / (error.bound + tiny) if within else math.inf

    def __str__(self) -> str:
        parts = [(i + 2, STEPS[w & 63], w >> 6 & 15, w >> 10 & 15, w >> 14 & 15, CONSTANTS[w >> 18])
                 for i, w in enumerate(self.words) if w & 63]
        return f"{parts} in {self.jobs[0].arguments}"


def coded(statements: Sequence[tuple[str | int, ...]]) -> list[int]:
    """After copies of the two arguments."""
    words: list[int] = []
    copies = [("p", i % 2) for i in range(STATEMENTS - len(statements))]
    for number, (step, *parts) in enumerate([*copies, *statements]):
        at = [part if i == 3 or part >= 0 else number + 2 + part for i, part in enumerate(parts)]
        words.append(sum(part << bits for part, bits in zip((STEPS.index(step), *at), (0, 6, 10, 14, 18))))
    return words


def random_text(rng: np.random.Generator) -> list[int]:
    """Most statements use the numbers that were made last."""
    first = STATEMENTS - rng.integers(1, STATEMENTS + 1)
    return coded([(rng.choice(STEPS), *(max(0, number + 2 - int(back)) for back in rng.geometric(0.3, 3)),
                   int(rng.integers(len(CONSTANTS)))) for number in range(first, STATEMENTS)])


def case_of(words: list[int], text: Text, rng: np.random.Generator, count: int = 64) -> Case:
    """In a random box, at random places."""
    columns = {f"s{i}": word for i, word in enumerate(words)}
    arguments = {name: f"word:{word}" for name, word in columns.items()}
    for axis in "xy":
        low, side = BOXES[rng.integers(len(BOXES))]
        at = low + side * np.where(rng.random(count) < 0.2, rng.choice((0.0, 0.5, 1.0), count), rng.random(count))
        columns[axis] = np.clip(at.astype(np.float32), np.float32(low), np.float32(low + side))
        arguments[axis] = f"box:{low!r}:{low + side!r}"
    for word in "hk":
        columns[word] = np.where(rng.random(count) < 0.2, rng.choice(WORDS, count), rng.integers(0, 2**32, count))
    exact = text("text", EXACT, **columns)[0]
    every = [exact, *(text("text", rounding, **columns)[0] for rounding in ROUNDINGS)]
    return Case(words, [Job("text", ("v",), arguments, most=1, measure=measure) for measure in MEASURES],
                float(np.max([abs(run - exact) for run in every])), float(np.min(every)), float(np.max(every)))


@functools.cache
def cases() -> list[Case]:
    text, rng = Text((), text=TEXT, optimized=True), np.random.default_rng(90)
    random = [random_text(rng) for _ in range(COUNT)]
    return [case_of(words, text, rng) for words in [*random, *map(coded, TEXTS * 20)]]


def shares(engine: Prover) -> list[tuple[float, Case]]:
    found = iter(engine.prove(job for case in cases() for job in case.jobs))
    return [(case.share(*itertools.islice(found, 3)), case) for case in cases()]


# A mistake: its file, a text there, and the wrong one.
MISTAKES = (
    # Roundings.
    ("form.hpp", "u += ulp(size)", "u += ulp(size) / 2"),
    ("form.hpp", "std::ldexp(1.0, f.grid + 24) || f.bits <= 24", "std::ldexp(1.0, f.grid + 25) || f.bits <= 24"),
    ("form.hpp", "|| f.bits <= 24", "|| f.bits <= 25"),
    ("form.hpp", "if (!may_fuse && least > 0)", "if (least > 0)"),
    ("form.hpp", "std::ilogb(least) - 23", "std::ilogb(least) - 22"),
    ("form.hpp", "std::min(a.grid, b.grid);\n  f.bits", "std::max(a.grid, b.grid);\n  f.bits"),
    ("form.hpp", "a.bits + b.bits", "std::max(a.bits, b.bits)"),
    ("form.hpp", "if (!(size <= kLargest))", "if (false)"),
    ("form.hpp", "combined(in_sum(a, of_a), {1, 1}, in_sum(b, of_b), s)", "combined(a, {1, 1}, b, s)"),
    ("node.hpp", "symbols.size() != before", "false"),
    # Rules.
    ("form.hpp", "combined(a, b.range, b, hull(a.range, a.mid))", "combined(a, b.mid, b, a.mid)"),
    ("form.hpp", "hull(x ? *x : Interval{}, y ? *y : Interval{})", "x ? *x : *y"),
    ("form.hpp", "mid), hull(a.error(), b.error())", "mid), a.error()"),
    ("form.hpp", "error = hull(error, a.error());", ""),
    ("form.hpp", "mid = hull(mid, a.mid);", ""),
    ("form.hpp", "hull(at(part.lo), at(part.hi))", "at(part.lo)"),
    ("form.hpp", "+ apart * (dt ? *dt : zero)", ""),
    ("form.hpp", "away * (da ? *da : zero)", "zero"),
    ("form.hpp", "std::max(from + slope.hi * meeting, to + -slope.lo * (width - meeting))", "std::max(from, to)"),
    ("floats.hpp", "sum.terms.back().symbol <= x.terms.back().symbol", "true"),
    ("roots.hpp", "if (x.range.lo >= y.range.hi) return x;", "if (x.mid.lo >= y.mid.hi) return x;"),
    ("roots.hpp", "return made(-larger(-a, -b), 'n', a, b);\n  }", "return a;\n  }"),  # an undecided minimum
    ("roots.hpp", "-(hull(quotient, f.mid) * by)", "point(0)"),
    ("roots.hpp", "error += w * raised(off),", "error = w * raised(off),"),
    ("roots.hpp", "some[i].range.lo < 0 ? INFINITY : range.hi", "range.hi"),
    ("floats.hpp", "taken(2, less) ? hi : lo", "taken(2) ? hi : lo"),
    ("floats.hpp", "!less.rounds() && decided >= kMostDecisions", "decided >= kMostDecisions"),
    ("floats.hpp", "is_wrong ? 0 : taken(2, less)", "is_wrong ? 0 : taken(2)"),
    ("floats.hpp", "known != same.end() && known->second != 0", "true"),
    ("floats.hpp", "&& x.fused < 0 ?", "?"),
    ("prove.cpp", "largest + apart(outcomes)", "largest"),
    ("seams.hpp", "range = f.mid - point(l) * (c.mid + c.error())", "range = f.mid - point(l) * c.mid"),
    ("seams.hpp", "off = off + factor", "off = factor"),
    ("seams.hpp", "if (term.second != 0)", "if (term.second > 0)"),
    # Words.
    ("integers.hpp", "if (lo < t && hi >= t)", "if (lo < t && hi > t)"),
    ("integers.hpp", "m.v.push_back((hi < t) != flip);", "m.v.push_back((hi <= t) != flip);"),
    ("integers.hpp", "b.bits[i].value >> 31 ? negative(f) : f", "f"),
    ("integers.hpp", "choose(f, 0x1p31);", "choose(f, 0x1p30);"),
    ("integers.hpp", "const double lo = std::max(x.lo, x.value), hi = std::min(x.hi, x.value | ~x.known)",
     "const double lo = std::max(x.lo, x.value), hi = lo"),
    ("integers.hpp", "const int n = c.v[i] ? x : y;", "const int n = c.v[i] ? y : x;"),
    ("integers.hpp", "off = turns.error().size() * turn + 1", "off = 1"),
    ("integers.hpp", "std::ldexp(a.off, static_cast<int>(b.value)) : a.off + b.off", "a.off : a.off + b.off"),
    ("integers.hpp", ": a.off + b.off;", ": a.off;"),
    ("text.hpp", "std::exchange(angle.off, 0) * kUnit", "std::exchange(angle.off, 0) * 0"),
    ("text.hpp", "double error = error_of_sines() + std", "double error = std"),
    ("integers.hpp", "std::ilogb(one) - 23", "std::ilogb(one) - 22"),
)
# A noise on a line whose cells are a third of x: rounding decides which cell a place is in. Its points reach as far as
# the next ones if the square of the radius is 1.
SEAM = """
    float u = float_of(a.y) * 3.0f, x = u - floor(u);
    const auto share = [](uint h, float x) {{
      const float t = max({radius}f - x * x, 0.0f);
      return (uintBitsToFloat((hn_i_scramble(h) & 0x007FC000u) | 0x40000000u) - 3.0f) * (t * t * t);
    }};
    const uint i = a.x + uint(int(floor(u)));
    return uvec4(bits_of(share(i, x) + share(i + {step}u, x - 1.0f)), 0u, 0u, 0u);"""
SEAMS = ((1.0, 1, 0.0, 2e-6), (1.25, 1, 0.03, 1.0), (1.0, 2, 1.9, 4.0))  # with bounds of their error
# A direction, near the vector 0; and a number by another that one of two hashes chooses.
OTHERS = {"direction": Body.of("x:f32 y:f32", "v:f64", """
    float x = float_of(a.x) * 3.0f - 1.0f, y = float_of(a.y) * 3.0f - 1.0f;
    return uvec4(bits_of(x / sqrt(max(x * x + y * y, HN_I_TINY_SQUARE))), 0u, 0u, 0u);"""), "chosen": Body.of("x:f32 h:u32 k:u32", "v:f64", """
    float h = float(a.y >> 20u), k = float(a.z >> 20u);
    float n = hn_i_select(h < k, 2.0f, hn_i_select(k < h, 5.0f, 7.0f));
    return uvec4(bits_of(float(int(n)) * float_of(a.x)), 0u, 0u, 0u);""")}
BODIES = {"text": TEXT} | OTHERS | {f"seam{i}": Body.of("c:u32 x:f32", "v:f64", SEAM.format(radius=radius, step=step))
                           for i, (radius, step, *_) in enumerate(SEAMS)}
INTERVALS = """
#include <cstdio>
#include <random>
#include "interval.hpp"
int main() {
  using namespace hn::prover;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  const Proving rounding_up;
  for (int i = 0; i < 10000; ++i) {
    Interval a = point(number(random)), b = point(number(random));
    if (i % 2) a.hi += 0x1p-10, b.lo -= 0x1p-10;
    const auto has = [](Interval x, __float128 exact) {
      if (!(x.lo <= exact && exact <= x.hi)) std::puts("left");
    };
    for (const double x : {a.lo, a.hi, middle(a)}) {
      for (const double y : {b.lo, b.hi, middle(b)}) {
        has(a + b, __float128(x) + y), has(a - b, __float128(x) - y), has(a * b, __float128(x) * y);
        has(hull(a, b), x), has(Interval{middle(a) - reach(a, middle(a)), middle(a) + reach(a, middle(a))}, x);
      }
    }
  }
}
"""
WRONG_INTERVALS = (
    ("std::fesetround(FE_UPWARD)", "std::fesetround(FE_TONEAREST)"),
    ("{-(-a.lo - b.lo), a.hi + b.hi}", "{a.lo + b.lo, a.hi + b.hi}"),
    ("return {-lo, hi};", "return {lo, hi};"),
    ("std::max(a.hi - from, from - a.lo)", "a.hi - from"),
    ("{std::min(a.lo, b.lo), std::max(a.hi, b.hi)}", "{a.lo, std::max(a.hi, b.hi)}"),
)


@contextlib.contextmanager
def mistaken(file: str, old: str, new: str) -> Iterator[None]:
    """The engine has a mistake."""
    with tempfile.TemporaryDirectory() as folder:
        engine = Path(shutil.copytree(ENGINE, Path(folder, "engine")))
        text = (engine / file).read_text(encoding="utf-8")
        (engine / file).write_text(text.replace(old, new), encoding="utf-8")
        with mock.patch.object(prover, "ENGINE", engine), mock.patch.object(rounded, "FOLDER", Path(folder)):
            yield


def output_of_intervals(old: str = "", new: str = "") -> str:
    with tempfile.TemporaryDirectory() as folder:
        header = (ENGINE / "interval.hpp").read_text(encoding="utf-8")
        Path(folder, "interval.hpp").write_text(header.replace(old, new) if old else header, encoding="utf-8")
        Path(folder, "intervals.cpp").write_text(INTERVALS, encoding="utf-8")
        compile_program("intervals", Path(folder, "intervals.cpp"), Path(folder, "intervals"), "-frounding-math")
        return subprocess.run([f"{folder}/intervals"], capture_output=True, text=True, check=True).stdout


def is_noticed(engine: Prover) -> bool:
    try:
        return any(not share <= 1 for share, _ in shares(engine))
    except subprocess.CalledProcessError:  # it stops
        return True


class Programs(unittest.TestCase):
    def test_each_is_made_once(self) -> None:
        """Others that want it at the same time wait for it."""
        runs = []

        def make(folder: Path) -> None:
            runs.append(folder)
            time.sleep(0.1)
            (folder / "new").touch()

        with tempfile.TemporaryDirectory() as folder, mock.patch.object(rounded, "FOLDER", Path(folder)), \
                ThreadPoolExecutor() as pool:
            paths = list(pool.map(lambda text: rounded.made("program", [text], [], make), ("a", "a", "b")))
        self.assertEqual((len(runs), len({*paths})), (2, 2))


class Engine(unittest.TestCase):
    def test_random_texts(self) -> None:
        """Runs stay within the bounds, and come near them."""
        found = shares(Prover(BODIES))
        self.assertEqual([], [f"{share} {case}" for share, case in found if not share <= 1])
        self.assertGreater(np.mean([share > 0.5 for share, _ in found]), 0.15)

    def test_seams(self) -> None:
        """Cells meet if both have the same points there, and else their errors are the difference."""
        jobs = [Job(f"seam{i}", ("v",), {}, most=2000) for i in range(len(SEAMS))]
        for (radius, step, least, most), found in zip(SEAMS, Prover(BODIES).prove(jobs)):
            with self.subTest(radius=radius, step=step):
                self.assertLess(least, found.bound)
                self.assertLess(found.bound, most)

    def test_directions(self) -> None:
        """The error times the length is bounded, also where the length may be 0."""
        at, rng = np.float32(1 / 3) + np.arange(-200, 200) * np.float32(2.0**-24), np.random.default_rng(5)
        x, y = (rng.choice(at, 5000).astype(float) for _ in range(2))
        text, box = Text((), direction=OTHERS["direction"]), f"box:{at.min()!r}:{at.max()!r}".replace("np.float32", "")
        exact = text("direction", EXACT, x=x, y=y)[0]
        seen = max((abs(text("direction", rounding, x=x, y=y)[0] - exact) * np.hypot(3 * x - 1, 3 * y - 1)).max()
                   for rounding in ROUNDINGS)
        job = Job("direction", ("v",), {"x": box, "y": box}, most=1, measure="error_by_length")
        bound = Prover(BODIES).prove([job])[0].bound
        self.assertTrue(0.3 * bound < seen < bound, (seen, bound))
        for mistake in (("roots.hpp", "std::sqrt(2) * e + steps", "steps"), ("roots.hpp", "e += off * off", "e += 0"))[:2 * THOROUGH]:
            with self.subTest(mistake), mistaken(*mistake):
                self.assertLess(Prover(OTHERS).prove([job])[0].bound, seen)

    def test_choices(self) -> None:
        """Each number that conditions may choose is a path."""
        jobs = [Job("chosen", ("v",), {"x": "float:1.5"}, given=1, measure=measure) for measure in ("least", "most", "error")]
        found = [proven.bound for proven in Prover(BODIES).prove(jobs)]
        self.assertEqual([-3.0, 10.5, 0.0], found)
        wrong, = Prover(BODIES).prove([replace(jobs[2], given=0)])  # rounding decides, for all it knows
        self.assertEqual(math.inf, wrong.bound)

    def test_mistakes(self) -> None:
        """The same texts notice a mistake that is planted."""
        for file, old, _ in MISTAKES:
            self.assertEqual(1, (ENGINE / file).read_text(encoding="utf-8").count(old), f"{file}: {old}")
        for mistake in some(MISTAKES, 0):
            with self.subTest(mistake), mistaken(*mistake):
                self.assertTrue(is_noticed(Prover({"text": TEXT})))

    def test_intervals(self) -> None:
        self.assertEqual("", output_of_intervals())
        for old, new in some(WRONG_INTERVALS, 0):
            with self.subTest(old):
                self.assertIn("left", output_of_intervals(old, new))
