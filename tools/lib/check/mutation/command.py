"""Tests the conformance suite: changes the library at one place at a time, and sees whether the suite notices.

    tools/test mutants [--list] [--sample N [--seed S]] [--file NAME]... [--rule NAME]... [--thorough] [--program PATH]
                       [--jobs N]

A mutant is a copy of glsl/hashnoise/ with one change in the body of a function, in whatever branch of an #if it stands,
or in a preprocessor line: a constant, an operator, a shift, a comparison, a sign, two arguments swapped, another or no
function called, another component or variable of the same type taken, a line dropped. tools/lib/check/mutation/rules.py
has the rules. Each mutant prints a line: its number, where it is, what changed, and the case that killed it, or
SURVIVED. The numbers are the same with every selection, until the library changes. At the end come the sums by file and
by rule.

A mutant first runs with --filter on the golden values of the functions of its own file, then on all cases of these,
then on functions of the files that include it. Only if these do not kill it the whole default run follows; so a
survivor has survived all that tools/conform runs. With --thorough a survivor goes on to what --thorough has of these
functions: every setting in every version and stage. A mutant that only that kills is reported as such, and wants a case
in the default run. Nothing is cached. A mutant that does not compile is killed, but proves nothing about the suite:
those are counted apart.

The unchanged library must pass the cases that kill, or else they would show nothing. Some are tried first, and at the
end all that killed a mutant.

Some mutants compute the same, or nothing that the contract distinguishes from the right values.
tools/lib/check/mutation/equivalent.py has them, with the proof; they are shown and not run, and no sample has them.

Exit status: 0 all were killed, 1 some survived the default run, 2 bad usage, 3 the program could not judge some, or not
even the unchanged library.
"""

from base import needs

needs.python("test", "mutants")

import argparse  # noqa: E402
import json  # noqa: E402
import shutil  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
import tempfile  # noqa: E402
import time  # noqa: E402
from collections import Counter  # noqa: E402
from collections.abc import Iterable, Sequence  # noqa: E402
from concurrent.futures import ThreadPoolExecutor  # noqa: E402
from dataclasses import dataclass  # noqa: E402
from functools import cache  # noqa: E402
from pathlib import Path  # noqa: E402

from base.tree import GLSL as LIBRARY  # noqa: E402
from base.tree import ROOT, glsl_files  # noqa: E402
from base.usage import Parser, whole  # noqa: E402
from catalog.tables.functions import read_functions  # noqa: E402
from check.mutation import rules  # noqa: E402
from check.mutation.equivalent import is_equivalent  # noqa: E402
from check.mutation.mutants import Mutant, Sources, all_mutants, sample  # noqa: E402
from translate.single_file.files import in_order, parts  # noqa: E402

PROGRAM = ROOT / "build" / "conformance" / "hn-conform"
TIMEOUT = 1800  # seconds; a whole run takes one or two minutes on idle cores, so beyond this something hangs


@dataclass(frozen=True)
class Verdict:
    kind: str  # one of KINDS
    detail: str = ""

    def __str__(self) -> str:
        return KINDS[self.kind] + self.detail


# The verdicts, and their texts.
KINDS = {"killed": "killed by ", "uncompiled": "does not compile: killed by ", "equivalent": "equivalent, not run",
         "thorough": "SURVIVED, and killed with --thorough by ", "survived": "SURVIVED", "error": "ERROR: "}
# The statuses of a case that notices the change: all that are bad but error, which is a fault of the suite.
KILLING = ("fail", "crash", "timeout")


def verdict_of(case: dict[str, object]) -> Verdict:
    """A case that fails without a value compared did not come so far, unless it is one that wants no value."""
    compiles = case["status"] != "fail" or case.get("samples") != 0 or ".refused_" in str(case["id"])
    return Verdict("killed" if compiles else "uncompiled", str(case["id"]))


def failed_case(results: Path) -> Verdict:
    """The message of the first case that notices the change."""
    try:
        cases = [case for run in json.loads(results.read_text(encoding="utf-8"))["runs"] for case in run["cases"]]
    except (OSError, ValueError, KeyError) as error:
        return Verdict("error", f"no results that could be read: {error!r}")
    failed = (verdict_of(case) for case in cases if case["status"] in KILLING)
    return next(failed, Verdict("error", "something is not as expected, but no case fails"))


