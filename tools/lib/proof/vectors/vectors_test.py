"""The vectors are right, docs/develop/porting.md shows how to read them, and a wrong port is found."""

from __future__ import annotations

import contextlib
import copy
import functools
import io
import json
import math
import re
import struct
import tempfile
import unittest
from collections.abc import Callable, Iterator
from pathlib import Path
from unittest import mock

from base.thorough import THOROUGH
from base.tree import GOLDEN, ROOT
from catalog.tables.configurations import read_configurations
from catalog.tables.functions import read_functions
from proof.vectors import choice, command, files

PAGE = (ROOT / "docs" / "develop" / "porting.md").read_text(encoding="utf-8")
CHECKER, PORT = re.findall(r"^```python\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
NUMBER = re.compile(r"0x[0-9A-F]+|(?<=2\*\*)24|(?<=>> )\d+|\b2 (?=\* a)|\b1\b(?=\) \* 4097)|4097")


@functools.cache
def folder() -> Path:
    return files.vectors_folder()


@functools.cache
def read(name: str) -> dict:
    return json.loads((folder() / name).read_text(encoding="ascii"))


def all_groups() -> Iterator[tuple[dict, dict]]:
    for listed in read(files.INDEX)["files"]:
        file = read(listed["file"])
        for group in file["settings"]:
            yield file, group


def checker() -> Callable:
    defined: dict = {}
    exec(compile(CHECKER, "docs/develop/porting.md", "exec"), defined)  # the page's own text
    return defined["faults"]


def said_by(port: str) -> str:
    """The output of the page's program with a port."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.chdir(folder().parent):
        exec(compile(CHECKER + port, "docs/develop/porting.md", "exec"), {})
    return out.getvalue()


class Port(unittest.TestCase):
    def test_that_of_the_page_is_right(self) -> None:
        self.assertEqual(said_by(PORT), "")

    def test_it_is_told_of_each_number_that_is_wrong(self) -> None:
        places = list(NUMBER.finditer(PORT))
        self.assertEqual(len(places), 17)
        for place in places:
            number = int(place[0], 0)
            broken = f"{PORT[:place.start()]}{number ^ 2 if number > 2 else number + 1} {PORT[place.end():]}"
            with self.subTest(place[0], at=place.start()):
                self.assertRegex(said_by(broken), r"\A(\[-?\d+, -?\d+, \d+\]: 0x\w+ where 0x\w+ is right\n)+\Z")

    def test_the_checker_is_short(self) -> None:
        self.assertLess(len(CHECKER.strip().splitlines()), 14)


class Replayed:
    """A port that returns the values of the file, and at one row something else."""

    def __init__(self, rows: list[dict], wrong: int | None = None, change: Callable = lambda x: x):
        self.results = iter([tuple(map(change, row["out"])) if i == wrong else tuple(row["out"])
                             for i, row in enumerate(rows)])

    def __call__(self, *inputs: float) -> tuple[float, ...]:
        return next(self.results)


class Checker(unittest.TestCase):
    def test_it_reports_the_row_that_is_wrong(self) -> None:
        faults = checker()
        for number, (file, group) in enumerate(all_groups()):
            if number % 7 and not THOROUGH:
                continue
            rows = group["rows"]
            wrong = number % len(rows)
            bound = max(rows[wrong].get("bound", [0]))
            are_words = max(map(abs, rows[wrong]["out"])) >= 2**24
            step = 1.01 * bound or (2.0**-24 if group["arithmetic"] == "fixed" and not are_words else 1)
            with self.subTest(file["function"], setting=group["name"]):
                self.assertEqual(list(faults(folder(), file["function"], Replayed(rows), group["name"])), [])
                for change in (lambda x: x + step, lambda x: math.nan, lambda x: math.inf)[:1 if number % 70 else 3]:
                    found = faults(folder(), file["function"], Replayed(rows, wrong, change), group["name"])
                    self.assertEqual([row for row, _ in found], [rows[wrong]])


def rows_that_are_not_golden(file: dict) -> list[dict]:
    """The rows whose words have other values in the golden file."""
    lines = (GOLDEN / f"{file['function']}.golden").read_text(encoding="ascii").split("\n")
    settings = next(line for line in lines if line.startswith("settings ")).split(" ")[1:]
    named = [setting.split(":")[0] for setting in settings]
    rows: dict[str, list[list[str]]] = {}  # some stand there twice, for fixed arithmetic alone the second time
    for words, *values in (line.split(" = ") for line in lines if " = " in line):
        rows.setdefault(words, []).append(values)
    kinds = [column["type"] for column in file["outputs"]]

    def is_golden(row: dict, group: int) -> bool:
        found = [values[group].split(" ") for values in rows.get(row["words"], ()) if values[group] != "-"]
        return any(row["out"] == [files.meaning(kind, int(word, 16)) for kind, word in zip(kinds, values)]
                   for values in found)

    return [row for group in file["settings"] for row in group["rows"]
            if not is_golden(row, named.index(group["name"]))]


class Files(unittest.TestCase):
    def test_every_function_has_one(self) -> None:
        listed = {one["file"] for one in read(files.INDEX)["files"]}
        self.assertEqual(listed, {f"{function.id}.json" for function in read_functions()})
        self.assertEqual({path.name for path in folder().iterdir()}, listed | {files.INDEX})

    def test_each_arithmetic_has_as_many_rows_as_it_says(self) -> None:
        for file, group in all_groups():
            with self.subTest(file["function"], setting=group["name"]):
                few = file["function"].startswith("noise4d.") and len(group["rows"]) > 40
                self.assertTrue(len(group["rows"]) == choice.COUNT or few, len(group["rows"]))
                zeros = sum(not any(row["out"]) for row in group["rows"])
                self.assertLess(zeros, choice.COUNT / 3)
        names = [{group["name"] for group in read(f"{name}.json")["settings"]}
                 for name in ("noise2d.perlin", "hash.lattice2")]
        hashes = {one.hash for one in read_configurations()} - {"custom"}
        self.assertEqual(names, [{"lattice", "lattice+fixed", "lattice+sine", "lattice+sine+fixed"}, hashes])

    def test_numbers_are_exact_and_said_twice(self) -> None:
        for file, group in all_groups():
            for row in group["rows"]:
                words = [int(word, 16) for word in row["words"].split()]
                for column, word, value in zip(file["inputs"], words, row["in"], strict=True):
                    code = {"f32": ">f", "i32": ">i", "u32": ">I"}[column["type"]]
                    if struct.pack(code, value) != word.to_bytes(4, "big") or struct.unpack(
                            code, word.to_bytes(4, "big"))[0] != value:
                        self.fail(f"{file['function']}: {value} is not {word:08x}")
                for value, units, unit in zip(row["out"], row.get("units", ()), group.get("units", ())):
                    if units * 2.0**unit != value or struct.unpack(">f", struct.pack(">f", value))[0] != value:
                        self.fail(f"{file['function']}: {units} units are not {value}")
                allowed = max(row.get("bound", [0]))
                if ("bound" in row) != (group["arithmetic"] == "fast") or allowed > files.LARGEST_BOUND:
                    self.fail(f"{file['function']}: {row}")

    def test_values_are_those_of_the_golden_files(self) -> None:
        for listed in read(files.INDEX)["files"]:
            wrong = rows_that_are_not_golden(read(listed["file"]))
            self.assertEqual(wrong[:3], [], f"{len(wrong)} rows of {listed['file']}")

    def test_a_value_that_is_not_golden_is_noticed(self) -> None:
        for name, at in (("noise2d.perlin_d", 2), ("hash.lattice2", 0), ("position.fraction2", 1)):
            changed = copy.deepcopy(read(f"{name}.json"))
            row = changed["settings"][-1]["rows"][17]
            row["out"][at] += 2**-21 if isinstance(row["out"][at], float) else 1
            other = changed["settings"][0]["rows"][3]
            other["words"] = other["words"].replace("0", "7")
            self.assertEqual(rows_that_are_not_golden(changed), [other, row], name)

    def test_the_page_shows_their_form(self) -> None:
        shown = json.loads(re.search(r"^```json\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)[1])
        file = read("noise2d.perlin.json")
        self.assertEqual([*shown], [*file])
        for ours in shown["settings"]:
            there, = [one for one in file["settings"] if one["name"] == ours["name"]]
            self.assertEqual(([*ours], [*ours["rows"][0]]), ([*there], [*there["rows"][0]]))

    def test_there_is_a_unit_for_what_is_fixed(self) -> None:
        for file, group in all_groups():
            if group["arithmetic"] == "fixed" and file["outputs"][0]["type"] == "f64":
                with self.subTest(file["function"]):
                    self.assertTrue(all(-24 <= unit <= -16 for unit in group["units"]))
                    odd = [sum(row["units"][i] % 2 for row in group["rows"]) for i in range(len(group["units"]))]
                    self.assertLess(0, min(odd) + max(odd))

    def test_points_are_where_ports_go_wrong(self) -> None:
        for file, group in all_groups():
            rows = [dict(zip((column["name"] for column in file["inputs"]), row["in"])) for row in group["rows"]]
            with self.subTest(file["function"], setting=group["name"]):
                if "x" in rows[0] and file["inputs"][0]["type"] == "f32":
                    negative = {choice.kind_of(row["x"]) for row in rows if row["x"] < 0}
                    self.assertLessEqual({"whole", "inside"}, negative)
                if "cx" in rows[0] and "octaves" not in rows[0]:
                    ends = {-2**31, 2**31 - 1} & {row["cx"] for row in rows}
                    self.assertGreaterEqual(len(ends), 1 if file["function"].startswith("noise4d.") else 2)
                    if "fx" in rows[0]:
                        self.assertLessEqual({0.0, 1.0}, {row["fx"] for row in rows})
                if "px" in rows[0]:
                    cells = [(cell, period) for row in rows for axis, period, cell in choice.periods_of(row)]
                    self.assertTrue(any(cell == 0 < period - 1 for cell, period in cells), "behind a seam")
                    self.assertTrue(any(cell == period - 1 > 0 for cell, period in cells), "before a seam")
                    self.assertTrue(any(row["px"] <= 0 for row in rows), "no period")
                if "seed" in rows[0]:
                    self.assertLessEqual({0, 1, 2**32 - 1}, {row["seed"] for row in rows})

    def test_a_row_that_nothing_else_is_like_is_chosen(self) -> None:
        rows = [choice.features({"x": 0.25 + i % 7, "seed": 5}) for i in range(400)]
        rows[333] = choice.features({"x": -2.0**25, "seed": 2**32 - 1})
        self.assertIn(333, choice.chosen(rows, [[0.5]] * 400))
        self.assertEqual(len(choice.chosen(rows, [[0.5]] * 400)), choice.COUNT)
        zeros = choice.chosen(rows, [[0.0 if i % 2 else 0.5] for i in range(400)])
        self.assertLessEqual(sum(i % 2 for i in zeros), choice.ZERO)
        self.assertEqual(len(zeros), choice.COUNT)


class Command(unittest.TestCase):
    def test_a_program_that_is_missing_or_wrong_is_told(self) -> None:
        for program, said in (("none.cpp", "does not compile.*apt-get install g"),
                              ("wrong.cpp", r"wrong.cpp ended with status 0, and answered 1 of 2 questions")):
            scratch = Path(self.enterContext(tempfile.TemporaryDirectory()))
            (scratch / "wrong.cpp").write_text('#include <cstdio>\nint main() { std::puts("1"); }\n')
            with self.subTest(program), mock.patch.object(files, "PROGRAM", scratch / program), \
                    self.assertRaisesRegex(files.NoVectors, f"(?s){said}"):
                files.asked(["one", "other"])

    def test_where_there_are_none_the_status_is_4(self) -> None:
        error = io.StringIO()
        with mock.patch.object(command, "vectors_folder", side_effect=files.NoVectors("there is no g++")), \
                contextlib.redirect_stderr(error), self.assertRaises(SystemExit) as ended:
            command.main([])
        self.assertEqual((ended.exception.code, error.getvalue()), (4, "tools/make vectors: there is no g++\n"))
