"""Compares what tools/pick writes in other languages with the library in C++, bit by bit, at many points.

    tools/measure languages [--points N] [--out DIR] [LANGUAGE...]

The functions are the ten of FUNCTIONS, with integers. Each language is compiled as users compile it, and gets the same
points: N in all (10^9), drawn anew in each round of 5 million. languages.csv goes into DIR: the language, the function,
its points, and at how many of them a bit differs. docs/measured/results/languages.csv is such a file. A language is one
of c, csharp, go, java, javascript, rust; without one all are compared, and those without a compiler here are left out.

All languages take an hour or two for 10^9 points. The file is written after each round, so a run that is stopped has
what it has compared.

Exit status: 0 no bit differs, 1 some do, 2 bad usage, 4 a compiler is missing or fails.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from base.debian import Missing
from base.tree import GLSL
from base.twin import NotBuilt
from base.usage import Parser, whole
from base.versions import version_of
from measure import record, stamps
from translate.pick.command import Choice, picker, read_library
from translate.pick.comparison import compile_words
from translate.pick.runners import RUNNERS, NotRun, Runner, ran

FUNCTIONS = ("hn_perlin2", "hn_perlin3", "hn_simplex2", "hn_simplex3", "hn_value2", "hn_value3", "hn_cellular2",
             "hn_cellular3", "hn_fbm2", "hn_random2")
ROUND = 500_000  # points of each function


def differing(right: bytes, found: bytes, sizes: Mapping[str, int], points: int) -> Iterator[tuple[str, int]]:
    """At how many points each function differs; the words of the functions stand behind each other."""
    if len(right) != len(found):
        raise NotRun(f"{len(found)} bytes came back; the library has {len(right)}")
    at = 0
    for function, size in sizes.items():
        end = at + size * points
        yield function, 0 if right[at:end] == found[at:end] else sum(
            right[i:i + size] != found[i:i + size] for i in range(at, end, size))
        at = end


def compared(runners: Mapping[str, Runner], rounds: int, points: int) -> Iterator[dict[tuple[str, str], int]]:
    """After each round at how many points each language and function differs."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        module, pick = read_library(GLSL, Choice(language="c", arithmetic="fixed")), picker()
        functions, commands = {name: module.forms[name] for name in FUNCTIONS}, {}
        sizes = {name: 4 * len(module.parts(function.type)) for name, function in functions.items()}
        compile_words(module, functions, points, "fixed", folder / "words")
        for language, runner in runners.items():
            (folder / language).mkdir()
            (folder / language / "inputs").symlink_to(folder / "inputs")
            texts = [pick([name], Choice(language=language, arithmetic="fixed")) for name in functions]
            calls = [runner.call(module, function, points) for function in functions.values()]
            commands[language] = runner.build(texts, calls, folder / language)
        sums = {(language, function): 0 for language in runners for function in functions}
        for number in range(rounds):
            ran(folder, folder / "words", folder / "inputs", folder / "right", str(number))
            right = (folder / "right").read_bytes()
            for language, command in commands.items():
                ran(folder / language, *command)
                found = (folder / language / "outputs").read_bytes()
                for function, count in differing(right, found, sizes, points):
                    sums[language, function] += count
            yield sums


def main(arguments: Sequence[str] | None = None) -> int:
    parser = Parser("tools/measure languages", __doc__)
    parser.add_argument("--points", type=whole, default=10**9, metavar="N", help="of each language, in all (10^9)")
    parser.add_argument("--out", type=Path, default=Path("out"), metavar="DIR", help="for languages.csv (out)")
    parser.add_argument("languages", nargs="*", metavar="LANGUAGE", help=", ".join(sorted(RUNNERS)))
    given = parser.parse_args(arguments)
    for language in given.languages:
        if language not in RUNNERS:
            parser.error(f"there is no language {language}; it is one of {', '.join(sorted(RUNNERS))}")
    runners = {}
    for language in given.languages or sorted(RUNNERS):
        runner = RUNNERS[language]()
        runner.optimizes = True
        try:
            runner.check()
        except Missing as reason:
            print(f"tools/measure languages: {language} is left out: {reason}", file=sys.stderr)
        else:
            runners[language] = runner
    if given.languages and len(runners) < len(given.languages) or not runners:
        return 4
    points = min(ROUND, -(-given.points // len(FUNCTIONS)))
    rounds = -(-given.points // (points * len(FUNCTIONS)))
    file = given.out / "languages.csv"
    compilers = "; ".join(version_of(runner.programs[0]) for runner in runners.values())
    sums = {}
    try:
        for number, sums in enumerate(compared(runners, rounds, points), 1):
            record.write(file, [{"language": language, "function": function, "points": number * points,
                                 "differing": count} for (language, function), count in sums.items()])
            stamps.stamp(file, compilers)  # each time, for whoever stops it
            print(f"round {number} of {rounds}: {sum(sums.values())} points differ", file=sys.stderr, flush=True)
    except (NotBuilt, NotRun, OSError) as error:
        print(f"tools/measure languages: {error}", file=sys.stderr)
        return 4
    print(file)
    return 1 if any(sums.values()) else 0
