"""The tree is complete, and whatever is left out is noticed: each kind of entry is deleted in a copy of the tree.

If test_the_tree_is_complete fails, its message says what to write, and where.
"""

from __future__ import annotations

import re
import shutil
import tempfile
import unittest
from pathlib import Path

from base.tree import BOUNDS, CONFIGURATIONS, FUNCTIONS, GLSL, GOLDEN, ROOT
from catalog.model import CATALOG
from check.complete.check import problems

FORMS = FUNCTIONS.with_name("forms.inc")
BOUNDS_FILE, SETTINGS_FILE, TABLE, MADE = (str(path.relative_to(ROOT))
                                           for path in (BOUNDS, CONFIGURATIONS, FUNCTIONS, FORMS))
PERLIN = "tools/lib/proof/{}/noises/perlin"


class Complete(unittest.TestCase):
    def test_the_tree_is_complete(self) -> None:
        found = problems()
        self.assertEqual(found, [], "\n" + "\n".join(found))


class Deletions(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for path in (GLSL, ROOT / "include" / "hashnoise", ROOT / "README.md", ROOT / "docs" / "contract.md",
                     ROOT / "docs" / "knobs.md", ROOT / "docs" / "noises.md", ROOT / "docs" / "random.md",
                     ROOT / "docs" / "same-bits.md", ROOT / "docs" / "uniform.md", CATALOG, FUNCTIONS, FORMS, CONFIGURATIONS, BOUNDS,
                     *(ROOT / "tools" / "lib" / "proof" / of / "noises" for of in ("oracle", "bounds"))):
            target = self.root / path.relative_to(ROOT)
            target.parent.mkdir(parents=True, exist_ok=True)
            (shutil.copytree if path.is_dir() else shutil.copy)(path, target)
        self.golden = self.root / GOLDEN.relative_to(ROOT)
        self.golden.parent.mkdir(parents=True, exist_ok=True)
        self.golden.symlink_to(GOLDEN)

    def change(self, path: str, pattern: str, new: str = "") -> None:
        """Replaces what a pattern finds in a file, or in the one of the library that has it."""
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
        self.change(TABLE, r'^FUNCTION\("hash\.lattice3"(.|\n)*?;\)\n')
        self.noticed(r"^glsl/hashnoise/\w+\.glsl:\d+: hn_lattice\(ivec3, uint\) has no row: .* add a FUNCTION .* to .*\.inc$",
                     r"hn_lattice\(ivec3\) has no row")

    def test_the_rows_of_a_noise(self) -> None:
        self.change(MADE, r'^FUNCTION\("noise\dd\.value_cubic(?:.*\n)*?\n')
        self.noticed(r"hn_value_cubic\(vec2\) has no row: give it an entry in catalog/ and run tools/make catalog",
                     r"^tools/lib/proof/oracle/noises/value_cubic\.py: no function is the noise value_cubic",
                     r"^tools/lib/proof/bounds/noises/value_cubic\S*: no function is the noise value_cubic")

    def test_the_entry_of_a_function(self) -> None:
        self.change("catalog/noises.toml", r"(?<=^\[simplex\]\ndimensions = )\[2, 4\]", "[2, 3]")
        self.change("catalog/noises.toml", r"(?<=^\[value_cubic\]\ndimensions = )\[1, 3\]", "[1, 4]")
        self.change("catalog/sums.toml", r"^\[ridged\]\n(?:[^\[].*\n|\n)*")
        self.noticed(r"^catalog: there is no hn_simplex in 4D: add it to noises\.toml", r"no hn_ridged in 1D",
                     r"^catalog/noises\.toml: there is no function hn_value_cubic in 4D")

    def test_a_function_that_nobody_knows(self) -> None:
        self.change("glsl/hashnoise/*.glsl", r"^(// Gradient noise on the square lattice)",
                    "// New.\n//   returns  0\nHN_FN hn_float hn_merlin(hn_vec4 p, hn_uint seed) {\n}\n\n\\1")
        self.noticed(r"^glsl/hashnoise/\w+\.glsl:\d+: hn_merlin\(vec4, uint\) has no row: .*add a FUNCTION that calls it")

    def test_an_argument_that_may_not_be_the_same_everywhere(self) -> None:
        self.change("docs/same-bits.md", r"^- \*\*Amplitude, depth, detail", "- **Amplitude, detail")
        self.noticed(r"^glsl/hashnoise/gullies2d\.glsl:\d+: hn_gullies\(.*\) takes depth, of which docs/same-bits\.md says")

    def test_a_function_in_another_form(self) -> None:
        self.change("glsl/hashnoise/*.glsl", r"^HN_FN (hn_float hn_snorm\()", "  \\1")
        self.noticed(r"^glsl/hashnoise/\w+\.glsl:\d+: hn_snorm is not written as .*: begin its first line with HN_FN")

    def test_a_macro_with_the_name_of_a_function(self) -> None:
        self.change("glsl/hashnoise/detail/jacobian.glsl", r"\bhn_i_square_of_slope\b", "hn_i_squared")
        self.noticed(r"^glsl/hashnoise/detail/jacobian\.glsl:\d+: hn_i_squared is also a function: give the macro another name")

    def test_a_function_of_a_row(self) -> None:
        self.change("glsl/hashnoise/*.glsl", r"\bhn_unorm\(", "hn_i_unorm(")
        self.noticed(rf"^{TABLE}:\d+: hash\.unorm: declare hn_unorm\(uint\) in hashnoise/")

    def test_an_overload_without_a_seed(self) -> None:
        self.change("glsl/hashnoise/*.glsl", r"^HN_FN .*\bhn_perlin\(hn_vec3 p\) \{.*\n")
        self.noticed(rf"^{MADE}:\d+: noise3d\.perlin: declare hn_perlin\(vec3\) in hashnoise/")

    def test_the_oracle(self) -> None:
        (self.root / f"{PERLIN.format('oracle')}.py").unlink()
        self.noticed(rf"^{MADE}:\d+: noise2d\.perlin: write tools/lib/proof/oracle/noises/perlin\.py, its exact")

    def test_the_bounds(self) -> None:
        shutil.rmtree(self.root / PERLIN.format("bounds"))
        self.noticed(rf"^{MADE}:\d+: noise3d\.perlin_cell: write tools/lib/proof/bounds/noises/perlin\.py, what is proven")

    def test_a_row_of_the_bounds(self) -> None:
        self.change(BOUNDS_FILE, r'^NOISE_BOUNDS\("perlin", 3.*\n')
        self.noticed(r"noise3d\.perlin: .*bounds\.inc has no perlin in 3D: run tools/make bounds")

    def test_the_contract(self) -> None:
        self.change("docs/contract.md", r"^`hn_value_cubic` takes positions of")
        self.noticed(r"noise3d\.value_cubic_cell: say in docs/contract\.md that `hn_value_cubic` takes positions of 3 dim")

    def test_the_contract_of_a_function(self) -> None:
        self.change("docs/contract.md", r"^\| `hn_snorm\(.*\n")
        self.noticed(r"^docs/contract\.md: no word of hn_snorm\(\.\.\.\): say what its value is")

    def test_the_readme(self) -> None:
        self.change("README.md", r"^\| `hn_perlin\b.*\n")
        self.noticed(r"^README\.md: no line for hn_perlin: add one to the table of functions")

    def test_pages_with_tables_of_functions(self) -> None:
        for page, name in (("random", "hn_gaussian"), ("uniform", "hn_spread_fbm"), ("noises", "hn_phasor_d")):
            with self.subTest(page=page):
                self.change(f"docs/{page}.md", rf"^\| `{name}\b.*\n")
                self.noticed(rf"^README\.md: no line for {name}: .* or to that of docs/noises\.md or docs/uniform\.md or docs/random\.md$")

    def test_a_comment(self) -> None:
        self.change("glsl/hashnoise/*.glsl", r"^(//.*\n)+(HN_FN .*\bhn_snorm\()", "\\2")
        self.noticed(r"^glsl/hashnoise/\w+\.glsl:\d+: hn_snorm\(uint\) has no comment that says what it returns: write one")

    def test_lines_of_a_comment(self) -> None:
        for heading in ("error", "cost"):
            with self.subTest(heading=heading):
                self.change("glsl/hashnoise/perlin2d.glsl", rf"^//   {heading} .*\n")
                self.noticed(rf"^glsl/hashnoise/perlin2d\.glsl:\d+: the comment over hn_perlin\(.*has no line `{heading}`")
        self.change("glsl/hashnoise/perlin3d.glsl", r"^//   period .*\n")
        self.noticed(r"^glsl/hashnoise/perlin3d\.glsl: no comment over its functions has a line `period`")

    def test_a_setting(self) -> None:
        for setting, left, message in (
                (r'^CONFIGURATION\("lattice\+sine\+fixed".*\n', "", "sine_gradient to .* configuration with FIXED"),
                (r'^CONFIGURATION\("pcg"(.|\n)*?\)\n', "", "HN_HASH_PCG is under .* add CONFIGURATION..pcg., PCG"),
                (r"(PRECISE, .*) \| octave_sum", "\\1", "octave_sum to .* configuration with PRECISE"),
                (r'^CONFIGURATION\("fnv1\+precise".*\n', "", 'add CONFIGURATION."fnv1.precise", FNV1, OCTAHEDRAL, '
                 r"PRECISE, gradient_noise \| lattice_noise\)$"),
                (r'^CONFIGURATION\("lattice\+sine\+precise".*\n', "", "add .*LATTICE, SINE, PRECISE, "),
                (r'^CONFIGURATION\("fnv1\+fixed".*\n', "", "fnv1.precise is there without fnv1.fixed: add ")):
            with self.subTest(setting=setting):
                self.setUp()
                self.change(SETTINGS_FILE, setting, left)
                self.noticed(rf"^{SETTINGS_FILE}: .*{message}")

    def test_a_family_of_a_row(self) -> None:
        for row, left, message in (
                (r'^(CONFIGURATION\("lattice\+precise", .*) gradient_noise \|', "\\1", r"lattice\+precise: add "
                 r"gradient_noise to its families, as in lattice\+fixed"),
                (r'^(CONFIGURATION\("fnv1\+fixed", .*) \| lattice_noise', "\\1", r"fnv1\+fixed: add lattice_noise to "
                 r"its families, as in fnv1\+precise"),
                (r'^(CONFIGURATION\("fnv1", .* FAST, hash) .*\)$', "\\1)", "fnv1: add lattice_noise to its families"),
                (r'^(CONFIGURATION\("murmur", .* FAST,)', "\\1 octave_sum |", "murmur: take octave_sum from its families"),
                (r"independent \| ", "", "lattice: add independent to its families"),
                (r'^(CONFIGURATION\("pcg", .* FAST,)', "\\1 independent |", "pcg: take independent from its families")):
            with self.subTest(row=row):
                self.setUp()
                self.change(SETTINGS_FILE, row, left)
                self.noticed(rf"^{SETTINGS_FILE}:\d+: {message}")

    def test_a_function_with_further_values(self) -> None:
        row = 'VALUES("pcg", "noise2d.{}")'
        self.change(SETTINGS_FILE, r'^VALUES\("pcg", "noise2d.simplex"\)', row.format("perlin") + row.format("merlin") +
                    'VALUES("md5", "noise2d.simplex")')
        self.noticed(rf"^{SETTINGS_FILE}:\d+: noise2d.perlin has values with pcg as all of gradient_noise have: take",
                     rf"^{SETTINGS_FILE}:\d+: there is no function noise2d.merlin: name another",
                     rf"^{SETTINGS_FILE}:\d+: there is no configuration md5: name another")

    def test_a_knob(self) -> None:
        self.change("glsl/hashnoise/config.glsl", r"^(#ifndef HN_ARITHMETIC)",
                    "#ifndef HN_WARP\n#define HN_WARP HN_WARP_NONE  // new\n#endif\n\\1")
        self.noticed(r"^include/hashnoise/hashnoise\.hpp: HN_WARP names no inline namespace: add .*\(warp_, HN_WARP\)",
                     r"^docs/knobs\.md: no line for HN_WARP: add one to the table of knobs",
                     rf"^{SETTINGS_FILE}: HN_WARP is not an argument of CONFIGURATION: add warp to",
                     r"^tools/lib/catalog/tables/configurations\.py: HN_WARP is not in Configuration: add warp")

    def test_the_entries_of_a_knob(self) -> None:
        for path, entry, left, message in (
                ("include/hashnoise/*.hpp", r"^inline namespace .*HN_ARITHMETIC\) \{\n", "",
                 r"include/hashnoise/hashnoise\.hpp: HN_ARITHMETIC names no inline namespace"),
                ("docs/knobs.md", r"^\| `HN_ARITHMETIC` \| `HN_FAST`.*\n", "", r"docs/knobs\.md: no line for HN_ARITH"),
                (SETTINGS_FILE, r"^(//   CONFIGURATION\(.*) gradient,", "\\1", r".*: HN_GRADIENT is not an argument of C")):
            with self.subTest(path=path):
                self.setUp()
                self.change(path, entry, left)
                self.noticed(f"^{message}")

    def test_a_value_of_a_knob(self) -> None:
        for after, name, message in (
                ("HN_GRADIENT_SINE 2", "HN_GRADIENT_CUBE", "add a CONFIGURATION with CUBE as its gradient"),
                ("HN_FIXED 3", "HN_EXACT", "add a CONFIGURATION with EXACT as its arithmetic")):
            with self.subTest(name=name):
                self.change("glsl/hashnoise/config.glsl", rf"^(#define {after})", rf"\1\n#define {name} 4  // new")
                self.noticed(rf"^{SETTINGS_FILE}: {name} is under test nowhere: {message}$")

    def test_a_hash(self) -> None:
        self.change("glsl/hashnoise/config.glsl", r"^(#define HN_HASH_PCG 6)", "\\1\n#define HN_HASH_MD5 10  // new")
        self.noticed(r"configurations\.inc: HN_HASH_MD5 is under test with no default",
                     r"^tools/lib/proof/oracle/words\.py: HN_HASH_MD5 is not among the hashes",
                     r"^docs/contract\.md: no line for HN_HASH_MD5", r"^docs/knobs\.md: the knob .* HN_HASH_MD5")

    def test_a_hash_by_its_name(self) -> None:
        self.change(SETTINGS_FILE, r'^CONFIGURATION\("xxhash32".*\n')
        self.noticed(r"^glsl/hashnoise/\w+\.glsl:\d+: hn_hash_xxhash32\(uint\) is the hash of no configuration: add CONFIGURATION")

    def test_a_hash_that_is_no_setting(self) -> None:
        self.change(TABLE, r'^FUNCTION\("hash\.lowbias32"(.|\n)*?;\)\n')
        self.noticed(r"^glsl/hashnoise/\w+\.glsl:\d+: hn_hash_lowbias32\(uint\) is the hash of no .*, or a FUNCTION that calls")

    def test_a_golden_file(self) -> None:
        self.golden.unlink()
        shutil.copytree(GOLDEN, self.golden, ignore=shutil.ignore_patterns("noise1d.perlin.golden"))
        self.change(f"{self.golden.relative_to(self.root)}/noise2d.perlin.golden", r"^(settings .*) fnv1\+fixed:fixed", "\\1")
        self.noticed(r"golden: noise1d\.perlin has no golden values with lattice, lattice\+fixed: run tools/make "
                     r"golden$", r"golden: noise2d\.perlin has no golden values with fnv1\+fixed: run tools/make golden$")

    def test_an_internal_name_in_a_page(self) -> None:
        self.change("docs/uniform.md", r"\A", "Take `hn_i_select`.\n")
        self.change("docs/random.md", r"\A",
                    "\n<!-- tools/make readme: picked -->\nhn_i_mix(k)\n<!-- end -->\n`HN_I_FLOAT`\n")
        found = self.noticed(r"^docs/uniform\.md:1: hn_i_select is internal: recommend a public function, or publish",
                             r"^docs/random\.md:5: HN_I_FLOAT is internal")
        self.assertFalse(any("hn_i_mix" in text for text in found), found)
