"""tools/pack materialx: the content of the library of nodes, and its command line.

    python3 -m unittest ship.materialx.materialx_test  names and texts of a few
    python3 -m ship.materialx.materialx_test           the whole library: MaterialX makes shaders of it, which
                                                       have the values of the vectors

Exit status: as of the tests; 77 something that the second needs is not here.
"""

from __future__ import annotations

import re
import shutil
import unittest
import xml.etree.ElementTree as xml

from base.renderer import NoRenderer
from base.testing import skipped_without
from ship.materialx import files
from ship.materialx.generated import LANGUAGES, RUN, Generated, Job, materialx, needed, vectors
from ship.packing_support import made


class Text(unittest.TestCase):
    def test_a_definition_is_that_of_its_node(self) -> None:
        made = xml.fromstring(files.document(files.declared("hn_cellular2_jitter"))).find("nodedef")
        self.assertEqual((made.get("name"), made.get("node")), ("ND_hn_cellular2d_vector2", "hn_cellular2d"))
        self.assertEqual([(one.get("name"), one.get("type")) for one in made.iter("input")],
                         [("texcoord", "vector2"), ("jitter", "float"), ("metric", "integer"), ("seed", "integer")])
        self.assertEqual(made.find("output").attrib, {"name": "out", "type": "vector2", "default": "0.0, 0.0"})
        self.assertRegex(made.get("doc"), r"^\w.*[^.]\.$")

    def test_inputs_have_the_ranges_and_the_texts_of_the_catalog(self) -> None:
        made = xml.fromstring(files.document(files.declared("hn_warp2"))).find("nodedef")
        found = {one.get("name"): (one.get("uimin"), one.get("uimax")) for one in made.iter("input")}
        self.assertEqual(found, {"texcoord": (None, None), "octaves": ("1", "32"), "lacunarity": ("0.0", "255.0"),
                                 "diminish": ("0.0", "1.0"), "amplitude": ("0.0", "64.0"), "seed": (None, None)})
        for one in made.iter("input"):
            self.assertRegex(one.get("doc"), r"^[A-Z].*[^.]\.$")

    def test_each_input_has_a_sentence_and_a_sum_names_its_inputs(self) -> None:
        for form in files.FORMS:
            made = xml.fromstring(files.document(files.declared(form))).find("nodedef")
            for one in made.iter("input"):
                self.assertRegex(one.get("doc", ""), r"^[A-Z].*[^.]\.$", f"{files.node(form)}.{one.get('name')}")
            self.assertNotIn("gain", made.get("doc"))

    def test_a_tile_is_described_as_one(self) -> None:
        for form in ("hn_perlin2_place", "hn_fbm2_place"):
            self.assertRegex(files.doc(form), "repeats after the period")
        self.assertNotIn(", and rotated", files.doc("hn_fbm2_place"))
        with self.assertRaises(KeyError):
            files.doc("hn_value2_place")
        lacunarity, = (one.said for one in files.inputs("hn_fbm2_place") if one.name == "lacunarity")
        self.assertIn("a whole number from 1 to 255", lacunarity)
        self.assertNotIn(files.TILE_LACUNARITY, files.inputs("hn_fbm2"))

    def test_every_target_has_an_implementation_of_its_own(self) -> None:
        """Else Metal and Slang would take that of GLSL."""
        for target in files.TARGETS:
            made = xml.fromstring(files.implementations(target)).findall("implementation")
            self.assertEqual([(one.get("nodedef"), one.get("target")) for one in made],
                             [(files.definition(form), target) for form in files.FORMS])
            self.assertEqual(made[0].get("name"), f"IM_hn_value2d_float_{target}")

    def test_a_text_has_names_of_its_own(self) -> None:
        text = files.source("hn_value2", "genglsl")
        self.assertIn("void hn_value2d(highp float amplitude, highp float pivot, highp vec2 texcoord, highp int seed, "
                      "out highp float result) {\n"
                      "  result = hn_value2d_value(texcoord, uint(seed)) * amplitude + pivot;\n}\n", text)
        self.assertEqual(set(re.findall(r"\bhn_[^\W_]+", text.partition("\n")[2])), {"hn_value2d"})
        self.assertNotIn("#", text)

    def test_osl_has_coordinates_in_place_of_vectors(self) -> None:
        self.assertEqual(files.osl_wrapper("hn_perlin2_place"), """\
void hn_perlin2d_tile(float amplitude, float pivot, vector2 texcoord, vector2 period, int seed, output float result) {
  hn_place2 place = hn_tile2(texcoord.x, texcoord.y, (int)period.x, (int)period.y);
  result = hn_perlin2_place(place, seed) * amplitude + pivot;
}
""")


@unittest.skipUnless(__name__ == "__main__", "the test materialx.library makes all nodes")
class Library(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.root, cls.folder = made(cls, "materialx")
        cls.made = Generated(cls.folder)

    def test_materialx_takes_it(self) -> None:
        self.assertEqual(self.made.faults(), "")
        page = (self.folder / "README.md").read_text()
        self.assertEqual(re.findall(r"^\| `(\w+)`", page, re.MULTILINE), [files.node(form) for form in files.FORMS])
        self.assertEqual(set(self.made.nodes), {files.node(form) for form in files.FORMS})

    def test_each_target_has_its_own_text(self) -> None:
        self.assertEqual(self.made.targets(), {node: set(files.TARGETS) for node in self.made.nodes})

    def test_what_is_wrong_is_told(self) -> None:
        wrong = self.root / "wrong"
        shutil.copytree(self.folder, wrong)
        shutil.rmtree(wrong / "hashnoise" / "genmsl")
        definitions = wrong / "hashnoise" / "hashnoise_defs.mtlx"
        definitions.write_text(definitions.read_text().replace('value="1.0"', 'value="one"', 1))
        made = Generated(wrong)
        self.assertRegex(made.faults(), "Invalid value: <input name=.amplitude.")
        self.assertEqual(made.targets(), {node: {*files.TARGETS} - {"genmsl"} for node in self.made.nodes})

    def test_the_page_is_right(self) -> None:
        page = (self.folder / "README.md").read_text()
        code, = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
        found = {}
        exec(code.replace("import MaterialX as mx\n", "").replace("hashnoise-materialx-VERSION", str(self.folder)),
             {"mx": materialx()}, found)
        self.assertIsNotNone(found["library"].getNodeDef("ND_hn_fbm2d_float"))
        nodes, = re.findall(r"```xml\n(.*?)```", page, re.DOTALL)
        self.assertIn("hn_fbm2d(", self.made.shader_of(files.document(nodes), "height"))

    def test_all_shaders_compile(self) -> None:
        for language in LANGUAGES:
            with self.subTest(language.name):
                language().compile(self.made, self.root)

    def test_all_have_the_bits_of_the_vectors_and_a_fault_is_noticed(self) -> None:
        """At once, since a language may take long to begin."""
        for language in RUN:
            right = language().functions(self.made)
            wrong = right.replace("0x2C1B3C6D", "0x2C1B3C6F")
            self.assertNotEqual(right, wrong)
            *found, of_wrong = language().run([*(Job(right, form) for form in files.FORMS), Job(wrong, "hn_perlin2")],
                                              self.root)
            for form, got in zip(files.FORMS, found, strict=True):
                with self.subTest(language=language.name, form=form):
                    self.assertEqual(got, [row.out for row in vectors(form).rows])
            self.assertNotEqual(of_wrong, [row.out for row in vectors("hn_perlin2").rows])


if __name__ == "__main__":
    with skipped_without(NoRenderer):
        needed()
    unittest.main(defaultTest="Library", verbosity=2)
