"""The tree is complete, and whatever is left out is noticed: each kind of entry is deleted in a copy of the tree.

If test_the_tree_is_complete fails, its message names the missing text and its place.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from base.tree import BOUNDS, GLSL, GOLDEN, ROOT
from catalog.model import CATALOG
from catalog.tables import glsl
from check.complete.check import ROWS, SETTINGS, problems
from proof.oracle import noises

BOUNDS_FILE = str(BOUNDS.relative_to(ROOT))


class Complete(unittest.TestCase):
    def test_the_tree_is_complete(self) -> None:
        found = problems()
        self.assertEqual(found, [], "\n" + "\n".join(found))


class Examples(unittest.TestCase):
    """The code in the comments of the library compiles."""

    def shader(self, library: Path) -> str:
        """All of it, in the strictest GLSL. uv is a position from 0 to 1, and o the octaves of a fractal."""
        blocks = []
        for path, comment in dict.fromkeys((one.path, one.comment) for one in glsl.declarations(library) if one.comment):
            found = re.search(r"(\d)d\.glsl$", path.name)
            dims = found[1] if found else "2"
            for code in comment.examples:
                octaves = "" if f"hn_octaves{dims} o" in code or not re.search(r"\bo\b", code) else (
                    f"hn_octaves{dims} o = hn_octaves(p, 6, 2.0, 0.5, 7u);")
                type_ = f"vec{dims}" if dims > "1" else "float"
                p = "" if re.search(r"vec\d p =", code) else f"{type_} p = {type_}(uv.x);"
                blocks.append(f"{{ {p} {octaves}\n{code}\n}}")
        return ("#version 300 es\n#extension GL_GOOGLE_include_directive : enable\nprecision highp float;\n"
                '#include "hashnoise/hashnoise.glsl"\nin vec2 uv;\nvoid main() {\n' + "\n".join(blocks) + "\n}\n")

    def compiled(self, shader: str) -> subprocess.CompletedProcess[str]:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "shader.frag"
            file.write_text(shader, encoding="ascii")
            return subprocess.run(["glslangValidator", "-l", f"-I{GLSL.parent}", file], capture_output=True, text=True, check=False)

    def test_they_compile(self) -> None:
        shader = self.shader(GLSL)
        self.assertGreater(shader.count("hn_perlin(uv * 8.0, 7u);"), 0)
        done = self.compiled(shader)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_a_wrong_one_is_noticed(self) -> None:
        shader = self.shader(GLSL)
        for old, new in (("hn_perlin(uv * 8.0, 7u);", "hn_perlin(uv * 8.0, 7);"), ("vec3 height =", "vec2 height ="),
                         ("ivec2 nearest;", "")):
            with self.subTest(new):
                self.assertIn(old, shader)
                self.assertNotEqual(self.compiled(shader.replace(old, new, 1)).returncode, 0)


class Deletions(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for path in (GLSL, ROOT / "include" / "hashnoise", ROOT / "README.md", ROOT / "docs" / "reference" / "contract.md",
                     ROOT / "docs" / "reference" / "knobs.md", ROOT / "docs" / "reference" / "noises.md", ROOT / "docs" / "guide" / "random.md",
                     ROOT / "docs" / "guide" / "same-bits.md", ROOT / "docs" / "guide" / "uniform.md", CATALOG, BOUNDS,
                     *(ROOT / "tools" / "lib" / "proof" / of for of in ("oracle", "bounds", "sums"))):
            target = self.root / path.relative_to(ROOT)
            target.parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if path.is_dir() else shutil.copy)(path, target)
        self.golden = self.root / GOLDEN.relative_to(ROOT)
        self.golden.parent.mkdir(parents=True, exist_ok=True)
        self.golden.symlink_to(GOLDEN)

    def change(self, path: str, pattern: str, new: str = "") -> None:
        """Replaces the matches of a pattern in a file, or in the one of the library that has it."""
        files = [file for file in sorted(self.root.glob(path)) if re.search(pattern, file.read_text(), re.MULTILINE)]
        self.assertTrue(files, f"{pattern} is not in {path}")
        text = files[0].read_text()
        files[0].write_text(re.sub(pattern, new, text, flags=re.MULTILINE))

    def noticed(self, *messages: str) -> list[str]:
        found = problems(self.root)
        for message in messages:
            self.assertTrue(any(re.search(message, text) for text in found), f"{message} is not in {found}")
        return found

    def test_the_copy_is_complete(self) -> None:
        self.assertEqual(problems(self.root), [])

    def test_a_row_of_a_function(self) -> None:
        self.change(ROWS, r'(^lattice = .*calls = "hn_lattice", dimensions = )\[1, 2, 3, 4\]', r"\1[1, 2, 4]")
        self.noticed(r"^glsl/hashnoise/\w+\.glsl:\d+: hn_lattice\(ivec3, uint\) has no row: .* add a row .* to catalog/functions\.toml$",
                     r"hn_lattice\(ivec3\) has no row")

    def test_the_rows_of_a_noise(self) -> None:
        self.change("catalog/noises.toml", r"^\[value_cubic\]\n(?:[^\[\n].*\n|\n)*")
        self.noticed(r"hn_value_cubic\(vec2\) has no row: give it an entry in catalog/noises.toml or sums.toml",
                     r"^tools/lib/proof/oracle/noises: no function is the noise value_cubic",
                     r"^conformance/expected/bounds\.inc: no function is the noise value_cubic")

    def test_the_entry_of_a_function(self) -> None:
        self.change("catalog/noises.toml", r"(?<=^\[simplex\]\ndimensions = )\[2, 4\]", "[2, 3]")
        self.change("catalog/noises.toml", r"(?<=^\[value_cubic\]\ndimensions = )\[1, 3\]", "[1, 4]")
        self.change("catalog/sums.toml", r"^\[ridged\]\n(?:[^\[\n].*\n|\n)*")
        self.noticed(r"hn_simplex\(vec4\) has no row: give it an entry", r"hn_ridged\(vec2, int, float, float\) has no row",
                     r"^catalog: noise4d\.value_cubic: declare hn_value_cubic\(vec4\) in hashnoise/")

    def test_a_row_that_is_not_what_the_function_takes(self) -> None:
        self.change("catalog/noises.toml", r"(?<=^\[cell_border\.options\]\n)", 'metric = "none"\n')
        self.change(ROWS, r'(^scattered = .*"period", )"radius"', r'\1"metric"')
        self.noticed(r"^catalog: noise2d\.cell_border_full: declare hn_cell_border\(vec2, float, int, uint\) in hashnoise/",
                     r"^catalog: scatter\.scattered3: declare hn_scattered\(place3, int, uint\) in hashnoise/",
                     r"hn_scattered\(ivec2, float, uint\) has no row")

    def test_a_function_that_nobody_knows(self) -> None:
        self.change("glsl/hashnoise/*.glsl", r"^(// Perlin noise on the plane: )",
                    "// New.\n//   returns  0\nHN_FN hn_float hn_merlin(hn_vec4 p, hn_uint seed) {\n}\n\n\\1")
        self.noticed(r"^glsl/hashnoise/\w+\.glsl:\d+: hn_merlin\(vec4, uint\) has no row: .* or add a row that calls it")

    def test_an_argument_that_may_not_be_the_same_everywhere(self) -> None:
        self.change("docs/guide/same-bits.md", r"^- \*\*Amplitude, depth, detail", "- **Amplitude, detail")
        self.noticed(r"^glsl/hashnoise/gullies2d\.glsl:\d+: hn_gullies\(.*\) takes depth, which docs/guide/same-bits\.md does not name")

    def test_a_function_in_another_form(self) -> None:
        self.change("glsl/hashnoise/*.glsl", r"^HN_FN (hn_float hn_snorm\()", "  \\1")
        self.noticed(r"^glsl/hashnoise/\w+\.glsl:\d+: hn_snorm is not written as .*: begin its first line with HN_FN")

    def test_a_macro_with_the_name_of_a_function(self) -> None:
        self.change("glsl/hashnoise/detail/jacobian.glsl", r"\bhn_i_square_of_slope\b", "hn_i_squared")
        self.noticed(r"^glsl/hashnoise/detail/jacobian\.glsl:\d+: hn_i_squared is also a function: give the macro another name")

    def test_a_function_of_a_row(self) -> None:
        self.change("glsl/hashnoise/*.glsl", r"\bhn_unorm\(", "hn_i_unorm(")
        self.noticed(r"^catalog: hash\.unorm: declare hn_unorm\(uint\) in hashnoise/")

    def test_an_overload_without_a_seed(self) -> None:
        self.change("glsl/hashnoise/*.glsl", r"^HN_FN .*\bhn_perlin\(hn_vec3 p\) \{.*\n")
        self.noticed(r"^catalog: noise3d\.perlin: declare hn_perlin\(vec3\) in hashnoise/")

    def test_the_oracle(self) -> None:
        with mock.patch.object(noises, "names", return_value=["value"]):
            self.noticed(r"^catalog: noise2d\.perlin: write in tools/lib/proof/oracle/noises its exact")

    def test_a_sum(self) -> None:
        for name, path, mark, message in (
                ("ridged", "oracle/sums.py", '"ridged": ', "its exact and its fixed value"),
                ("ping_pong", "bounds/steps.py", '"wave": ', "its computation"),
                ("weighted", "sums/bounds.cpp", "case SumStep::bent:", "its errors"),
                ("eroded", "oracle/jacobians.py", '"eroded": ', "its exact and its fixed value"),
                ("warp", "bounds/jacobians.py", '"warp": ', "its computation"),
                ("warp_progressive", "sums/bounds.cpp", "case SumStep::warp_progressive:", "its errors")):
            with self.subTest(name):
                self.change(f"tools/lib/proof/{path}", mark)
                self.noticed(rf"^catalog/sums\.toml: {name}: write in tools/lib/proof/{path} {message}")

    def test_a_row_of_the_bounds(self) -> None:
        self.change(BOUNDS_FILE, r'^NOISE_BOUNDS\("perlin", 3.*\n')
        self.noticed(r"noise3d\.perlin: .*bounds\.inc has no perlin in 3D: write in .*, and run tools/make bounds")

    def test_the_contract(self) -> None:
        self.change("docs/reference/contract.md", r"^`hn_value_cubic` takes positions of")
        self.noticed(r"noise3d\.value_cubic_cell: state in docs/reference/contract\.md that `hn_value_cubic` takes "
                     r"positions of 3 dim")

    def test_the_contract_of_a_function(self) -> None:
        self.change("docs/reference/contract.md", r"^\| `hn_snorm\(.*\n")
        self.noticed(r"^docs/reference/contract\.md: no word of hn_snorm\(\.\.\.\): state what its value is")

    def test_the_readme(self) -> None:
        self.change("README.md", r"^\| `hn_perlin\b.*\n")
        self.noticed(r"^README\.md: no line for hn_perlin: add one to the table of functions")

    def test_pages_with_tables_of_functions(self) -> None:
        for page, name in (
                ("guide/random", "hn_gaussian"), ("guide/uniform", "hn_distribution_fbm"), ("reference/noises", "hn_phasor_d")):
            with self.subTest(page=page):
                self.change(f"docs/{page}.md", rf"^\| `{name}\b.*\n")
                self.noticed(rf"^README\.md: no line for {name}: .* or to that of docs/reference/noises\.md or "
                             r"docs/guide/uniform\.md or docs/guide/random\.md$")

    def test_a_comment(self) -> None:
        self.change("glsl/hashnoise/*.glsl", r"^(//.*\n)+(HN_FN .*\bhn_snorm\()", "\\2")
        self.noticed(r"^glsl/hashnoise/\w+\.glsl:\d+: hn_snorm\(uint\) has no comment on what it returns: write one")

    def test_lines_of_a_comment(self) -> None:
        for heading in ("error", "cost"):
            with self.subTest(heading=heading):
                self.change("glsl/hashnoise/perlin2d.glsl", rf"^//   {heading} .*\n")
                self.noticed(rf"^glsl/hashnoise/perlin2d\.glsl:\d+: the comment over hn_perlin\(.*has no line `{heading}`")
        self.change("glsl/hashnoise/perlin3d.glsl", r"^//   period .*\n")
        self.noticed(r"^glsl/hashnoise/perlin3d\.glsl: no comment over its functions has a line `period`")

    def test_the_text_to_read(self) -> None:
        self.change("glsl/hashnoise/perlin2d.glsl", r"snippets/hn_perlin2", "snippets/hn_perlin3")
        self.noticed(r"^glsl/hashnoise/perlin2d\.glsl: its header has no line `// To read it .*/hn_perlin2\.md`")

    def test_a_function_with_further_values(self) -> None:
        self.change(SETTINGS, r'"noise4d.value"', '"noise2d.perlin", "noise2d.merlin"')
        self.noticed(rf"^{SETTINGS}: noise2d.perlin has values with pcg as all of gradient_noise have: take",
                     rf"^{SETTINGS}: there is no function noise2d.merlin: name another")

    def test_a_knob(self) -> None:
        self.change("glsl/hashnoise/config.glsl", r"^(#ifndef HN_ARITHMETIC)",
                    "#ifndef HN_WARP\n#define HN_WARP HN_WARP_NONE  // new\n#endif\n\\1")
        self.noticed(r"^include/hashnoise/hashnoise\.hpp: HN_WARP names no inline namespace: add .*\(warp_, HN_WARP\)",
                     r"^docs/reference/knobs\.md: no line for HN_WARP: add one to the table of knobs",
                     r"^tools/lib/catalog/tables/configurations\.py: HN_WARP is not in Configuration: add warp")

    def test_the_entries_of_a_knob(self) -> None:
        for path, entry, left, message in (
                ("include/hashnoise/*.hpp", r"^inline namespace .*HN_ARITHMETIC\) \{\n", "",
                 r"include/hashnoise/hashnoise\.hpp: HN_ARITHMETIC names no inline namespace"),
                ("docs/reference/knobs.md", r"^\| `HN_ARITHMETIC` \| `HN_FAST`.*\n", "", r"docs/reference/knobs\.md: no line for HN_ARITH")):
            with self.subTest(path=path):
                self.setUp()
                self.change(path, entry, left)
                self.noticed(f"^{message}")

    def test_a_value_of_a_knob(self) -> None:
        for after, name, message in (
                ("HN_GRADIENT_SINE 2", "HN_GRADIENT_CUBE", "add a group with cube as its gradient"),
                ("HN_FIXED 3", "HN_EXACT", "add a group with exact as its arithmetic")):
            with self.subTest(name=name):
                self.change("glsl/hashnoise/config.glsl", rf"^(#define {after})", rf"\1\n#define {name} 4  // new")
                self.noticed(rf"^{SETTINGS}: {name} is under test nowhere: {message}$")

    def test_a_hash(self) -> None:
        self.change("glsl/hashnoise/config.glsl", r"^(#define HN_HASH_PCG 6)", "\\1\n#define HN_HASH_MD5 10  // new")
        self.noticed(r"configurations\.toml: HN_HASH_MD5 is under test with no default",
                     r"^tools/lib/proof/oracle/words\.py: HN_HASH_MD5 is not among the hashes",
                     r"^docs/reference/contract\.md: no line for HN_HASH_MD5", r"^docs/reference/knobs\.md: the knob .* HN_HASH_MD5")

    def test_a_hash_by_its_name(self) -> None:
        self.change(SETTINGS, r'"xxhash32", ')
        self.noticed(r"^glsl/hashnoise/detail/\w+\.glsl:\d+: hn_hash_xxhash32\(uint\) is the hash of no configuration: add xxhash32 to",
                     r"^catalog/configurations\.toml: HN_HASH_XXHASH32 is under test with no default gradient: add xxhash32")

    def test_a_hash_that_is_no_setting(self) -> None:
        self.change(ROWS, r"^lowbias32 = .*\n")
        self.noticed(r"^glsl/hashnoise/detail/\w+\.glsl:\d+: hn_hash_lowbias32\(uint\) is the hash of no .*, or a row that calls")

    def test_a_golden_file(self) -> None:
        self.golden.unlink()
        shutil.copytree(GOLDEN, self.golden, ignore=shutil.ignore_patterns("noise1d.perlin.golden"))
        self.change(f"{self.golden.relative_to(self.root)}/noise2d.perlin.golden", r"^(settings .*) fnv1\+fixed:fixed", "\\1")
        self.noticed(r"golden: noise1d\.perlin has no golden values with lattice, lattice\+fixed: run tools/make "
                     r"golden$", r"golden: noise2d\.perlin has no golden values with fnv1\+fixed: run tools/make golden$")

    def test_an_internal_name_in_a_page(self) -> None:
        self.change("docs/guide/uniform.md", r"\A", "Take `hn_i_select`.\n")
        self.change("docs/guide/random.md", r"\A",
                    "\n<!-- tools/make readme: picked -->\nhn_i_mix(k)\n<!-- end -->\n`HN_I_FLOAT`\n")
        found = self.noticed(r"^docs/guide/uniform\.md:1: hn_i_select is internal: recommend a public function, or publish",
                             r"^docs/guide/random\.md:5: HN_I_FLOAT is internal")
        self.assertFalse(any("hn_i_mix" in text for text in found), found)
