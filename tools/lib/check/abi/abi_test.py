"""tools/test abi: its messages on the committed interface, and its refusals.

    python3 -m unittest abi.abi_test    without a compiler
    python3 -m check.abi.abi_test FOLDER      builds the library in FOLDER; skipped (77) where tools/test abi is
"""

from __future__ import annotations

import contextlib
import io
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from base.tree import ROOT, version
from check.abi import command
from check.abi.command import INTERFACE

MINOR = ".".join(version().split(".")[:2])
# A user's file: functions of the header, a struct of them, and the library.
USER = """
#include <hashnoise/field.hpp>
#include <hashnoise/hashnoise.hpp>
using namespace hashnoise;
float height(float x, float y) {
  const auto place = hn_tile(hn_place(ivec2(3, 4), vec2(x, y)), ivec2(8, 8));
  return hn_fbm(place, 6, 2.0f, 0.5f, 7u) + hn_perlin_d(vec2(x, y), 7u).x + hn_cellular(vec2(x, y), 7u).x;
}
Range filled(std::span<float> values) {
  return Field<2>(Settings{}).fill(Grid<2>{{0, 0}, {0.5f, 0.5f}, {4, 4}}, values, threads(2));
}
"""


class Committed(unittest.TestCase):
    def setUp(self) -> None:
        self.text = INTERFACE.read_text(encoding="utf-8")

    def test_it_is_of_this_minor_version(self) -> None:
        self.assertEqual(command.soname(self.text), f"libhashnoise-grid.so.{MINOR}")

    def test_it_has_what_the_header_offers_and_nothing_else(self) -> None:
        names = command.functions(self.text)
        space = f"hashnoise::v{MINOR.replace('.', '_')}::"
        for name in ("Field<2>::Field(", "Field<4>::fill(", "threads(int)", "noise_names[abi:cxx11](int)", "fractal_names",
                     "instruction_sets()", "name("):
            self.assertTrue(any(name.split("[")[0] in symbol for symbol in names), name)
        self.assertEqual([name for name in names if space not in name or f"{space}grid::" in name], [])


class Promise(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def test_programs_ask_for_the_minor_version(self) -> None:
        self.assertEqual(command.promised("1.2.3"), "libhashnoise-grid.so.1.2")
        self.assertEqual(command.promised("0.10.0"), "libhashnoise-grid.so.0.10")

    def test_a_patch_keeps_the_interface_of_its_minor_version(self) -> None:
        before = self.folder / "grid.abi"
        self.assertFalse(command.is_kept(before, "1.2.3"), "there is none yet")
        before.write_text("<abi-corpus version='2.1' soname='libhashnoise-grid.so.1.2'>")
        for of, kept in (("1.2.3", True), ("1.2.0", False), ("1.3.0", False), ("1.3.1", False)):
            with self.subTest(of):
                self.assertEqual(command.is_kept(before, of), kept)

    def test_without_the_programs_it_is_skipped(self) -> None:
        out = io.StringIO()
        with mock.patch.object(command, "NEEDED", ("no-such-abidw",)), contextlib.redirect_stdout(out):
            self.assertEqual(command.main(["--check", str(self.folder)]), 77)
        self.assertIn("there is no no-such-abidw", out.getvalue())


@unittest.skipUnless(__name__ == "__main__", "the test abi.whole compiles the library")
class Whole(unittest.TestCase):
    folder = Path()

    @classmethod
    def setUpClass(cls) -> None:
        library = command.build(cls.folder)
        cls.now = cls.folder / "grid.abi"
        cls.now.write_text(command.described(library), encoding="utf-8")

    def setUp(self) -> None:
        self.before = self.folder / "before.abi"

    def changed(self, old: str, new: str) -> list[str]:
        """The messages for another committed file."""
        text = INTERFACE.read_text(encoding="utf-8")
        self.assertIn(old, text)
        self.before.write_text(text.replace(old, new), encoding="utf-8")
        return command.problems(self.before, self.now, version())

    def test_it_is_as_it_was(self) -> None:
        self.assertEqual(command.problems(INTERFACE, self.now, version()), [])

    def test_a_member_that_moved_is_told(self) -> None:
        printed = "\n".join(self.changed("<var-decl name='footprint'", "<var-decl name='blurred'"))
        self.assertIn("footprint", printed)

    def test_a_function_that_is_new_is_told(self) -> None:
        line = next(line for line in INTERFACE.read_text(encoding="utf-8").splitlines(keepends=True)
                    if "<elf-symbol name=" in line and "threads" in line)
        self.assertIn("1 Added function", "\n".join(self.changed(line, "")))

    def test_two_versions_share_no_name(self) -> None:
        """Objects of a program; one includes another version."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for library in ("include", "glsl"):
                shutil.copytree(ROOT / library, folder / library)
            header = folder / "include/hashnoise/glsl.hpp"
            text = header.read_text(encoding="ascii")
            own = f"HN_I_NAMESPACE v{MINOR.replace('.', '_')}"
            self.assertIn(own, text)
            header.write_text(text.replace(own, "HN_I_NAMESPACE v7_1"), encoding="ascii")
            (folder / "user.cpp").write_text(USER)
            ours, theirs = (self.names_in(folder, root / "include") for root in (ROOT, folder))
            self.assertTrue(any("Field" in name for name in ours))
            self.assertEqual(ours & theirs, set())
            self.assertEqual(ours & self.names_in(folder, ROOT / "include"), ours)

    def names_in(self, folder: Path, include: Path) -> set[str]:
        """hashnoise's symbols in an object that is not optimized."""
        made = folder / "user.o"
        command.output_of("c++", "-std=c++20", "-O0", "-I", include, "-c", folder / "user.cpp", "-o", made)
        return set(re.findall(r"\S*\bhashnoise::.*", command.output_of("nm", "--demangle", made)))

    def test_another_version_needs_another_name(self) -> None:
        printed = "\n".join(command.problems(INTERFACE, self.now, "7.1.0"))
        self.assertIn("of version 7.1.0 it is libhashnoise-grid.so.7.1", printed)
        self.assertIn("is not in the namespace hashnoise::v7_1", printed)


if __name__ == "__main__":
    Whole.folder = Path(sys.argv.pop())
    if reason := command.skipped():
        print(reason)
        sys.exit(77)
    unittest.main(defaultTest="Whole", verbosity=2)