def run_suite(program: Path, glsl: Path, out: Path, filters: Sequence[str], thorough: bool = False) -> Verdict:
    command = [str(program), "run", "--glsl", str(glsl), "--fail-fast", "--out", str(out)]
    command += ["--thorough"] * thorough
    for glob in filters:
        command += ["--filter", glob]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=TIMEOUT)
    except (OSError, subprocess.TimeoutExpired) as error:
        return Verdict("error", str(error))
    if done.returncode == 0:
        return Verdict("survived")
    if done.returncode == 1:
        return failed_case(out / "results.json")
    return Verdict("error", f"exit status {done.returncode}: {(done.stderr.strip() or 'no message').splitlines()[-1]}")


def judge(program: Path, sources: Sources, stages: Sequence[Sequence[str]], thorough: bool = False) -> Verdict:
    """Runs the suite on these sources with the filters of each stage in turn, until one notices something."""
    with tempfile.TemporaryDirectory(prefix="mutate-") as scratch:
        glsl = Path(scratch, "glsl")
        shutil.copytree(LIBRARY, glsl)  # with the files for other languages, which no rule changes
        for name, text in sources.items():
            (glsl / name).write_text(text, encoding="utf-8")
        verdicts = (run_suite(program, glsl, Path(scratch, "out"), filters, thorough) for filters in stages)
        return next((verdict for verdict in verdicts if verdict.kind != "survived"), Verdict("survived"))


NOISE = "noise2d.perlin.*.golden"  # what rests on most of the library
MOST_NEAR = 16  # functions of other files that judge a file which they include


@cache
def includers(file: str) -> frozenset[str]:
    """The files that include a file, by themselves or by others."""
    library = parts()
    return frozenset(name for name in library if name != file and file in in_order(name, library))


@cache
def rows() -> tuple[tuple[str, str], ...]:
    """Each function's id and its file of glsl/hashnoise/."""
    return tuple((function.id, function.includes) for function in read_functions())


