#!/usr/bin/env python3
"""hn-bake as its user meets it. Usage: bake_cli_test.py PATH-OF-HN-BAKE"""

from __future__ import annotations

import array
import json
import math
import os
import pathlib
import pty
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

PROGRAM = ""


def chunks(data: bytes) -> list[tuple[str, bytes]]:
    """The chunks of a PNG, each with a checksum that is right."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG"
    found, at = [], 8
    while at < len(data):
        length, = struct.unpack(">I", data[at:at + 4])
        name, body = data[at + 4:at + 8], data[at + 8:at + 8 + length]
        assert struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0] == zlib.crc32(name + body)
        found.append((name.decode(), body))
        at += 12 + length
    return found


def paeth(a: int, b: int, c: int) -> int:
    by_a, by_b, by_c = abs(b - c), abs(a - c), abs(a + b - 2 * c)
    return a if by_a <= by_b and by_a <= by_c else b if by_b <= by_c else c


def png(path: pathlib.Path) -> tuple[int, int, int, list[int], dict[str, str]]:
    """Width, height, channels, the samples of 16 bits, and the texts of a PNG."""
    parts = chunks(path.read_bytes())
    width, height, depth, colour = struct.unpack(">IIBB", parts[0][1][:10])
    assert depth == 16
    channels = {0: 1, 2: 3, 6: 4}[colour]
    texts = dict(body.decode("latin-1").split("\0", 1) for name, body in parts if name == "tEXt")
    raw = zlib.decompress(b"".join(body for name, body in parts if name == "IDAT"))
    step, row = 2 * channels, 2 * channels * width
    before, samples = bytearray(row), []
    for y in range(height):
        kind, line = raw[y * (row + 1)], bytearray(raw[y * (row + 1) + 1:(y + 1) * (row + 1)])
        for i in range(row):
            a = line[i - step] if i >= step else 0
            c = before[i - step] if i >= step else 0
            line[i] = (line[i] + [0, a, before[i], (a + before[i]) // 2, paeth(a, before[i], c)][kind]) & 255
        samples += struct.unpack(f">{width * channels}H", line)
        before = line
    return width, height, channels, samples, texts


class Bake(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def call(self, *arguments, **options):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False,
                              cwd=self.folder, timeout=120, **options)

    def bake(self, *arguments):
        done = self.call(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def numbers(self, name: str, kind: str = "f") -> list:
        return array.array(kind, (self.folder / name).read_bytes()).tolist()

    def assert_usage(self, arguments, *parts):
        """Status 2, one line with these texts, and nothing written."""
        done = self.call(*arguments)
        self.assertEqual(done.returncode, 2, (arguments, done.stderr))
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertTrue(done.stderr.startswith("hn-bake: "), done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_picture_has_the_values_and_says_how_it_was_made(self):
        picture = ["fbm", "--noise", "simplex", "--size", "48x32", "--cells", "6", "--tile", "--seed", "7"]
        done = self.bake(*picture, "-o", "a.png", "--json")
        self.bake(*picture, "-o", "a.f32")
        record = json.loads(done.stdout)
        width, height, channels, samples, texts = png(self.folder / "a.png")
        self.assertEqual((width, height, channels), (48, 32, 1))
        values = self.numbers("a.f32")
        self.assertEqual(samples, [math.floor((v + 1) / 2 * 65535 + 0.5) for v in values])
        inside = json.loads(texts["hashnoise"])
        self.assertEqual({key: record[key] for key in inside}, inside)
        self.assertEqual(inside["settings"], {"noise": "simplex", "octaves": 6, "lacunarity": 2, "gain": 0.5,
                                              "arithmetic": "fixed", "seed": 7, "period": [6, 4]})
        component, = inside["components"]
        self.assertEqual((component["least"], component["greatest"]), (min(values), max(values)))
        self.assertEqual((component["0"], component["65535"], component["range"]), (-1, 1, "documented"))
        self.assertEqual(record["files"], ["a.png"])
        self.assertIn("hn-bake", texts["Software"])

    def test_the_record_of_a_file_makes_it_again(self):
        for call in (["fbm", "--seed", "3", "--gain", "0.6", "--detail", "3.25"], ["cellular", "--jitter", "0.4"],
                     ["ping_pong", "--strength", "1.75", "--noise", "value"], ["warp", "--amplitude", "0.3"],
                     ["perlin", "--phase", "0.1", "--period", "4x0", "--origin", "5x-6.5"],
                     ["phasor", "--wave", "-2.5x0.1", "--phase", "0.25"], ["phasor"],
                     ["fbm", "--noise", "cellular_smooth"], ["eroded", "--strength", "0.5"], ["warp"]):
            with self.subTest(call=call):
                self.bake(*call, "--size", "20x10", "--cells", "4", "-o", "a.png")
                record = json.loads(png(self.folder / "a.png")[4]["hashnoise"])
                again = [record["function"]]
                for name, value in record["settings"].items():
                    if name == "noise" and record["function"] == value:
                        continue
                    again += [f"--{name}", "x".join(map(str, value)) if isinstance(value, list) else str(value)]
                for name in ("size", "cells", "origin"):
                    again += [f"--{name}", "x".join(f"{value:g}" for value in record[name])]
                self.bake(*again, "-o", "b.png")
                self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_a_sum_of_its_own_noises_names_none(self):
        done = self.bake("perlin_worley", "--octaves", "4", "--size", "6x5x4", "--cells", "3", "-o", "a.r16", "--json")
        self.assertEqual(json.loads(done.stdout)["settings"],
                         {"octaves": 4, "lacunarity": 2, "gain": 0.5, "arithmetic": "fixed", "seed": 0})

    def test_the_bytes_depend_on_nothing_but_the_settings(self):
        sets = ["sse4.1", "avx2", "avx512"]
        have = [name for name in sets if self.call("perlin", "--size", "1", "--instruction-set", name, "-o",
                                                   "x.f32").returncode == 0]
        self.assertGreaterEqual(len(have), 1)
        for name in ("a.png", "a.exr", "a.f32", "a.r16"):
            call = ["ridged", "--noise", "simplex", "--size", "333x222", "--seed", "5"]
            self.bake(*call, "-o", name)
            reference = (self.folder / name).read_bytes()
            for more in (["--threads", "1"], ["--threads", "3"], *(["--instruction-set", one] for one in have)):
                self.bake(*call, "-o", name, *more)
                self.assertEqual((self.folder / name).read_bytes(), reference, more)
            self.bake(*call, "-o", name, "--arithmetic", "precise")
            self.assertNotEqual((self.folder / name).read_bytes(), reference)

    def test_a_tile_goes_on_where_it_ends(self):
        tile = ["--size", "100x50", "--cells", "7x3"]
        self.bake("fbm", *tile, "--tile", "-o", "tile.f32")
        self.bake("fbm", "--size", "200x50", "--cells", "14x3", "--period", "7x3", "-o", "two.f32")
        self.bake("fbm", "--size", "200x50", "--cells", "14x3", "-o", "no_tile.f32")
        one, two, other = self.numbers("tile.f32"), self.numbers("two.f32"), self.numbers("no_tile.f32")
        columns = [two[y * 200 + 100] for y in range(50)]
        self.assertEqual(columns, [one[y * 100] for y in range(50)])
        self.assertNotEqual([other[y * 200 + 100] for y in range(50)], [other[y * 200] for y in range(50)])

    def test_clamped_values_are_a_warning(self):
        done = self.bake("perlin", "--size", "64x64", "--range", "-0.25:0.25", "-o", "a.r16", "--json")
        self.bake("perlin", "--size", "64x64", "-o", "a.f32")
        outside = sum(abs(value) > 0.25 for value in self.numbers("a.f32"))
        self.assertGreater(outside, 10)
        self.assertIn(f"warning: {outside} values of value are outside of -0.25 to 0.25", done.stderr)
        self.assertEqual(json.loads(done.stdout)["components"][0]["clamped"], outside)
        words = self.numbers("a.r16", "H")
        self.assertEqual((min(words), max(words)), (0, 65535))
        self.assertEqual(self.bake("perlin", "--size", "64x64", "-o", "a.r16").stderr, "")

    def test_normalized(self):
        done = self.bake("fbm", "--size", "64x64", "--normalize", "-o", "a.r16")
        self.assertIn("(normalized) became 0 to 65535", done.stdout)
        words = self.numbers("a.r16", "H")
        self.assertEqual((min(words), max(words)), (0, 65535))

    def test_volumes(self):
        self.bake("perlin", "--size", "8x6x5", "-o", "a.r16")
        words = self.numbers("a.r16", "H")
        self.assertEqual(len(words), 240)
        self.bake("perlin", "--size", "8x6x5", "-o", "atlas.png", "--columns", "2")
        width, height, _, samples, _ = png(self.folder / "atlas.png")
        self.assertEqual((width, height), (16, 18))
        self.bake("perlin", "--size", "8x6x5", "-o", "s.png", "--layout", "slices")
        for z in range(5):
            own = words[z * 48:(z + 1) * 48]
            self.assertEqual(png(self.folder / f"s.00{z}.png")[3], own)
            there = [samples[(z // 2 * 6 + y) * 16 + z % 2 * 8 + x] for y in range(6) for x in range(8)]
            self.assertEqual(there, own)
        self.bake("value", "--size", "100", "-o", "line.png")
        self.assertEqual(png(self.folder / "line.png")[:2], (100, 1))
        self.bake("perlin", "--size", "4x3x2x2", "-o", "four.f32")
        self.assertEqual(len(self.numbers("four.f32")), 48)

    def test_bad_usage(self):
        for arguments, *parts in (
            (["fmb", "-o", "a.png"], '"fmb"', "did you mean fbm?"),
            (["hn_fbm", "-o", "a.png"], "did you mean fbm?"),
            (["FBM", "-o", "a.png"], '"FBM" in 2D (did you mean fbm?)'),
            (["worley", "-o", "a.png"], '"worley" in 2D (here it is cellular)'),
            (["simplex", "--size", "8", "-o", "a.png"], "in 1D", "value"),
            (["perlin", "--noise", "value", "-o", "a.png"], "--noise is for a fractal"),
            (["fbm", "--noise", "perlim", "-o", "a.png"], "did you mean perlin?"),
            (["fbm_d", "--noise", "perlin", "-o", "a.exr"], "perlin_d"),
            (["fbm"], "--out"),
            (["fbm", "-o", "a.raw"], ".r16", "--format"),
            (["fbm", "-o", "a"], "--format"),
            (["fbm", "-o", "a.png", "--format", "tiff"], "exr, f32, r16, ktx2"),
            (["fbm", "-o", "a.png", "--size", "0x4"], '--size "0x4"', "as in 1024x1024"),
            (["fbm", "-o", "a.png", "--size", "4xx4"], "--size"),
            (["fbm", "-o", "a.png", "--size", "1e3"], "--size"),
            (["fbm", "-o", "a.png", "--size", "4x4x4x4x4"], "at most four"),
            (["fbm", "-o", "a.png", "--cells", "0"], "--cells"),
            (["fbm", "-o", "a.png", "--cells", "nan"], "--cells"),
            (["fbm", "-o", "a.png", "--cells", "1x2x3"], "--cells", "--size has 2"),
            (["fbm", "-o", "a.png", "--cells", "2.5", "--tile"], "--tile wants whole numbers", "2.5"),
            (["fbm", "-o", "a.png", "--tile", "--period", "8x8"], "--period"),
            (["fbm", "-o", "a.png", "--tile", "--lacunarity", "inf"], "inf is not a number"),
            (["fbm", "-o", "a.png", "--period", "8x8x8"], "--period", "3 axes", "or one for all"),
            (["fbm", "-o", "a.png", "--origin", "1"], "--origin"),
            (["fbm", "-o", "a.png", "--range", "1:-1"], "--range", "-1:1"),
            (["fbm", "-o", "a.png", "--range", "1"], "--range"),
            (["fbm", "-o", "a.png", "--range", "0:nan"], "--range"),
            (["fbm", "-o", "a.png", "--range=-1e308:1e308"], "--range", "apart"),
            (["fbm", "-o", "a.png", "--range", "0:1", "--normalize"], "leave one out"),
            (["fbm", "-o", "a.png", "--range", "0:1", "--range", "0:1"], "2 times"),
            (["fbm", "-o", "a.exr", "--range", "0:1"], "as they are"),
            (["fbm", "-o", "a.f32", "--normalize"], "as they are"),
            (["fbm", "-o", "a.png", "--layout", "slices"], "volumes"),
            (["fbm", "-o", "a.r16", "--size", "4x4x4", "--columns", "2"], "volumes"),
            (["fbm", "-o", "a.png", "--size", "4x4x4", "--columns", "2", "--layout", "slices"], "--layout atlas"),
            (["cellular", "-o", "a.png", "--components", "f3"], '"f3"', "f1, f2"),
            (["cellular", "-o", "a.png", "--metric", "manhatten"], "did you mean manhattan?"),
            (["cellular", "-o", "a.png", "--metric", "manhattan"], "--range", "--normalize"),
            (["value_d", "-o", "a.png", "--size", "2x2x2x2"], "at most 4", "--components"),
            (["fbm", "-o", "a.png", "--arithmetic", "fix"], "fixed, precise, fast"),
            (["fbm", "-o", "a.png", "--instruction-set", "mmx"], "sse4.1"),
            (["fbm", "-o", "a.png", "--seed", "-1"], "--seed"),
            (["fbm", "-o", "a.png", "--seed", "4294967296"], "--seed"),
            (["fbm", "-o", "a.png", "--phase", "0.5"], "phase"),
            (["fbm", "-o", "a.png", "--wave", "2x1"], '"fbm" in 2D has no wave; phasor has one in 2D and 3D'),
            (["phasor", "-o", "a.png", "--wave", "2"], '--wave "2" has 1 axes, and --size has 2'),
            (["phasor", "-o", "a.png", "--wave", "2x1x0"], '--wave "2x1x0" has 3 axes, and --size has 2'),
            (["phasor", "-o", "a.png", "--wave", "2x-16.5"], '"-16.5" is not a number from -16 to 16', "2.5x-1.5"),
            (["phasor", "-o", "a.png", "--wave", "nanx2"], '"nan" is not a number from -16 to 16'),
            (["phasor", "-o", "a.png", "--wave", "2.5,1.5"], "as in 2.5x-1.5"),
            (["perlin_worley", "-o", "a.ktx2", "--size", "4x4x4", "--noise", "value"],
             "--noise: the fractal perlin_worley has noises of its own"),
            (["fbm", "-o", "a.png", "--detail", "2", "--tile"], ""),
            (["fbm", "-o", "a.png", "--octave", "2"], "did you mean --octaves?"),
            (["fbm", "ridged", "-o", "a.png"], '"ridged"'),
            (["fbm", "-o", "a.png", "--octaves", "0"], "octaves is 0, and has to be from 1 to 32"),
            (["fbm", "-o", "a.png", "--octaves", "-1"], "octaves is -1, and has to be from 1 to 32"),
            (["fbm", "-o", "a.png", "--octaves", "33"], "octaves is 33, and has to be from 1 to 32"),
            (["fbm", "-o", "a.png", "--octaves", "2.5"], "--octaves: 2.5 is not a whole number from 1 to 32"),
            (["fbm", "-o", "a.png", "--octaves", "99999999999"], "octaves is 99999999999, and has to be"),
            (["fbm", "-o", "a.png", "--threads", "0"], "threads is 0, and has to be from 1 to 1024"),
            (["fbm", "-o", "a.png", "--seed", "x"], "--seed", "x is not a whole number from 0 to 4294967295"),
            (["fbm", "-o", "a.png", "--gain", "-0.5"], "gain is -0.5, and has to be a finite number of 0 or more"),
            (["fbm", "-o", "a.png", "--period", "-1x4"], "--period", "from 0 to 2147483647"),
            (["fbm", "-o", "a.png", "--detail", "33"], "detail is 33, and has to be from 0 to 32"),
            (["fbm", "-o", "a.png", "--detail", "2.5", "--octaves", "3"], "detail stands in place of octaves"),
            (["fbm", "-o", "a.png", "--footprint", "-1"], "footprint is -1"),
            (["cellular", "-o", "a.exr", "--jitter", "1.5"], "jitter is 1.5, and has to be from 0 to 1"),
            (["perlin", "-o", "a.png", "--octaves", "3"], '"perlin" in 2D has no octaves; fractals have them'),
            (["perlin", "-o", "a.png", "--octaves", "6"], '"perlin" in 2D has no octaves; fractals have them'),
            (["perlin", "-o", "a.png", "--lacunarity", "2"], "has no lacunarity; fractals have one"),
            (["perlin", "-o", "a.png", "--gain", "0.5"], "has no gain; fractals have one"),
            (["perlin", "-o", "a.png", "--strength", "1"], "has no strength; the fractals ping_pong"),
            (["perlin", "-o", "a.png", "--amplitude", "1"], "has no amplitude; the fractals warp"),
            (["perlin", "-o", "a.png", "--detail", "1"], "has no detail; the fractal fbm"),
            (["perlin", "-o", "a.png", "--jitter", "1"], "has no jitter; cellular, cellular_three"),
            (["perlin", "-o", "a.png", "--metric", "euclidean"], "has no metric; cellular and"),
            (["fbm", "-o", "a.png", "--amplitude", "1"], 'the fractal "fbm" in 2D has no amplitude'),
            (["fbm", "-o", "a.png", "--jitter", "1"], 'the fractal "fbm" in 2D has no jitter'),
            (["fbm", "-o", ".", "--format", "png"], "it is a folder"),
            (["fbm", "-o", "none/a.png"], "--out none/a.png", "there is no folder none; make it"),
            (["fbm", "-o", "none/of/these/a.png"], "there is no folder none/of/these"),
            (["fbm", "-o", "/dev/null/a.png"], "/dev/null/a.png", "no file can be made there"),
        ):
            with self.subTest(arguments=arguments):
                self.assert_usage(arguments, *parts)

    def test_a_slice_that_cannot_be_written_ends_it_before_the_work(self):
        (self.folder / "a.001.png").mkdir()
        done = self.call("perlin", "--size", "4x4x4", "--layout", "slices", "-o", "a.png")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--out a.001.png: it is a folder", done.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["a.001.png"])
        (self.folder / "b.png").mkdir()  # no file of that name is made
        self.bake("perlin", "--size", "4x4x4", "--layout", "slices", "-o", "b.png")

    def test_a_number_is_decimal(self):
        self.assertEqual(json.loads(self.bake("fbm", "--size", "4", "--seed", "010", "--octaves", "08", "-o", "a.png",
                                              "--json").stdout)["settings"]["seed"], 10)

    def test_one_period_is_for_all_axes(self):
        self.bake("fbm", "--size", "20x10", "--period", "8", "-o", "a.f32")
        self.bake("fbm", "--size", "20x10", "--period", "8x8", "-o", "b.f32")
        self.assertEqual((self.folder / "a.f32").read_bytes(), (self.folder / "b.f32").read_bytes())

    def test_more_than_fits(self):
        for size in ("500000000x500000000", "500000000x500000000x500000000x500000000"):
            self.assert_usage(["perlin", "--size", size, "-o", "a.f32"], "--size", "memory")

    def test_a_full_disk_leaves_the_old_file(self):
        (self.folder / "a.f32").write_text("old")
        limit = f"ulimit -f 8; exec {PROGRAM} perlin --size 512x512 -o a.f32"
        done = subprocess.run(["bash", "-c", limit], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("cannot write a.f32", done.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["a.f32"])
        self.assertEqual((self.folder / "a.f32").read_text(), "old")

    def test_what_is_no_file_stays_and_so_do_files_beside(self):
        os.mkfifo(self.folder / "pipe.f32")
        for name in ("a.f32.part", "a.f32.try"):
            (self.folder / name).write_text("mine")
        done = self.call("perlin", "--size", "4x4", "-o", "pipe.f32")
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertIn("--out pipe.f32: no file can be made there: it is no regular file", done.stderr)
        self.bake("perlin", "--size", "4x4", "-o", "a.f32")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         ["a.f32", "a.f32.part", "a.f32.try", "pipe.f32"])
        self.assertEqual((self.folder / "a.f32.part").read_text(), "mine")

    def test_a_signal_leaves_no_half_file(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            for wait in (0.05, 0.3):
                with self.subTest(signal=number, wait=wait):
                    process = subprocess.Popen([PROGRAM, "ridged", "--size", "6000x6000", "--threads", "1", "-o",
                                                "a.png"], cwd=self.folder, stderr=subprocess.PIPE, text=True)
                    time.sleep(wait)
                    process.send_signal(number)
                    _, printed = process.communicate(timeout=60)
                    self.assertEqual(process.returncode, -number)
                    self.assertIn(number.name, printed)
                    self.assertEqual(list(self.folder.iterdir()), [])

    def test_progress_is_for_terminals(self):
        call = [PROGRAM, "ridged", "--size", "3000x3000", "--threads", "1", "-o", "a.r16"]
        done = subprocess.run(call, cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")
        ours, theirs = pty.openpty()
        process = subprocess.Popen(call, cwd=self.folder, stderr=theirs, stdout=subprocess.DEVNULL)
        os.close(theirs)
        printed = b""
        while True:
            try:
                part = os.read(ours, 4096)
            except OSError:  # the other end is closed
                break
            if not part:
                break
            printed += part
        os.close(ours)
        self.assertEqual(process.wait(), 0)
        self.assertRegex(printed.decode(), r"of 3000 rows, [\d.]+ million points a second")

    def test_help_and_version(self):
        for option in ("--help", "--version"):
            done = self.call(option)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertNotEqual(done.stdout, "")

    def test_a_standard_output_that_is_full(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([PROGRAM, "perlin", "--size", "4x4", "-o", "a.png"], cwd=self.folder, stdout=full,
                                  stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot write the standard output", done.stderr)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
