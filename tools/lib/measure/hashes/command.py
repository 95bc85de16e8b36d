"""Measures how random the hashes are, and what the noise is like.

Without options every hash of the library is judged, and docs/measured/quality.md and its pictures are written. With
options that choose what is judged, or with --quick or --least and no --out, the verdicts alone are printed.

    tools/measure hashes --quick     the gate alone, with fewer and smaller windows: no page is written

To judge a candidate for the default hash: a copy of glsl/ and include/ in one folder, with what is tried in its
detail/word.glsl, first briefly and then as the page does:

    tools/measure hashes --include FOLDER/include --hash LATTICE --dimensions 2 --least
    tools/measure hashes --include FOLDER/include --hash LATTICE --dimensions 2 --seeds 5,6,7

Exit status: 0 every hash passes, 1 one does not (or, with --check, the page is not up to date), 2 bad usage, 4 it could
not be built.
"""

from __future__ import annotations

import argparse
import importlib.util
import json
import os
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import numpy as np

from base.renderer import Renderer
from base.tree import ROOT
from base.usage import Parser
from measure.hashes import controls, fields, gate, isotropy, library, noise, octaves, others, report, stripes
from measure.hashes.judgement import Finding
from measure.hashes.lattice import Lattice, sample
from measure.hashes.report import HashResult

DIMENSIONS = (2, 3)
PARTS = ("hash", "hash_fn", "dimensions", "seeds", "steps")  # options with which not the whole page is measured


@dataclass
class Task:
    """A hash in the plane or in space, for a process of its own."""
    twin: library.Twin
    dimensions: int
    effort: gate.Effort
    dump: Path | None
    with_noise: bool


class Dump:
    """Writes the windows that are judged, as .npy files, and prints what they are."""

    def __init__(self, folder: Path, twin: library.Twin):
        self.folder, self.twin, self.entries = folder, twin, []

    def __call__(self, lattice: Lattice) -> None:
        for quantity, array in (("word", lattice.words), ("gradient", lattice.gradients)):
            name = "_".join([self.twin.name, f"{lattice.dimensions}d", *map(str, lattice.origin), str(lattice.seed),
                             quantity]) + ".npy"
            np.save(self.folder / name, array)
            self.entries.append({"file": name, "hash": self.twin.name, "dimensions": lattice.dimensions,
                                 "origin": lattice.origin, "seed": lattice.seed, "quantity": quantity,
                                 "axes": "xyz"[:lattice.dimensions] + ("", ", component")[quantity == "gradient"],
                                 "consumed_bits": [int(bit) for bit in lattice.bits]})


def measure(task: Task) -> tuple[HashResult, list[dict]]:
    dump = Dump(task.dump, task.twin) if task.dump else None
    findings = gate.judge_twin(task.twin, task.dimensions, task.effort, dump or (lambda lattice: None))
    curves = noise.measure(task.twin, task.dimensions) if task.with_noise else None
    return HashResult(task.twin.name, task.dimensions, findings, curves), dump.entries if dump else []


def measure_all(tasks: list[Task], jobs: int) -> tuple[list[HashResult], list[dict]]:
    results, entries = [], []
    with ProcessPoolExecutor(jobs) as pool:
        for result, dumped in pool.map(measure, tasks):
            print(report.verdict(result), flush=True)
            results.append(result)
            entries += dumped
    return results, entries


def control_results(twin: library.Twin) -> list[HashResult]:
    """Every control in the plane, those of components in space, small; and what is random, which passes."""
    side = gate.SIDES[2]
    results = [HashResult("random", 2, gate.judge_words(controls.random((side, side)), twin), None)]
    for name, (make, _) in controls.WINDOWS.items():
        results.append(HashResult(name, 2, gate.judge_words(make((side, side)), twin), None))
    for name, (function, _) in controls.FUNCTIONS.items():
        stand_in = controls.Function(name, twin.program, twin.bits, function)
        results.append(HashResult(name, 2, gate.judge_twin(stand_in, 2, gate.LEAST), None))
    for name, (make, _) in controls.GRADIENTS.items():
        window = controls.of_gradients(make(controls.GRADIENT_SHAPES[2]))
        results.append(HashResult(name, 2, gate.judge_gradients(window), None))
    words = controls.random(controls.COMPONENT_SHAPE)
    for name, (make, _) in controls.COMPONENTS.items():
        results.append(HashResult(name, 3, list(gate.judge_components([words, *make(words)], twin)), None))
    for name, (make, _) in controls.VECTORS.items():
        stand_in = controls.Vectors(name, twin.program, twin.bits, others=make)
        found = gate.components.of_noise(stand_in, 3, 0, gate.LEAST.samples >> 3)
        results.append(HashResult(name, 3, found, None))
    return results


def preferences() -> list[report.Preference]:
    """How isotropic the noise of each shape of gradients is."""
    rows = []
    for make, _ in controls.GRADIENTS.values():
        for n in DIMENSIONS:
            window = controls.of_gradients(make(controls.GRADIENT_SHAPES[n]))
            rows.append(report.Preference(make.__doc__, n, isotropy.of_window(window)))
    return rows


