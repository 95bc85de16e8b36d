"""Prints which tests the last run of ctest skipped, and why: skipped.py LOG NAME..., for ctest's LastTest.log and the names
of the tests that were skipped as a whole.

Such a test prints its reason last. A test that passes may skip cases: unittest prints their reasons with -v, and GoogleTest
always does. Cases that take long are counted. A case whose reason is "the test NAME ..." is not listed, since NAME runs it.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

TEST = re.compile(r'^"([^\n]+)" start time: [^\n]*\nOutput:\n-+\n(.*?)<end of output>$', re.MULTILINE | re.DOTALL)
REASON = re.compile(r"""\.\.\.\ skipped\ (?P<quote>['"])(.*)(?P=quote)$   # of unittest
                        | ^\S+:\d+:\ Skipped\n(.*)$                       # of GoogleTest""", re.MULTILINE | re.VERBOSE)
COUNT = re.compile(r"^(?:OK|FAILED) \(.*?skipped=(\d+)", re.MULTILINE)
LONG = "takes long"  # thorough.py


def reasons(output: str, whole: bool) -> Iterator[str]:
    found = [match[2] or match[3] for match in REASON.finditer(output)]
    yield from found
    if sum(map(int, COUNT.findall(output))) > len(found):
        yield "its cases print no reason: unittest wants -v"
    elif whole and not found:
        yield (output.strip() or "it prints no reason").splitlines()[-1].removeprefix("skipped: ")


def skipped(log: str, whole: set[str]) -> tuple[dict[str, list[str]], int]:
    """The reasons of each test that skipped something, and the number of the cases that take long."""
    tests = {name: list(reasons(output, name in whole)) for name, output in TEST.findall(log)}
    listed = {name: [reason for reason in dict.fromkeys(found) if not reason.startswith((LONG, "the test "))]
              for name, found in tests.items()}
    return ({name: found for name, found in listed.items() if found},
            sum(reason.startswith(LONG) for found in tests.values() for reason in found))


if __name__ == "__main__":
    listed, long = skipped(Path(sys.argv[1]).read_text(encoding="utf-8", errors="replace"), set(sys.argv[2:]))
    if listed:
        print("Skipped, in whole or in part:")
        print(*(f"  {name}: {'; '.join(found)}" for name, found in listed.items()), sep="\n")
    if long:
        print(f"{long} cases of other tests take long: tools/test --thorough runs them.")
