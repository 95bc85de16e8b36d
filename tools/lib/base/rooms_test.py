"""A room of tools/lib imports those before it and none behind it, its tests too. The oracle imports no text of glsl/
and nothing that reads it, so that it shares no mistake with the library."""

from __future__ import annotations

import re
import unittest
from pathlib import Path

from base.modules import LIB, files_of, imported
from base.pieces import was_deleted

ROOMS = ("base", "catalog", "translate", "proof", "measure", "ship", "check")
ORACLE = LIB / "proof" / "oracle"
# Modules that the oracle and its tests may import: the rows of functions, and for tests points, and ranges that are
# proven.
OF_ORACLE = (LIB / "base", LIB / "catalog", ORACLE)
OF_TESTS = (*OF_ORACLE, LIB / "proof" / "golden", LIB / "proof" / "bounds" / "table.py")
READERS = re.compile(r"\b(GLSL|glsl_files)\b|catalog\.tables(\.glsl\b| import (.*\b)?glsl\b)")


def floor_of(path: Path) -> int:
    return ROOMS.index(path.relative_to(LIB).parts[0])


def arrows_up(path: Path, text: str) -> list[Path]:
    return [other for other in imported(text) if floor_of(other) > floor_of(path)]


def beyond(allowed: tuple[Path, ...], files: dict[Path, str]) -> list[Path]:
    """Imports in these files that the oracle must not have."""
    return [path for path, text in files.items() if not any(path.is_relative_to(room) for room in allowed)
            or (READERS.search(text) and path != LIB / "base" / "tree.py")]


class Rooms(unittest.TestCase):
    def test_every_folder_is_a_room(self) -> None:
        found = {path.relative_to(LIB).parts[0] for path in LIB.rglob("*.py")}
        self.assertEqual(found, {room for room in ROOMS if room in found or not was_deleted(f"tools/lib/{room}")})

    def test_none_imports_a_room_behind_it(self) -> None:
        for path in sorted(LIB.rglob("*.py")):
            with self.subTest(path.relative_to(LIB).as_posix()):
                self.assertEqual(arrows_up(path, path.read_text(encoding="utf-8")), [])

    def test_an_arrow_up_is_reported(self) -> None:
        for text in ("from ship.recipes import RECIPES", "def f():\n    import ship.recipes", "from ship import recipes"):
            self.assertEqual(set(arrows_up(LIB / "proof" / "new.py", text)), {LIB / "ship" / "recipes.py"})
            self.assertEqual(arrows_up(LIB / "check" / "new.py", text), [])

    def test_the_oracle_sees_no_text_of_the_library(self) -> None:
        files = sorted(ORACLE.rglob("*.py"))
        tests = [path for path in files if path.name.endswith("_test.py") or path.name == "testing.py"]
        self.assertEqual(beyond(OF_ORACLE, files_of(path for path in files if path not in tests)), [])
        self.assertEqual(beyond(OF_TESTS, files_of(tests)), [])

    def test_what_it_must_not_see_is_reported(self) -> None:
        new = ORACLE / "new.py"
        for text in ("from base.tree import GLSL", "from catalog.tables import glsl", "import catalog.tables.glsl as g"):
            self.assertEqual(beyond(OF_ORACLE, {new: text}), [new])
        for path in (LIB / "translate" / "pick" / "program.py", LIB / "proof" / "bounds" / "table.py"):
            self.assertEqual(beyond(OF_ORACLE, {path: ""}), [path])
