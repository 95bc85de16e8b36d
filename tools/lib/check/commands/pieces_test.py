"""Each piece of base.pieces can be deleted, and all of them: the rest works.

    python3 -B -m check.commands.pieces_test FOLDER [PIECE...]     makes copies of the tree in the folder, in an hour

By default no module of Python imports one of a piece. In copies: without each piece a copy is configured, each test that
is registered has its files, and the tests of LISTS pass; without all pieces, and with a PIECE in place of that without
this one, a copy is built and passes all its tests.

Exit status: 0 it works, 1 it does not.
"""

from __future__ import annotations

import ast
import functools
import json
import re
import shutil
import subprocess
import sys
import unittest
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from unittest import mock

from base import pieces
from base.pieces import PIECES
from base.tree import ROOT, files

CONTRIBUTING = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
# They read lists of files, links, rooms, and what packages have.
LISTS = ("base.rooms_test", "catalog.catalog_test", "check.frozen.interface_test.Interface.test_the_library_is_as_in_the_committed_table",
         "check.make.make_test.Table", "ship.packing_test", "ship.pages.pages_test.Readme", "ship.website.website_test")


def outer_imports(text: str) -> Iterator[str]:
    """The modules that a module imports when it is imported, and names in them."""
    left: list[ast.AST] = [*ast.parse(text).body]
    while left:
        node = left.pop()
        if isinstance(node, ast.ImportFrom):
            yield from (node.module or "", *(f"{node.module}.{name.name}" for name in node.names))
        elif isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif not isinstance(node, ast.FunctionDef) and getattr(getattr(node, "test", None), "id", "") != "TYPE_CHECKING":
            left += [child for child in ast.iter_child_nodes(node) if isinstance(child, ast.stmt)]


@functools.cache
def modules() -> dict[str, set[str]]:
    return {name: {*outer_imports((ROOT / name).read_text(encoding="utf-8"))}
            for name in files() if name.startswith("tools/lib/") and name.endswith(".py")}


def needed(piece: str) -> list[str]:
    """The imports of modules of a piece by others. An import in a function is for code that runs where there is one."""
    inside = pieces.files_of(piece, modules())
    names = {name.removeprefix("tools/lib/").removesuffix(".py").replace("/", ".") for name in inside}
    return [f"{file} imports {name}" for file, imported in modules().items() if file not in inside
            for name in sorted(names & imported)]


def copy(names: Iterable[str], folder: Path) -> Path:
    """The tree without these pieces, in a folder that keeps the build of an earlier copy."""
    gone = {file for name in names for file in pieces.files_of(name, files())}
    for path in folder.glob("*"):
        if path.name != "build":
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    for file in files():
        if file not in gone:
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / file, folder / file)  # of the same age, so that little is built anew
    return folder


def run(command: Sequence[str | Path], folder: Path) -> list[str]:
    """The output of a command that fails."""
    done = subprocess.run(command, cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return done.stdout.splitlines() if done.returncode else []


def configured(tree: Path) -> list[str]:
    return run(["cmake", "-S", ".", "-B", "build", "-G", "Ninja"], tree)


def lost_tests(tree: Path) -> list[str]:
    """Files and modules of registered tests that are not there."""
    shown = subprocess.run(["ctest", "--show-only=json-v1", "-C", "Thorough"], cwd=tree / "build", capture_output=True,
                           check=True).stdout
    lost = []
    for test in json.loads(shown)["tests"]:
        words = test.get("command", [])
        modules = [word for option, word in zip(words, words[1:]) if option == "-m" and "." in word]
        paths = [tree / "tools" / "lib" / f"{module.replace('.', '/')}.py" for module in modules]
        paths += [Path(word) for word in words if word.startswith(f"{tree}/") and not word.startswith(f"{tree}/build/")]
        lost += [f"{test['name']}: there is no {path}" for path in paths if not path.exists()]
    return lost


def listed(tree: Path, tests: Sequence[str] = LISTS) -> list[str]:
    return run([tree / "tools/lib/base/scientific-python", "--with", "jinja2,numpy,scipy", "-B", "-m", "unittest", *tests],
               tree / "tools" / "lib")


class Table(unittest.TestCase):
    def test_each_path_is_there(self) -> None:
        for name, paths in PIECES.items():
            if not pieces.is_deleted(name):
                for path in paths:
                    self.assertTrue((ROOT / path).exists() or pieces.was_deleted(path), f"{name}: {path}")

    def test_a_page_was_deleted_if_its_piece_was(self) -> None:
        self.assertFalse(pieces.was_deleted("docs/guide/no-such-page.md"))
        with mock.patch.dict(PIECES, {"gone": ("docs/guide/no-such-page.md", "no-such-folder")}):
            for path in ("docs/guide/no-such-page.md", "no-such-folder/README.md"):
                self.assertTrue(pieces.was_deleted(path))
            self.assertFalse(pieces.was_deleted("docs/guide/no-such-page.mds"))
        with mock.patch.dict(PIECES, {"there": ("docs/guide/no-such-page.md", "tools/pick")}):
            self.assertFalse(pieces.was_deleted("docs/guide/no-such-page.md"))

    def test_nothing_imports_a_piece(self) -> None:
        for name in PIECES:
            self.assertEqual(needed(name), [])
        with mock.patch.dict(PIECES, {"needed": ("tools/lib/translate/names.py",)}):
            self.assertIn("tools/lib/translate/wgsl/module.py imports translate.names", needed("needed"))

    @unittest.skipIf(any(map(pieces.is_deleted, PIECES)), "something was deleted")
    def test_the_page_has_the_size_of_the_rest(self) -> None:
        """Within a tenth, so that not each change changes the page."""
        said, now = (list(map(int, re.search(r"([\d,]+) lines of code,? (?:and )?([\d,]+) of tests", text.replace(",", ""))
                              .groups())) for text in (CONTRIBUTING, pieces.lines_of(pieces.rest())))
        for one, other in zip(said, now, strict=True):
            self.assertLess(abs(one - other), other / 10, f"CONTRIBUTING.md states {said}, and it is {now}")


@unittest.skipUnless(__name__ == "__main__", "the test commands.pieces makes copies")
class Copies(unittest.TestCase):
    folder: Path
    named: Sequence[str] = ()

    def test_without_each(self) -> None:
        for name in () if self.named else PIECES:
            with self.subTest(name):
                tree = copy([name], self.folder / "one")
                for found in (configured(tree) or lost_tests(tree), listed(tree)):
                    self.assertEqual(found, [], "\n".join(found))

    def test_the_whole(self) -> None:
        for names in [[name] for name in self.named] or [[*PIECES]]:
            with self.subTest(names):
                tree = copy(names, self.folder / "whole")
                self.assertEqual(found := run([tree / "tools" / "test"], tree), [], "\n".join(found))

    def test_something_that_the_rest_needs(self) -> None:
        for path, look, said in () if self.named else (
                ("conformance/report", configured, "The room cli cannot see report"),
                ("examples/examples_test.py", lambda tree: configured(tree) or lost_tests(tree),
                 "examples.webgl: there is no "),
                ("docs/guide/random.md", lambda tree: listed(tree, ["ship.pages.pages_test.Readme"]),
                 "README.md: docs/guide/random.md")):
            with self.subTest(path), mock.patch.dict(PIECES, {"needed": (path,)}):
                self.assertIn(said, "\n".join(look(copy(["needed"], self.folder / "one"))))


if __name__ == "__main__":
    Copies.folder, Copies.named = Path(sys.argv[1]).resolve(), sys.argv[2:]
    for name in ("one", "whole"):
        (Copies.folder / name).mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1], verbosity=2)
