"""GDScript as text: its arithmetic has the golden values. Python runs it, as far as both languages are alike; a real Godot
does in pick.gdscript, of thorough runs."""

from __future__ import annotations

import math
import re
import struct
import unittest
from collections import namedtuple

from base.golden_values import Golden
from translate.pick import command
from translate.pick.gdscript import GDScript
from translate.pick.program import Program, chosen
from translate.pick.scalars import Piece, Syntax, text
from translate.pick.scalars_test import library, written

# Golden files, with the forms of their functions.
FORMS = {"fbm.fbm2": "hn_fbm2", "fbm.ridged3": "hn_ridged3", "fbm.weighted4": "hn_weighted4", "noise2d.cellular": "hn_cellular2",
         "noise3d.cellular_smooth": "hn_cellular_smooth3", "noise2d.random": "hn_random2", "curl.curl_fbm2_phase": "hn_curl_fbm2_phase"}
Color = namedtuple("Color", "r g b")
TO_PYTHON = ((r"(?m)^\s*(#|@|extends|var \w+: \w+$).*\n", "\n"), (r"\bvar (\w+) :=", r"\1 ="), (r"\bstatic func", "def"),
             (r": (int|float|bool|Vector\d?i?)\b(?= *[,)=])", ""), (r"\bwhile true:", "while True:"), (r"\bnot \(", "not ("),
             (r"\) -> \w+:", "):"), (r"(?m)^const (\w+) :=", r"\1 ="), (r"= (\w+) / (\w+)$", r"= \1 // \2"))


def single(x: float) -> float:
    return struct.unpack("f", struct.pack("f", x))[0]


def vector(size: int, whole: bool) -> type:
    """A vector of Godot's: whole numbers are cut off to 32 bits."""
    def made(*parts: float) -> tuple:
        return of(*(((one + (1 << 31)) & 0xFFFFFFFF) - (1 << 31) if whole else single(one) for one in parts))
    of = namedtuple("Vector", [*"xyzw"[:size]])
    return made


GODOT = {"mini": min, "maxi": max, "absi": abs, "absf": abs, "minf": lambda a, b: a if a < b else b,
         "maxf": lambda a, b: a if a > b else b, "sqrt": lambda x: abs(x) ** 0.5, "true": True, "false": False,
         "ceilf": math.ceil, "floorf": math.floor,
         "Color": lambda r, g, b: Color(single(r), g, b),
         **{f"Vector{size}{'i' * whole}": vector(size, whole) for size in (2, 3, 4) for whole in (False, True)}}


def functions(shown: str) -> dict[str, object]:
    for pattern, by in TO_PYTHON:
        shown = re.sub(pattern, by, shown, flags=re.MULTILINE)
    made = dict(GODOT)
    exec(shown, made)
    return made


class Loose(GDScript):
    """It leaves the masks out."""
    def masked(self, piece: Piece) -> Piece:
        return piece


class AsText(unittest.TestCase):
    def differing(self, golden: str, form: str, syntax: type[Syntax]) -> int:
        """At how many of some golden rows the function has other values."""
        made = syntax()
        made.is_fixed = True
        shown = text(Program(library(syntax), chosen(library(syntax), [form])), made)
        called, rows = functions(shown)[made.function_name(form, True)], Golden(golden)
        kinds = {"f32": "f", "i32": "i", "u32": "I"}
        wrong = 0
        for given, expected in [*zip(rows.inputs, rows.values)][::4]:
            arguments = [struct.unpack(kinds[kind], struct.pack("I", word))[0] for (_, kind), word in zip(rows.head.columns, given)]
            value = called(*arguments)
            parts = value if isinstance(value, tuple) else (value,)
            wrong += [struct.unpack(">Q", struct.pack(">d", one))[0] for one in parts] != expected
        return wrong

    def test_the_text_has_the_golden_values(self) -> None:
        for golden, form in FORMS.items():
            with self.subTest(form):
                self.assertEqual(self.differing(golden, form, GDScript), 0)

    def test_masks_that_are_left_out_are_noticed(self) -> None:
        for golden, form in FORMS.items():
            with self.subTest(form):
                self.assertGreater(self.differing(golden, form, Loose), 20)

    def test_a_word_is_masked_where_its_size_counts(self) -> None:
        for shown, expected in (
                ("uint hn_f(uint a, uint b) { return (a + b) * 3u >> 4u; }",
                 "    return (((a + b) * 3) & 0xFFFFFFFF) >> 4"),
                ("uint hn_f(uint a, uint b) { return ((a - b) >> 4u) & 255u; }", "    return ((a - b) >> 4) & 255"),
                ("uint hn_f(uint a) { return ((a & 1023u) * 3u) >> 4u; }", "    return ((a & 1023) * 3) >> 4"),
                ("bool hn_f(uint a, uint b) { return a + b < b; }", "    return ((a + b) & 0xFFFFFFFF) < b"),
                ("int hn_f(uint a) { return int(a * 3u); }",
                 "    return (((a * 3) & 0xFFFFFFFF) ^ 0x80000000) - 0x80000000"),
                ("int hn_f(uint a) { return int((a & 1023u) << 3u); }", "    return (a & 1023) << 3"),
                ("uint hn_f(int a) { return uint(a >> 3u); }", "    return (a >> 3) & 0xFFFFFFFF"),
                ("int hn_f(int a) { return a << 3u; }", "    return (((a * 8) & 0xFFFFFFFF) ^ 0x80000000) - 0x80000000"),
                ("float hn_f(float a) { return max(a, 0.0f); }", "    return maxf(0.0, a)"),
                ("int hn_f(float a) { return int(max(-4.0f, min(2.0f, a))); }", "    return int(maxf(minf(a, 2.0), -4.0))"),
                ("int hn_f(float a) { return int(a); }", "    return _to_int(a)"),
                ("float hn_f(float a) { return a * 0.1f; }",
                 "    return Color(a * 0.10000000149011612, 0.0, 0.0).r")):
            with self.subTest(shown):
                self.assertIn(expected.replace("    ", "\t"), written(shown, GDScript))

    def test_a_class_has_a_name_if_it_is_asked_for(self) -> None:
        for name in ("", "Terrain"):
            shown = command.picked(["hn_perlin2"], command.Choice("gdscript", "fixed", name=name))
            self.assertEqual(shown.count("\nclass_name Terrain\n"), bool(name))
            self.assertIn(f"Example: {'Terrain.' * bool(name)}perlin2(", shown)


if __name__ == "__main__":
    unittest.main()
