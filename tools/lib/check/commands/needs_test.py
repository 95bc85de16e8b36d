"""Which Python the commands need: what users call runs by 3.9, and one that is too old gets one line."""

from __future__ import annotations

import ast
import functools
import os
import re
import subprocess
import sys
import textwrap
import unittest
from collections.abc import Iterator
from pathlib import Path

from base import modules
from base.modules import LIB, imported
from base.pieces import is_deleted, was_deleted
from base.tree import TOOLS
from check.make.parts import PARTS
from ship.recipes import RECIPES

USERS = tuple(name for name in ("make", "pack", "pick", "playground") if (TOOLS / name).exists())
# Modules that tools/pack imports by the names of its recipes. Only maintainers make a release.
OF_PACK = tuple(path for name, recipe in RECIPES.items() if recipe.python == (3, 9)
                for path in sorted((LIB / "ship" / name.replace("-", "_")).glob("*.py"))
                if path.name in ("command.py", "files.py"))
WHAT = re.compile(r"^needs\.python\((3), (\d+)\)$", re.M)
TYPES = {"bool", "bytes", "dict", "float", "frozenset", "int", "list", "set", "str", "tuple", "type"}
# Python has these since 3.10 or later: modules and their names, methods, and arguments of calls.
LATER_NAMES = {"tomllib", "itertools.pairwise", "functools.Placeholder", "contextlib.aclosing", "contextlib.chdir",
               "datetime.UTC", "enum.StrEnum", "hashlib.file_digest", "inspect.get_annotations",
               "itertools.batched", "math.cbrt", "math.exp2", "math.sumprod", "operator.call", "statistics.correlation",
               "statistics.linear_regression", "sys.orig_argv", "sys.stdlib_module_names", "types.NoneType",
               "types.UnionType", "typing.Concatenate", "typing.Never", "typing.ParamSpec", "typing.Self",
               "typing.TypeAlias", "typing.TypeGuard", "typing.assert_never", "typing.override"}
LATER_METHODS = {"bit_count", "hardlink_to", "is_junction", "walk_up"}
LATER_ARGUMENTS = {"zip": {"strict"}, "dataclass": {"kw_only", "slots"}, "write_text": {"newline"},
                   "glob": {"root_dir"}, "bisect": {"key"}, "bisect_left": {"key"}, "bisect_right": {"key"},
                   "insort": {"key"}, "TemporaryDirectory": {"ignore_cleanup_errors", "delete"}}


def files_of(command: str) -> dict[Path, str]:
    """The command, and all of lib/ that it imports, now or later."""
    start = TOOLS / command
    if not start.read_text(encoding="utf-8").startswith("#!/usr/bin/env python3"):
        start = LIB / command / "command.py"  # started by the command of the shell
    return modules.files_of([start, *(OF_PACK if command == "pack" else ())])


@functools.cache
def later_than(version: tuple[int, int], text: str) -> list[str]:
    """Names in a file that Python did not have by then. Annotations are of no account where nothing evaluates them."""
    try:
        ast.parse(text, feature_version=version)
    except SyntaxError as error:
        return [f"line {error.lineno}: {error.msg}"]
    if version >= (3, 11):
        return []
    tree = ast.parse(text)
    kept = {id(node) for part in ast.walk(tree) for node in _of_no_account(part, "annotations" in _futures(tree))}
    return sorted(f"line {node.lineno}: {what}" for node in ast.walk(tree) if id(node) not in kept
                  for what in _later(node))


def _futures(tree: ast.Module) -> set[str]:
    return {name.name for node in tree.body if isinstance(node, ast.ImportFrom) and node.module == "__future__"
            for name in node.names}


def _of_no_account(part: ast.AST, has_annotations_as_text: bool) -> Iterator[ast.AST]:
    if has_annotations_as_text:
        for annotation in (getattr(part, "annotation", None), getattr(part, "returns", None)):
            if annotation is not None:
                yield from ast.walk(annotation)
    # A substitute for a Python that lacks the function.
    if isinstance(part, ast.Try) and any(isinstance(handler.type, ast.Name) and handler.type.id == "ImportError"
                                         for handler in part.handlers):
        for statement in part.body:
            yield from ast.walk(statement)


def _later(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Import):
        yield from (name.name for name in node.names if name.name in LATER_NAMES)
    elif isinstance(node, ast.ImportFrom):
        yield from (name for name in (node.module, *(f"{node.module}.{name.name}" for name in node.names))
                    if name in LATER_NAMES)
    elif isinstance(node, ast.Attribute):
        if node.attr in LATER_METHODS or f"{getattr(node.value, 'id', '')}.{node.attr}" in LATER_NAMES:
            yield node.attr
    elif isinstance(node, ast.Call):
        name = getattr(node.func, "id", getattr(node.func, "attr", ""))
        yield from (f"{name}({given.arg}=)" for given in node.keywords if given.arg in LATER_ARGUMENTS.get(name, ()))
    elif isinstance(node, ast.Subscript):
        index = node.slice.operand if isinstance(node.slice, ast.UnaryOp) else node.slice
        if getattr(node.value, "attr", "") == "parents" and (index is not node.slice or isinstance(index, ast.Slice)):
            yield "a part of parents, or one from the end"
    elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitOr):
        if any(_is_type(side) for side in (node.left, node.right)):
            yield f"a type that is made at run time: {ast.unparse(node)}"


