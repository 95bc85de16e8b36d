"""Tests of tools/measure likeness: it finds a known scale and factor, and that what is no noise looks like none."""

from __future__ import annotations

import subprocess
from pathlib import Path

from base.testing import Case, called
from measure.likeness import command as likeness
from measure.noise.noise import version

PORTS = Path(likeness.__file__).with_name("ports.glsl")


class Likeness(Case):
    def test_a_known_scale_and_factor_are_found(self) -> None:
        """By a file that includes another; the library's own call with other numbers."""
        (self.folder / "library.glsl").write_text(likeness.our_library("hn_simplex(", 2))
        file = self.folder / "known.glsl"
        file.write_text('#version 120\n#include "library.glsl"\n'
                        "float known(vec2 p) { return 0.3 + 0.7 * hn_simplex(0.6 * p + 17.0, 3u); }\n")
        status, printed = called(likeness.main, file, "known(p)", "hn_simplex(p, 7u)")
        self.assertEqual(status, 0, printed)
        self.assertRegex(printed, r"\n0\.(29|30|31) \+ 0\.(69|7[01]) \* hn_simplex\(\(0\.(59|6[01]) \* p\), 7u\): mean 0\.")

    def test_the_row_of_a_page_is_found(self) -> None:
        status, printed = called(likeness.main, PORTS, "gradient_noise(p)", "hn_perlin(p, 7u)")
        self.assertEqual(status, 0, printed)
        self.assertRegex(printed, r"\n0\.50 \+ 0\.7[012] \* hn_perlin\(\((0\.9[89]|1\.00) \* p\), 7u\): mean 0\.50")

    def test_what_no_scale_makes_alike_is_status_1(self) -> None:
        status, printed = called(likeness.main, PORTS, "value_noise(p)", "hn_value(0.01 * p * p, 7u)")
        self.assertEqual(status, 1, printed)

    def test_bad_usage(self) -> None:
        for arguments, part in (((PORTS, "stand_out(p)", "hn_perlin(p, 7u)"), "stand_out"),
                                ((self.folder / "none.glsl", "p.x", "hn_perlin(p, 7u)"), "none.glsl")):
            status, printed = called(likeness.main, *arguments)
            self.assertEqual(status, 2)
            self.assertIn(part, printed)

    def test_half_is_where_it_is(self) -> None:
        for size in (0.05, 0.7, 0.8, 5.0):
            found = likeness.half(lambda lag, size=size: max(1.0 - 0.5 * lag / size, -0.1))
            self.assertAlmostEqual(found, size, delta=likeness.NEAR)
        with self.assertRaisesRegex(ValueError, "does not vary"):
            likeness.half(lambda lag: float("nan"))

    def test_a_version_is_the_name_that_git_has(self) -> None:
        file = self.folder / "a.glsl"
        file.write_text("float a() { return 1.0; }\n")
        blob = subprocess.run(["git", "hash-object", file], capture_output=True, text=True, check=True).stdout
        self.assertEqual(version(file), f"blob {blob[:10]}")
