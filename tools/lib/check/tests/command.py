"""Runs ctest, for tools/test, which has the options: shows what is running and since when, and at the end what
was skipped.

    python3 -B -m check.tests.command BUILD [--thorough [--resume]] [options of ctest]
"""

from __future__ import annotations

import hashlib
import itertools
import json
import os
import queue
import re
import subprocess
import sys
import threading
import time
from collections.abc import Iterable
from pathlib import Path

from base import ending
from base.tree import ROOT, files
from check.tests import skipped

SILENCE = float(os.environ.get("HN_PROGRESS_SECONDS", 10))
# Browsers, drivers and processes that are killed are waited for, so there are twice as many tests as cores.
AT_A_TIME = 2 * (os.cpu_count() or 1)
CHOICES = ("-R", "--tests-regex", "-E", "--exclude-regex", "-L", "--label-regex", "-LE", "--label-exclude")
START = re.compile(r" +Start +\d+: (.+)$")
END = re.compile(r" *\d+/\d+ +Test +#\d+: (.+?) \.{3,}(?: +(Passed) +[\d.]+ sec)?")


def listed(build: Path, options: Iterable[str]) -> set[str]:
    command = ["ctest", "--test-dir", str(build), "--show-only=json-v1", *options]
    text = subprocess.run(command, capture_output=True, text=True, check=False).stdout
    # Else ctest itself prints what is wrong.
    return {test["name"] for test in json.loads(text)["tests"]} if text.startswith("{") else set()


def clock(seconds: float) -> str:
    return f"{int(seconds) // 60}:{int(seconds) % 60:02}"


def next_line(lines: queue.Queue[str | None]) -> str | None:
    """An empty text where none comes for long, and None behind the last."""
    try:
        return lines.get(timeout=SILENCE)
    except queue.Empty:
        return ""


def run(command: list[str], passed: Path | None) -> int:
    """Copies what ctest prints, adds lines of progress, and appends the names of tests that passed to a file."""
    lines: queue.Queue[str | None] = queue.Queue()
    started = printed = time.monotonic()
    running: dict[str, None] = {}  # in this order
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, errors="replace") as process:
        threading.Thread(target=lambda: [lines.put(line) for line in itertools.chain(process.stdout, [None])]).start()
        while (line := next_line(lines)) is not None:
            print(line, end="", flush=True)
            if match := START.match(line):
                running[match[1]] = None
            elif match := END.match(line):
                running.pop(match[1], None)
                if passed and match[2]:
                    with passed.open("a", encoding="utf-8") as file:
                        file.write(f"{match[1]}\n")
            if (now := time.monotonic()) - printed >= SILENCE:
                printed = now
                print(f"    ({clock(now - started)}: {', '.join(running)})", flush=True)
    return process.returncode


def digest_of_tree() -> str:
    digest = hashlib.sha256(subprocess.run(["c++", "--version"], capture_output=True, check=False).stdout)
    for name in files():
        digest.update(name.encode() + hashlib.sha256((ROOT / name).read_bytes()).digest())
    return digest.hexdigest()


def passed_before(path: Path, resume: bool) -> set[str]:
    """The tests that passed in the thorough run of this tree, if it is resumed; else a new run begins."""
    digest = digest_of_tree()
    first, *names = (path.read_text(encoding="utf-8").splitlines() if path.exists() else []) or [""]
    if resume and first == digest:
        return set(names)
    if resume:
        print("There is no thorough run of this tree to go on with. All of the tests are run.")
    path.write_text(f"{digest}\n", encoding="utf-8")
    return set()


def without_choice(options: Iterable[str]) -> list[str]:
    """The options but those that choose tests: with one of them ctest -I counts the chosen tests alone."""
    rest = iter(options)
    return [option for option in rest if not (option in CHOICES and [next(rest, "")])]


def numbers_of(build: Path, names: set[str], options: Iterable[str]) -> str:
    """The tests but these, as ctest -I reads them: without the end of the line it loses the last."""
    command = ["ctest", "--test-dir", str(build), "-N", *options]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    tests = re.findall(r"^ *Test *#(\d+): (.+)$", text, re.MULTILINE)
    return f"0,0,0,{','.join(number for number, name in tests if name not in names)}\n"


def main(arguments: list[str]) -> int:
    build = Path(arguments[0])
    options = [option for option in arguments[1:] if option not in ("--thorough", "--resume")]
    thorough, resume = "--thorough" in arguments, "--resume" in arguments
    chosen, before, passed = list(options), set(), None
    if thorough:
        chosen += ["-C", "Thorough"]
        passed = build / "thorough-passed"  # a digest of the tree, and the tests that have passed on it, a line each
        before = passed_before(passed, resume)
    tests = listed(build, chosen)
    if left_out := before & tests:
        if tests <= before:
            print(f"All {len(left_out)} tests have passed on this tree.")
            return 0
        rest = build / "thorough-rest"
        rest.write_text(numbers_of(build, before, chosen), encoding="ascii")
        chosen = [*without_choice(chosen), "-I", str(rest)]
    results = build / "tests.xml"  # of this run, with all that the tests printed
    results.unlink(missing_ok=True)
    status = run(["ctest", "--test-dir", str(build), "--no-tests=error", "--output-on-failure",
                  "--parallel", str(AT_A_TIME), "--output-junit", str(results),
                  "--test-output-size-passed", "10000000", *chosen], passed)
    if results.exists():
        skipped.show(results)
    if left_out:
        print(f"{len(left_out)} tests had passed on this tree before, and were left out.")
    elif not thorough:
        print(f"{len(listed(build, [*options, '-C', 'Thorough'])) - len(tests)} more tests run with --thorough only.")
    return status


if __name__ == "__main__":
    ending.with_children()
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt:
        sys.exit(130)
