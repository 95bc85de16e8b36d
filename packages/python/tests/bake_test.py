"""python -m hashnoise bake: the bytes of files, which other programs read, and what happens if one cannot be made."""

from __future__ import annotations

import contextlib
import io
import json
import os
import pty
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import termios
import time
import unittest
import zlib
from pathlib import Path
from unittest import mock

import golden
import hashnoise
import numpy
import png
from hashnoise import _bake, _bake_values, _grids

from ship.python import metadata

PAGE = golden.ROOT / "docs" / "guide" / "bake.md"
PLAYGROUND = golden.ROOT / "playground"
JAVASCRIPT = golden.ROOT / "tools" / "lib" / "base" / "javascript" / "environment.py"
COMMAND = [sys.executable, "-m", "hashnoise", "bake"]
# CRC-32 of files that the program in C++ wrote, which was there before, and of masks.
RAW = {
    "perlin --size 50x30 -o a.f32": 0x90A9F7EF,
    "fbm --noise simplex --size 48x32 --cells 6 --tile --seed 7 -o a.r16": 0xC99F1F33,
    "cellular --size 33x21 --cells 7x3 --tile --components f2 -o a.r16": 0x6F6BD930,
    "cellular_three --size 33x21 --metric hybrid --normalize -o a.r16": 0x6D0083EE,
    "curl --size 9x8x7 --cells 3.7 --origin 1000000000.3x-2.25x0 -o a.f32": 0x7EA94CD8,
    "phasor --wave -2.5x0.1 --phase 0.25 --size 31x17 -o a.f32": 0x476F345B,
    "ridged --size 64x48 --octaves 3 --lacunarity 3 --gain 0.6 --period 5x0 --cells 11.3 -o a.f32": 0xAD49F19A,
    "fbm --size 40x30 --detail 2.5 --origin -7.3x1e6 -o a.f32": 0xB47F9D16,
    "fbm --footprint 0.3 --size 40x30 --origin 1e6x-5 -o a.f32": 0x22A47BE2,
    "perlin_d --size 31x17 --arithmetic precise --range -1:1 --range -2:2 --range -4:4 -o a.r16": 0x0A874FFA,
    "perlin_worley --octaves 4 --size 6x4x4 --cells 3x2x2 --tile -o a.f32": 0x54AE6220,
    "value_d --size 5x4x3x2 --cells 7 -o a.f32": 0x3A104B74,
    "warp --amplitude 0.3 --size 20x10 --seed 4294967295 -o a.r16": 0x19B29536,
    "value --size 1001 --cells 13 --tile -o a.f32": 0xF11BA98B,
    "perlin --phase 0.1 --period 4x0 --origin 5x-6.5 --size 20x10 --range -0.25:0.25 -o a.r16": 0x21BA963A,
    "random --size 20x10 --cells 20 -o a.f32": 0x42BA4575,
    "eroded --noise value_d --strength 0.5 --size 40x30 -o a.f32": 0x4CE7875D,
    "cellular --jitter 0.4 --size 40x30 --arithmetic precise --cells 1073741824 -o a.f32": 0xACEBDAFF,
    "ping_pong --strength 1.75 --noise value_cubic --size 1x300 --cells 0.01 -o a.f32": 0x0014CBE1,
    "cellular_d --size 2100x1100 --cells 91x37 --tile --seed 3 -o a.r16": 0x6C6FB08D,  # in several pieces
    "value --size 1200000 --cells 64 --tile -o a.r16": 0x3A5B0A0E,  # the pieces of a row
    "bluenoise --size 16 --components 3 -o a.r16": 0x56164B43,
    "bluenoise --size 12x10 --frames 5 --seed 7 -o a.f32": 0xDA520082,
}
USAGE = (
    # The package's errors (options_test.py has more).
    ("fmb -o a.png", "'fmb' (did you mean fbm?)"), ("perlin --noise value -o a.png", "perlin has no option noise"),
    ("fbm -o a.png --octaves 33", "octaves must be from 1 to 32"), ("fbm -o a.png --threads 0", "threads must be from 1"),
    ("fbm -o a.png --seed -1", "seed must be from 0 to 4294967295"),
    ("fbm", "--out"), ("-o a.exr", "a function is missing"), ("fbm --source a.py -o a.exr", "--expression"),
    ("fbm ridged -o a.png", "unrecognized arguments: ridged"), ("fbm -o a.png --octave 2", "arguments: --octave"),
    ("fbm -o a.png --gain inf", '--gain: "inf" is not a number'),
    *((f"fbm -o a.png --size {size}", f'--size: "{size}"', "at most four", "as in 1024x1024")
      for size in ("0x4", "4xx4", "1e3", "4x4x4x4x4")),
    ("fbm -o a.png --cells 0", "--cells"), ("fbm -o a.png --cells nan", "--cells"),
    ("fbm -o a.png --cells 1x2x3", "--cells", "--size has 2"),
    ("fbm -o a.png --cells 2.5 --tile", "whole numbers of cells"),
    ("fbm -o a.png --size 1x9 --cells 1e9", "--cells", "1073741824"), ("fbm -o a.png --tile --period 8x8", "--period"),
    ("fbm -o a.png --period 8x8x8", "3 axes", "or one for all"),
    ("fbm -o a.png --period -1x4", "--period", "from 0 to 2147483647"), ("fbm -o a.png --origin 1", "--origin"),
    ("phasor -o a.png --wave 2x-16.5", "from -16 to 16", "2.5x-1.5"), ("phasor -o a.png --wave 2", "1 axes"),
    *((f"fbm -o a.png --range {text}", f'--range: "{text}"', "-1:1") for text in ("1:-1", "1", "0:nan", "-1e308:1e308")),
    ("fbm -o a.png --range 0:1 --normalize", "leave one out"), ("fbm -o a.png --range 0:1 --range 0:1", "2 times"),
    ("fbm -o a.exr --range 0:1", "as they are"), ("fbm -o a.f32 --normalize", "as they are"),
    ("fbm -o a.raw", "does not state the format", "r16"), ("fbm -o a.png --format tiff", "--format: invalid choice"),
    ("fbm -o a.png --layout slices", "volumes"), ("fbm -o a.r16 --size 4x4x4 --columns 2", "volumes"),
    ("fbm -o a.png --size 4x4x4 --columns 2 --layout slices", "--layout atlas"),
    ("fbm -o a.png --size 4x4x4 --columns 0", "--columns: 0 is not"),
    ("fbm -o a.png --size 20000000x4", "16777216 pixels"), ("fbm -o a.png --size 9 --y-up", "two axes or more"), ("cellular -o a.png --components f3", '"f3"', "f1, f2"),
    ("cellular -o a.png --components f1,f1", "twice"),
    ("cellular -o a.png --metric manhattan", "--range", "--normalize"),
    ("value_d -o a.png --size 2x2x2x2", "at most 4", "--components"),
    ("fbm -o a.ktx2 --size 2x2x2x2", "at most three axes"), ("fbm_d -o a.png", "no range is documented"),
    ("fbm -o . --format png", "it is a folder"), ("fbm -o none/a.png", "there is no folder none; make it"),
    ("fbm -o /dev/null --format f32", "no regular file"), ("fbm -o a.f32 --size 500000000x500000000", "GB"),
    *((f"bluenoise -o a.png {more}", *parts) for more, *parts in (
        ("--octaves 3", "bluenoise has no option octaves", "components, frames, seed, size"), ("--tile", "option tile"),
        ("--phase 0", "option phase"), ("--size 8x8x8", "--frames is for a volume"), ("--size 513", "at most 512"),
        ("--frames 257", "257 is more than 256"), ("--frames 0", "--frames: 0 is not"), ("--seed -1", "seed must be"),
        ("--components x,y", '1 to 4, and not "x,y"'), ("--components 5", "1 to 4"))),
    ("bluenoises -o a.png", "(did you mean bluenoise?)"), ("fbm --frames 3 -o a.png", "--frames is for bluenoise"),
    ("fbm --expression fbm() -o a.exr", '"fbm" is one argument too many'),
    ("--expression fbm() -o a.png", "no range is documented", "--normalize"),
    ("--expression fbm() --octaves 6 -o a.exr", "--octaves is for a function"),
    ("--expression fbm() --source none.py -o a.exr", "cannot read none.py"),
    ("--expression fmb() -o a.f32", "--expression: NameError", "did you mean fbm?"),
    ("--expression fbm( -o a.f32", "--expression: SyntaxError"), ("--expression fbm(octave=3) -o a.f32", "TypeError"),
    ("--expression [x]*5 -o a.f32", "5 components"), ("--expression str(x) -o a.f32", "ValueError"),
)


