"""tools/make freeze: the faults that it notices and refuses, and the committed table."""

from __future__ import annotations

import re
import unittest
from collections import defaultdict
from collections.abc import Collection
from unittest import mock

from base.testing import Case, called
from base.tree import FROZEN, ROOT
from catalog.tables.functions import read_functions
from catalog.tables.glsl import declarations
from check.frozen import command, interface, table
from check.frozen.table import ALL, FIRST

PERLIN = ("noise2d.perlin", "lattice+fixed:fixed")
HASHED = ("noise2d.perlin", "fnv1+fixed:fixed")
WORD = ("hash.word", "pcg:exact")
VALUES = {PERLIN: ("11111111", "aaaa0001"), HASHED: ("11111111", "aaaa0002"), WORD: ("22222222", "aaaa0003")}


class Command(Case):
    """With a program that prints a library's values."""
    experimental: Collection[str] = ()

    def setUp(self) -> None:
        self.program, self.table = self.folder / "hn-frozen", self.folder / "frozen.csv"
        self.library = {key: list(sums) for key, sums in VALUES.items()}
        self.interface, self.names = self.folder / "interface.csv", {("default", "octaves"): "6"}

    def write_program(self) -> None:
        """The checksums of all points differ from those of the first."""
        lines = "\n".join(",".join((*key, *sums)) for key, sums in sorted(self.library.items()))
        self.script(self.program, f"""
count=$1; shift
print() {{ if [ "$count" = {ALL} ]; then sed s,aaaa,bbbb,; else cat; fi; }}
if [ $# = 0 ]; then print; else grep "^$1," | print; fi <<end
{lines}
end""")

    def call(self, *arguments: str, version: str = "1.0.0") -> tuple[int, str]:
        self.write_program()
        with mock.patch.object(interface, "library", lambda: self.names), mock.patch.multiple(
                command, version=lambda: version, experimental=lambda: frozenset(self.experimental),
                INTERFACE=self.interface):
            return called(command.main, *arguments, "--program", self.program, "--table", self.table)

    def assert_told(self, pattern: str, *arguments: str, version: str = "1.0.0", status: int = 1) -> None:
        before = self.table.read_text() if self.table.exists() else None
        found, error = self.call(*arguments, version=version)
        self.assertEqual(found, status, error)
        self.assertRegex(error, pattern)
        self.assertEqual(self.table.read_text() if self.table.exists() else None, before, "it was written all the same")

    def assert_right(self, *arguments: str, version: str = "1.0.0") -> None:
        status, error = self.call(*arguments, version=version)
        self.assertEqual(status, 0, error)

    def change_table(self, before: str, after: str) -> None:
        text = self.table.read_text()
        self.assertEqual(text.count(before), 1)
        self.table.write_text(text.replace(before, after))


