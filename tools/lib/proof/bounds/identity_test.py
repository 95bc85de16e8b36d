"""Tests of the comparison with the contract: it reports changes of the text."""

import collections
import functools
import unittest
from dataclasses import replace

import numpy as np

from base.thorough import in_thorough_runs, some
from base.tree import GLSL
from catalog.tables.configurations import DEFAULT_HASH, read_configurations
from proof.bounds import identity
from proof.bounds.rounded import Text, with_true_numbers
from proof.golden.files import Values
from proof.golden.generator import generator_of
from proof.golden.rows import redrawn

# Changes of the text, and the function that each makes wrong. No function of a group notices two of them.
MUTANTS = (
    (("vec4 t = f * f * f * (d * (f * 6.0f - 9.0f)", "vec4 t = f * f * f * (d * (f * 6.0f - 8.5f)",
      "noise4d.value_cell"),
     ("return hn_i_scaled(n, 1831);", "return hn_i_scaled(n, 1832);", "noise2d.perlin"),
     ("hn_i_along3(h.z, x, y1, z, turned)", "hn_i_along3(h.z, x, y, z, turned)", "noise3d.perlin_cell"),
     ("hn_float w = q * q;\n  return w;\n}\nHN_FN hn_float hn_i_weight5", "hn_float w = q * t;\n  return w;\n}\n"
      "HN_FN hn_float hn_i_weight5", "noise3d.simplex_cell"),
     ("first = g * g * g * (1.0f / 6.0f)", "first = g * g * g * 0.1666667f", "noise1d.value_cubic"),
     ("hn_i_select(d.y == 0.0f, 0.0f, -d.y)", "hn_i_select(d.y == 0.0f, 0.0f, d.y)", "curl.curl2"),
     ("hn_i_root(hn_i_plus(weights, 1.0f / 4096.0f))", "hn_i_root(hn_i_plus(weights, 1.0f / 4095.0f))",
      "noise2d.cellular_smooth"),
     ("hn_i_multiply_add(squares, 0.5f, sums)", "hn_i_multiply_add(squares, 0.51f, sums)", "noise3d.cellular_full"),
     ("return sqrt(rank) * 0.25f;", "return sqrt(rank * 1.001f) * 0.25f;", "noise2d.cell_border"),
     ("w = (g * g * 15.0f + q) * t", "w = (g * g * 14.0f + q) * t", "noise2d.phasor"),
     ("n = 65.0f * a + 33.0f * b", "n = 65.0f * a + 34.0f * b", "uniform.spread_fbm"),
     ("#define HN_I_SHIFT_X 5767168", "#define HN_I_SHIFT_X 5767169", "fbm.fbm1_cell_period"),
     ("hn_i_fraction_to_float(hn_i_minus(most, least))", "hn_i_fraction_to_float(hn_i_minus(least, most))",
      "noise2d.hex_weights")),
    (("25.0f / 32.0f * z - b * q.w + 23.0f / 32.0f", "25.0f / 32.0f * z - b * q.w + 22.0f / 32.0f", "fbm.fbm4"),
     ("hn_float e = r.y * 1.15470054f;", "hn_float e = r.y * 1.1547005f;", "noise3d.perlin_phase"),
     ("hn_i_times(k, 6.2831853f)", "hn_i_times(k, 6.28318f)", "noise2d.phasor_d"),
     ("hn_i_quotient(x, hn_i_plus(r, 0.125f))", "hn_i_quotient(x, hn_i_plus(r, 0.25f))", "noise2d.gullies"),
     ("hn_i_float(across) * (1.0f / 32.0f)", "hn_i_float(across) * (1.0f / 31.0f)", "fbm_d.fbm_d2"),
     ("1.0f - strength * (0.5f - 0.5f * n)", "1.0f - strength * (0.5f - n)", "fbm.weighted1_cell_period"),
     ("(hn_i_moved_fraction(place.fraction.x, 2)", "(hn_i_moved_fraction(place.fraction.x, 1)", "curl.curl3")))


def mutated(mutants, text):
    for old, new, _ in mutants:
        text = text.replace(old, new)
    return with_true_numbers(text)


class Texts(unittest.TestCase):
    """identity.wrong_texts() finds none: `tools/make bounds --check`."""

    def test_enough_functions_are_compared(self):
        settings = collections.Counter(golden.setting for golden in identity.golden_files())
        self.assertTrue(settings["lattice"] > 350 and settings["lattice+sine"] >= 17, settings)

    def test_changed_ones_are_found(self):
        """At many places: a constant, a sign, a power, an axis, a shift."""
        golden = {of.function.id: of for of in identity.golden_files() if of.setting == "lattice"}
        library = "".join(path.read_text(encoding="utf-8") for path in GLSL.rglob("*.glsl"))
        for group in some(MUTANTS, 0, 1):
            self.assertEqual([old for old, _, _ in group if library.count(old) != 1], [])
            text = Text([id for _, _, id in group], change=functools.partial(mutated, group))
            for _, new, id in group:
                with self.subTest(new):
                    wrong, count = identity.differing(text, golden[id])
                    self.assertGreater(wrong, count / 10)

    @in_thorough_runs
    def test_other_places(self):
        """With other seeds, and the oracle's values."""
        golden = [of for of in identity.golden_files() if of.setting == DEFAULT_HASH]
        text = Text([of.function.id for of in golden])
        setting = next(one for one in read_configurations() if one.name == DEFAULT_HASH)
        for of in golden:
            rows = redrawn(of.function, generator_of(f"{of.function.id} identity"))
            values = Values(of.function, setting)
            drawn = replace(of, columns={name: np.array(words) for name, words in zip(of.columns, zip(*rows))}, values=[
                np.array(column, float if one.type == "f64" else np.int64) for one, column in zip(
                    of.function.outputs, zip(*map(values.evaluate, rows)))])
            with self.subTest(of.function.id):
                self.assertEqual(identity.differing(text, drawn)[0], 0)
