"""The add-on has the golden values in a real Godot: with HN_FIXED not one bit differs, on each renderer.

    python3 packages/godot/tests/values_test.py [--all]

It compares some of the functions, or all with --all, which takes minutes.
A word goes into the shader as two floats of 16 bits each, and comes out as the four bytes of a pixel, so that no
driver flushes a bit. Exit status: 0 they are, 1 they are not, 77 there is no Godot here.
"""

from __future__ import annotations

import array
import json
import re
import struct
import sys
import tempfile
import unittest
from collections.abc import Callable, Iterable
from pathlib import Path

from engine import RENDERERS, Engine, Failure, main

from base.golden_values import Golden, ids
from base.tree import BOUNDS
from catalog.tables.functions import Function, read_functions
from ship.godot.files import ADDON, package
from translate.parsing.preprocessor import Preprocessor
from translate.single_file.godot import SUFFIX
from translate.wgsl.evaluation import PROLOGUE

HERE = Path(__file__).resolve().parent
POINTS = 64   # in a line of the picture
LINES = 8
INPUTS = 16   # words of a point
OUTPUTS = 4
# Users name their uniforms as the library names its variables, and both must keep their values.
NAMES_OF_USERS = ("seed", "p", "q", "f", "s", "cell", "place", "tile", "tiled", "period", "octaves", "lacunarity",
                  "gain", "n", "x", "y", "z", "h", "k", "w", "jitter", "first", "last", "sum", "size", "growth",
                  "phase", "weight")
SHADER = """\
shader_type canvas_item;
render_mode blend_disabled, unshaded;
{uniforms}
uniform sampler2D inputs_of_rows : filter_nearest;
uniform int which_row;
#define HN_ARITHMETIC {arithmetic}
#include "res://{addon}/{part}.gdshaderinc"

uint word_of(ivec2 at_, int number_) {{
	vec4 two_ = texelFetch(inputs_of_rows, ivec2(at_.x * {texels} + number_ / 2, at_.y), 0);
	return number_ % 2 == 0 ? (uint(two_.x) << 16u) | uint(two_.y) : (uint(two_.z) << 16u) | uint(two_.w);
}}
uvec4 words_of(ivec2 at_, int from_) {{
	return uvec4(word_of(at_, from_), word_of(at_, from_ + 1), word_of(at_, from_ + 2), word_of(at_, from_ + 3));
}}
{functions}
void fragment() {{
	ivec2 at_ = ivec2(UV * vec2({width}.0, {height}.0));
	int output_ = at_.x % {outputs};
	at_.x /= {outputs};
	uvec4 a_ = words_of(at_, 0);
	uvec4 b_ = words_of(at_, 4);
	uvec4 c_ = words_of(at_, 8);
	uvec4 d_ = words_of(at_, 12);
	uvec4 words_ = uvec4(0u);
	{calls}
	uint word_ = output_ == 0 ? words_.x : output_ == 1 ? words_.y : output_ == 2 ? words_.z : words_.w;
	uvec4 bytes_ = (uvec4(word_) >> uvec4(0u, 8u, 16u, 24u)) & uvec4(255u);
	COLOR = vec4(bytes_) / 255.0;
}}
"""
# Users' loops over octaves, which are sums of the library's own: the row, the call, and the loop in its place.
LOOPS = {
    "fbm.fbm2": ("hn_fbm", "float my_fbm(vec2 p, int octaves, float lacunarity, float gain, uint seed) {",
                 "do hn_add(o, hn_perlin(o.place, o.seed)); while (hn_next(o));\n\treturn hn_mean(o);"),
    "fbm.ridged2": ("hn_ridged", "float my_ridged(vec2 p, int octaves, float lacunarity, float gain, uint seed) {",
                    "do hn_add_ridged(o, hn_perlin(o.place, o.seed)); while (hn_next(o));\n\treturn hn_mean(o);"),
    "warp.warp_progressive2": (
        "hn_warp_progressive",
        "vec2 my_warp(vec2 p, int octaves, float lacunarity, float gain, float amplitude, uint seed) {",
        "hn_shifts2 shifts = hn_shifts(o, amplitude);\n"
        "\tdo hn_add_progressive(o, shifts, hn_value_vector(o.place, o.seed)); while (hn_next(o));\n"
        "\treturn hn_mean(o, shifts);")}
Rows = dict[str, Golden]  # by the ids of their rows
ROWS = {function.id: function for function in read_functions()}


def exact_values(golden: Golden) -> list[float]:
    return [struct.unpack(">d", struct.pack(">Q", value))[0] for value, in golden.values]


def expanded_bodies(rows: Iterable[str]) -> dict[str, str]:
    """The bodies of the rows without the macros of the table, which Godot's preprocessor does not all take."""
    macros = Preprocessor(Path(), {})
    vectors = [f"hn_{kind} {kind}" for scalar, prefix in (("float", ""), ("int", "i"), ("uint", "u"))
               for kind in (scalar, *(f"{prefix}vec{n}" for n in (2, 3, 4)))]
    for definition in (*vectors, *(line.removeprefix("#define ") for line in PROLOGUE.splitlines())):
        macros.define(definition)
    return {row: macros.expanded(ROWS[row].body).replace(" . ", ".") for row in rows}


