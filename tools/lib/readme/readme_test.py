"""The README's picture is what the code draws, its code compiles as it stands there, and its costs were measured.

Usage: readme_test.py PATH-OF-PICTURE
"""

import csv
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

from tree import ROOT

PICTURE = ""
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
INCLUDE_PLACE = re.compile(r"^// here: .*$", re.MULTILINE)  # where the README leaves the way of inclusion open


def blocks(language):
    return [code for name, code in BLOCK.findall((ROOT / "README.md").read_text()) if name == language]


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False)


def compile_glsl(code):
    """As the README says for Vulkan; for others with what tools/single-file makes in the place of the include."""
    with tempfile.TemporaryDirectory() as folder:
        shader = pathlib.Path(folder) / "shader.frag"
        if "#include" in INCLUDE_PLACE.sub("", code):
            shader.write_text(code)
            return run("glslangValidator", "-V", f"-I{ROOT / 'glsl'}", "-o", f"{folder}/shader.spv", str(shader))
        single = run(str(ROOT / "tools" / "single-file"), "noise2d.glsl").stdout
        shader.write_text(INCLUDE_PLACE.sub(lambda _: single, code))
        return run("glslangValidator", str(shader))


def compile_cpp(code):
    with tempfile.NamedTemporaryFile("w", suffix=".cpp") as source:
        source.write(code)
        source.flush()
        return run("g++", "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-I", str(ROOT / "include"),
                   source.name)


def black_pixel():
    """A PNG file of one black pixel."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(4))) + chunk(b"IEND", b"")


class Picture(unittest.TestCase):
    def test_it_is_what_the_code_draws(self):
        done = run(PICTURE, "--check", str(ROOT / "docs" / "images" / "noise.png"))
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_another_picture_is_noticed(self):
        with tempfile.NamedTemporaryFile(suffix=".png") as other:
            other.write(black_pixel())
            other.flush()
            self.assertEqual(run(PICTURE, "--check", other.name).returncode, 1)
        self.assertEqual(run(PICTURE, "--check", "/nowhere.png").returncode, 2)


def costs(readme, rows):
    """The rows of the table of costs that do not say what the CSV file does: (what, what it should be)."""
    table = re.search(r"^\| noise \|.*\n\|[- |]+\|\n((?:\|.*\n)+)", readme, re.MULTILINE)[1]
    for line in table.splitlines():
        name = re.search(r"`([^`]+)`", line)[1]
        ids = [f"{name}{n}" if name.startswith("table.") else f"noise{n}d.perlin.{name}" for n in (2, 3)]
        right = [f"{float(rows[i]['ratio']):.2f}" for i in ids] + [rows[i]["navi21"] for i in ids]
        if [cell.strip() for cell in line.split("|")[2:-1]] != right:
            yield line, right


class Costs(unittest.TestCase):
    def setUp(self):
        self.readme = (ROOT / "README.md").read_text()
        with open(ROOT / "docs" / "results" / "llvmpipe" / "bench.csv", newline="") as file:
            self.rows = {row["id"]: row for row in csv.DictReader(file)}

    def test_they_are_those_of_the_recorded_run(self):
        self.assertEqual(list(costs(self.readme, self.rows)), [])

    def test_another_number_is_noticed(self):
        self.rows["noise2d.perlin.lattice"]["ratio"] = "9.999"
        self.assertEqual(len(list(costs(self.readme, self.rows))), 1)


class Code(unittest.TestCase):
    def test_shaders_compile_without_a_warning(self):
        self.assertGreaterEqual(len(blocks("glsl")), 3)
        for code in blocks("glsl"):
            done = compile_glsl(code)
            self.assertEqual(done.returncode, 0, code + done.stdout)
            self.assertNotIn("WARNING", done.stdout)

    def test_cpp_compiles(self):
        self.assertGreaterEqual(len(blocks("cpp")), 2)
        for code in blocks("cpp"):
            done = compile_cpp(code)
            self.assertEqual(done.returncode, 0, code + done.stderr)

    def test_both_compilations_can_fail(self):
        self.assertNotEqual(compile_glsl(blocks("glsl")[0].replace("hn_perlin", "hn_merlin")).returncode, 0)
        self.assertNotEqual(compile_cpp(blocks("cpp")[0].replace("hn_fbm", "hn_fmb")).returncode, 0)


if __name__ == "__main__":
    PICTURE = sys.argv.pop(1)
    unittest.main()
