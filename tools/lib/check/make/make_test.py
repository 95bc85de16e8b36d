"""Tests of tools/make: its table, and that it makes the stale parts alone."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Iterable, Iterator
from pathlib import Path

from base.pieces import PIECES, is_deleted
from base.testing import Case
from base.tree import ROOT
from check.make import command, graph
from check.make.parts import PARTS, Part

MADE = [part for part in PARTS if not part.by_name]
FOLDERS = ("catalog", "conformance", "docs", "glsl", "include", "packages", "playground", "src")
TEXTS = (".cpp", ".glsl", ".h", ".hpp", ".inc", ".js", ".md", ".py", ".pyi", ".ts")
# The note at the top of a made file, and around a made part.
AT_THE_TOP = re.compile(r"(?:Made|Written)(?: from \S+)? by tools/make\b(?: (\w+))?"
                        r"|`tools/make (\w+)` (?:makes|writes) this")
MARK = re.compile(r"^(?://|#|<!--|  //) ?tools/make (\w+): (?!end\b)", re.MULTILINE)


def marks(text: str) -> Iterator[str]:
    """The parts that a file names as its makers; an empty name if it names none."""
    if found := AT_THE_TOP.search("\n".join(text.splitlines()[:5])):
        yield found[1] or found[2] or ""
    yield from MARK.findall(text)


def unmade(files: Iterable[Path], parts: Iterable[Part] = MADE) -> list[str]:
    """Files that name tools/make as their maker, and are no product of a part."""
    products = {part.name: graph.found(part.products) for part in parts}
    wrong = []
    for path in files:
        for name in marks(path.read_text(encoding="utf-8")):
            written = products.get(name, set()) if name else set().union(*products.values())
            if name == "catalog":  # whose marks dimensions takes into other dimensions
                written = written | products.get("dimensions", set())
            if path not in written:
                wrong.append(f"{path.name}: {name}")
    return wrong


def texts() -> Iterator[Path]:
    for path in (*ROOT.glob("*.md"), *(path for folder in FOLDERS for path in (ROOT / folder).rglob("*"))):
        if path.suffix in TEXTS and path.is_file():
            yield path


def backward(parts: list[Part]) -> list[str]:
    """Parts that read the products of a part below them: among them would be every cycle."""
    reads = [graph.inputs(part) for part in parts]
    written = [graph.found(part.products) for part in parts]
    return [f"{part.name} reads what {other.name} writes" for number, part in enumerate(parts)
            for below, other in enumerate(parts[number + 1:], number + 1) if written[below] & reads[number]]


class Table(unittest.TestCase):
    def test_no_part_reads_what_one_below_it_writes(self) -> None:
        self.assertEqual(backward(MADE), [])
        self.assertIn("snippets reads what dimensions writes", backward(MADE[::-1]))

    def test_what_a_part_waits_for(self) -> None:
        waits = {name: [other.name for other in others] for name, others in graph.needs(MADE).items()}
        for part, others in (("dimensions", ["catalog"]), ("bounds", ["catalog", "dimensions"]),
                             ("freeze", ["dimensions"]), ("snippets", ["dimensions"]), ("pages", ["dimensions"])):
            with self.subTest(part):
                self.assertLessEqual(set(others), set(waits[part]))
        self.assertEqual(waits["catalog"], [])

    def test_what_says_that_it_is_made_is_made_by_a_part(self) -> None:
        self.assertEqual(unmade(texts()), [])
        self.assertGreater(sum(len(list(marks(path.read_text(encoding="utf-8")))) for path in texts()), 50)

    def test_a_file_that_no_part_makes_is_told(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            for text in ("// Made by tools/make.\n", "// Made from a.glsl by tools/make. More.\n",
                         "// Made by tools/make catalog: rows.\n", "`tools/make faults` writes this page.\n",
                         "a\n<!-- tools/make pages: typical values -->\n", "# tools/make catalog: names\n"):
                with self.subTest(text):
                    path = Path(folder, "a.md")
                    path.write_text(text)
                    self.assertEqual(len(unmade([path])), 1)
            path.write_text("// tools/make catalog: end\nRun `tools/make golden`.\n")
            self.assertEqual(unmade([path]), [])
        page = ROOT / "docs" / "measured" / "accuracy.md"
        self.assertEqual(unmade([page]), [])
        self.assertNotEqual(unmade([page], [part for part in MADE if part.name != "bounds"]), [])

    def test_each_file_in_a_folder_of_made_files_is_made(self) -> None:
        products = set().union(*(graph.found(part.products) for part in MADE))
        for pattern in ("conformance/expected/golden/*", "docs/reference/snippets/*", "docs/guide/gallery/*"):
            files = {path for path in ROOT.glob(pattern) if path.is_file()}
            self.assertGreater(len(files), 10)
            self.assertEqual(files - products, set())
        for file in ("conformance/expected/bounds.inc", "conformance/expected/frozen.csv",
                     "conformance/expected/interface.csv"):
            self.assertIn(ROOT / file, products)

    @unittest.skipIf(any(map(is_deleted, PIECES)), "something was deleted")
    def test_every_pattern_finds_something(self) -> None:
        for part in MADE:
            for pattern in (*part.inputs, *part.products):
                with self.subTest(part.name, pattern=pattern):
                    self.assertTrue(graph.found([pattern]) or pattern.startswith("build/") or "versions" in pattern)

    def test_the_code_of_a_part_is_an_input(self) -> None:
        golden = graph.inputs(next(part for part in PARTS if part.name == "golden"))
        for file in ("proof/golden/command.py", "proof/oracle/sums.py", "proof/oracle/noises/perlin.py",
                     "catalog/tables/functions.py"):
            self.assertIn(ROOT / "tools" / "lib" / file, golden)
        self.assertEqual([path for path in golden if path.stem.endswith("_test")], [])

    def test_of_a_page_what_stands_between_its_marks_counts(self) -> None:
        pages = next(part for part in PARTS if part.name == "pages")
        page = (b"a\n<!-- tools/make pages: x -->\nb\n<!-- end -->\nc\n"
                b"<!-- tools/make catalog: y -->\nd\n<!-- end -->\n")
        self.assertEqual(graph.own(pages, page), b"b\n")
        self.assertEqual(graph.own(pages, b"no mark\n"), b"no mark\n")
        catalog = next(part for part in PARTS if part.name == "catalog")
        self.assertEqual(graph.own(catalog, b"// tools/make catalog: x\na\n// tools/make catalog: end\nb\n"), b"a\n// ")


TOY = '''
PARTS = (Part("one", "the first", "no time", "toy.one", ("in/*.txt",), ("out/one",)),
         Part("two", "the second", "no time", "toy.two", (), ("out/two",){two}),
         Part("three", "the third", "no time", "toy.three", (), ("out/three",), by_name=True, check=()))
PARTS = (PARTS[0], PARTS[1]._replace(inputs=("out/one",)), PARTS[2])
'''
MODULE = '''
import sys
from pathlib import Path
ROOT = Path(__file__).resolve().parents[3]
def main(arguments):
    text = "".join(path.read_text() for path in sorted(ROOT.glob({source!r}))){changed}
    out = ROOT / "out" / {name!r}
    if "--check" in arguments:
        right = out.is_file() and out.read_text() == text
        print("" if right else "{name} is another")
        return 0 if right else 1
    if "bad" in text:
        print("{name} cannot be made")
        return 1
    (ROOT / "calls").open("a").write("{name} ")
    out.write_text(text)
    return 0
'''


class Toy(Case):
    """A repository in which out/one is in/*.txt in capitals, and out/two is the first line of that."""

    def setUp(self) -> None:
        self.root = self.folder
        for file in ("tools/make", *(f"tools/lib/{name}" for name in (
                "base/ending.py", "base/needs.py", "base/modules.py", "base/tree.py", "base/usage.py",
                "check/make/command.py", "check/make/graph.py", "check/make/parts.py",
                "catalog/copies.py"))):
            self.put(file, (ROOT / file).read_text())
        (self.root / "tools/make").chmod(0o755)
        self.parts()
        for name, source, changed in (("one", "in/*.txt", ".upper()"), ("two", "out/one", ".split()[0]"),
                                      ("three", "in/*.txt", "")):
            self.put(f"tools/lib/toy/{name}.py", MODULE.format(name=name, source=source, changed=changed))
        self.put("in/a.txt", "a b\n")
        self.put("out/one", "A B\n")
        self.put("out/two", "A")

    def put(self, file: str, text: str) -> None:
        path = self.root / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def parts(self, two: str = "") -> None:
        real = (ROOT / "tools/lib/check/make/parts.py").read_text().partition("\nPARTS = (")[0]
        self.put("tools/lib/check/make/parts.py", real + TOY.format(two=two))

    def make(self, *arguments: str, status: int = 0) -> tuple[str, str]:
        """Which parts were made, and the output."""
        (self.root / "calls").write_text("")
        done = subprocess.run([sys.executable, "-B", self.root / "tools/make", *arguments], capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return (self.root / "calls").read_text().strip(), done.stdout + done.stderr

    def test_in_a_new_clone_nothing_is_made_that_is_right(self) -> None:
        made, said = self.make()
        self.assertEqual((made, said), ("", "one: it is as it should be\ntwo: it is as it should be\n"
                                            "Everything is as it should be.\n"))
        self.assertEqual(self.make(), ("", "Everything is as it should be.\n"))

    def test_in_a_new_clone_what_is_wrong_is_made(self) -> None:
        self.put("out/two", "B")
        made, said = self.make()
        self.assertEqual(made, "two")
        self.assertIn("two: two is another. It takes no time\ntwo: it wrote out/two\n", said)

    def test_what_is_made_of_a_change_is_made_in_order(self) -> None:
        self.make()
        self.put("in/a.txt", "c b\n")
        self.put("in/b.txt", "\n")
        made, said = self.make()
        self.assertEqual(made, "one two")
        self.assertEqual(said, "one: in/a.txt changed, and 1 more. It takes no time\none: it wrote out/one\n"
                               "two: out/one changed. It takes no time\ntwo: it wrote out/two\n"
                               "Everything is as it should be.\n")
        self.assertEqual(self.make()[0], "")

    def test_what_did_not_become_another_makes_nothing_stale(self) -> None:
        self.make()
        self.put("in/a.txt", "A B\n")
        made, said = self.make()
        self.assertEqual(made, "one")
        self.assertIn("one: nothing changed\n", said)

    def test_a_product_that_somebody_changed_is_stale(self) -> None:
        self.make()
        self.put("out/two", "B")
        self.assertIn("two is stale:\n  two is another\n", self.make("--check", status=1)[1])
        made, said = self.make()
        self.assertEqual(made, "two")
        self.assertIn("two: out/two changed.", said)
        self.assertEqual((self.root / "out/two").read_text(), "A")
        (self.root / "out/two").unlink()
        self.assertIn("two: out/two is gone.", self.make()[1])

    def test_a_change_that_is_taken_back_makes_nothing(self) -> None:
        self.make()
        self.put("out/two", "B")
        self.make("--check", status=1)
        self.put("out/two", "A")
        self.assertEqual(self.make(), ("", "Everything is as it should be.\n"))

    def test_code_that_changed_makes_a_part_stale(self) -> None:
        self.make()
        file = self.root / "tools/lib/toy/two.py"
        file.write_text(file.read_text() + "# more\n")
        self.assertEqual(self.make()[0], "two")

    def test_what_waits_for_a_part_that_fails_is_not_made(self) -> None:
        self.make()
        self.put("in/a.txt", "bad\n")
        self.put("tools/lib/toy/one.py", (self.root / "tools/lib/toy/one.py").read_text().replace('"bad"', '"BAD"'))
        made, said = self.make(status=1)
        self.assertEqual(made, "")
        self.assertIn("one cannot be made\n", said)
        self.assertIn("tools/make: these are not made: one\n", said)
        self.put("in/a.txt", "good\n")
        self.assertEqual(self.make()[0], "one two")

    def test_a_check_makes_nothing(self) -> None:
        self.put("in/a.txt", "c\n")
        made, said = self.make("--check", status=1)
        self.assertEqual(made, "")
        self.assertIn("one is stale:\n  one is another\n", said)
        self.assertNotIn("two is stale", said)
        self.assertEqual(self.make("--check", "two")[0], "")
        self.assertEqual((self.root / "out/one").read_text(), "A B\n")
        self.assertEqual(self.make()[0], "one two")
        self.assertEqual(self.make("--check"), ("", ""))  # nobody has to compare

    def test_a_sample_is_no_proof(self) -> None:
        self.parts(two=", sample=True")
        for _ in range(2):
            self.assertIn("two: comparing", self.make("--check")[1])
        self.make()
        self.assertEqual(self.make("--check"), ("", ""))

    def test_what_asks_a_program_that_is_not_there_is_left_out_of_a_check(self) -> None:
        self.parts(two=", program='hn-frozen'")
        self.put("out/two", "B")
        self.assertIn("two: nobody looked: it runs hn-frozen, which tools/test -N builds\n", self.make("--check")[1])
        self.put("tools/test", "#!/bin/sh\nexit 4\n")
        (self.root / "tools/test").chmod(0o755)
        made, said = self.make(status=1)
        self.assertEqual(made, "")
        self.assertIn("tools/make: two: it runs hn-frozen", said)
        self.assertIn("tools/make: these are not made: two\n", said)

    def test_a_part_that_is_named_is_made(self) -> None:
        self.assertEqual(self.make("two")[0], "two")
        self.assertEqual(self.make("three")[0], "three")
        made, said = self.make("two", "one")
        self.assertEqual(made, "one two")
        self.assertEqual(self.make("--check"), ("", ""))  # they were made just now

    def test_bad_usage_is_one_line(self) -> None:
        for arguments, said in ((("tow",), "part tow (did you mean two?)"), (("nonsense",), "part nonsense"),
                                (("--chekc",), "option --chekc (did you mean --check?)"),
                                (("--check", "on"), "part on (did you mean one?)")):
            with self.subTest(arguments):
                self.assertEqual(self.make(*arguments, status=2),
                                 ("", f"tools/make: there is no {said}; tools/make --help lists them\n"))

    def test_help_lists_the_parts(self) -> None:
        for word in ("--help", "-h", "help"):
            made, said = self.make(word)
            self.assertIn("\n    two        the second\n    three      the third; only where it is named\n", said)
            self.assertIn("Exit status: 0 ", said)


class Help(unittest.TestCase):
    def test_each_part_tells_its_options_without_running(self) -> None:
        for part in PARTS:
            if part.scientific:
                continue  # its Python may have to be installed first
            with self.subTest(part.name):
                done = subprocess.run([sys.executable, "-B", ROOT / "tools/make", part.name, "--help"],
                                      capture_output=True, text=True, check=False)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertRegex(done.stdout, rf"usage: tools/make {part.name} ")
                self.assertIn("Exit status: 0 ", done.stdout)

    def test_they_are_listed(self) -> None:
        for part in PARTS:
            self.assertIn(f"\n    {part.name:10} {part.what}", command.described().join("\n\n"))

    @unittest.skipUnless(shutil.which("ninja"), "there is no ninja")
    def test_ninja_takes_the_graph(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "build.ninja").write_text(graph.graph(MADE))
            done = subprocess.run(["ninja", "-C", folder, "-t", "targets", "all"], capture_output=True, text=True,
                                  check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        for part in MADE:
            self.assertIn(f"{part.name}.made: make\n", done.stdout)
        order = [part.program for name in re.findall(r"^build (\S+)\.made", graph.graph(MADE), re.MULTILINE)
                 for part in MADE if part.name == name]
        self.assertEqual(order, sorted(order, key=bool), "what needs a build comes last")