def sine_results(names: dict[str, int], include: Path, folder: Path) -> list[report.Sine]:
    """The paper's gradient, which the gate leaves alone: its gradients and its noise."""
    rows = []
    for name, number in names.items():
        twin = library.build(f"{name}_sine", [f"HN_HASH={number}", "HN_GRADIENT=2"], include, folder)
        for n in DIMENSIONS:
            side = gate.SIDES[n]
            window = sample(twin, (side,) * n, (0,) * n, 0)
            rows.append(report.Sine(name, n, gate.fourier.autocorrelation(window), noise.measure(twin, n, 1 << 20)))
    return rows


def chosen_twins(options, folder: Path) -> list[library.Twin]:
    names = library.hash_names(options.include)
    unknown = set(options.hash or ()) - set(names)
    if unknown:
        options.parser.error(f"there is no hash {', '.join(sorted(unknown))}; the library has {', '.join(names)}")
    wanted = options.hash or ([] if options.hash_fn else list(names))
    twins = [library.build(name, [f"HN_HASH={names[name]}"], options.include, folder) for name in wanted]
    if options.hash_fn:
        twins.append(library.build("CUSTOM", ["HN_HASH=HN_HASH_CUSTOM", f"HN_HASH_FN(k)=({options.hash_fn})"],
                                   options.include, folder))
    more = options.steps or ()
    return [replace(twin, steps=tuple(tuple(dict.fromkeys(axis + more)) for axis in twin.steps)) for twin in twins]


def judge_given(options, folder: Path) -> int:
    """Judges words from files."""
    given, passed = [], True
    for n, path in ((2, options.words2), (3, options.words3)):
        if path is None:
            continue
        try:
            words = np.load(path, allow_pickle=False)
        except (OSError, ValueError) as error:
            options.parser.error(f"{path} cannot be read: {error}")
        if words.ndim != n or words.dtype not in (np.uint32, np.int32) or min(words.shape) < 64:
            options.parser.error(f"{path} is not an array of 32-bit words with {n} axes of 64 or more: it has "
                                 f"{words.dtype} and the shape {words.shape}")
        given.append((str(path), n, words.view(np.uint32)))
    twin = library.build("stage", [], options.include, folder)
    for name, n, words in given:
        result = HashResult(name, n, gate.judge_words(words, twin), None)
        print(report.verdict(result))
        passed &= result.passed
    return 0 if passed else 1


def judge_others(options, folder: Path) -> int:
    """Judges hashes from shaders."""
    given = [(other.name, n) for other in options.against for n in other.dimensions]
    twice = next((each for each in given if given.count(each) > 1), None)
    if twice:
        options.parser.error(f"--against names {twice[0]} twice in {twice[1]}D: write {twice[0]}/2=... and {twice[0]}/3=...")
    twin = library.build("stage", [], options.include, folder)
    renderer = Renderer(others.SIDE)
    results: list[others.Judged] = []
    for other in options.against:
        try:
            found = others.judge(other, (options.dimensions,) if options.dimensions else DIMENSIONS, twin, renderer)
        except others.BadExpression as error:
            options.parser.error(str(error))
        print("\n".join(others.lines(found)), flush=True)
        results += found
    if options.out:
        options.out.mkdir(parents=True, exist_ok=True)
        others.write(results, options.out / "hashes.csv", renderer.version)
    return 0 if all(judged.result.passed for judged in results) else 1


def odd_words(text: str) -> tuple[int, ...]:
    words = tuple(int(word, 0) for word in text.split(","))
    for word in words:
        if not 0 < word <= gate.WORD or word % 2 == 0:
            raise argparse.ArgumentTypeError(f"{word} is not an odd number below 2^32")
    return words


def refuse(options, name: str, others: tuple[str, ...]) -> None:
    """Bad usage, if an option comes with others that it would not heed."""
    given = ["--" + other.replace("_", "-") for other in others if getattr(options, other)]
    if getattr(options, name) and given:
        options.parser.error(f"--{name} goes without {' and '.join(given)}")


