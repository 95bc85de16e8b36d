"""Digests of results, as anybody may send them: read, and refused for whatever is not as the suite writes it.

docs/reference/formats.md lists what a digest has. A refusal is a sentence with the place, what is wrong, and what would
be right. It quotes nothing that it has not made harmless before."""

from __future__ import annotations

import json
import re
import stat
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from measure.results.sets import Sets

FORMAT = "hashnoise-digest 1"
# As in conformance/report/digest.hpp and digest.cpp.
MOST_BYTES = 4096
MOST_FAILED = 12
MOST_NAME = 96
TIMED = ("fbm.fbm2", "noise2d.cellular", "noise2d.perlin", "noise2d.simplex", "noise2d.value", "warp.warp2")
UNIT = "noise2d.perlin.fast"

BROWSER_APIS = ("webgl2", "webgpu")
APIS = ("opengl", "opengles", "vulkan", *BROWSER_APIS)
# As in conformance/web/whereabouts.js; and what uname calls systems.
BROWSERS = ("Chrome", "Edge", "Firefox", "Opera", "Safari", "Samsung Internet")
SYSTEMS = ("Android", "ChromeOS", "FreeBSD", "Linux", "NetBSD", "OpenBSD", "Windows", "iOS", "macOS", "unknown")
ARITHMETICS = ("exact", "fast", "fixed", "precise")
DEEPEST = 5
MOST_CASES = 100_000

FILE_NAME = re.compile(r"[a-z0-9][a-z0-9._-]{0,119}\.json")
SAFE = re.compile(r"[A-Za-z0-9()+,./:;@_-]+(?: [A-Za-z0-9()+,./:;@_-]+)*")
BUILD = re.compile(r"\d+\.\d+\.\d+")
CHECKSUM = re.compile(r"[0-9a-f]{8}")
GROUP = re.compile(rf"([a-z0-9_]{{1,32}})\.({'|'.join(ARITHMETICS)})")
CASE = re.compile(rf"([a-z0-9_]{{1,32}})\.([a-z0-9_]{{1,48}})\.[a-z0-9_+]{{1,32}}\.({'|'.join(ARITHMETICS)})"
                  r"\.(?:fragment|vertex|compute)\.[a-z0-9]{1,16}\.[a-z0-9_]{1,32}")


class Refused(Exception):
    """A digest that cannot be taken; the message has the reason."""


class Earlier(Refused):
    """One of other golden files of the same version, which cannot be judged any more. All else of it is right."""


@dataclass(frozen=True)
class Part:
    """A digest's results of one API."""
    counts: Mapping[str, tuple[int, int, int]]  # of a group, "fbm.fixed": passed, failed, other
    checksums: Mapping[str, str]
    sets: frozenset[int]
    wrong: frozenset[str] = frozenset()  # the groups whose checksums are not those of the golden files

    def failed(self, *arithmetics: str) -> int:
        return sum(counts[1] for group, counts in self.counts.items() if group.rpartition(".")[2] in arithmetics)

    def ran(self, *arithmetics: str) -> int:
        return sum(counts[0] + counts[1] for group, counts in self.counts.items()
                   if group.rpartition(".")[2] in arithmetics)


@dataclass(frozen=True)
class Digest:
    name: str  # of its file
    version: str
    system: str
    browser: str
    renderer: str
    vendor: str
    driver: str
    parts: Mapping[str, Part]  # by the API
    failed: tuple[str, ...]    # cases
    costs: Mapping[str, int]


def shown(value: object) -> str:
    """A value in a message: short, in printable ASCII."""
    text = value if isinstance(value, str) else json.dumps(value)
    harmless = "".join(c if " " <= c <= "~" else "?" for c in text[:60])
    return f'"{harmless}"' + ("..." if len(text) > 60 else "")


def bytes_at(path: Path) -> bytes:
    if not FILE_NAME.fullmatch(path.name):
        raise Refused(f"its name is {shown(path.name)}; a digest has one of small letters, digits, dots and hyphens, "
                      "which ends with .json")
    try:
        mode = path.lstat().st_mode
        if not stat.S_ISREG(mode):
            what = "a link" if stat.S_ISLNK(mode) else "no file"
            raise Refused(f"it is {what}; a digest is a file")
        with path.open("rb") as file:
            data = file.read(MOST_BYTES + 1)
    except OSError as error:
        raise Refused(f"it cannot be read: {error.strerror}") from error
    if len(data) > MOST_BYTES:
        raise Refused(f"it is larger than {MOST_BYTES} bytes; the suite writes none that is")
    return data