class Frozen(Command):
    def setUp(self) -> None:
        super().setUp()
        self.assert_right()

    def test_it_is_made_and_checked(self) -> None:
        self.assertEqual(self.table.read_text().splitlines()[1], "hash.word,pcg:exact,1.0.0,22222222,aaaa0003,"
                                                                 "22222222,bbbb0003")
        self.assert_right("--check")
        self.assert_right("--check", "--all", version="1.2.0")

    def test_a_value_that_is_another_is_told_and_stays(self) -> None:
        message = r"\Anoise2d.perlin with lattice\+fixed:fixed: of \d+ points some have other values than those of its entry"
        for before, after, arguments in (("aaaa0001", "aaaa0009", ["--check"]), ("aaaa0001", "aaaa0009", []),
                                         ("bbbb0001", "bbbb0009", ["--check", "--all"])):
            with self.subTest(before, arguments=arguments):
                self.change_table(before, after)
                self.assert_told(rf"{message}, which is frozen since 1.0.0\nA frozen value must not change\. .*another name"
                                 r"\. If you did not, .*-R '\^unit.expected\$' .* freeze --check --all .*\n\Z", *arguments,
                                 version="1.1.0")
                self.change_table(after, before)
        self.assert_right("--check")

    def test_a_name_is_told_and_stays_and_a_new_one_is_added(self) -> None:
        committed = self.interface.read_text()
        self.names = {("default", "octaves"): "5"}
        for arguments in (["--check"], []):
            self.assert_told(r"\Adefault octaves: it was 6, and is 5\. ", *arguments, version="1.1.0")
        self.assertEqual(self.interface.read_text(), committed)
        self.names = {("default", "octaves"): "6", ("form", "hn_new2"): "float hn_new(vec2)"}
        self.assert_told(r"\Aform hn_new2: it has no row\. Run tools/make freeze$", "--check", version="1.1.0")
        self.assert_right(version="1.1.0")
        self.assert_right("--check", version="1.1.0")
        self.interface.unlink()
        self.assert_told("there is no .*interface.csv; tools/make freeze writes it", "--check", status=2)

    def test_nothing_replaces_an_entry(self) -> None:
        for version in ("1.0.0", "1.1.0", "2.0.0", "10.0.0"):
            self.assert_told("the values of hash.word stay, since it is not experimental", "--provisional", "*",
                             version=version, status=2)

    def test_a_new_function_is_told_and_frozen_at_once(self) -> None:
        self.library["noise2d.new", "lattice+fixed:fixed"] = ["33333333", "aaaa0004"]
        self.assert_told(r"\Anoise2d.new with lattice\+fixed:fixed: it has no entry. Run tools/make freeze$", "--check")
        self.assert_right(version="1.1.0")
        self.assert_right("--check", version="1.1.0")
        entries = table.read(self.table)
        self.assertEqual(len(entries), 4)
        self.assertEqual(entries["noise2d.new", "lattice+fixed:fixed"].since, "1.1.0")
        self.assertEqual(entries[PERLIN].since, "1.0.0")

    def test_a_function_has_to_stay(self) -> None:
        del self.library[WORD]
        self.assert_told("no such function any more. It is frozen since 1.0.0, so it has to stay", version="1.1.0")

    def test_other_points_are_told_apart_from_other_values(self) -> None:
        self.library[WORD][0] = "2222222f"
        self.assert_told("hash.word with pcg:exact: the points are others", "--check")

    def test_a_version_that_cannot_be_is_told(self) -> None:
        self.assert_told("frozen since 1.0.0, but the library is 0.9.0", "--check", version="0.9.0")


class Experimental(Command):
    experimental = {WORD[0]}

    def setUp(self) -> None:
        super().setUp()
        self.assert_right()

    def test_its_entry_is_provisional_and_made_anew(self) -> None:
        self.assertEqual({key: entry.since for key, entry in table.read(self.table).items()},
                         {PERLIN: "1.0.0", HASHED: "1.0.0", WORD: "provisional"})
        self.library[WORD][1] = "aaaa0009"
        self.assert_told("hash.word with pcg:exact: .*provisional.*--provisional$", "--check", version="1.1.0")
        self.assert_told("the values of noise2d.perlin stay", "--provisional", "hash.*", "noise2d.perlin", version="1.1.0",
                         status=2)
        self.assert_told("there is no function fbm.*", "--provisional", "hash.word", "fbm.*")
        self.assert_right("--provisional", "hash.*", version="1.1.0")
        self.assert_right("--check", version="1.1.0")

    def test_it_may_go(self) -> None:
        del self.library[WORD]
        for arguments in (["--check"], []):
            self.assert_told("hash.word with pcg:exact: there is no such function any more. Its entry is provisional",
                             *arguments)
        self.assert_right("--provisional", "hash.word")
        self.assertEqual(set(table.read(self.table)), {PERLIN, HASHED})

    def test_one_that_is_ready_is_told_and_frozen(self) -> None:
        self.experimental = set()
        self.assert_told("hash.word with pcg:exact: it is provisional, and the function is not experimental", "--check",
                         version="1.1.0")
        self.change_table("bbbb0003", "bbbb0009")
        self.assert_told("of 1048576 points some have other values", version="1.1.0")
        self.change_table("bbbb0009", "bbbb0003")
        self.assert_right(version="1.1.0")
        self.assertEqual(table.read(self.table)[WORD].since, "1.1.0")

    def test_one_that_is_frozen_is_told(self) -> None:
        self.experimental = {WORD[0], PERLIN[0]}
        self.assert_told("noise2d.perlin with .* frozen since 1.0.0, so catalog/functions.toml cannot", "--check",
                         version="1.1.0")


