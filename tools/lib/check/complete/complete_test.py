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

from base.testing import Case
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


class Examples(Case):
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
        file = self.folder / "shader.frag"
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


LIBRARY, CONFIG, SAME_BITS = "glsl/hashnoise/*.glsl", "glsl/hashnoise/config.glsl", "docs/guide/same-bits.md"
ENTRY = r"\n(?:[^\[\n].*\n|\n)*"  # the rest of a table of TOML
# Changes, each a file (or a pattern of names: the first that has the text), a pattern and the text in its place; and the
# messages that follow.
DELETIONS = (
    # Rows, and functions
    (((ROWS, r'(^lattice = .*calls = "hn_lattice", dimensions = )\[1, 2, 3, 4\]', r"\1[1, 2, 4]"),),
     (r"^glsl/hashnoise/\w+\.glsl:\d+: hn_lattice\(ivec3, uint\) has no row: .* add a row .* to catalog/functions\.toml$",
      r"hn_lattice\(ivec3\) has no row")),
    ((("catalog/noises.toml", rf"^\[value_cubic\]{ENTRY}", ""),),
     (r"hn_value_cubic\(vec2\) has no row: give it an entry in catalog/noises.toml or sums.toml",
      r"^tools/lib/proof/oracle/noises: no function is the noise value_cubic",
      r"^conformance/expected/bounds\.inc: no function is the noise value_cubic")),
    ((("catalog/noises.toml", r"(?<=^\[simplex\]\ndimensions = )\[2, 4\]", "[2, 3]"),
      ("catalog/noises.toml", r"(?<=^\[value_cubic\]\ndimensions = )\[1, 3\]", "[1, 4]"),
      ("catalog/sums.toml", rf"^\[ridged\]{ENTRY}", "")),
     (r"hn_simplex\(vec4\) has no row: give it an entry", r"hn_ridged\(vec2, int, float, float\) has no row",
      r"^catalog: noise4d\.value_cubic: declare hn_value_cubic\(vec4\) in hashnoise/")),
    ((("catalog/noises.toml", r"(?<=^\[cell_border\.options\]\n)", 'metric = "none"\n'),
      (ROWS, r'(^scattered = .*"period", )"radius"', r'\1"metric"')),
     (r"^catalog: noise2d\.cell_border_full: declare hn_cell_border\(vec2, float, int, uint\) in hashnoise/",
      r"^catalog: scatter\.scattered3: declare hn_scattered\(place3, int, uint\) in hashnoise/",
      r"hn_scattered\(ivec2, float, uint\) has no row")),
    (((LIBRARY, r"^(// Perlin noise on the plane: )",
       "// New.\n//   returns  0\nHN_FN hn_float hn_merlin(hn_vec4 p, hn_uint seed) {\n}\n\n\\1"),),
     (r"^glsl/hashnoise/\w+\.glsl:\d+: hn_merlin\(vec4, uint\) has no row: .* or add a row that calls it",)),
    (((LIBRARY, r"^HN_FN (hn_float hn_snorm\()", "  \\1"),),
     (r"^glsl/hashnoise/\w+\.glsl:\d+: hn_snorm is not written as .*: begin its first line with HN_FN",)),
    ((("glsl/hashnoise/detail/jacobian.glsl", r"\bhn_i_square_of_slope\b", "hn_i_squared"),),
     (r"^glsl/hashnoise/detail/jacobian\.glsl:\d+: hn_i_squared is also a function: give the macro another name",)),
    (((LIBRARY, r"\bhn_unorm\(", "hn_i_unorm("),), (r"^catalog: hash\.unorm: declare hn_unorm\(uint\) in hashnoise/",)),
    (((LIBRARY, r"^HN_FN .*\bhn_perlin\(hn_vec3 p\) \{.*\n", ""),),
     (r"^catalog: noise3d\.perlin: declare hn_perlin\(vec3\) in hashnoise/",)),
    # Comments
    (((LIBRARY, r"^(//.*\n)+(HN_FN .*\bhn_snorm\()", "\\2"),),
     (r"^glsl/hashnoise/\w+\.glsl:\d+: hn_snorm\(uint\) has no comment on what it returns: write one",)),
    ((("glsl/hashnoise/perlin2d.glsl", r"^//   error .*\n", ""), ("glsl/hashnoise/perlin3d.glsl", r"^//   period .*\n", "")),
     (r"^glsl/hashnoise/perlin2d\.glsl:\d+: the comment over hn_perlin\(.*has no line `error`",
      r"^glsl/hashnoise/perlin3d\.glsl: no comment over its functions has a line `period`")),
    ((("glsl/hashnoise/perlin2d.glsl", r"^//   cost .*\n", ""), ("glsl/hashnoise/perlin2d.glsl", r"snippets/hn_perlin2", "")),
     (r"^glsl/hashnoise/perlin2d\.glsl:\d+: the comment over hn_perlin\(.*has no line `cost`",
      r"^glsl/hashnoise/perlin2d\.glsl: its header has no line `// To read it .*/hn_perlin2\.md`")),
    # Pages
    (((SAME_BITS, r"\(amplitude, bandwidth, depth, detail", "(amplitude, detail"),),
     (rf"^glsl/hashnoise/gullies2d\.glsl:\d+: hn_gullies\(.*\) takes depth, which {SAME_BITS} does not name",)),
    ((("docs/reference/contract.md", r"^`hn_value_cubic` takes positions of", ""),
      ("docs/reference/contract.md", r"^\| `hn_snorm\(.*\n", "")),
     (r"noise3d\.value_cubic_cell: state in docs/reference/contract\.md that `hn_value_cubic` takes positions of 3 dim",
      r"^docs/reference/contract\.md: no word of hn_snorm\(\.\.\.\): state what its value is")),
    ((("README.md", r"^\| `hn_perlin\b.*\n", ""), ("docs/guide/random.md", r"^\| `hn_gaussian\b.*\n", ""),
      ("docs/guide/uniform.md", r"^\| `hn_distribution_fbm\b.*\n", ""),
      ("docs/reference/noises.md", r"^\| `hn_phasor_d\b.*\n", "")),
     (r"^README\.md: no line for hn_perlin: add one to the table of functions",
      *(rf"^README\.md: no line for {name}: .* or to that of docs/reference/noises\.md or docs/guide/uniform\.md or "
        r"docs/guide/random\.md$" for name in ("hn_gaussian", "hn_distribution_fbm", "hn_phasor_d")))),
    # Proofs
    (((BOUNDS_FILE, r'^NOISE_BOUNDS\("perlin", 3.*\n', ""),),
     (r"noise3d\.perlin: .*bounds\.inc has no perlin in 3D: run tools/make bounds",)),
    *((((path, mark, ""),), (rf"^catalog/sums\.toml: {name}: write in {path} {what}",)) for name, path, mark, what in (
        ("ridged", "tools/lib/proof/oracle/sums.py", '"ridged": ', "its exact and its fixed value"),
        ("eroded", "tools/lib/proof/oracle/jacobians.py", '"eroded": ', "its exact and its fixed value"))),
    # Settings
    (((SETTINGS, r'"noise4d.value"', '"noise2d.perlin", "noise2d.merlin"'),),
     (rf"^{SETTINGS}: noise2d.perlin has values with pcg as all of gradient_noise have: take",
      rf"^{SETTINGS}: there is no function noise2d.merlin: name another")),
    (((CONFIG, r"^(#ifndef HN_ARITHMETIC)", "#ifndef HN_WARP\n#define HN_WARP HN_WARP_NONE  // new\n#endif\n\\1"),),
     (r"^include/hashnoise/hashnoise\.hpp: HN_WARP names no inline namespace: add .*\(warp_, HN_WARP\)",
      r"^docs/reference/knobs\.md: no line for HN_WARP: add one to the table of knobs",
      r"^tools/lib/catalog/tables/configurations\.py: HN_WARP is not in Configuration: add warp")),
    ((("include/hashnoise/*.hpp", r"^inline namespace .*HN_ARITHMETIC\) \{\n", ""),
      ("docs/reference/knobs.md", r"^\| `HN_ARITHMETIC` \| `HN_FAST`.*\n", "")),
     (r"^include/hashnoise/hashnoise\.hpp: HN_ARITHMETIC names no inline namespace",
      r"^docs/reference/knobs\.md: no line for HN_ARITH")),
    (((CONFIG, r"^(#define HN_GRADIENT_SINE 2)", r"\1\n#define HN_GRADIENT_CUBE 4  // new"),
      (CONFIG, r"^(#define HN_FIXED 3)", r"\1\n#define HN_EXACT 4  // new")),
     (rf"^{SETTINGS}: HN_GRADIENT_CUBE is under test nowhere: add a group with cube as its gradient$",
      rf"^{SETTINGS}: HN_EXACT is under test nowhere: add a group with exact as its arithmetic$")),
    (((CONFIG, r"^(#define HN_HASH_PCG 6)", "\\1\n#define HN_HASH_MD5 10  // new"),),
     (r"configurations\.toml: HN_HASH_MD5 is under test with no default",
      r"^tools/lib/proof/oracle/hashes\.py: HN_HASH_MD5 is not among the hashes",
      r"^docs/reference/contract\.md: no line for HN_HASH_MD5", r"^docs/reference/knobs\.md: the knob .* HN_HASH_MD5")),
    (((SETTINGS, r'"xxhash32", ', ""),),
     (r"^glsl/hashnoise/detail/\w+\.glsl:\d+: hn_hash_xxhash32\(uint\) is the hash of no configuration: add xxhash32 to",
      r"^catalog/configurations\.toml: HN_HASH_XXHASH32 is under test with no default gradient: add xxhash32")),
    (((ROWS, r"^lowbias32 = .*\n", ""),),
     (r"^glsl/hashnoise/detail/\w+\.glsl:\d+: hn_hash_lowbias32\(uint\) is the hash of no .*, or a row that calls",)))