def parse(data: bytes) -> Any:
    """JSON as the suite writes it: one line of ASCII, the keys in order, no blanks, and whole numbers alone."""
    for place, byte in enumerate(data):
        if not 0x20 <= byte < 0x7F and not (byte == 0x0A and place == len(data) - 1):
            raise Refused(f"byte {place} is 0x{byte:02x}; a digest is one line of printable ASCII")
    text = data.decode("ascii").rstrip("\n")
    depth = deepest = 0
    for character in text:
        depth += (character in "[{") - (character in "]}")
        deepest = max(deepest, depth)
    if deepest > DEEPEST:
        raise Refused(f"it is nested {deepest} levels deep; a digest has {DEEPEST} at most")

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        keys = [key for key, _ in pairs]
        for key in keys:
            if keys.count(key) > 1:
                raise Refused(f"the key {shown(key)} occurs twice; each occurs once")
        return dict(pairs)

    def no_number(number: str) -> Any:
        raise Refused(f"{shown(number)} is a number that no digest has; all of them are whole")

    try:
        found = json.loads(text, object_pairs_hook=unique, parse_float=no_number, parse_constant=no_number)
    except ValueError as error:
        raise Refused(f"it is not JSON: {error}") from error
    if json.dumps(found, separators=(",", ":"), sort_keys=True) != text:
        raise Refused("it is not written as the suite writes it, which is without blanks and with its keys in order; "
                      "send the file itself")
    return found


class Reader:
    """Values at places of a digest. A place is a path such as apis.webgl2.cases."""

    @staticmethod
    def of_kind(value: Any, kind: type, where: str, what: str) -> Any:
        if type(value) is not kind:  # True is an int, too
            raise Refused(f"{where} is {shown(value)}; it should be {what}")
        return value

    def keys(self, value: Any, where: str, needed: Iterable[str], allowed: Iterable[str] = ()) -> dict[str, Any]:
        found = self.of_kind(value, dict, where, "an object")
        needed = list(needed)
        for key in needed:
            if key not in found:
                raise Refused(f"{where} has no {shown(key)}; it has {', '.join(needed)}")
        for key in found:
            if key not in needed and key not in allowed:
                raise Refused(f"{where} has the key {shown(key)}, which no digest has; it has "
                              f"{', '.join([*needed, *allowed])}")
        return found

    def text(self, value: Any, where: str, right: Callable[[str], object], what: str) -> str:
        found = self.of_kind(value, str, where, what)
        if not right(found):
            raise Refused(f"{where} is {shown(found)}; it should be {what}")
        return found

    def name(self, value: Any, where: str) -> str:
        """A driver's own name."""
        found = self.text(value, where, lambda text: len(text) <= MOST_NAME and SAFE.fullmatch(text),
                          f"at most {MOST_NAME} letters, digits and ()+,./:;@_- with single blanks between them")
        return self.text(found, where, lambda text: not BUILD.search(text), "a name without the numbers of builds, "
                         "such as 1.2 in place of 1.2.3")

    def one_of(self, value: Any, where: str, values: Iterable[str]) -> str:
        values = list(values)
        return self.text(value, where, lambda text: text in values, f"one of {', '.join(values)}")

    def number(self, value: Any, where: str, least: int, most: int) -> int:
        found = self.of_kind(value, int, where, "a whole number")
        if not least <= found <= most:
            raise Refused(f"{where} is {shown(found)}; it should be from {least} to {most}")
        return found


READER = Reader()


