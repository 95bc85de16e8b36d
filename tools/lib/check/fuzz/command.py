"""Fuzzes the parsers of hn-conform with libFuzzer, under the address and the undefined-behaviour sanitizer.

    tools/test fuzz [--seconds N | --runs N] [--build DIR] [--out DIR] [TARGET...]

A target is a file of conformance/testing/fuzz: expectations, golden, journal, results, shaders; without one
all are run, one after the other, for N seconds each (600), or for N inputs. Each begins with
conformance/testing/fuzz/corpus/TARGET, which stays as it is. New inputs are kept in DIR/TARGET/corpus (--out,
build-fuzz/findings), and where the next run goes on; with --runs, for which every run is to be the same, it is not.
Inputs that break a parser, or that take it too long or too much memory, are left in DIR/TARGET/findings; call the
program that found one with it for details.

Exit status: 0 nothing found, 1 something found, 2 bad usage, 4 it could not be built.
"""

from base import needs

needs.python("test", "fuzz")

import argparse  # noqa: E402
import os  # noqa: E402
import shutil  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
import tempfile  # noqa: E402
import time  # noqa: E402
from collections.abc import Sequence  # noqa: E402
from pathlib import Path  # noqa: E402

from base.tree import ROOT  # noqa: E402
from base.usage import Parser, whole  # noqa: E402

FUZZ = ROOT / "conformance" / "testing" / "fuzz"
TARGETS = sorted(path.stem for path in FUZZ.glob("*.cpp"))

LONGEST = 10  # seconds for one input; those of the corpus take milliseconds
MOST_MEMORY = 1024  # MiB; a parser that needs more can be made to need all
LONGEST_INPUT = 65536  # bytes; deep nesting and long lists need room


class BuildError(Exception):
    pass


def build(folder: Path, targets: Sequence[str]) -> None:
    log = folder / "fuzz.log"
    folder.mkdir(parents=True, exist_ok=True)
    configure = ["cmake", "--preset", "fuzz", "-B", str(folder)]
    if shutil.which("ccache"):
        configure.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    compile_ = ["cmake", "--build", str(folder), "--target", *(f"fuzz-{target}" for target in targets)]
    with log.open("w", encoding="utf-8") as out:
        for command in (configure, compile_):
            try:
                status = subprocess.run(command, cwd=ROOT, stdout=out, stderr=subprocess.STDOUT, check=False).returncode
            except OSError as error:
                raise BuildError(f"{command[0]}: {error.strerror}") from error
            if status != 0:
                end = "\n".join(log.read_text(encoding="utf-8", errors="replace").splitlines()[-20:])
                raise BuildError(f"{end}\nThe fuzzers could not be built; all of the output is in {log}. They need what "
                                 "tools/test installs, with Debian's libclang-rt-dev.")


def fuzz(program: Path, target: str, out: Path, limit: Sequence[str], keep: bool) -> bool:
    """Runs one target. Whether it found nothing."""
    findings = out / target / "findings"
    findings.mkdir(parents=True, exist_ok=True)
    options = [f"-artifact_prefix={findings}/", f"-timeout={LONGEST}", f"-rss_limit_mb={MOST_MEMORY}",
               f"-max_len={LONGEST_INPUT}", "-print_final_stats=1", *limit]
    dictionary = FUZZ / "corpus" / f"{target}.dict"
    if dictionary.exists():
        options.append(f"-dict={dictionary}")
    log = out / target / "log"
    environment = {"ASAN_OPTIONS": "detect_stack_use_after_return=1", "UBSAN_OPTIONS": "print_stacktrace=1", **os.environ}
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as scratch, log.open("w", encoding="utf-8") as text:
        corpus = out / target / "corpus" if keep else Path(scratch)
        corpus.mkdir(parents=True, exist_ok=True)
        command = [str(program), *options, str(corpus), str(FUZZ / "corpus" / target)]
        status = subprocess.run(command, stdout=text, stderr=subprocess.STDOUT, check=False, env=environment).returncode
    lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
    if status != 0:
        print("\n".join(lines[-40:]))
    print(f"{target:<14} {describe(status, lines, findings, log)}, {time.monotonic() - start:.0f} s", flush=True)
    return status == 0


def describe(status: int, lines: Sequence[str], findings: Path, log: Path) -> str:
    if status != 0:
        return f"FOUND SOMETHING: see {findings} and {log}"
    stats = dict(line.removeprefix("stat::").split(":", 1) for line in lines if line.startswith("stat::"))
    return f"nothing found in {int(stats['number_of_executed_units']):,} inputs"


def options_from(arguments: Sequence[str]) -> argparse.Namespace:
    parser = Parser("tools/test fuzz", __doc__)
    limit = parser.add_mutually_exclusive_group()
    limit.add_argument("--seconds", type=whole, default=600, metavar="N", help="for each target (600)")
    limit.add_argument("--runs", type=whole, metavar="N", help="so many inputs for each, always the same")
    parser.add_argument("--build", type=Path, default=ROOT / "build-fuzz", metavar="DIR", help="where they are built")
    parser.add_argument("--out", type=Path, metavar="DIR", help="for what is found and learnt (BUILD/findings)")
    parser.add_argument("targets", nargs="*", metavar="TARGET", help=", ".join(TARGETS))
    options = parser.parse_args(arguments)
    for target in options.targets:
        if target not in TARGETS:
            parser.error(f"there is no target {target}; there are: {', '.join(TARGETS)}")
    return options


def main(arguments: Sequence[str]) -> int:
    options = options_from(arguments)
    targets = options.targets or TARGETS
    folder = options.build.resolve()
    out = options.out.resolve() if options.out else folder / "findings"
    try:
        build(folder, targets)
    except BuildError as error:
        print(f"tools/test fuzz: {error}", file=sys.stderr)
        return 4
    limit = [f"-runs={options.runs}", "-seed=1"] if options.runs else [f"-max_total_time={options.seconds}"]
    results = [fuzz(folder / "conformance" / f"fuzz-{target}", target, out, limit, keep=not options.runs)
               for target in targets]
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