class Bake(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.enterContext(contextlib.chdir(self.folder))

    def call(self, line):
        """The status, and what is printed."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = _bake.main(line if isinstance(line, list) else shlex.split(line))
        return status, out.getvalue(), err.getvalue()

    def bake(self, line):
        """The bytes of the file, or of the files by their names; and what is printed."""
        status, out, err = self.call(line)
        self.assertEqual(status, 0, err)
        return out, err

    def planes(self, name, shape, kind="<f4"):
        return numpy.fromfile(name, kind).reshape(shape)

    def node(self, *command):
        """The output of a program in JavaScript."""
        run = [sys.executable, "-B", JAVASCRIPT, "run", os.environ["HASHNOISE_JAVASCRIPT"], "node"]
        done = subprocess.run([*run, *command], capture_output=True, text=True, check=False)
        if done.returncode == 77:
            self.skipTest(done.stdout)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def read_png(self, name):
        data = Path(name).read_bytes()
        width, height, rows, _ = png.Reader(bytes=data).read()
        chunks = [*png.Reader(bytes=data).chunks()]
        self.assertLessEqual({kind for kind, _ in chunks}, {b"IHDR", b"tEXt", b"IDAT", b"IEND"})  # no colour space
        texts = [text.decode("ascii").split("\0", 1) for kind, text in chunks if kind == b"tEXt"]
        pixels = numpy.array([*rows]).reshape(height, width, -1)
        return numpy.moveaxis(pixels, -1, 0), json.loads(dict(texts)["hashnoise"])


class Files(Bake):
    def test_raw_files_have_the_bytes_of_the_program_before(self):
        for line, expected in RAW.items():
            with self.subTest(line):
                self.bake(line)
                self.assertEqual(f"{zlib.crc32(Path(line.split()[-1]).read_bytes()):08x}", f"{expected:08x}")

    def test_they_are_the_values_of_the_package(self):
        self.bake("simplex_d --size 64x32x4 --cells 16x8x2 --seed 9 --origin 0.25x-0.125x1000000000.5 -o a.f32")
        expected = hashnoise.grid("simplex_d", (64, 32, 4), step=(0.25, 0.25, 0.5), cell=(0, -1, 1000000000),
                                  origin=(0.25, 0.875, 0.5), seed=9, arithmetic="fixed")
        self.assertEqual(self.planes("a.f32", (4, 4, 32, 64)).tobytes(), expected.tobytes())

    def test_they_depend_on_nothing_but_the_settings(self):
        for ending in ("png", "exr", "r16"):
            files = set()
            for more in ("", "--threads 1", *(f"--instruction-set {name}" for name in hashnoise.instruction_sets())):
                self.bake(f"ridged --noise simplex --size 333x222 --seed 5 -o a.{ending} {more}")
                files.add(Path(f"a.{ending}").read_bytes())
            self.assertEqual(len(files), 1, ending)

    def test_a_picture_has_the_words_and_how_it_was_made(self):
        for line, samples in (("fbm --noise simplex --size 48x32 --cells 6 --tile --seed 7", 1),
                              ("cellular --size 31x17", 3), ("perlin_d --size 31x17", 3),
                              ("perlin_d --size 31x17x1", 4)):
            with self.subTest(line):
                out, _ = self.bake(f"{line} -o a.png --json")
                self.bake(f"{line} -o a.r16")
                pixels, record = self.read_png("a.png")
                planes = self.planes("a.r16", (-1, *pixels.shape[1:]), "<u2")
                self.assertEqual((len(pixels), pixels[:len(planes)].tolist()), (samples, planes.tolist()))
                self.assertFalse(pixels[len(planes):].any())
                printed = json.loads(out)
                self.assertEqual({key: printed[key] for key in record if key != "components"},
                                 {key: value for key, value in record.items() if key != "components"})
                self.assertEqual(record["components"][0]["range"], "documented")
                self.assertEqual(printed["files"], ["a.png"])

    def test_other_programs_read_textures_and_exr(self):
        """bake_readers.mjs prints what readers of three.js find."""
        raw = {}
        for name, line, count, form in (
                ("a.exr", "simplex_d --size 50x30", 3, "R G B"), ("b.exr", "fbm --size 20x9", 1, "Y"),
                ("c.exr", "perlin_d --size 5x4x3", 4, "R G B A"), ("d.ktx2", "perlin_d --size 5x4x3", 4, 109),
                ("e.ktx2", "fbm --size 7", 1, 100), ("f.ktx2", "cellular --size 7x5 --normalize", 2, 77),
                ("g.ktx2", "curl --size 4x3x2", 3, 84), ("h.ktx2", "fbm --size 3", 1, 70)):
            words = form in (77, 84, 70)
            self.bake(f"{line} -o {name} {'' if words or name[2:] == 'exr' else '--format ktx2-float'}")
            self.bake(f"{line} -o raw.{'r16' if words else 'f32'}")
            raw[name] = numpy.fromfile(f"raw.{'r16' if words else 'f32'}", "<u2" if words else "<f4"), count, form
        found = json.loads(self.node(Path(__file__).with_name("bake_readers.mjs"), self.folder))
        self.assertEqual(found.keys(), raw.keys())
        for name, (values, count, form) in raw.items():
            with self.subTest(name):
                self.assertEqual(found[name]["form"], form)
                self.assertEqual(len(found[name]["record"]["components"]), count)
                planes = numpy.array(found[name]["planes"], values.dtype)
                if name == "c.exr":  # three slices in an atlas of two columns
                    rows = planes.reshape(4, 2, 4, 2, 5)
                    planes = rows.transpose(0, 1, 3, 2, 4).reshape(4, 4, 20)[:, :3]
                    self.assertFalse(rows[:, 1, :, 1].any())
                self.assertEqual(planes.tobytes(), values.tobytes())

    def test_volumes(self):
        self.bake("perlin --size 8x6x5 -o a.r16")
        words = self.planes("a.r16", (5, 6, 8), "<u2")
        self.bake("perlin --size 8x6x5 -o atlas.png --columns 2")
        atlas = self.read_png("atlas.png")[0][0].reshape(3, 6, 2, 8).transpose(0, 2, 1, 3).reshape(6, 6, 8)
        self.assertEqual(atlas[:5].tolist(), words.tolist())
        self.bake("perlin --size 8x6x5 -o s.png --layout slices")
        for z in range(5):
            picture, record = self.read_png(f"s.00{z}.png")
            self.assertEqual((picture[0].tolist(), record["slice"]), (words[z].tolist(), z))
        self.bake("value --size 100 -o line.png")
        self.assertEqual(self.read_png("line.png")[0].shape, (1, 1, 100))

    def test_a_tile_goes_on_where_it_ends(self):
        for name in ("fbm --noise simplex", "cellular", "warp", "value_cubic"):
            self.bake(f"{name} --size 100x36 --cells 7x5 --tile -o tile.f32")
            self.bake(f"{name} --size 200x72 --cells 14x10 --period 7x5 -o four.f32")
            self.bake(f"{name} --size 49x49 --tile -o exact.f32")  # 8 / 49 * 49 is not 8
            tile = self.planes("tile.f32", (-1, 36, 100))
            self.assertEqual(self.planes("four.f32", (-1, 72, 200)).tobytes(), numpy.tile(tile, (1, 2, 2)).tobytes())
        self.bake("fbm --size 200x72 --cells 14x10 -o none.f32")
        self.assertNotEqual(*self.planes("none.f32", (72, 200))[0, [0, 100]])

    def test_the_record_of_a_file_makes_it_again(self):
        for line in ("fbm --seed 3 --gain 0.6 --detail 3.25", "cellular --jitter 0.4", "warp --amplitude 0.3", "warp",
                     "ping_pong --strength 1.75 --noise value", "perlin --phase 0.1 --period 4x0 --origin 5x-6.5",
                     "phasor --wave -2.5x0.1 --phase 0.25", "phasor", "fbm --noise cellular_smooth", "eroded"):
            with self.subTest(line):
                self.bake(f"{line} --size 20x10 --cells 4 -o a.png")
                record = self.read_png("a.png")[1]
                given = {**record["settings"], **{name: record[name] for name in ("size", "cells", "origin")}}
                again = [record["function"]]
                for name, value in given.items():
                    parts = value if isinstance(value, list) else [value]
                    again += [f"--{name}", "x".join(map(str, parts))]
                self.bake([*again, "-o", "b.png"])
                self.assertEqual(Path("a.png").read_bytes(), Path("b.png").read_bytes())
        self.assertEqual(record["settings"], {"noise": "perlin_d", "octaves": 6, "lacunarity": 2.0, "gain": 0.5,
                                              "strength": 1.0, "arithmetic": "fixed", "seed": 0})

    def test_clamped_values_and_nan_are_warnings(self):
        self.bake("perlin --size 64x64 -o a.f32")
        values = self.planes("a.f32", -1)
        outside = int((abs(values) > 0.25).sum())
        out, err = self.bake("perlin --size 64x64 --range -0.25:0.25 -o a.r16 --json")
        least, greatest = values.min(), values.max()  # in the fewest digits
        self.assertIn(f"warning: {outside} values of value are outside of -0.25 to 0.25, and became its ends; they go "
                      f"from {least!s} to {greatest!s}\n", err)
        self.assertEqual(json.loads(out)["components"][0]["clamped"], outside)
        _, err = self.bake("--expression numpy.where(x==0,numpy.nan,x) --size 8x4 --range 0:8 -o a.r16")
        self.assertIn("4 values of value are NaN, and became 0", err)
        self.assertEqual(self.call("--expression numpy.where(x==0,numpy.inf,x) --normalize -o a.r16")[0], 1)

    def test_words(self):
        for values, ends, words in (
                ([-1, 0, 1, -0.5], (-1, 1), [0, 32768, 65535, 16384]), ([0.5, 0.5], (0.5, 0.5), [0, 0]),
                ([1.1, -0.1, numpy.nan, numpy.inf, -numpy.inf, 1], (0, 1), [65535, 0, 0, 65535, 0, 65535]),
                (numpy.arange(65536) / 65536, (0, 65535 / 65536), [*range(65536)])):
            self.assertEqual(_bake_values.words_of(numpy.array(values, numpy.float32), *ends).tolist(), words)

    def test_places(self):
        for origin, cells, size, cell, fraction in (
                (0.0, 2.0, 8, [0] * 4 + [1] * 4, [0, 0.25, 0.5, 0.75] * 2), (-0.25, 1.0, 2, [-1, 0], [0.75, 0.25]),
                (2.0**30 - 0.5, 1.0, 4, [2**30 - 1] * 2 + [2**30] * 2, [0.5, 0.75, 0, 0.25])):
            found = _bake_values.places(origin, cells, size, numpy.arange(size))
            self.assertEqual([part.tolist() for part in found], [cell, fraction])
        for cells, size in ((1, 7), (1000, 1001), (2**20, 4001)):  # errors do not add up
            index = numpy.arange(2 * size)
            cell, fraction = _bake_values.places(0.0, 2.0 * cells, 2 * size, index)
            one, of_one = _bake_values.places(0.0, float(cells), size, index[:size])
            self.assertEqual(cell[size:].tolist(), (one + cells).tolist())
            self.assertEqual(fraction[size:].tolist(), of_one.tolist())

    def test_y_up_turns_the_rows(self):
        for name in ("fbm --size 9x7", "fbm --size 9x7x4 --layout slices", "fbm --size 9x7x2x2"):
            self.bake(f"{name.partition(' --layout')[0]} -o a.f32")
            self.bake(f"{name.partition(' --layout')[0]} --y-up -o b.f32")
            a, b = (self.planes(file, (-1, 7, 9)) for file in ("a.f32", "b.f32"))
            self.assertEqual(a[:, ::-1].tobytes(), b.tobytes(), name)
        self.bake("fbm --size 9x7x4 --layout slices --y-up -o s.png")
        self.bake("fbm --size 9x7x4 --y-up -o a.r16")
        self.assertEqual(self.read_png("s.002.png")[0][0].tolist(), self.planes("a.r16", (4, 7, 9), "<u2")[2].tolist())
        self.assertIs(self.read_png("s.002.png")[1]["y-up"], True)

    def test_a_file_larger_than_the_memory_of_the_command(self):
        call = [*COMMAND, *"value --size 12000x6000 -o a.r16".split()]
        with subprocess.Popen(call, stdout=subprocess.DEVNULL) as process:
            _, process.returncode, usage = os.wait4(process.pid, 0)
        self.assertEqual((process.returncode, Path("a.r16").stat().st_size), (0, 144_000_000))
        self.assertLess(usage.ru_maxrss, 110_000)  # KiB


class Expressions(Bake):
    def test_values(self):
        place = "--size 100x57 --cells 7x3 --tile --seed 9"
        Path("a.py").write_text("def both(a, b):\n    return a - 0.3 * b[1]\n", encoding="utf-8")
        self.bake([*f"{place} --source a.py -o a.f32 --expression".split(),
                   "fbm(), both(simplex(seed=3), cellular(seed=5)), perlin(2 * x, y, period=(14, 3)), x"])
        found = self.planes("a.f32", (4, 57, 100))
        of = {}
        for name, seed in (("fbm", 9), ("simplex", 3), ("cellular", 5)):
            self.bake(f"{name} {place} --seed {seed} -o b.f32")
            of[name] = self.planes("b.f32", (-1, 57, 100))
        self.assertEqual(found[0].tobytes(), of["fbm"].tobytes())
        self.assertEqual(found[1].tobytes(), (of["simplex"][0] - numpy.float32(0.3) * of["cellular"][1]).tobytes())
        x, y = numpy.float32(numpy.arange(100) * 7 / 100), numpy.float32(numpy.arange(57) * 3 / 57)[:, numpy.newaxis]
        numpy.testing.assert_allclose(found[2], hashnoise.perlin(2 * x, y, period=(14, 3), seed=9), atol=1e-4)
        numpy.testing.assert_allclose(found[3], numpy.broadcast_to(x, (57, 100)), atol=1e-6)

    def test_forms(self):
        for expression, size, shape in (
                ("fbm()", "1030x1026", (1, 1026, 1030)), ("value()", "9", (1, 9)), ("curl()", "5x4x3", (3, 3, 4, 5)),
                ("0.5", "3", (1, 3)), ("perlin(y)", "1100x1906", (1, 1906, 1100)), ("3 * [x]", "4", (3, 4)),
                ("-value(x)", "3", (1, 3)), ("fbm(points=[0.5, 0.5])", "2x2", (1, 2, 2))):
            with self.subTest(expression):
                self.bake(["--expression", expression, "--size", size, "-o", "a.f32"])
                self.assertTrue(numpy.isfinite(self.planes("a.f32", shape)).all())

    def test_a_volume_of_slices_has_its_planes(self):
        self.bake("--expression fbm() --size 20x9x4x2 --cells 8 -o a.f32")
        self.bake("fbm --size 20x9x4x2 --cells 8 -o b.f32")
        self.assertEqual(Path("a.f32").read_bytes(), Path("b.f32").read_bytes())

    def test_an_error_has_the_line_of_the_file(self):
        Path("a.py").write_text("def f(v):\n    if v.shape[-1] > 1:\n        raise ValueError('no')\n    return v\n")
        status, _, err = self.call("--expression f(x) --source a.py -o a.f32")
        self.assertEqual((status, err), (1, "hashnoise bake: --source a.py, line 3: ValueError: no\n"))
        self.assertEqual(os.listdir(), ["a.py"])
        Path("a.py").write_text("x = 1\nx = = 1\n")
        self.assertIn("--source a.py, line 2: SyntaxError", self.call("--expression f(x) --source a.py -o a.f32")[2])


class Endings(Bake):
    def test_bad_usage(self):
        for line, *parts in USAGE:
            with self.subTest(line):
                status, out, err = self.call(line)
                self.assertEqual((status, out), (2, ""), err)
                self.assertRegex(err, r"\Ahashnoise bake: [^\n]+\n\Z")
                for part in parts:
                    self.assertIn(part, err)
                self.assertEqual(os.listdir(), [])

    def test_what_is_no_file_stays_and_so_do_files_beside(self):
        os.mkfifo("pipe.f32")
        Path("real.f32").write_text("old")
        Path("link.f32").symlink_to("real.f32")
        Path("a.001.png").mkdir()
        status, _, err = self.call("perlin --size 4x4 -o pipe.f32")
        self.assertEqual((status, "no regular file" in err), (2, True))
        status, _, err = self.call("perlin --size 4x4x4 --layout slices -o a.png")
        self.assertEqual((status, "--out a.001.png: it is a folder" in err), (2, True))
        self.bake("perlin --size 4x4 -o link.f32")
        self.assertEqual((Path("link.f32").is_symlink(), Path("real.f32").stat().st_size), (True, 64))
        self.assertEqual(sorted(os.listdir()), ["a.001.png", "link.f32", "pipe.f32", "real.f32"])

    def test_a_full_disk_leaves_the_old_file(self):
        for name in ("a.f32", "a.png", "a.exr", "a.ktx2"):
            Path(name).write_text("old")
            line = f"ulimit -f 8; exec {shlex.join([*COMMAND, 'perlin', '-o', name])}"
            done = subprocess.run(["bash", "-c", line], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(f"hashnoise bake: cannot write {name}", done.stderr)
            self.assertEqual(Path(name).read_text(), "old")
        self.assertEqual(len(os.listdir()), 4)

    def test_a_signal_leaves_no_half_file(self):
        for number, name in ((signal.SIGINT, "a.png"), (signal.SIGTERM, "a.r16")):
            call = [*COMMAND, "ridged", "--size", "9000x9000", "--threads", "1", "-o", name]
            with self.subTest(number), subprocess.Popen(call) as process:
                while not list(self.folder.glob("*.part")) and process.poll() is None:
                    time.sleep(0.01)
                process.send_signal(number)
                self.assertEqual((process.wait(60), os.listdir()), (128 + number, []))

    def test_a_standard_output_that_is_full(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([*COMMAND, "perlin", "-o", "a.f32"], stdout=full, stderr=subprocess.PIPE, text=True,
                                  check=False)
        self.assertEqual((done.returncode, "standard output" in done.stderr), (1, True), done.stderr)

    def test_progress_is_for_terminals(self):
        call = [*COMMAND, *"ridged --size 3000x3000 --threads 1 -o a.r16".split()]
        self.assertEqual(subprocess.run(call, capture_output=True, text=True, check=True).stderr, "")
        ours, theirs = pty.openpty()
        termios.tcsetwinsize(theirs, (24, 80))
        with subprocess.Popen(call, stderr=theirs, stdout=subprocess.DEVNULL):
            os.close(theirs)
            printed = b""
            with contextlib.suppress(OSError):  # the other end is closed
                while part := os.read(ours, 4096):
                    printed += part
        os.close(ours)
        self.assertRegex(printed.decode(), r"%\|.*9\.00M.*points/s")

    def test_without_the_libraries(self):
        with mock.patch.dict(sys.modules, {"OpenImageIO": None, "tqdm": None}):
            self.bake("fbm --size 4x4 -o a.r16")
            self.bake("fbm --size 4x4 -o a.png")
            status, _, err = self.call("fbm -o a.exr")
        self.assertEqual((status, "pip install 'hashnoise[bake]'" in err, len(os.listdir())), (4, True, 2))

    def test_another_command(self):
        done = subprocess.run([*COMMAND[:-1], "bakery"], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, "the command is bake" in done.stderr), (2, True), done.stderr)


@unittest.skipUnless(PLAYGROUND.is_dir(), "there is no playground")
class Links(Bake):
    """Files of links, which the playground saves, too."""

    LINKS = (
        "#seed=3&arithmetic=fixed&x=2.3&y=-7.1&cells=3&width=61&height=40",
        "#sum=none&noise=cellular_second&dimensions=3&z=1.5&arithmetic=fixed&x=1e6&y=0.5&cells=7&width=64&height=33",
        "#arithmetic=fixed&period=3&view=tiles&width=48&height=48&driftx=0.3&drifty=-0.5&time=7.5",
        "#arithmetic=fixed&sum=ridged&cells=5&width=50&height=70&drifty=0.25&time=9.5&sum2=none&noise2=middle&driftx2=-0.1&blend2=add&seed3=5&blend3=mask&blend4=multiply",
    )

    def test_they_look_as_the_page(self):
        from ship.playground.linked import words_of_bake

        links = [f"{link}&file={kind}" for link in self.LINKS for kind in ("heights", "r32")]
        self.node(PLAYGROUND / "tests" / "save.mjs", os.environ["HASHNOISE_PAGE"], self.folder, *links)
        for number, link in enumerate(links):
            with self.subTest(link):
                is_raw = link.endswith("r32")
                words, source = words_of_bake(link, ("-o", "a.f32" if is_raw else "a.png"))
                Path("pattern.py").write_text(source, encoding="utf-8")
                self.bake(words)
                if is_raw and not source:
                    self.assertEqual(Path("a.f32").read_bytes(), Path(str(number)).read_bytes())
                elif not is_raw:
                    width, height, rows, _ = png.Reader(bytes=Path(str(number)).read_bytes()).read()
                    page = numpy.array([*rows]).reshape(1, height, width).astype(int)
                    baked = self.read_png("a.png")[0]
                    # In place of 65,536 numbers there are 65,535; and the page rounds each of four layers to steps of 2^-16.
                    self.assertLessEqual(abs(baked - page).max(), 4 if source else 1)
                    for wrong in (page[:, ::-1], (page + numpy.roll(page, 1, 2)) // 2):  # upside down, or by half a pixel
                        self.assertGreater(abs(baked - wrong)[..., 1:].max(), 500)

    def test_corners_are_those_of_the_function(self):
        """A size in the options takes the place of the link's."""
        from ship.playground.linked import words_of_bake

        self.bake(words_of_bake("#seed=3&arithmetic=fixed&x=2.25&y=-7&cells=3&width=61", ("--size=24x49", "-o", "a.f32"))[0])
        values = self.planes("a.f32", (49, 24))
        for row, y in ((0, -7 + 24 / 8), (48, -7 - 24 / 8)):
            for column, x in ((0, 2.25 - 12 / 8), (23, 2.25 + 11 / 8)):
                self.assertEqual(values[row, column], hashnoise.fbm(x, y, seed=3, arithmetic="fixed"), (row, column))


class Page(Bake):
    def test_its_commands_write_what_they_name(self):
        text = PAGE.read_text(encoding="utf-8")
        calls = [shlex.split(line)[1:] for line in text.splitlines() if line.startswith("    tools/bake ")]
        self.assertGreaterEqual(len(calls), 10)
        name, source = re.search(r"`(\w+\.py)`:\n\n```python\n(.*?)```", text, re.DOTALL).groups()
        Path(name).write_text(source, encoding="utf-8")
        for call in calls:
            with self.subTest(call):
                self.assertEqual(self.bake(call)[1], "")
                out = Path(call[call.index("-o") + 1])
                self.assertTrue(list(self.folder.glob(f"{out.stem}*{out.suffix}")))
        self.assertEqual(len(list(self.folder.glob("cells.*.png"))), 64)
        self.assertGreater(len(set(re.findall(r"`(--[\w-]+)", text))), 10)
        self.assertLessEqual(set(re.findall(r"`(--[\w-]+)", text)) - {"--help"},
                             {name for action in _bake.options()._actions for name in action.option_strings})


class Ranges(unittest.TestCase):
    """The documented ranges, by which 16 bits are scaled."""

    @staticmethod
    def ranges(name, dimensions, **options):
        field = _grids.field_of("ranges", name, dimensions, options)
        return dict(zip(field.component_names, field.ranges))

    def test_each_stands_in_the_comment_of_its_function(self):
        found = 0
        for dimensions in range(1, 5):
            for name in hashnoise.noises(dimensions):
                has_phase = name != "phasor" and "phase" in _bake_values.FUNCTIONS[name].__kwdefaults__
                for phase in (None, 0.25)[:1 + (has_phase and dimensions in (2, 3))]:
                    stem = name.removesuffix("_d") + "_phase" if phase else name
                    text = self.comment(f"{stem}{dimensions}d")
                    for component, ends in self.ranges(name, dimensions, phase=phase).items():
                        if tuple(ends) in ((-1, 1), (0, 1)):
                            continue
                        # The page of two distances has the rest on three.
                        is_of_two = component[0] == "f" and component != "f3" and name != "cellular"
                        page = self.comment(f"cellular{dimensions}d") if is_of_two else text
                        written = "[{}]".format(", ".join("7/8" if end == 0.875 else f"{end:g}" for end in ends))
                        self.assertIn(written, page, (name, dimensions, component))
                        found += 1
        self.assertGreater(found, 30)

    @staticmethod
    def comment(stem):
        text = (golden.ROOT / "glsl" / "hashnoise" / f"{stem}.glsl").read_text(encoding="ascii")
        return re.sub(r"\n// {12}", " ", text)  # a range may be broken into two lines

    def test_values_are_within_and_use_it(self):
        for dimensions, size in ((2, (200, 200)), (3, (40, 40, 40))):
            for name in (*hashnoise.noises(dimensions), *hashnoise.fractals(dimensions)):
                planes = hashnoise.grid(name, size, step=37 / size[0], arithmetic="fixed")
                planes = planes.reshape(-1, size[0]**dimensions)
                for plane, (component, ends) in zip(planes, self.ranges(name, dimensions).items()):
                    with self.subTest(name, component=component, dimensions=dimensions):
                        self.assertEqual(ends is None, name in ("fbm_d", "curl_fbm") and component != "value")
                        if ends:  # the fixed arithmetic may exceed a range by its error
                            self.assertGreaterEqual(plane.min(), ends[0] - 1e-3)
                            self.assertLessEqual(plane.max(), ends[1] + 1e-3)
                            self.assertGreaterEqual(plane.max() - plane.min(), 0.2 * (ends[1] - ends[0]))

    def test_settings_change_them(self):
        self.assertEqual(self.ranges("cellular", 2, metric="manhattan"), {"f1": None, "f2": None})
        self.assertEqual(self.ranges("warp", 2, amplitude=2.5), {"x": (-2.5, 2.5), "y": (-2.5, 2.5)})


class Command(unittest.TestCase):
    """tools/bake, in a copy of what it is made of."""

    def setUp(self):
        self.root = Path(self.enterContext(tempfile.TemporaryDirectory()), "root")
        for name in (*metadata.SOURCES, *(f"tools/{one}" for one in ("bake", "lib/base", "lib/ship/page.py", "lib/ship/python"))):
            path = self.root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            copy = shutil.copytree if (golden.ROOT / name).is_dir() else shutil.copy
            copy(golden.ROOT / name, path)
        # There is no virtual environment, so that a build ends at once, with status 4.
        python = self.root.with_name("python3")
        python.write_text(f'#!/bin/sh\n[ "$2" != venv ] && exec {sys.executable} "$@"\n', encoding="ascii")
        python.chmod(0o755)

    def status(self, file="value.png"):
        variables = {**os.environ, "PATH": f"{self.root.parent}:{os.environ['PATH']}"}
        variables.pop("PYTHONPATH", None)  # it has OpenImageIO
        done = subprocess.run([self.root / "tools" / "bake", "value", "--size=8x8", "-o", self.root.with_name(file)],
                              env=variables, capture_output=True, text=True, check=False)
        self.assertEqual("about a minute" in done.stderr, done.returncode == 4, done.stderr)
        return done.returncode

    def test_a_package_that_is_installed_is_taken(self):
        self.assertEqual(self.status(), 0)
        self.assertTrue(self.root.with_name("value.png").is_file())
        self.assertEqual(self.status("value.exr"), 4)

    def test_one_of_other_sources_is_not(self):
        for name, status in (("CMakeLists.txt", 4), ("glsl/hashnoise/value2d.glsl", 4), ("include/hashnoise/field.hpp", 4),
                             ("packages/python/core.cpp", 4), ("packages/python/hashnoise/_bake.py", 4), ("pyproject.toml", 4),
                             ("src/CMakeLists.txt", 4), ("src/grid/plan.cpp", 4), ("src/grid/new.hpp", 4),
                             ("src/grid/tests/new.cpp", 0), ("packages/python/tests/new_test.py", 0), ("docs/new.md", 0)):
            with self.subTest(name):
                path = self.root / name
                path.parent.mkdir(exist_ok=True)
                before = path.read_bytes() if path.exists() else None
                path.write_bytes((before or b"") + b"\n")
                self.assertEqual(self.status(), status)
                path.unlink() if before is None else path.write_bytes(before)
        self.assertEqual(self.status(), 0)
