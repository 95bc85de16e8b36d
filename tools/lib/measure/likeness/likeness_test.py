"""Tests of tools/measure likeness. Real peers are measured where HN_PEERS has options of it that name them."""

from __future__ import annotations

import contextlib
import io
import os
import shlex
import statistics
import subprocess
import tempfile
import unittest
import zlib
from pathlib import Path
from unittest import mock

from base.renderer import NotCompiled, Renderer
from base.thorough import THOROUGH
from base.tree import TOOLS
from measure import stamps
from measure.likeness import command, picture, ports
from measure.likeness.measure import at_places, half, look
from measure.likeness.table import PLAIN, ROWS, Row, own_sum

# Another library, for want of one: value noise with a lattice, a curve and a contrast of its own.
STAND_IN = """#version 120
#include "stand_in_hash.glsl"
float stand_in(vec2 p) {
  p *= 0.75;
  vec2 i = floor(p), f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  vec2 low = mix(vec2(hash(i), hash(i + vec2(0.0, 1.0))), vec2(hash(i + vec2(1.0, 0.0)), hash(i + 1.0)), f.x);
  return 0.2 + 0.5 * mix(low.x, low.y, f.y);
}
"""
HASH = """#version 120
float hash(vec2 p) { return fract(sin(dot(p, vec2(41.3, 289.1))) * 17341.7); }
"""


def row(theirs: str, ours: str, axes: int = 2, expression: str = "", before: str = "", inner: str = "") -> Row:
    return Row("stand-in", "stand-in", f"`{theirs}`", "stand_in.glsl", expression or "stand_in(p)", axes, ours, PLAIN,
               before, inner=inner)


VALUE = row("stand_in", "{offset}{factor}hn_value({p}, {seed})")