def part_of(function: Function) -> str:
    return Path(function.includes).stem


def with_names_of_users(code: str) -> str:
    """Users write their variables so that they do not meet their own uniforms."""
    return re.sub(rf"(?<![.\w])({'|'.join(NAMES_OF_USERS)})\b(?!\s*\()", r"\1_", code)


def with_loop(code: str, row: str) -> str:
    """A shader that calls a loop of the user's in place of the library's sum."""
    name, head, rest = LOOPS[row]
    octaves = "hn_octaves2 o = hn_octaves(p, octaves, lacunarity, gain, seed);"
    loop = with_names_of_users(f"{head}\n\t{octaves}\n\t{rest}\n}}\n")
    before, _, after = code.replace("uvec4 evaluate_0", f"{loop}uvec4 evaluate_0").partition(f" {name} (")
    return f"{before} {re.search(r'my_[a-z]+', head)[0]} ({after}"


def shader_of(part: str, bodies: dict[str, str], arithmetic: str, edit: Callable[[str], str]) -> str:
    functions = "".join(f"uvec4 evaluate_{i}(uvec4 a, uvec4 b, uvec4 c, uvec4 d) {{ {body} }}\n"
                        for i, body in enumerate(bodies.values()))
    functions = with_names_of_users(functions)
    uniforms = "\n".join(f"uniform uint {name} = {1000 + i}u;" for i, name in enumerate(NAMES_OF_USERS))
    calls = "\n\t".join(f"if (which_row == {i}) words_ = evaluate_{i}(a_, b_, c_, d_);" for i in range(len(bodies)))
    return edit(SHADER.format(uniforms=uniforms, arithmetic=arithmetic, addon=ADDON, part=part, texels=INPUTS // 2,
                              functions=functions, width=POINTS * OUTPUTS, height=LINES, outputs=OUTPUTS, calls=calls))


def texture_of(inputs: list[list[int]]) -> bytes:
    halves = array.array("f", bytes(4 * 2 * INPUTS * POINTS * LINES))
    if len(inputs) > POINTS * LINES:
        raise ValueError(f"{len(inputs)} points do not fit into the picture")
    for point, words in enumerate(inputs):
        for number, word in enumerate(words):
            halves[2 * (INPUTS * point + number)] = word >> 16
            halves[2 * (INPUTS * point + number) + 1] = word & 0xFFFF
    return halves.tobytes()


def evaluated(engine: Engine, renderer: str, rows: Rows, arithmetic: str = "HN_FIXED",
              addon: Callable[[str, bytes], bytes] = lambda name, content: content,
              edit: Callable[[str], str] = lambda code: code) -> dict[str, list[tuple[int, ...]]]:
    """Godot's values for each point of each row."""
    with tempfile.TemporaryDirectory() as folder:
        project = Path(folder)
        (project / "project.godot").write_text("config_version=5\n")
        (project / "evaluate.gd").write_bytes((HERE / "evaluate.gd").read_bytes())
        for name, content in package().items():
            (project / name).parent.mkdir(parents=True, exist_ok=True)
            (project / name).write_bytes(addon(name, content))
        bodies = expanded_bodies(rows)
        shaders = []
        for part in dict.fromkeys(part_of(ROWS[row]) for row in rows):
            here = {row: body for row, body in bodies.items() if part_of(ROWS[row]) == part}
            (project / f"{part}.gdshader").write_text(shader_of(part, here, arithmetic, edit))
            entries = []
            for which, row in enumerate(here):
                (project / f"{row}.inputs").write_bytes(texture_of(rows[row].inputs))
                entries.append({"which": which, "inputs": f"res://{row}.inputs", "out": f"res://{row}.out"})
            shaders.append({"code": f"res://{part}.gdshader", "rows": entries})
        (project / "job.json").write_text(json.dumps({"size": [POINTS * OUTPUTS, LINES], "shaders": shaders}))
        engine.run(project, renderer, "res://evaluate.gd", "res://job.json")
        found = {}
        for row, golden in rows.items():
            words = struct.unpack(f"<{POINTS * LINES * OUTPUTS}I", (project / f"{row}.out").read_bytes())
            found[row] = [words[OUTPUTS * i:OUTPUTS * (i + 1)] for i in range(len(golden.inputs))]
        return found


def differing(got: dict[str, list[tuple[int, ...]]], rows: Rows) -> dict[str, str]:
    """Which rows have other bits than their files, and where first."""
    found = {}
    for row, golden in rows.items():
        for inputs, expected, words in zip(golden.inputs, golden.expected, got[row], strict=True):
            if list(words[:len(expected)]) != expected:
                found.setdefault(row, f"{inputs}: got {words}, expected {expected}")
    return found


