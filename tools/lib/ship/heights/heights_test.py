"""The heights of one land are the same wherever people work: in C++, Python, JavaScript, C#, Blender, a page's shader
and the shader of Godot's add-on, at points of our own, near the origin and far from it.

    python3 -m ship.heights.heights_test ENVIRONMENT PACKAGES    the folders of python.wheel and of javascript.packages

The land is hn_fbm on the plane with HN_FIXED. Godot itself does not run: Chromium runs its add-on's text as GLSL.
Exit status: 0 they are the same, 1 they are not, 77 they are the same where there is all that it needs.
"""

from __future__ import annotations

import functools
import json
import random
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from collections.abc import Sequence
from pathlib import Path

from base.tree import ROOT
from base.twin import compile_program
from ship.blender.in_blender import Heights, NoBlender, found
from ship.godot.files import ADDON
from ship.godot.files import package as godot
from ship.packing_support import made
from ship.unity import files as unity
from translate.pick.runners import ran

SKIPPED = 77
SEEDS, POINTS = 8, 64  # of each seed
PROJECT = ROOT / "packages" / "npm" / "tests" / "project.py"
CPP = """#define HN_ARITHMETIC HN_FIXED
#include <hashnoise/hashnoise.hpp>
#include <cstdint>
#include <cstdio>
#include <cstring>

int main() {
  std::uint32_t row[3];
  while (std::fread(row, sizeof row, 1, stdin) == 1) {
    float p[2];
    std::memcpy(p, row, sizeof p);
    const float height = hashnoise::hn_fbm(hashnoise::vec2(p[0], p[1]), 6, 2.0f, 0.5f, row[2]);
    std::fwrite(&height, sizeof height, 1, stdout);
  }
}
"""
CSHARP = """static class Run {
    static void Main() {
        byte[] rows = System.IO.File.ReadAllBytes("rows");
        using (var heights = System.IO.File.Create("heights"))
            for (int at = 0; at < rows.Length; at += 12)
                heights.Write(System.BitConverter.GetBytes(HashNoiseFixed.Fbm2(
                    System.BitConverter.ToSingle(rows, at), System.BitConverter.ToSingle(rows, at + 4), 6, 2f, 0.5f,
                    System.BitConverter.ToUInt32(rows, at + 8))), 0, 4);
    }
}
"""
Row = tuple[float, float, int]


@functools.cache
def rows() -> list[Row]:
    """Places x and y, which are floats of 32 bits, with a seed, all of one seed together, as Blender takes them."""
    of = random.Random(35)
    found = []
    for seed in [of.randrange(1 << 32) for _ in range(SEEDS)]:
        for i in range(POINTS):
            span = 2.0 ** (i % 22)
            found.append((*(struct.unpack("f", struct.pack("f", of.uniform(-span, span)))[0] for _ in "xy"), seed))
    return found


def packed() -> bytes:
    return b"".join(struct.pack("<ffI", *row) for row in rows())


def words(heights: bytes) -> list[int]:
    return [word for word, in struct.iter_unpack("<I", heights)]


def difference(expected: Sequence[int], got: Sequence[int]) -> str:
    """At how many points heights differ, and how at the first; nothing if they do not."""
    if len(got) != len(expected):
        return f"there are {len(got)} heights and not {len(expected)}"
    wrong = [i for i, pair in enumerate(zip(expected, got)) if pair[0] != pair[1]]
    if not wrong:
        return ""
    first = wrong[0]
    return (f"{len(wrong)} of {len(expected)} points differ, the first is {rows()[first]}: {got[first]:08X} where C++ "
            f"has {expected[first]:08X}")


