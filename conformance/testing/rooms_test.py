#!/usr/bin/env python3
"""No room of conformance/ can include what is above it: the compiler finds only what the room's CMakeLists.txt names.
The lowest is src/base, on which the programs of src/ stand; src/ includes nothing of conformance/.

Usage: rooms_test.py COMPILER FOLDER, with a file NAME.includes for each room: its include folders, a line each.
"""

import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]*)"', re.MULTILINE)
COMPILER = ""
FOLDERS: dict[str, list[str]] = {}  # of each room


def finds(room: str, header: str) -> bool:
    """Whether the compiler finds the header for a source of the room."""
    command = [COMPILER, "-std=c++20", "-E", "-x", "c++", "-", "-o", "/dev/null", *(f"-I{f}" for f in FOLDERS[room])]
    text = f'#if !__has_include("{header}")\n#error\n#endif\n'
    return subprocess.run(command, input=text, text=True, capture_output=True).returncode == 0


def folder_of(room: str) -> pathlib.Path:
    return next(pathlib.Path(f) / room for f in FOLDERS[room] if pathlib.Path(f).parts[-2:] == ("roots", room))


def headers_of(room: str) -> list[str]:
    return [f"{room}/{path.name}" for path in sorted(folder_of(room).glob("*.hpp"))]


def seen_by(room: str) -> set[str]:
    """The rooms that it was given the folders of."""
    return {other for other in FOLDERS if any(pathlib.Path(f).parts[-2:] == ("roots", other) for f in FOLDERS[room])}


def way_around(text: str, rooms: set[str]) -> list[str]:
    """The includes of a source that are not of the form "room/file.hpp", and so not kept to the rooms; but for the
    library's text, lines that are made, and the prover, which is no room."""
    wrong = []
    for name in INCLUDE.findall(text):
        if "/" not in name and (name.endswith((".glsl", ".inc")) or (ROOT / "conformance" / "prover" / name).is_file()):
            continue
        parts = name.split("/")
        if parts[0] not in rooms or len(parts) < 2 or ".." in parts:
            wrong.append(name)
    return wrong


def of_the_suite(text: str, rooms: set[str]) -> list[str]:
    """The includes of a source that name a room of conformance/."""
    return [name for name in INCLUDE.findall(text)
            if name.split("/")[0] in rooms - {"base"} or "conformance" in name.split("/")]


class Rooms(unittest.TestCase):
    def test_a_room_includes_what_it_sees_and_nothing_else(self) -> None:
        for room in FOLDERS:
            for other in FOLDERS:
                with self.subTest(room=room, other=other):
                    self.assertEqual(finds(room, headers_of(other)[0]), other in seen_by(room))

    def test_none_sees_a_room_that_sees_it(self) -> None:
        for room in FOLDERS:
            for other in seen_by(room) - {room}:
                self.assertNotIn(room, seen_by(other), other)

    def test_every_include_names_its_room(self) -> None:
        for room in FOLDERS:
            for path in folder_of(room).rglob("*.[ch]pp"):
                self.assertEqual(way_around(path.read_text(encoding="utf-8"), set(FOLDERS)), [], path)

    def test_the_sources_of_users_include_nothing_of_the_suite(self) -> None:
        for path in (ROOT / "src").rglob("*.[ch]pp"):
            if path.parts[-3:-1] != ("grid", "tests"):  # they hold grids to the bounds of the suite
                self.assertEqual(of_the_suite(path.read_text(encoding="utf-8"), set(FOLDERS)), [], path)

    def test_an_include_of_the_suite_is_reported(self) -> None:
        text = '#include "base/file.hpp"\n#include "grid/run.hpp"\n#include "files.hpp"\n#include "{}"\n'
        for name in ("run/job.hpp", "../../conformance/run/job.hpp"):
            self.assertEqual(of_the_suite(text.format(name), {"base", "run"}), [name])

    def test_a_way_around_is_reported(self) -> None:
        rooms = {"base", "run"}
        self.assertEqual(way_around('#include "base/result.hpp"\n  #include <vector>\n', rooms), [])
        for name in ("../run/job.hpp", "job.hpp", "base/../run/job.hpp", "bugs/bugs.hpp"):
            self.assertEqual(way_around(f'#include "run/job.hpp"\n#  include "{name}"\n', rooms), [name])


if __name__ == "__main__":
    COMPILER = sys.argv[1]
    for listed in pathlib.Path(sys.argv[2]).glob("*.includes"):
        FOLDERS[listed.stem] = listed.read_text(encoding="utf-8").split()
    unittest.main(argv=sys.argv[:1])