class Likeness(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.renderer = Renderer()
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = Path(scratch.name)
        (cls.folder / "stand_in.glsl").write_text(STAND_IN)
        (cls.folder / "stand_in_hash.glsl").write_text(HASH)
        # It is ours, with other numbers.
        (cls.folder / "known.glsl").write_text(
            ports.our_library("hn_simplex(", 2) +
            "float known(vec2 p) { return 0.7 * hn_simplex(0.6 * p + 17.0, 3u); }\n"
            "float folded(vec2 p) { return 1.0 - 1.4 * abs(hn_simplex(0.6 * p + 17.0, 3u)); }\n")
        cls.found, = cls.ports(VALUE)

    @classmethod
    def ports(cls, *rows):
        return ports.ports({"stand-in": cls.folder}, rows, renderer=cls.renderer)

    def test_what_is_known_is_found(self):
        known = row("known", "{factor}hn_simplex({p}, {seed})", expression="known(p)")._replace(file="known.glsl")
        folded = known._replace(theirs="folded", expression="folded(p)", ours="-{factor}loud({p}, 1, 2.0, 0.5, {seed})",
                                before="float my(hn_place2 q, uint s) { return {inner} * hn_simplex(q, s); }\n"
                                       + own_sum("loud", "billow", "my").replace("#", "2"), inner=known.id)
        first, second = self.ports(known, folded)
        for found, factor in ((first, 0.7), (second, 1.0)):
            self.assertAlmostEqual(found.scale, 0.6, delta=0.012)
            self.assertAlmostEqual(found.factor, factor, delta=0.02)
        self.assertAlmostEqual(second.ported.mean, second.theirs.mean, delta=0.02)
        self.assertEqual(ports.problems([first, second], limit=0.02), [])

    def test_a_port_looks_alike(self):
        self.assertLess(self.found.scale, 0.8)
        self.assertLess(self.found.factor, 0.4)
        self.assertAlmostEqual(self.found.ported.mean, self.found.theirs.mean, delta=0.02)
        self.assertEqual(ports.problems([self.found]), [])

    def test_what_does_not_look_alike_is_told(self):
        unported = self.found._replace(ported=self.found.ours)
        deviation, size, mean = ports.problems([unported])
        self.assertIn("stand-in: stand_in 2D: the deviation of theirs is 0.", deviation)
        self.assertIn("the size of theirs is 0.", size)
        self.assertIn("the mean of theirs is 0.", mean)
        empty = self.found._replace(ported=self.found.ours._replace(deviation=float("nan")))
        self.assertIn("and of ours as ported nan", ports.problems([empty])[0])

    def test_another_record_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            record = Path(folder) / "likeness.csv"
            ports.write([self.found], record)
            same = ports.read(record)
        self.assertEqual(command.differences([self.found], same), [])
        other = {self.found.id: self.found._replace(factor=1.03 * self.found.factor)}
        printed, = command.differences([self.found], other)
        self.assertIn("the factor is", printed)
        printed, = command.differences([self.found], {})
        self.assertIn("the record has no such row", printed)

    def test_the_command_fails_with_what_it_finds(self):
        errors = io.StringIO()
        with mock.patch.object(ports, "ports", return_value=[self.found._replace(ported=self.found.ours)]), \
                mock.patch.object(stamps, "ROWS", [VALUE]), tempfile.TemporaryDirectory() as folder, \
                contextlib.redirect_stderr(errors):
            self.assertEqual(command.run({}, Path(folder), None, check=False), 1)
            self.assertEqual([file.name for file in Path(folder).iterdir()], ["likeness.csv"])
        self.assertIn("the deviation of theirs", errors.getvalue())

    def test_pictures_show_it(self):
        """Ours as ported has the slopes of theirs, and ours as it is has others."""
        library = ports.our_source(VALUE, {})
        with tempfile.TemporaryDirectory() as folder:
            file = picture.draw(self.renderer, VALUE, self.found, self.folder, library, Path(folder))
            self.assertEqual(file.name, "stand-in-stand-in-2d.png")
            data = file.read_bytes()
        width = 4 * picture.TILE
        pixels = zlib.decompress(data[data.index(b"IDAT") + 4:data.index(b"IEND")])
        lines = [pixels[i * (3 * width + 1) + 1:(i + 1) * (3 * width + 1)][::3] for i in range(picture.TILE)]

        def slope(tile: int) -> float:
            parts = (line[tile * picture.TILE:(tile + 1) * picture.TILE] for line in lines)
            return statistics.fmean(abs(a - b) for part in parts for a, b in zip(part, part[1:]))

        theirs, ours, ported, _ = (slope(tile) for tile in range(4))
        self.assertAlmostEqual(ported / theirs, 1.0, delta=0.2)  # of 64 cells
        self.assertGreater(ours / theirs, 2.0)

    def test_glsl_that_does_not_compile_is_told(self):
        with self.assertRaisesRegex(NotCompiled, "stand_out"):
            self.ports(VALUE._replace(expression="stand_out(p)"))

    def test_what_does_not_vary_has_no_size(self):
        for correlation in (1.0, float("nan")):
            with self.assertRaisesRegex(ValueError, "does not vary, or is no number"):
                half(lambda *lags, found=correlation: [found for _ in lags])

    def test_half_is_where_it_is(self):
        for size in (0.05, 0.7, 0.8, 5.0):
            found = half(lambda *lags, size=size: [max(1.0 - 0.5 * lag / size, -0.1) for lag in lags])
            self.assertAlmostEqual(found, size, places=3)

    def test_a_version_is_the_name_that_git_has(self):
        file = self.folder / "stand_in.glsl"
        blob = subprocess.run(["git", "hash-object", file], capture_output=True, text=True, check=True).stdout
        self.assertEqual(ports.version(file), f"blob {blob[:10]}")


class Record(unittest.TestCase):
    """The file in the repository."""

    def test_it_has_every_row_and_each_looks_alike(self):
        record = ports.read()
        self.assertEqual(list(record), [row.id for row in ROWS])
        self.assertEqual(ports.problems(record.values()), [])

    def test_our_noises_look_as_they_did_when_they_were_measured(self):
        """The noises that most others are made of."""
        record, renderer = {**ports.read()}, Renderer()
        some = ("FastNoiseLite: FNL_NOISE_PERLIN 2D", "lygia: snoise(vec3 p) 3D", "lygia: curl(vec3 p) 3D")
        now = {row.id: look(renderer, ports.our_source(row, {}), ports.measured_call(row), row.axes)
               for row in ROWS if row.id in some}

        def stale() -> list[str]:
            return [name for name in some if any(abs(a / b - 1) > command.SAME
                                                 for a, b in zip(now[name][1:], record[name].ours[1:]))]

        self.assertEqual(stale(), [])
        name = some[1]
        record[name] = record[name]._replace(ours=record[name].ours._replace(deviation=0.36))
        self.assertEqual(stale(), [name])

    def test_our_ports_have_these_numbers(self):
        some = ["Unity: Gradient Noise 2D", "Unity: Simple Noise 2D", "Quilez: fbm(x) of it 2D"]
        found = ports.ports(ports.PORTS, [row for row in ROWS if THOROUGH or row.id in some])
        self.assertLessEqual(set(some), {port.id for port in found})
        self.assertEqual([*command.differences(found, ports.read()), *ports.problems(found)], [])
        # A gradient is as long as 1, and webgl-noise has longer and shorter ones.
        self.assertAlmostEqual(found[0].theirs.deviation, 0.2176, delta=0.002)

    def test_sums_that_fold_are_in_the_ranges_of_the_page(self):
        """Their octaves are louder than [-1, 1]. Ranges of other rows follow from those of the library."""
        record, renderer = ports.read(), Renderer()
        rows = [row for row in ROWS if row.inner]
        self.assertGreater(len(rows), 4)
        for row in rows:
            found = record[row.id]
            source = ports.our_source(row, {id: port.factor for id, port in record.items()})
            program = renderer.program(at_places(source, ports.measured_call(row, found.scale, found.factor), row.axes))
            values = renderer.draw(program, likeness_lags=(0.0, 0.0, 0.0, 1.0))[::4]
            low, high = ports.ends(row, record)
            with self.subTest(row=row.id):
                self.assertGreaterEqual(min(values), low - 1e-6)
                self.assertLessEqual(max(values), high + 1e-6)
                self.assertLess(high - low, 1.5 * (max(values) - min(values)))

    def test_a_row_that_is_not_there_is_told(self):
        record = {**ports.read()}
        del record[ROWS[0].id]
        with self.assertRaisesRegex(LookupError, "FNL_NOISE_OPENSIMPLEX2 2D"):
            ports.moving_table(ROWS[0].table, record)

    def test_the_table_has_the_numbers_of_the_record(self):
        first = ROWS[0]
        record = {**ports.read()}
        record[first.id] = record[first.id]._replace(scale=0.5, factor=2.0)
        self.assertIn("| `FNL_NOISE_OPENSIMPLEX2` | 2D | `2.00 * hn_simplex(0.50 * p, seed)` | [-2, 2] |",
                      ports.moving_table(first.table, record))
        record[first.id] = record[first.id]._replace(scale=1.04, factor=0.96)
        self.assertIn("| `hn_simplex(p, seed)` | [-1, 1] |", ports.moving_table(first.table, record))

    @unittest.skipUnless(os.environ.get("HN_PEERS"), "HN_PEERS names no copies of other libraries")
    def test_real_peers_have_these_numbers(self):
        arguments = shlex.split(os.environ["HN_PEERS"])
        done = subprocess.run([TOOLS / "measure", "likeness", "--check", *arguments], capture_output=True, text=True,
                              check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
