"""The page: docs/measured/quality.md, from what was measured."""

from __future__ import annotations

import re
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from math import log2
from pathlib import Path

from measure.hashes import controls, fields, gate, isotropy, octaves, stripes, texts
from measure.hashes.judgement import ALPHA, Finding
from measure.hashes.library import Twin
from measure.hashes.noise import Measured


@dataclass
class HashResult:
    """The measures of a hash in the plane or in space."""
    name: str
    dimensions: int
    findings: list[Finding]
    noise: Measured | None

    @property
    def passed(self) -> bool:
        return all(finding.passed for finding in self.findings)

    @property
    def worst(self) -> dict[str, Finding]:
        """By test, the most improbable finding over origins and seeds."""
        worst: dict[str, Finding] = {}
        for finding in self.findings:
            if finding.test not in worst or finding.p < worst[finding.test].p:
                worst[finding.test] = finding
        return worst


@dataclass
class Sine:
    """The paper's gradient with a hash: measured, not judged."""
    name: str
    dimensions: int
    findings: list[Finding]
    noise: Measured


@dataclass
class Preference:
    """The directions in noise, by the blocks of a window of gradients."""
    gradients: str
    dimensions: int
    values: list[float]


def number(value: float) -> str:
    return f"{value:.4g}"


def bounds(finding: Finding) -> str:
    high = number(finding.threshold)
    return high if finding.lower is None else f"{number(finding.lower)} to {high}"


def verdict(result: HashResult) -> str:
    """Lines for the terminal: each test that fails, or the one that came nearest."""
    head = f"{result.name} {result.dimensions}D: "
    wrong = [f for f in result.worst.values() if not f.passed]
    if not wrong:
        near = min(result.findings, key=lambda f: f.p)
        return f"{head}passes {len(result.findings)} tests; the nearest is {describe(near)}"
    return "\n".join(f"{head}FAILS {describe(f)}" for f in wrong)


def describe(f: Finding) -> str:
    return f"{f.test}: {number(f.statistic)} (allowed {bounds(f)}, p = {f.p:.2g}; {f.where})"


def cell(finding: Finding | None) -> str:
    if finding is None:
        return ""
    return number(finding.statistic) if finding.passed else f"**{number(finding.statistic)}** (p = {finding.p:.1g})"