def fixed_rows() -> Rows:
    return {row: Golden(row, setting) for row, setting in ids("lattice+fixed", "any")}


class Values(unittest.TestCase):
    engine: Engine
    whole = False

    def test_loops_over_octaves_have_the_bits_of_the_sums(self):
        for row in LOOPS:
            rows = {row: fixed_rows()[row]}
            for renderer in RENDERERS:
                with self.subTest(renderer=renderer, row=row):
                    got = evaluated(self.engine, renderer, rows, edit=lambda code: with_loop(code, row))
                    self.assertEqual(differing(got, rows), {})
        with self.subTest("they are called"):
            other = evaluated(self.engine, "gl_compatibility", rows,
                              edit=lambda code: with_loop(code, row).replace("o.seed)", "o.seed + 1u)"))
            self.assertEqual([*differing(other, rows)], [row])

    def test_fixed_bit_for_bit_on_every_renderer(self):
        rows = fixed_rows()
        self.assertGreater(len(rows), 370)
        if not self.whole:
            rows = dict(list(rows.items())[::20])
        for renderer in RENDERERS:
            with self.subTest(renderer=renderer):
                self.assertEqual(differing(evaluated(self.engine, renderer, rows), rows), {})

    def test_floats_within_their_bounds_on_every_renderer(self):
        within = {(noise, int(axes)): float(error) for noise, axes, error in re.findall(
            r'^NOISE_BOUNDS\("(\w+)", (\d), (?!sine)\w+, [^,]+, ([^,]+),', BOUNDS.read_text(encoding="ascii"), re.MULTILINE)}
        rows = {row: Golden(row, "lattice") for row in ("noise2d.perlin", "noise3d.simplex", "noise2d.value_cubic")}
        for renderer in RENDERERS:
            got = evaluated(self.engine, renderer, rows, "HN_FAST")
            for row, golden in rows.items():
                error = max(abs(struct.unpack("<f", struct.pack("<I", words[0]))[0] - exact)
                            for words, exact in zip(got[row], exact_values(golden), strict=True))
                with self.subTest(renderer=renderer, row=row):
                    self.assertLessEqual(error, within[ROWS[row].bound, ROWS[row].axes])
                    self.assertGreater(error, 1e-9)  # these are floats

    def test_a_changed_constant_is_noticed(self):
        rows = {row: fixed_rows()[row] for row in ("noise2d.perlin", "noise2d.value")}
        for old, new in ((b"0x85EBCA77u", b"0x85EBCA79u"), (b"1572864u", b"1572868u")):
            with self.subTest(old=old):
                def changed(name: str, content: bytes) -> bytes:
                    return content.replace(old, new)
                self.assertEqual(set(differing(evaluated(self.engine, "gl_compatibility", rows, addon=changed), rows)),
                                 set(rows))

    def test_a_variable_with_the_name_of_a_uniform_is_noticed(self):
        """It is why the library's have names of their own."""
        rows = {"fbm.fbm2": fixed_rows()["fbm.fbm2"]}

        def plain(name: str, content: bytes) -> bytes:
            return content.replace(SUFFIX.encode(), b"") if name.endswith(".gdshaderinc") else content

        def seed_below(code: str) -> str:
            code = re.sub(r"uniform uint \w+ = .*\n", "", code)
            return code.replace("uint word_of(", "uniform uint seed = 1000u;\nuint word_of(")

        def seed_above(code: str) -> str:
            return re.sub(r"uniform uint (?!seed )\w+ = .*\n", "", code)

        with self.subTest("declared above the include"), self.assertRaisesRegex(Failure, "Redefinition of 'seed'"):
            evaluated(self.engine, "forward_plus", rows, addon=plain, edit=seed_above)
        with self.subTest("declared below it"):
            got = evaluated(self.engine, "forward_plus", rows, addon=plain, edit=seed_below)
            if not differing(got, rows):
                self.skipTest("this Godot keeps parameters and uniforms apart")

    def test_what_does_not_compile_is_noticed(self):
        rows = {"noise2d.perlin": fixed_rows()["noise2d.perlin"]}
        with self.assertRaisesRegex(Failure, "No matching function found for: 'hn_perlinn'"):
            evaluated(self.engine, "gl_compatibility", rows, edit=lambda code: code.replace("hn_perlin (", "hn_perlinn ("))

    def test_another_renderer_is_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "project.godot").write_text("config_version=5\n")
            (Path(folder) / "none.gd").write_text("extends SceneTree\nfunc _init():\n\tquit()\n")
            with self.assertRaisesRegex(Failure, "Godot does not run with forward_plus"):
                self.engine.run(Path(folder), "forward_plus", "res://none.gd", options=("--rendering-driver", "opengl3"))


if __name__ == "__main__":
    Values.whole = sys.argv[1:] == ["--all"]
    main(Values)