class Deletions(Case):
    def setUp(self) -> None:
        self.tree, docs = self.folder / "tree", ROOT / "docs"
        for path in (GLSL, ROOT / "include" / "hashnoise", ROOT / "README.md", CATALOG, BOUNDS,
                     *(docs / "reference" / f"{page}.md" for page in ("contract", "knobs", "noises")),
                     *(docs / "guide" / f"{page}.md" for page in ("random", "same-bits", "uniform")),
                     *(ROOT / "tools" / "lib" / "proof" / of for of in ("oracle", "bounds"))):
            target = self.tree / path.relative_to(ROOT)
            target.parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if path.is_dir() else shutil.copy)(path, target)
        self.golden = self.tree / GOLDEN.relative_to(ROOT)
        self.golden.parent.mkdir(parents=True, exist_ok=True)
        self.golden.symlink_to(GOLDEN)

    def change(self, path: str, pattern: str, new: str = "") -> tuple[Path, str]:
        """Replaces the matches of a pattern in a file. Returns the file, and the text that it had."""
        files = [file for file in sorted(self.tree.glob(path)) if re.search(pattern, file.read_text(), re.MULTILINE)]
        self.assertTrue(files, f"{pattern} is not in {path}")
        text = files[0].read_text()
        files[0].write_text(re.sub(pattern, new, text, flags=re.MULTILINE))
        return files[0], text

    def noticed(self, *messages: str) -> list[str]:
        # By another name each time: the tables of a folder are read once.
        root = Path(tempfile.mkdtemp(dir=self.folder)) / "tree"
        root.symlink_to(self.tree)
        found = problems(root)
        for message in messages:
            self.assertTrue(any(re.search(message, text) for text in found), f"{message} is not in {found}")
        return found

    def test_what_is_missing_is_noticed(self) -> None:
        self.assertEqual(self.noticed(), [], "the copy is complete")
        for changes, messages in DELETIONS:
            with self.subTest(changes):
                before = [self.change(*change) for change in changes]
                self.noticed(*messages)
                for file, text in reversed(before):
                    file.write_text(text)

    def test_the_oracle(self) -> None:
        with mock.patch.object(noises, "names", return_value=["value"]):
            self.noticed(r"^catalog: noise2d\.perlin: write in tools/lib/proof/oracle/noises its exact")

    def test_a_golden_file(self) -> None:
        self.golden.unlink()
        shutil.copytree(GOLDEN, self.golden, ignore=shutil.ignore_patterns("noise1d.perlin.golden"))
        self.change(f"{self.golden.relative_to(self.tree)}/noise2d.perlin.golden", r"^(settings .*) fnv1\+fixed:fixed", "\\1")
        self.noticed(r"golden: noise1d\.perlin has no golden values with lattice, lattice\+fixed: run tools/make "
                     r"golden$", r"golden: noise2d\.perlin has no golden values with fnv1\+fixed: run tools/make golden$")

    def test_an_internal_name_in_a_page(self) -> None:
        self.change("docs/guide/uniform.md", r"\A", "Take `hn_i_select`.\n")
        self.change("docs/guide/random.md", r"\A", "\n`HN_I_FLOAT`\n")
        self.noticed(r"^docs/guide/uniform\.md:1: hn_i_select is internal: recommend a public function, or publish",
                     r"^docs/guide/random\.md:2: HN_I_FLOAT is internal")