class Unreadable(Command):
    def test_a_table_that_is_none_is_told(self) -> None:
        self.assert_told("there is no .*frozen.csv; tools/make freeze writes it", "--check", status=2)
        self.assert_right()
        text = self.table.read_text()
        line = text.splitlines(keepends=True)[1]
        for broken, said in ((text.splitlines()[0], "it has no entry"),
                             (text.replace("since", "from", 1), "line 1: it has to be function,"),
                             (text + "a,b\n", "line 5: it has 2 fields in place of 7"),
                             (text + line, "line 5: hash.word with pcg:exact has a line already"),
                             ("\u00e9" + text, "frozen.csv: 'ascii' codec")):
            with self.subTest(said):
                self.table.write_text(broken, encoding="utf-8")
                self.assert_told(f"tools/make freeze: .*{said}", "--check", status=2)

    def test_a_program_that_is_missing_or_fails_is_told(self) -> None:
        for body, said in ((None, "does not run: No such file.*tools/test -N builds it"),
                           ("echo no >&2; exit 3", "ended with status 3: no")):
            with self.subTest(said), mock.patch.object(self, "write_program", lambda: None):
                if body is not None:
                    self.script(self.program, body)
                self.assert_told(f"tools/make freeze: .*{said}", status=2)

    def test_options_that_do_not_go_together_are_told(self) -> None:
        self.assert_told("--all goes with --check", "--all", status=2)
        self.assert_told("a NAME goes with --provisional", "noise2d.perlin", status=2)
        self.assert_told("and --provisional with a NAME", "--provisional", status=2)
        self.assert_told("not allowed with", "--check", "--provisional", status=2)


class Committed(unittest.TestCase):
    """The test frozen.values holds the library to it."""

    def test_what_is_experimental_says_so_everywhere(self) -> None:
        names = {row.calls for row in read_functions() if row.experimental}
        self.assertEqual(names, {"hn_gullies", "hn_perlin_worley", "hn_distribution", "hn_distribution_fbm"})
        self.assertEqual({row.calls for row in read_functions() if row.calls in names and not row.experimental}, set())
        page = (ROOT / "docs" / "reference" / "frozen.md").read_text(encoding="utf-8")
        listed = page.partition("\n## What is experimental\n")[2].partition("\n## ")[0]
        rows = " ".join(line.split("|")[1] for line in listed.splitlines() if line.startswith("| `"))
        self.assertEqual(set(re.findall(r"`(hn_\w+)`", rows)), names)
        said = {one.name for one in declarations() if any("Experimental: " in line for line in one.comment.lines)}
        self.assertEqual(said, names)

    def test_values_depend_on_the_setting_and_points_do_not(self) -> None:
        entries = table.read(FROZEN)
        self.assertEqual(FROZEN.read_text(encoding="ascii"), table.text_of(entries))
        of_function = defaultdict(list)
        for (function, _), entry in entries.items():
            of_function[function].append(entry)
        for function, those in of_function.items():
            for count in (FIRST, ALL):
                points, values = zip(*(entry.sums[count] for entry in those))
                with self.subTest(function, count=count):
                    self.assertEqual(len({*points}), 1)
                    self.assertEqual(len({*values}), len(values))
                    self.assertNotIn("00000000", values)
