"""Tests of tools/measure: the names that it lists are those that it has, and bad usage is refused in one line."""

from __future__ import annotations

import contextlib
import io
import re
import subprocess
import unittest
from collections.abc import Iterable
from pathlib import Path

from base.pieces import was_deleted
from base.tree import TOOLS
from base.usage import Parser

ROOMS = TOOLS / "lib" / "measure"
TABLE = re.compile(r'^table=.*<<<"\\\n(.*?)"\)$', re.MULTILINE | re.DOTALL)


def call(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([TOOLS / "measure", *arguments], capture_output=True, text=True, check=False)


def rows(text: str) -> dict[str, tuple[str, str]]:
    """The program behind each name, and the line of help, by the table in the command."""
    parts = (line.split(maxsplit=2) for line in TABLE.search(text)[1].splitlines())
    return {name: (started, line) for name, started, line in parts if not was_deleted(f"tools/lib/measure/{name}")}


def lost(names: Iterable[str], rooms: Path) -> set[str]:
    """Rows of files that are not there, and files that no row starts."""
    found = {path.stem for path in rooms.glob("*.sh")} | {path.parent.name for path in rooms.glob("*/command.py")}
    return found.union(names) - {name for name in names if name in found or (rooms / f"{name}.py").is_file()}


class Names(unittest.TestCase):
    def setUp(self) -> None:
        self.table = rows((TOOLS / "measure").read_text(encoding="utf-8"))

    def test_help_lists_them_with_a_line_each(self) -> None:
        for word in ("--help", "-h", "help"):
            done = call(word)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            listed = dict(re.findall("^  ([a-z]+) {2,}(.*)$", done.stdout, re.MULTILINE))
            self.assertEqual(listed, {name: line for name, (_, line) in self.table.items()})
            self.assertIn("Exit status:", done.stdout)

    def test_each_is_there_and_nothing_else(self) -> None:
        self.assertEqual(lost(self.table, ROOMS), set())
        started = {started for started, _ in self.table.values()}
        self.assertEqual(started, {"shell", "python", "numpy,scipy", "moderngl,numpy,scipy", "jinja2,moderngl,numpy,scipy"})

    def test_a_lost_one_is_noticed(self) -> None:
        self.assertEqual(lost({*self.table, "taste"}, ROOMS), {"taste"})
        for name in ("clock", "gpu"):
            self.assertEqual(lost({*self.table} - {name}, ROOMS), {name})

    def test_each_explains_itself(self) -> None:
        for name, (started, _) in self.table.items():
            if started == "python":  # commands.setup_test calls the others
                with self.subTest(name):
                    done = call(name, "--help")
                    self.assertEqual((done.returncode, done.stderr), (0, ""))
                    self.assertIn(f"usage: tools/measure {name} ", done.stdout)
                    self.assertIn("Exit status:", done.stdout)


class BadUsage(unittest.TestCase):
    def test_of_names(self) -> None:
        for arguments, message in (((), "a name is missing"), (("",), "a name is missing"),
                                   (("clok",), "there is no clok (did you mean clock?)"),
                                   (("hashs", "--help"), "there is no hashs (did you mean hashes?)"),
                                   (("no such thing",), "there is no no such thing"),
                                   ((".*",), "there is no .*"), (("--out", "x"), "there is no --out")):
            with self.subTest(arguments):
                done = call(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertEqual(done.stderr, f"tools/measure: {message}; tools/measure --help lists the names\n")

    def test_of_what_is_python(self) -> None:
        done = call("gpu", "--filtr", "x")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertEqual(done.stderr, "tools/measure gpu: there is no option --filtr (did you mean --filter?); "
                                      "see tools/measure gpu --help\n")

    def refusal(self, *arguments: str) -> str:
        parser = Parser("tools/measure taste", "")
        parser.add_argument("--out")
        parser.add_argument("--kind", choices=("sweet", "sour"))
        parser.add_argument("--rounds", type=int)
        with contextlib.redirect_stderr(io.StringIO()) as printed, self.assertRaises(SystemExit) as end:
            parser.parse_args(arguments)
        self.assertEqual(end.exception.code, 2)
        return printed.getvalue()

    def test_the_nearest_right_name_is_told(self) -> None:
        hint = "; see tools/measure taste --help\n"
        for arguments, message in ((("--ot=x",), f"there is no option --ot (did you mean --out?){hint}"),
                                   (("--wombat", "x"), f"there is no option --wombat{hint}"),
                                   (("--rounds", "x"), f"argument --rounds: invalid int value: 'x'{hint}"),
                                   (("more",), f"more is one word too many{hint}")):
            with self.subTest(arguments):
                self.assertEqual(self.refusal(*arguments), f"tools/measure taste: {message}")
        self.assertRegex(self.refusal("--kind", "swet"),
                         r"--kind: invalid choice: 'swet' .*\(did you mean sweet\?\); .*\n\Z")