@cache
def judges_of(file: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The functions of a file, and some of files that include it: one of each, or of some of them."""
    own = tuple(function for function, where in rows() if where == file)
    first = {where: function for function, where in reversed(rows()) if where in includers(file)}
    others = list(first.values())
    step = max(-(-len(others) // MOST_NEAR), 1)
    return own, tuple(others[::step])


def stages_of(file: str) -> tuple[tuple[str, ...], ...]:
    """The cases to run on a mutant of a file: its golden values, all of its cases, some of what rests on it,
    everything."""
    own, near = judges_of(file)
    of_file = ("config.*",) if file == "config.glsl" else (f"{Path(file).stem}.all.*",)
    golden = tuple(f"{function}.*.golden" for function in own)
    stages = ((*golden, *of_file), tuple(f"{function}.*" for function in own),
              tuple(f"{function}.*.{check}" for function in near for check in ("golden", "twin")))
    return (*filter(None, stages), ())


def thorough_stages_of(file: str) -> tuple[tuple[str, ...], ...]:
    """The stages in the product of settings, versions and stages."""
    own, near = judges_of(file)
    return tuple(filter(None, (tuple(f"{function}.*" for function in own), tuple(f"{function}.*" for function in near))))


def judge_mutant(program: Path, sources: Sources, mutant: Mutant, thorough: bool) -> Verdict:
    if is_equivalent(mutant):
        return Verdict("equivalent")
    changed = sources | {mutant.file: mutant.source}
    verdict = judge(program, changed, stages_of(mutant.file))
    if not thorough or verdict.kind != "survived":
        return verdict
    verdict = judge(program, changed, thorough_stages_of(mutant.file), thorough=True)
    return Verdict("thorough", verdict.detail) if verdict.kind in ("killed", "uncompiled") else verdict


def table(title: str, rows: Iterable[tuple[str, str]]) -> str:
    """The verdicts by their subjects, both as (about, kind): a line each, and a line of sums."""
    counts = Counter(rows)
    names = dict.fromkeys(name for name, _ in counts)
    lines = [f"{title:<16}{'mutants':>9}" + "".join(f"{kind:>12}" for kind in KINDS)]
    for name in (*names, "all"):
        kinds = [sum(count for (about, found), count in counts.items() if name in (about, "all") and found == kind)
                 for kind in KINDS]
        lines.append(f"{name:<16}{sum(kinds):>9}" + "".join(f"{count:>12}" for count in kinds))
    return "\n".join(lines)


def sound(verdict: Verdict) -> bool:
    """Whether the unchanged library passed; if not, this prints why."""
    if verdict.kind == "survived":
        return True
    print(f"mutate: the unchanged library does not pass, so a mutant proves nothing: {verdict}", file=sys.stderr)
    return False


def sweep(program: Path, sources: Sources, mutants: Sequence[Mutant], jobs: int, thorough: bool) -> int:
    start = time.monotonic()
    if not sound(judge(program, sources, ((NOISE,),))):
        return 3
    judged: list[tuple[Mutant, Verdict]] = []
    with ThreadPoolExecutor(jobs) as pool:
        verdicts = pool.map(lambda mutant: judge_mutant(program, sources, mutant, thorough), mutants)
        for mutant, verdict in zip(mutants, verdicts):
            print(f"{mutant}  {verdict}", flush=True)
            judged.append((mutant, verdict))
    killing = tuple(sorted({verdict.detail for _, verdict in judged if verdict.kind in ("killed", "uncompiled")}))
    if killing and not sound(judge(program, sources, (killing,))):
        return 3
    print(table("rule", ((mutant.rule, verdict.kind) for mutant, verdict in judged)))
    print(table("file", ((mutant.file, verdict.kind) for mutant, verdict in judged)))
    kinds = Counter(verdict.kind for _, verdict in judged)
    survivors = [str(mutant) for mutant, verdict in judged if verdict.kind in ("survived", "thorough")]
    print(*["Survivors:", *survivors] if survivors else [], sep="\n", end="\n" if survivors else "")
    print(f"{len(mutants)} mutants: {kinds['killed'] + kinds['uncompiled']} killed ({kinds['uncompiled']} of them did "
          f"not compile), {kinds['survived'] + kinds['thorough']} survived ({kinds['thorough']} of them not --thorough), "
          f"{kinds['equivalent']} equivalent, {kinds['error']} errors, in "
          f"{time.monotonic() - start:.0f} s")
    return 3 if kinds["error"] else 1 if survivors else 0


def options_of(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = Parser("tools/test mutants", __doc__)
    parser.add_argument("--list", action="store_true", help="only list the mutants")
    parser.add_argument("--sample", type=whole, metavar="N", help="only N of them, spread evenly")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="which N; default: 1")
    parser.add_argument("--file", action="append", metavar="NAME", help="only those of glsl/hashnoise/NAME; may be repeated")
    parser.add_argument("--rule", action="append", metavar="NAME", choices=(*rules.RULES, "directive"),
                        help=f"only those of one rule: {', '.join(rules.RULES)}, directive; may be repeated")
    parser.add_argument("--thorough", action="store_true", help="run survivors on what --thorough has besides")
    parser.add_argument("--program", type=Path, default=PROGRAM, metavar="PATH", help="default: %(default)s")
    parser.add_argument("--jobs", type=whole, default=2, metavar="N", help="how many at a time; default: 2")
    options = parser.parse_args(arguments)
    for name in options.file or ():
        if not (LIBRARY / name).is_file():
            parser.error(f"there is no {LIBRARY / name}; --file wants the name of a file of glsl/hashnoise/")
    if not options.list and not options.program.is_file():
        parser.error(f"there is no {options.program}; build it, or name another with --program")
    return options


def main(arguments: Sequence[str] | None = None) -> int:
    options = options_of(arguments)
    sources = {name: path.read_text(encoding="utf-8") for name, path in glsl_files(LIBRARY).items()}
    mutants = [mutant for mutant in all_mutants(sources) if (not options.file or mutant.file in options.file) and
               (not options.rule or mutant.rule in options.rule)]
    if not mutants:
        print("tools/test mutants: what --file and --rule name has no mutant", file=sys.stderr)
        return 2
    if options.sample:
        mutants = sample([mutant for mutant in mutants if not is_equivalent(mutant)], options.sample, options.seed)
    if options.list:
        print(*mutants, sep="\n")
        return 0
    return sweep(options.program.resolve(), sources, mutants, options.jobs, options.thorough)


if __name__ == "__main__":
    sys.exit(main())
