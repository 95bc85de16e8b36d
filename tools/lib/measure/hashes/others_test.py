"""Tests of others.py: a shader's words are where the gate looks for them, and bad hashes fail where good ones pass."""

from __future__ import annotations

import argparse
import contextlib
import io
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

from base.renderer import Renderer
from measure import stamps
from measure.hashes import command, gate, others
from measure.hashes.others import ORIGINS, Other

SHADER = """
#version 330
#include "stand_in_odd.glsl"
uint scrambled(uint k) { k ^= k >> 16; k *= ODD; k ^= k >> 15; k *= 0x846CA68Bu; return k ^ (k >> 16); }
uint good(ivec2 c) { return scrambled(uint(c.x) + scrambled(uint(c.y))); }
float striped(vec2 p) { return fract(p.x * 0.6180340); }
"""


class Others(unittest.TestCase):
    folder: Path
    renderer: Renderer

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        (cls.folder / "stand_in_odd.glsl").write_text("#define ODD 0x7FEB352Du\n")
        (cls.folder / "hashes.glsl").write_text(SHADER)
        cls.renderer = Renderer(others.SIDE)

    def other(self, expression: str) -> Other:
        return Other.parse(f"theirs={self.folder / 'hashes.glsl'}:{expression}")

    def words(self, expression: str, origin: tuple[int, ...]) -> np.ndarray:
        program, _ = others.compiled(self.renderer, self.other(expression), len(origin))
        return others.words_of(self.renderer, program, origin)

    def test_words_are_where_their_cells_are(self):
        for origin, expression in ((ORIGINS[2][2], "uint(c.x) * 7919u + uint(c.y)"),
                                   (ORIGINS[3][1], "uint(c.x) * 7919u + uint(c.y) * 104729u + uint(c.z)")):
            words = self.words(expression, origin)
            self.assertEqual(words.shape, (gate.SIDES[len(origin)],) * len(origin))
            cells = np.indices(words.shape).astype(np.int64) + np.array(origin).reshape(-1, *[1] * len(origin))
            factors = (7919, 1) if len(origin) == 2 else (7919, 104729, 1)
            expected = sum(axis * factor for axis, factor in zip(cells, factors))
            np.testing.assert_array_equal(words, expected & 0xFFFFFFFF)

    def test_a_float_gives_ten_bits(self):
        words = self.words("fract((p.x + 512.0) / 1024.0)", (-512, -512))
        np.testing.assert_array_equal(words >> 22, np.broadcast_to(np.arange(1024)[:, None], (1024, 1024)))

    def test_good_hashes_pass_and_a_bad_one_does_not(self):
        small = {2: ORIGINS[2][:1]}
        with mock.patch.object(others, "ORIGINS", small), contextlib.redirect_stdout(io.StringIO()) as printed:
            for expression, status in (("good(c)", 0), ("striped(p)", 1)):
                given = ["--against", f"theirs/2={self.folder / 'hashes.glsl'}:{expression}"]  # in the plane alone
                self.assertEqual(command.main([*given, "--out", str(self.folder)]), status)
        self.assertRegex(printed.getvalue(), r"theirs 2D at -512, -512: FAILS autocorrelation: ")
        row, = stamps.read(self.folder / "hashes.csv").rows
        self.assertEqual((row["hash"], row["dimensions"], row["part"], row["of"]), ("theirs", "2", "-512, -512", "6"))
        self.assertGreater(int(row["failed"]), 1)

    def test_what_is_no_hash_is_told(self):
        for text, problem in (("sine", "is not NAME=FILE:EXPRESSION"), ("s=none.glsl:random(p)", "no file none.glsl"),
                              (f"s={self.folder / 'hashes.glsl'}:", "is not NAME=FILE:EXPRESSION"),
                              (f"s/4={self.folder / 'hashes.glsl'}:p.x", "is not NAME=FILE:EXPRESSION")):
            with self.assertRaisesRegex(argparse.ArgumentTypeError, problem):
                Other.parse(text)
        with self.assertRaisesRegex(others.BadExpression, "neither a uint nor a float.*(?s:.)*absent"):
            next(others.judge(self.other("absent(p)"), self.renderer))
        given = f"theirs={self.folder / 'hashes.glsl'}:good(c)"
        with contextlib.redirect_stderr(io.StringIO()) as printed, self.assertRaises(SystemExit):
            command.main(["--against", given, "--against", given.replace("=", "/3=", 1)])
        self.assertIn("names theirs twice in 3D: write theirs/2=... and theirs/3=...", printed.getvalue())