def table(head: list[str], rows: list[list[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines) + "\n"


def hash_table(results: list[HashResult]) -> str:
    """Tests down, hashes across."""
    worst = [result.worst for result in results]
    rows = []
    for test, first in worst[0].items():
        values = [cell(w.get(test)) for w in worst]
        rows.append([test, str(first.samples), str(first.comparisons), number(first.floor), bounds(first), *values])
    head = ["test", "values", "comparisons", "floor", "allowed", *(f"`{r.name}`" for r in results)]
    return table(head, rows)


CONTROLS = {**controls.WINDOWS, **controls.FUNCTIONS, **controls.GRADIENTS, **controls.COMPONENTS,
            **controls.VECTORS}


def rejected_as_meant(results: list[HashResult]) -> bool:
    """Whether every test rejects the controls that are meant for it, and all accept what is random."""
    meant = {name: tests for name, (_, tests) in CONTROLS.items() if tests}
    return all(result.passed if result.name not in meant
               else not any(result.worst[test].passed for test in meant[result.name]) for result in results)


def sentence(text: str | None) -> str:
    return " ".join((text or "").split()).rstrip(".")


def control_table(results: list[HashResult]) -> str:
    rows = []
    for result in results:
        make, tests = CONTROLS.get(result.name, (controls.random, ()))
        worst = result.worst
        by = "; ".join(f"{t}: {number(worst[t].statistic)} ({'**passes**, ' * worst[t].passed}allowed {bounds(worst[t])})"
                       for t in tests) or "none"
        others = sum(not f.passed for t, f in worst.items() if t not in tests)
        rows.append([f"`{result.name}`", sentence(make.__doc__), by, str(others)])
    return table(["lattice", "what it is", "rejected by", "and by so many other tests"], rows)


def noise_table(results: list, label) -> str:
    names = list(results[0].noise.numbers)
    rows = [[label(r), *(with_error(*r.noise.numbers[name]) for name in names)] for r in results]
    return table(["hash", *names], rows)


def with_error(value: float, error: float) -> str:
    return f"{value:.4f}" if error == 0 else f"{value:.4f} ± {error:.4f}"


def preference_table(preferences: list[Preference]) -> str:
    """Shapes down, dimensions across."""
    rows: dict[str, list[str]] = {}
    for p in preferences:
        error = isotropy.SPREAD[p.dimensions] / len(p.values) ** 0.5
        rows.setdefault(sentence(p.gradients), []).append(with_error(sum(p.values) / len(p.values), error))
    return table(["gradients", *(f"{n}D" for n in sorted({p.dimensions for p in preferences}))],
                 [[name, *values] for name, values in rows.items()])


def look_table(looks: list[fields.Look]) -> str:
    """Noises down; the harmonics of structures and of the spectrum, and slices, across."""
    def cells(values: dict[int, list[float]]) -> str:
        return ", ".join(with_error(*fields.mean_and_error(v)) for v in values.values())

    rows = [[judged(look.noise.title, not look.problems), cells(look.structures),
             cells(look.spectrum), with_error(*fields.mean_and_error(look.slices)) if look.slices else ""]
            for look in looks]
    return table(["noise", "structures", "spectrum", "slices"], rows)


def judged(text: str, passed: bool) -> str:
    return text if passed else f"**{text}**"


def stripes_table(found: Sequence[stripes.Stripes]) -> str:
    """Waves down; what is not as it should be is bold."""
    def cells(each: stripes.Stripes) -> dict[str, str]:
        widths = ", ".join(with_error(*fields.mean_and_error(width)) for width in (each.along, each.across))
        return {"centre": number(each.away), "width": f"{widths} of {each.own:.4f}",
                "round": ", ".join(with_error(*fields.mean_and_error(v)) for v in each.harmonics.values()),
                "even": number(each.even), "steady": number(each.steady),
                "seeds": f"{number(each.seeds.statistic)} of {number(each.seeds.threshold)}"}

    rows = [[f"{each.dimensions}D, ({', '.join(f'{k:g}' for k in each.wave)})",
             *(judged(text, name not in each.problems) for name, text in cells(each).items())] for each in found]
    return table(["wave", *cells(found[0])], rows)


def sums_table(sums: octaves.Shown) -> str:
    """Pictures down; the spectrum and structures of sums that turn, and of those that do not, across."""
    def cells(found: octaves.Directions, passed: bool) -> list[str]:
        rows = [fields.mean_and_error(values) for values in (found.spectrum, *found.structures.values())]
        return [judged(with_error(*rows[0]), passed), *(with_error(*row) for row in rows[1:])]

    names = ["spectrum", *(f"structures over {smoothing:g}" for smoothing in octaves.SMOOTHINGS)]
    return table(["pictures", *names, *(f"{name}, with a period" for name in names)],
                 [[turned.cut.title, *cells(turned, turned.passed), *cells(unturned, True)]
                  for turned, unturned in zip(sums.turned, sums.unturned)])


def repeats_table(sums: octaves.Shown) -> str:
    return table(["tiles", "largest correlation", "allowed"],
                 [[f"{found.dimensions}D", judged(number(found.correlation), found.passed),
                   number(octaves.REPEAT_LIMIT)] for found in sums.repeats])


def _runs(bits: Sequence[int]) -> str:
    """Bits from the highest down: 31 and 22 to 14."""
    runs: list[list[int]] = []
    for bit in map(int, bits):
        if runs and runs[-1][-1] == bit + 1:
            runs[-1][1:] = [bit]
        else:
            runs.append([bit])
    return " and ".join(" to ".join(map(str, run)) for run in runs)


def page(results: list[HashResult], rejected: list[HashResult], sine: list[Sine], preferences: list[Preference],
         looks: list[fields.Look], waves: list[stripes.Stripes], sums: octaves.Shown, default: Twin,
         quick: bool) -> str:
    tests = sum(len(result.findings) for result in results)
    text = texts.HEAD.format(remark=texts.QUICK if quick else "",
                             alpha=f"2^{round(log2(ALPHA))}", tests=tests, chance=f"{tests * ALPHA:.2g}",
                             origins=gate.FULL.origins, seeds=len(gate.FULL.seeds), pairs=gate.FULL.pairs,
                             windows=gate.FULL.windows)
    for n in (2, 3):
        some = [result for result in results if result.dimensions == n]
        bits = default.consumed(n)
        text += texts.HASHES.format(dimensions=n, verdict=_verdicts(some), bits=len(bits), which=_runs(bits),
                                    lower=texts.LOWER if n == 3 else "")
        text += hash_table(some)
    text += texts.TESTS + table(["test", "statistic", "on a random lattice", "what it finds"],
                                [list(row) for row in texts.ROWS])
    text += texts.CONTROLS + control_table(rejected) + texts.NOISE
    text += noise_table(results, lambda r: f"`{r.name}` {r.dimensions}D")
    text += texts.ISOTROPY.format(aim=number(isotropy.AIM[2]), space=number(isotropy.AIM[3])) + preference_table(preferences)
    text += looks_section(looks) + stripes_section(waves) + sums_section(sums)
    rows = [[f"`{s.name}` {s.dimensions}D", *(number(f.statistic) for f in s.findings),
             *(number(f.threshold) for f in s.findings)] for s in sine]
    text += texts.SINE + table(["hash", "peak autocorrelation", "spectral peak", "allowed for the first",
                                "allowed for the second"], rows)
    return text + noise_table(sine, lambda r: f"`{r.name}` {r.dimensions}D").rstrip("\n") + "\n"


def looks_section(looks: list[fields.Look]) -> str:
    clouds = next(look for look in looks if look.noise.judged)
    return texts.LOOKS.format(structures=number(fields.STRUCTURES), waves=number(fields.WAVES),
                              slices=number(fields.SLICES), most=number(fields.FIXED),
                              fixed=with_error(*fields.mean_and_error(clouds.fixed)),
                              rest=with_error(*fields.mean_and_error(clouds.rest))) + look_table(looks)


def stripes_section(found: list[stripes.Stripes]) -> str:
    least = {f"even{n}": number(limit) for n, limit in stripes.EVEN.items()}
    return texts.STRIPES.format(seeds=len(stripes.EFFORTS[2].seeds), away=number(stripes.AWAY),
                                width=number(100 * stripes.OF_WIDTH), round=number(stripes.ROUND),
                                step=f"1/{round(1 / stripes.STEP)}", **least) + stripes_table(found)


def sums_section(sums: octaves.Shown) -> str:
    text = texts.SUMS.format(waves=octaves.WAVE_OCTAVES, octaves=octaves.OCTAVES, least=number(octaves.LEAST_WAVES),
                             limit=number(octaves.LIMIT), most=number(octaves.WAVES_PER_CELL / 2))
    return text + sums_table(sums) + texts.REPEATS.format(period=octaves.PERIOD) + repeats_table(sums)


def _verdicts(results: list[HashResult]) -> str:
    failed = [f"`{result.name}`" for result in results if not result.passed]
    return f"**These do not pass: {', '.join(failed)}.**" if failed else "All pass."


NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def same(path: Path, text: str) -> bool:
    """Whether a page has this text, but for the last digits of its numbers, in which versions of numpy may differ."""
    try:
        old = path.read_text(encoding="utf-8")
    except OSError as error:
        print(f"tools/measure hashes: {error}", file=sys.stderr)
        return False
    ours, theirs = NUMBER.findall(text), NUMBER.findall(old)
    if NUMBER.sub("#", old) == NUMBER.sub("#", text) and all(map(_near, ours, theirs)):
        return True
    print(f"tools/measure hashes: {path} is not what is measured now: run tools/measure hashes", file=sys.stderr)
    return False


def _near(a: str, b: str) -> bool:
    return a == b or abs(float(a) - float(b)) <= 2e-3 * max(abs(float(a)), abs(float(b)))  # two units of four digits


def write(out: Path, text: str, results: list[HashResult], default: Twin) -> None:
    from measure.hashes import plots  # which needs matplotlib; nothing else does
    for folder in ("images", "measured"):
        (out / folder).mkdir(parents=True, exist_ok=True)
    (out / "measured" / "quality.md").write_text(text, encoding="utf-8")
    plots.lattices(out / "images" / "quality-lattice.png", default)
    plots.isotropy_of_shapes(out / "images" / "isotropy.png", default)
    plots.looks(out / "images" / "looks.png", default)
    plots.noise(out / "images" / "quality-noise.png", [r for r in results if r.name == default.name])