def counts_of(value: Any, where: str) -> dict[str, tuple[int, int, int]]:
    found = READER.of_kind(value, dict, where, "an object with numbers for each group")
    if not found:
        raise Refused(f"{where} is empty; it should have the groups of the cases that ran")
    counts = {}
    for group, numbers in found.items():
        READER.text(group, f"a key of {where}", GROUP.fullmatch, "a group such as fbm.fixed")
        place = f"{where}.{group}"
        numbers = READER.of_kind(numbers, list, place, "a list of three numbers")
        if len(numbers) != 3:
            raise Refused(f"{place} has {len(numbers)} numbers; it should have three: passed, failed, other")
        counts[group] = tuple(READER.number(number, place, 0, MOST_CASES) for number in numbers)
        if sum(counts[group]) == 0:
            raise Refused(f"{place} counts no case; a group without cases is left out")
    return counts


def bits_of(value: Any, where: str, count: int) -> frozenset[int]:
    digits = -(-count // 4)
    what = f"{digits} hexadecimal digits, with a bit for each of {count} sets"
    text = READER.text(value, where, lambda text: len(text) == digits and re.fullmatch("[0-9a-f]*", text), what)
    sets = frozenset(4 * place + bit for place, digit in enumerate(text) for bit in range(4)
                     if int(digit, 16) & 8 >> bit)
    if sets and max(sets) >= count:
        raise Refused(f"{where} has a bit behind the last set; there are {count}")
    return sets


def part_of(value: Any, where: str, sets: Sets | None) -> Part:
    found = READER.keys(value, where, ("cases", "checksums", "sets", "verdict"))
    counts = counts_of(found["cases"], f"{where}.cases")
    failed = sum(numbers[1] for numbers in counts.values())
    verdict = READER.one_of(found["verdict"], f"{where}.verdict", ("pass", "fail"))
    if (verdict == "fail") != (failed > 0):
        raise Refused(f"{where}.verdict is {shown(verdict)}, and {where}.cases counts {failed} that failed; both "
                      "should agree")
    checksums = READER.of_kind(found["checksums"], dict, f"{where}.checksums", "an object with a checksum for each "
                               "group")
    for group, checksum in checksums.items():
        READER.text(group, f"a key of {where}.checksums", lambda text: GROUP.fullmatch(f"{text}.exact"),
                    "the name of a file of functions, such as fbm")
        READER.text(checksum, f"{where}.checksums.{group}", CHECKSUM.fullmatch, "eight hexadecimal digits")
    if sets is None:
        READER.text(found["sets"], f"{where}.sets", lambda text: re.fullmatch("[0-9a-f]{1,512}", text),
                    "hexadecimal digits")
        return Part(counts, checksums, frozenset())
    return judged(Part(counts, checksums, bits_of(found["sets"], f"{where}.sets", len(sets))), where, sets)


def judged(part: Part, where: str, sets: Sets) -> Part:
    """With the groups that are wrong, by the golden files."""
    groups = {sets.group(number) for number in part.sets}
    for group in sorted(groups ^ set(part.checksums)):
        has, lacks = ("sets", "checksums") if group in groups else ("checksums", "sets")
        raise Refused(f"{where}.{has} has {group}, and {where}.{lacks} has nothing of it; both should have the same")
    wrong = set()
    for group in sorted(groups):
        numbers = [number for number in part.sets if sets.group(number) == group]
        for arithmetic, fixed in (("fixed", True), ("exact", False)):
            seen = sum(sets.is_fixed(number) is fixed for number in numbers)
            passed, failed, _ = part.counts.get(f"{group}.{arithmetic}", (0, 0, 0))
            if seen > passed + failed:
                raise Refused(f"{where}.sets has {seen} sets of {group}.{arithmetic}, and {where}.cases counts "
                              f"{passed + failed} cases that returned something; each set is that of a case")
        right = sets.combined(numbers)
        if part.checksums[group] == right:
            continue
        wrong.add(group)
        if not any(part.counts.get(f"{group}.{arithmetic}", (0, 0, 0))[1] for arithmetic in ("fixed", "exact")):
            raise Refused(f"{where}.checksums.{group} is {part.checksums[group]}, and the golden files give {right}; "
                          f"no case of {group} with that arithmetic failed, so both should be equal")
    return Part(part.counts, part.checksums, part.sets, frozenset(wrong))


def failed_of(value: Any, parts: Mapping[str, Part]) -> tuple[str, ...]:
    found = READER.of_kind(value, list, "failed", "a list of cases")
    counts: dict[str, int] = {}
    for part in parts.values():
        for group, numbers in part.counts.items():
            counts[group] = counts.get(group, 0) + numbers[1]
    if len(found) > MOST_FAILED:
        raise Refused(f"failed has {len(found)} cases; it has {MOST_FAILED} at most")
    for number, case in enumerate(found):
        READER.text(case, f"failed[{number}]", CASE.fullmatch, "the id of a case, as hn-conform list shows it")
        if case in found[:number]:
            raise Refused(f"failed[{number}] is {shown(case)} once more; each case occurs once")
        file, name, arithmetic = CASE.fullmatch(case).groups()
        group = f"{'files' if name == 'all' else file}.{arithmetic}"
        counts[group] = counts.get(group, 0) - 1
        if counts[group] < 0:
            raise Refused(f"failed[{number}] is {shown(case)}, and the digest counts fewer cases of {group} that "
                          "failed")
    if not found and any(counts.values()):
        raise Refused("failed is empty, and cases failed; it should name the first of them")
    return tuple(found)


def costs_of(value: Any) -> dict[str, int]:
    names = [f"{function}.{arithmetic}" for function in TIMED for arithmetic in ("fast", "fixed")]
    found = READER.keys(value, "costs", (UNIT,), [name for name in names if name != UNIT])
    costs = {name: READER.number(number, f"costs.{name}", 1, 1_000_000) for name, number in found.items()}
    if costs[UNIT] != 100:
        raise Refused(f"costs.{UNIT} is {costs[UNIT]}; it is 100, for all others are in percent of it")
    return costs


def digest_of(name: str, found: Any, versions: Mapping[str, Sets]) -> Digest:
    """Of JSON. Earlier is raised if nothing else is wrong."""
    found = READER.keys(found, "the digest", ("apis", "device", "failed", "format", "golden", "system", "version"),
                        ("browser", "costs"))
    READER.text(found["format"], "format", lambda text: text == FORMAT, f'"{FORMAT}"')
    version = READER.one_of(found["version"], "version", versions)
    golden = READER.text(found["golden"], "golden", CHECKSUM.fullmatch, "eight hexadecimal digits")
    sets = versions[version]
    is_earlier = golden != sets.golden
    apis = READER.keys(found["apis"], "apis", (), APIS)
    if not apis or (len(apis) > 1 and set(apis) != set(BROWSER_APIS)):
        raise Refused(f"apis has {shown(', '.join(apis) or 'nothing')}; it has one of {', '.join(APIS)}, or what a "
                      f"page runs together, {' and '.join(BROWSER_APIS)}")
    in_browser = all(api in BROWSER_APIS for api in apis)
    parts = {api: part_of(part, f"apis.{api}", None if is_earlier else sets) for api, part in apis.items()}
    if not any(numbers[0] for part in parts.values() for numbers in part.counts.values()):
        raise Refused("no case passed; such a run proves nothing about a device")
    if in_browser != ("browser" in found):
        raise Refused("browser is missing; a digest of a browser has it" if in_browser else
                      "browser is there, and no API is one of a browser; it should be left out")
    browser = ""
    if in_browser:
        browser = READER.text(found["browser"], "browser", lambda text: text == "unknown" or re.fullmatch(
            rf"(?:{'|'.join(BROWSERS)}) \d{{1,4}}", text), f"one of {', '.join(BROWSERS)} with its version, such as "
            "Firefox 140")
    device = READER.keys(found["device"], "device", ("renderer", "vendor", *(() if in_browser else ("driver",))))
    names = {key: READER.name(value, f"device.{key}") for key, value in device.items()}
    digest = Digest(name=name, version=version, browser=browser, parts=parts,
                    system=READER.one_of(found["system"], "system", SYSTEMS), renderer=names["renderer"],
                    vendor=names["vendor"], driver=names.get("driver", ""), failed=failed_of(found["failed"], parts),
                    costs=costs_of(found["costs"]) if "costs" in found else {})
    if is_earlier:
        raise Earlier(f"golden is {golden}, and that of the golden files of {version} is {sets.golden}; run the suite "
                      "of this version once more")
    return digest


def read(path: Path, versions: Mapping[str, Sets]) -> Digest:
    return digest_of(path.name, parse(bytes_at(path)), versions)