def _is_type(node: ast.AST) -> bool:
    if isinstance(node, ast.Subscript):
        node = node.value
    return (isinstance(node, ast.Name) and node.id in TYPES) or (isinstance(node, ast.Constant) and node.value is None)


@functools.cache
def needed(command: str) -> tuple[int, int]:
    paths = [TOOLS / command, LIB / command / "command.py"]
    (version,) = [found for path in paths if path.exists() for found in WHAT.findall(path.read_text(encoding="utf-8"))]
    return int(version[0]), int(version[1])


def of_python() -> list[str]:
    """The commands that begin as Python, and import from lib/."""
    return [path.name for path in sorted(TOOLS.iterdir()) if path.is_file()
            and path.read_text(encoding="utf-8").startswith("#!/usr/bin/env python3") and imported(path.read_text())]


@functools.cache
def pythons() -> dict[tuple[int, int], str]:
    """Other Pythons of this machine, by their versions: those on the PATH, and pyenv's."""
    found = {}
    folders = [Path(folder) for folder in os.environ["PATH"].split(os.pathsep)]
    folders += Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")).glob("versions/*/bin")
    for python in (path for folder in folders for path in sorted(folder.glob("python3.?*"))):
        if re.fullmatch(r"python3\.\d+", python.name):
            done = call(str(python), "-c", "import sys; print(*sys.version_info[:2])")
            if done.returncode == 0:  # pyenv puts a stub on the PATH that only reports that there is none
                major, minor = done.stdout.split()
                found.setdefault((int(major), int(minor)), str(python))
    return found


def call(python: str, *arguments: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([python, "-B", *map(str, arguments)], capture_output=True, text=True, check=False)


class Files(unittest.TestCase):
    def test_each_command_says_what_it_needs(self):
        for name in {*of_python(), *["measure"] * (not is_deleted("measuring"))}:
            with self.subTest(name):
                self.assertEqual(needed(name), (3, 9) if name in USERS else (3, 11))

    def test_what_users_call_needs_no_more(self):
        for name in USERS:
            for path, text in files_of(name).items():
                with self.subTest(name, file=path.relative_to(TOOLS)):
                    self.assertEqual(later_than((3, 9), text), [])
        for part in PARTS:
            for path, text in modules.files_of([modules.path_of(part.module)]).items():
                with self.subTest(part.name, file=path.relative_to(TOOLS)):
                    self.assertEqual(later_than(part.python, text), [])
        self.assertEqual([part.name for part in PARTS if part.python == (3, 9)], ["dimensions", "snippets", "vectors"])
        self.assertGreater(len(files_of("pack")), 10)
        self.assertIn(LIB / "base" / "usage.py", files_of("make"))

    def test_a_command_is_read_by_a_python_that_is_too_old(self):
        for name in (*of_python(), "lib/base/ending.py", "lib/base/needs.py", "lib/measure/command.py"):
            if was_deleted(f"tools/{name}"):
                continue
            with self.subTest(name):
                text = (TOOLS / name).read_text(encoding="utf-8")
                ast.parse(text, feature_version=(3, 6) if name in USERS else (3, 8))
                self.assertNotIn("from __future__", text)

    def test_what_is_later_is_noticed(self):
        for text in ("import tomllib", "from tomllib import loads", "from itertools import pairwise",
                     "zip(a, b, strict=True)", "n.bit_count()", "Range = tuple[float, float] | None",
                     "Real = Fraction | float",
                     "isinstance(x, int | str)", "path.parents[:-1]", "path.parents[-1]", "import math\nmath.cbrt(2)",
                     "@dataclass(slots=True)\nclass A: pass", "path.write_text(text, newline='')",
                     "def f(x: int | None): pass", "match x:\n    case 1: pass",
                     "try:\n    pass\nexcept* ValueError: pass", "from typing import Self"):
            with self.subTest(text):
                self.assertNotEqual(later_than((3, 9), text), [])

    def test_what_is_not_is_left_alone(self):
        text = textwrap.dedent("""
            from __future__ import annotations
            try:
                from tomllib import loads
            except ImportError:
                loads = None
            def f(x: int | None = None) -> list[str] | None:
                y: dict[str, int] | None = {"a": 1} | {"b": 2}
                return zip(x, y), path.parents[0], flags | A
        """)
        self.assertEqual(later_than((3, 9), text), [])


class Running(unittest.TestCase):
    def assert_told(self, done: subprocess.CompletedProcess[str], name: str, needed: str, there: str):
        self.assertEqual((done.returncode, done.stdout), (4, ""), done.stderr)
        self.assertRegex(done.stderr, rf"\Atools/{name} needs Python {needed} or later, and this is {there} \(.*\)\. "
                                      rf"Another one is taken like this: python3\.12 tools/{name}\n\Z")

    def test_as_if_python_were_too_old(self):
        for name, version in (("pick", (3, 8)), ("make", (3, 6)), ("pack", (3, 8))):
            with self.subTest(name):
                self.assert_told(self.called_by(version, name), name, rf"3\.{needed(name)[1]}", rf"3\.{version[1]}")
        # A part of a command may need a later one.
        self.assert_told(self.called_by((3, 10), "pack", "release"), "pack release", r"3\.11", r"3\.10")
        for name in {"rust", "unity"} & {*RECIPES}:
            self.assertEqual(self.called_by((3, 9), "pack", name, "--help").returncode, 0)

    def called_by(self, version: tuple[int, int], name: str, *arguments: str) -> subprocess.CompletedProcess[str]:
        """As if Python were of that version."""
        code = (f"import runpy, sys; sys.argv = {[str(TOOLS / name), *arguments]}; sys.version_info = {(*version, 1)}; "
                "runpy.run_path(sys.argv[0], run_name='__main__')")
        return call(sys.executable, "-c", code)

    @unittest.skipIf(is_deleted("measuring"), "measuring was deleted")
    def test_as_if_the_python_of_a_command_of_the_shell_were(self):
        command = LIB / "measure" / "command.py"
        code = (f"import runpy, sys; sys.argv = [{str(command)!r}, 'gpu', '--help']; sys.version_info = (3, 10, 1); "
                "runpy.run_path(sys.argv[0], run_name='__main__')")
        done = call(sys.executable, "-c", code)
        self.assertEqual((done.returncode, done.stdout), (4, ""), done.stderr)
        self.assertRegex(done.stderr, r"\Atools/measure needs Python 3\.11 or later, and this is 3\.10 \(.*\)\. "
                                      r"The first python3 of the PATH is taken\.\n\Z")

    def test_as_if_python_were_too_old_for_a_part(self):
        code = (f"import runpy, sys; sys.argv = [{str(TOOLS / 'make')!r}, 'golden', '--check']; "
                "sys.version_info = (3, 10, 1); runpy.run_path(sys.argv[0], run_name='__main__')")
        self.assert_told(call(sys.executable, "-c", code), "make", r"3\.11", r"3\.10")

    @unittest.skipUnless(any((3, 6) <= version < (3, 9) for version in pythons()), "no Python 3.6 to 3.8 is here")
    def test_a_python_that_is_too_old(self):
        for (major, minor), python in pythons().items():
            if (3, 6) <= (major, minor) < (3, 9):
                for name in ("pick", "make", "pack"):
                    with self.subTest(name, python=python):
                        self.assert_told(call(python, TOOLS / name, "--help"), name, r"3\.\d+", rf"{major}\.{minor}")

    @unittest.skipUnless(any((3, 9) <= version < (3, 11) for version in pythons()), "no Python 3.9 or 3.10 is here")
    def test_older_pythons_write_the_same(self):
        for arguments in (("pick", "hn_fbm2", "--language", "wgsl"), ("pick", "whole", "--minify", "fbm2d.glsl"),
                          ("pick", "whole", "--language", "wgsl", "fbm2d.glsl")):
            right = call(sys.executable, TOOLS / arguments[0], *arguments[1:])
            for version, python in pythons().items():
                if (3, 9) <= version < (3, 11):
                    with self.subTest(arguments, python=python):
                        done = call(python, TOOLS / arguments[0], *arguments[1:])
                        self.assertEqual((done.returncode, done.stdout), (0, right.stdout), done.stderr)
        if is_deleted("playground"):
            return
        code = (f"import sys; sys.path.insert(0, {str(LIB)!r}); from ship.playground.picks import compressed; "
                "print(compressed('abc' * 999))")
        right = call(sys.executable, "-c", code)
        for python in (python for version, python in pythons().items() if (3, 9) <= version < (3, 11)):
            done = call(python, "-c", code)
            self.assertEqual((done.returncode, done.stdout), (0, right.stdout), done.stderr)
            self.assertNotEqual(done.stdout, "")

    @unittest.skipUnless(any((3, 9) <= version < (3, 11) for version in pythons()), "no Python 3.9 or 3.10 is here")
    def test_older_pythons_import_what_users_call(self):
        others = [*["ship.playground.command"] * (not is_deleted("playground")), "translate.pick.command"]
        of_pack = [".".join(path.relative_to(LIB).with_suffix("").parts) for path in OF_PACK]
        started = ", ".join(["ship.command", *of_pack, *others])
        for version, python in pythons().items():
            if (3, 9) <= version < (3, 11):
                with self.subTest(python=python):
                    done = call(python, "-c", f"import sys; sys.path.insert(0, {str(LIB)!r}); import {started}")
                    self.assertEqual((done.returncode, done.stderr), (0, ""))