def parse(arguments: list[str]) -> argparse.Namespace:
    parser = Parser("tools/measure hashes", __doc__)
    parser.add_argument("--hash", action="append", metavar="NAME", help="only this hash of the library (repeatable)")
    parser.add_argument("--hash-fn", metavar="EXPR", help="judge your own hash: an expression of the uint k")
    parser.add_argument("--dimensions", type=int, choices=DIMENSIONS, help="only in the plane, or only in space")
    parser.add_argument("--words2", type=Path, metavar="FILE", help="judge words in the plane: .npy, uint32")
    parser.add_argument("--words3", type=Path, metavar="FILE", help="the same in space")
    parser.add_argument("--against", type=others.Other.parse, action="append", metavar="NAME[/2|/3]=FILE:EXPRESSION",
                        help="judge a hash of a shader: a uint, or a float in [0, 1), of c, an ivec2 and an ivec3, or of "
                        "p, the same as floats; with /2 or /3 only in the plane or in space; --out DIR writes "
                        "hashes.csv (repeatable)")
    parser.add_argument("--include", type=Path, default=ROOT / "include", metavar="DIR",
                        help="another copy of include/, with its glsl/ beside it")
    parser.add_argument("--seeds", type=lambda text: tuple(int(s, 0) & gate.WORD for s in text.split(",")),
                        metavar="A,B,...", help="seeds to measure with")
    parser.add_argument("--steps", type=odd_words, metavar="A,B,...", help="constants that any coordinate may be "
                        "multiplied by, beside those that detail/word.glsl names (HN_I_STEP_X and so on): the test of near "
                        "returns finds its distances by them")
    parser.add_argument("--dump", type=Path, metavar="DIR", help="keep what is judged: the words and gradients of each "
                        "window (.npy; some hundred MB for a hash), index.json, statistics.json")
    parser.add_argument("--out", type=Path, metavar="DIR", help="for the page (default docs; with --quick none is "
                        "written unless DIR is named)")
    parser.add_argument("--check", action="store_true", help="compare with the page instead of writing it")
    short = parser.add_mutually_exclusive_group()
    short.add_argument("--quick", action="store_true", help="the default hash, or one that is named, with fewer "
                       "windows, the others with few and small ones; no page")
    short.add_argument("--least", action="store_true", help="every hash with few and small windows; no page")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N", help="processes")
    options = parser.parse_args(arguments)
    options.parser = parser
    for name in ("words2", "words3"):
        refuse(options, name, (*PARTS, "quick", "least", "check"))
    refuse(options, "against", (*(part for part in PARTS if part != "dimensions"), "words2", "words3", "quick", "least",
                                "check"))
    refuse(options, "check", (*PARTS, "quick", "least"))
    if not options.against:
        refuse(options, "out", (*PARTS, "words2", "words3", "least"))
    if options.jobs < 1:
        parser.error("--jobs must be 1 or more")
    return options


def effort_for(options, twin: library.Twin) -> gate.Effort:
    effort, default = gate.FULL, library.default_hash(options.include)
    if options.least:
        effort = gate.LEAST
    elif options.quick:
        # A hash that somebody names is judged as the default is.
        effort = gate.QUICK if options.hash or options.hash_fn or twin.name == default else gate.LEAST
    return replace(effort, seeds=options.seeds) if options.seeds else effort


def write_dump(folder: Path, results: list[HashResult], entries: list[dict]) -> None:
    (folder / "index.json").write_text(json.dumps(entries, indent=1), encoding="utf-8")
    table = [{"hash": r.name, "dimensions": r.dimensions, **statistic(f)} for r in results for f in r.findings]
    (folder / "statistics.json").write_text(json.dumps(table, indent=1), encoding="utf-8")


def statistic(finding: Finding) -> dict:
    return {**asdict(replace(finding, scores=None)), "passed": finding.passed}


def run(options, folder: Path) -> int:
    if options.against:
        return judge_others(options, folder)
    if options.words2 or options.words3:
        return judge_given(options, folder)
    twins = chosen_twins(options, folder)
    page = options.out is not None or not any(getattr(options, name) for name in (*PARTS, "quick", "least"))
    out = options.out or ROOT / "docs"
    if page and not options.check and importlib.util.find_spec("matplotlib") is None:
        raise library.NotBuilt("the pictures need matplotlib, which tools/measure hashes finds or installs")
    if options.dump:
        options.dump.mkdir(parents=True, exist_ok=True)
    dimensions = (options.dimensions,) if options.dimensions else DIMENSIONS
    tasks = [Task(twin, n, effort_for(options, twin), options.dump, page) for twin in twins for n in dimensions]
    # The longest first, so that no process is left with one at the end.
    tasks.sort(key=lambda task: (task.effort is gate.LEAST, -task.dimensions))
    results, entries = measure_all(tasks, options.jobs)
    names = [twin.name for twin in twins]
    results.sort(key=lambda result: (names.index(result.name), result.dimensions))
    if options.dump:
        write_dump(options.dump, results, entries)
    passed = all(result.passed for result in results)
    if not page:
        return 0 if passed else 1
    default = next(twin for twin in twins if twin.name == library.default_hash(options.include))
    rejected = control_results(default)
    sine = sine_results(library.hash_names(options.include), options.include, folder)
    looks, waves, sums = fields.looks(default), stripes.shown(default.phasor), octaves.shown(default)
    passed &= report.rejected_as_meant(rejected) and sums.passed and not any(found.problems for found in waves)
    passed &= not any(look.problems for look in looks)
    text = report.page(results, rejected, sine, preferences(), looks, waves, sums, default, options.quick)
    if options.check:
        return 0 if report.same(out / "measured" / "quality.md", text) and passed else 1
    report.write(out, text, results, default)
    return 0 if passed else 1


def main(arguments: list[str]) -> int:
    options = parse(arguments)
    try:
        with tempfile.TemporaryDirectory() as folder:
            return run(options, Path(folder))
    except library.NotBuilt as error:
        print(f"{options.parser.prog}: {error}", file=sys.stderr)
        return 4


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