class Everywhere(unittest.TestCase):
    environment: Path
    packages: Path
    user: Path

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder, cls.add_on = made(cls, "blender", "--zip")
        (cls.folder / "heights.cpp").write_text(CPP)
        compile_program("the heights", cls.folder / "heights.cpp", cls.folder / "of_cpp")
        cls.expected = words(subprocess.run([cls.folder / "of_cpp"], input=packed(), stdout=subprocess.PIPE,
                                            check=True).stdout)

    def assert_same(self, got: Sequence[int]) -> None:
        self.assertEqual(difference(self.expected, got), "")

    def test_a_land_is_not_flat_and_one_bit_is_noticed(self) -> None:
        self.assertGreater(len(set(self.expected)), 0.95 * len(self.expected))
        changed = [*self.expected]
        changed[5] ^= 1
        self.assertRegex(difference(self.expected, changed), f"^1 of {SEEDS * POINTS} points differ, the first is ")
        self.assertRegex(difference(self.expected, changed[1:]), "^there are")

    def test_csharp_of_the_package_for_unity(self) -> None:
        if not (shutil.which("mcs") and shutil.which("mono")):
            self.skipTest("there is no Mono: apt-get install mono-mcs mono-runtime")
        text = unity.script("fixed")

        def heights(library: str) -> list[int]:
            (self.folder / "library.cs").write_text(library)
            (self.folder / "run.cs").write_text(CSHARP)
            (self.folder / "rows").write_bytes(packed())
            ran(self.folder, "mcs", "-langversion:7.2", "-out:run.exe", "library.cs", "run.cs")
            ran(self.folder, "mono", "run.exe")
            return words((self.folder / "heights").read_bytes())
        self.assert_same(heights(text))
        self.assertNotEqual(difference(self.expected, heights(self.changed(text))), "")

    @staticmethod
    def changed(text: str) -> str:
        """Another hash, as a fault."""
        wrong = text.replace("0x2C1B3C6D", "0x2C1B3C6F")
        if wrong == text:
            raise ValueError("the text has no such number")
        return wrong

    def test_npm_a_page_and_godots_shader(self) -> None:
        text = godot()[f"{ADDON}/fbm2d.gdshaderinc"].decode()
        job = self.folder / "job.json"
        job.write_text(json.dumps({"rows": [struct.unpack("<III", struct.pack("<ffI", *row)) for row in rows()],
                                   "texts": {"godot": text, "wrong": self.changed(text)}}))
        done = subprocess.run([sys.executable, "-B", PROJECT, "run", self.packages, "node", "heights.mjs", job],
                              capture_output=True, text=True, check=False)
        if done.returncode == SKIPPED:
            self.skipTest(done.stdout.strip())
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        heights = json.loads(done.stdout.splitlines()[-1])
        self.assertNotEqual(difference(self.expected, heights.pop("wrong")), "")
        self.assertEqual(sorted(heights), ["godot", "npm", "page"])
        for name, got in heights.items():
            with self.subTest(name):
                self.assert_same(got)

    def test_python_and_blender(self) -> None:
        try:
            found(self.environment, self.user)
        except NoBlender as reason:
            self.skipTest(str(reason))
        import hashnoise
        import numpy
        in_blender = Heights(self.add_on)
        of_python, of_blender = b"", b""
        for start in range(0, len(rows()), POINTS):
            x, y, seeds = zip(*rows()[start:start + POINTS])
            places = numpy.array([x, y, [0] * POINTS], numpy.float32)
            of_python += hashnoise.fbm(places[0], places[1], seed=seeds[0], arithmetic="fixed").tobytes()
            settings = {"fractal": "fbm", "octaves": 6, "scale": 1.0, "strength": 1.0}
            seed = seeds[0] - ((seeds[0] & 1 << 31) << 1)  # Blender's numbers have a sign
            of_blender += in_blender.displaced(places.T, seed=seed, **settings).tobytes()
        for name, got in (("Python", of_python), ("Blender", of_blender)):
            with self.subTest(name):
                self.assert_same(words(got))
        other = in_blender.displaced(places.T, seed=seed ^ 1, **settings).tobytes()
        self.assertNotEqual(difference(self.expected, words(of_blender[:-len(other)] + other)), "")


if __name__ == "__main__":
    Everywhere.environment, Everywhere.packages = map(Path, sys.argv[1:])
    with tempfile.TemporaryDirectory() as place:
        Everywhere.user = Path(place)
        result = unittest.main(argv=sys.argv[:1], exit=False, verbosity=2).result
    for _, reason in result.skipped:
        print(f"skipped: {reason}")
    sys.exit(1 if not result.wasSuccessful() else SKIPPED if result.skipped else 0)
