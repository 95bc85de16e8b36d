"""Prints which tests a run of ctest skipped, in whole or in part, and why, from the file of its --output-junit.

A test that is skipped as a whole prints its reason last. A test that passes may skip cases: unittest prints their
reasons with -v, and GoogleTest always does. Cases that take long are counted. A case whose reason is "the test NAME
..." is not listed, since NAME runs it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

REASON = re.compile(r"""\.\.\.\ skipped\ (?P<quote>['"])(.*)(?P=quote)$   # of unittest
                        | ^\S+:\d+:\ Skipped\n(.*)$                       # of GoogleTest""", re.MULTILINE | re.VERBOSE)
COUNT = re.compile(r"^(?:OK|FAILED) \(.*?skipped=(\d+)", re.MULTILINE)
LONG = "takes long"  # thorough.py


def reasons(test: ElementTree.Element) -> Iterator[str]:
    output = test.findtext("system-out", "")
    found = [match[2] or match[3] for match in REASON.finditer(output)]
    yield from found
    if sum(map(int, COUNT.findall(output))) > len(found):
        yield "its cases print no reason: unittest wants -v"
    elif test.find("skipped") is not None and not found:
        yield (output.strip() or "it prints no reason").splitlines()[-1].removeprefix("skipped: ")


def skipped(tests: ElementTree.Element) -> tuple[dict[str, list[str]], int]:
    """The reasons of each test that skipped something, and the number of the cases that take long."""
    found = {test.attrib["name"]: list(reasons(test)) for test in tests.iter("testcase") if test.get("status") != "disabled"}
    listed = {name: [reason for reason in dict.fromkeys(of) if not reason.startswith((LONG, "the test "))]
              for name, of in found.items()}
    return ({name: of for name, of in listed.items() if of},
            sum(reason.startswith(LONG) for of in found.values() for reason in of))


def show(results: Path) -> None:
    listed, long = skipped(ElementTree.parse(results).getroot())
    if listed:
        print("Skipped, in whole or in part:")
        print(*(f"  {name}: {'; '.join(of)}" for name, of in listed.items()), sep="\n")
    if long:
        print(f"{long} cases of other tests take long: tools/test --thorough runs them.")
