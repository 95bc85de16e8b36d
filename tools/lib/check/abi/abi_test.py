"""tools/test abi: its messages on the committed interface, and its refusals.

    python3 -m unittest abi.abi_test    without a compiler
    python3 -m check.abi.abi_test FOLDER      builds the library in FOLDER; skipped (77) where tools/test abi is
"""

from __future__ import annotations

import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from base.testing import Case, called
from base.tree import ROOT, version
from check.abi import command
from check.abi.command import INTERFACE

MAJOR, MINOR, _ = version().split(".")
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

    def test_it_is_of_this_major_version(self) -> None:
        self.assertEqual(command.soname(self.text), f"libhashnoise-grid.so.{MAJOR}")

    def test_it_has_what_the_header_offers_and_nothing_else(self) -> None:
        names = command.functions(self.text)
        space = f"hashnoise::v{MAJOR}::"
        for name in ("Field<2>::Field(", "Field<4>::fill(", "threads(int)", "noises[abi:cxx11](int)", "fractals(",
                     "instruction_sets()", "name("):
            self.assertTrue(any(name.split("[")[0] in symbol for symbol in names), name)
        self.assertEqual([name for name in names if space not in name or "::grid::" in name], [])


class Promise(Case):
    def test_programs_name_the_major_version(self) -> None:
        self.assertEqual(command.promised("1.2.3"), "libhashnoise-grid.so.1")
        self.assertEqual(command.promised("10.0.0"), "libhashnoise-grid.so.10")

    def test_the_first_interface_of_a_major_version_is_free(self) -> None:
        before = self.folder / "grid.abi"
        self.assertEqual(command.broken(before, INTERFACE, version()), "", "there is none yet")
        before.write_text(f"SONAME libhashnoise-grid.so.{int(MAJOR) + 1}\n")
        self.assertEqual(command.broken(before, INTERFACE, version()), "")

    def test_without_the_programs_it_is_skipped(self) -> None:
        with mock.patch.object(command, "NEEDED", ("no-such-abidw",)):
            status, printed = called(command.main, "--check", self.folder)
        self.assertEqual((status, printed), (77, "skipped: there is no no-such-abidw\n"))


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

    def broken(self, patch: int) -> str:
        """The message on what the library breaks of the other committed file, in a patch or in a minor version."""
        return command.broken(self.before, self.now, f"{MAJOR}.7.{patch}")

    def test_it_is_as_it_was(self) -> None:
        self.assertEqual(command.problems(INTERFACE, self.now, version()), [])

    def test_a_member_that_moved_is_told(self) -> None:
        printed = self.changed("::footprint is a", "::blurred is a")
        self.assertEqual([re.sub(" is a .*", "", one) for one in printed],
                         ["gone: hashnoise::v1::Settings::blurred", "new: hashnoise::v1::Settings::footprint"])
        self.assertIn("blurred", self.broken(patch=0))
        self.assertIn("footprint", self.broken(patch=1))

    def test_a_function_that_is_new_is_told(self) -> None:
        line = next(line for line in INTERFACE.read_text(encoding="utf-8").splitlines(keepends=True)
                    if line.startswith("symbol ") and "threads" in line)
        self.assertEqual(self.changed(line, ""), [f"new: {line.strip()}"])
        self.assertEqual(self.broken(patch=0), "", "a minor version may add it")
        self.assertIn(line, self.broken(patch=1))

    def test_a_function_that_is_gone_is_told(self) -> None:
        self.changed("_ZN9hashnoise2v17threadsEi", "_ZN9hashnoise2v17runnersEi")
        for patch in (0, 1):
            self.assertIn("gone: symbol _ZN9hashnoise2v17runnersEi", self.broken(patch))

    def test_two_versions_share_no_name_but_for_the_library_of_a_major_version(self) -> None:
        """Objects of a program; one includes another version."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for library in ("include", "glsl"):
                shutil.copytree(ROOT / library, folder / library)
            header = folder / "include/hashnoise/glsl.hpp"
            text = header.read_text(encoding="ascii")
            (folder / "user.cpp").write_text(USER)
            ours = self.names_in(folder, ROOT / "include")
            self.assertEqual(ours & self.names_in(folder, ROOT / "include"), ours)
            self.assertTrue(any("Field" in name for name in ours))
            other_minor = text.replace(f"HN_I_NAMESPACE v{MAJOR}_{MINOR}\n", f"HN_I_NAMESPACE v{MAJOR}_77\n")
            self.assertNotEqual(text, other_minor)
            other_major = other_minor.replace(f"HN_I_LIBRARY v{MAJOR}\n", "HN_I_LIBRARY v77\n")
            self.assertNotEqual(other_minor, other_major)
            header.write_text(other_minor, encoding="ascii")
            shared = ours & self.names_in(folder, folder / "include")
            self.assertTrue(any("Field" in name for name in shared))
            self.assertEqual([name for name in shared if f"hashnoise::v{MAJOR}_" in name], [])
            header.write_text(other_major, encoding="ascii")
            self.assertEqual(ours & self.names_in(folder, folder / "include"), set())

    def names_in(self, folder: Path, include: Path) -> set[str]:
        """hashnoise's symbols in an object that is not optimized."""
        made = folder / "user.o"
        command.output_of("c++", "-std=c++20", "-O0", "-I", include, "-c", folder / "user.cpp", "-o", made)
        return set(re.findall(r"\S*\bhashnoise::.*", command.output_of("nm", "--demangle", made)))

    def test_another_version_needs_another_name(self) -> None:
        printed = "\n".join(command.problems(INTERFACE, self.now, "7.1.0"))
        self.assertIn("of version 7.1.0 it is libhashnoise-grid.so.7", printed)
        self.assertIn("is not in the namespace hashnoise::v7", printed)


if __name__ == "__main__":
    Whole.folder = Path(sys.argv.pop())
    if reason := command.skipped():
        print(reason)
        sys.exit(77)
    unittest.main(defaultTest="Whole", verbosity=2)
