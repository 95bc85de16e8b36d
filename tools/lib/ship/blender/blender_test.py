"""tools/pack blender: the content of the add-on, and its command line.

    python3 -m unittest ship.blender.blender_test     names and texts of a few
    python3 -m ship.blender.blender_test ENVIRONMENT  in Blender, PyPI's bpy: the operators. ENVIRONMENT is the
                                                      folder of python.wheel, which has the Python package

Exit status: as of the tests; 77 bpy or the package is not here.
"""

from __future__ import annotations

import contextlib
import io
import itertools
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from base.pypi import installed
from base.testing import skipped_without
from base.tree import TOOLS, version
from ship import command
from ship.blender import files
from ship.blender.in_blender import Heights, NoBlender, found
from ship.packing_support import made
from translate.pick.osl_runner import PACKAGE

SIDE = 12  # pixels
OFFSET = (100.25, -70.5, 3.75)  # of positions, from the numbers of pixels


class Text(unittest.TestCase):
    def test_it_says_what_it_is(self) -> None:
        with mock.patch.object(files, "texts", return_value={"hn_fbm2": "shader"}):
            package = files.package.__wrapped__()
        self.assertIn(f'\nid = "hashnoise"\nversion = "{version()}"\n', package["blender_manifest.toml"])
        self.assertEqual(package["shaders/fbm2.osl"], "shader")
        self.assertTrue({"__init__.py", "displace.py", "nodes.py", "README.md", "LICENSE"} <= set(package))

    def test_what_is_no_wheel_of_the_package_is_refused(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            for name in ("hashnoise-0.4.0.zip", "hashnoise-0.4.0-cp311-cp311-linux_x86_64.whl"):
                Path(folder, name).write_text("no wheel")
                with self.subTest(name), contextlib.redirect_stderr(io.StringIO()) as error:
                    with mock.patch.object(files, "texts", return_value={}), self.assertRaises(SystemExit) as ended:
                        command.main(["blender", "--wheel", f"{folder}/{name}", folder])
                    self.assertEqual(ended.exception.code, 2)
                    self.assertIn(f"{name} is no wheel of hashnoise; tools/pack python makes one", error.getvalue())


@unittest.skipUnless(__name__ == "__main__", "the test blender.addon has Blender")
class AddOn(unittest.TestCase):
    environment: Path

    @classmethod
    def setUpClass(cls) -> None:
        cls.root, cls.zip = made(cls, "blender", "--zip")
        cls.heights = Heights(cls.zip)
        cls.add_on = sys.modules["bl_ext.user_default.hashnoise"]

    def setUp(self) -> None:
        self.scene = self.heights.scene
        self.scene.render.engine = "CYCLES"

    def refused(self, operator, pattern: str, **settings) -> None:
        with self.assertRaisesRegex(RuntimeError, pattern):
            operator(**settings)

    def test_blenders_own_program_takes_the_file(self) -> None:
        program = self.heights.extensions_program()

        def status(file: Path) -> int:
            return subprocess.run([sys.executable, "-B", program, "validate", file], capture_output=True,
                                  check=False).returncode
        self.assertEqual(status(self.zip), 0)
        with tempfile.TemporaryDirectory() as folder:
            wrong = Path(folder, files.MANIFEST)
            wrong.write_text(files.package()[files.MANIFEST].replace("type =", "kind ="))
            self.assertNotEqual(status(Path(folder)), 0)

    def test_a_wheel_is_installed_with_it(self) -> None:
        """In a Blender that has none."""
        import hashnoise
        wheel, = (self.environment / "wheels").glob("*.whl")
        with contextlib.redirect_stdout(io.StringIO()) as out:
            command.main(["blender", "--zip", "--wheel", str(wheel), str(self.root / "with wheel")])
        lines = ("import sys; from pathlib import Path; from ship.blender.in_blender import Heights\n"
                 "heights = Heights(Path(sys.argv[1])).displaced([(0.5, 0.25, 0.0)], scale=1.0, strength=1.0, seed=7)\n"
                 "import hashnoise; print(hashnoise.__file__, float(heights[0]).hex())\n")
        user = self.root / "other user"
        environment = {**os.environ, "BLENDER_USER_RESOURCES": str(user),
                       "PYTHONPATH": os.pathsep.join(map(str, (installed(PACKAGE), TOOLS / "lib")))}
        done = subprocess.run([sys.executable, "-B", "-c", lines, out.getvalue().strip()], env=environment,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        height = hashnoise.fbm(0.5, 0.25, seed=7, arithmetic="fixed").hex()
        self.assertRegex(done.stdout.splitlines()[-1],
                         rf"^{re.escape(str(user))}/\S*hashnoise/__init__.py {re.escape(height)}$")

    # The operator.

    def test_the_heights_are_those_of_the_package(self) -> None:
        import hashnoise
        import numpy
        displace = self.add_on.displace
        points = self.heights.random_points(200)
        at = points * numpy.float32(0.37)
        octaves = {"octaves": 5, "lacunarity": 2.25, "gain": 0.625}
        for (fractal, *_), (noise, *_), axes in itertools.product(displace.FRACTALS, displace.NOISES, (2, 3)):
            if fractal != "NONE" and noise == "cellular":
                continue
            function = getattr(hashnoise, noise if fractal == "NONE" else fractal)
            more = {} if fractal == "NONE" else {"noise": noise, **octaves}
            expected = [function(*map(float, p[:axes]), seed=7, arithmetic="fixed", **more) for p in at]
            if noise == "cellular":
                expected = [value[0] for value in expected]
            with self.subTest(fractal=fractal, noise=noise, axes=axes):
                got = self.heights.displaced(points, fractal=fractal, noise=noise, scale=0.37, strength=1.0, seed=7, **octaves,
                                             position="PLANE" if axes == 2 else "SPACE")
                self.assertEqual(got.tobytes(), numpy.array(expected, numpy.float32).tobytes())
        other = self.heights.displaced(points, scale=0.37, strength=1.0, seed=8)
        same = self.heights.displaced(points, scale=0.37, strength=1.0, seed=7)
        self.assertLess((other == same).sum(), len(points) / 2)

    def test_vertices_move_along_their_normals(self) -> None:
        import bpy
        import hashnoise
        import numpy
        self.heights.select(None)
        bpy.ops.mesh.primitive_uv_sphere_add(segments=12, ring_count=8)
        mesh = bpy.context.object.data
        displace = self.add_on.displace
        before, normals = displace.read(mesh.vertices, "co"), displace.read(mesh.vertex_normals, "vector")
        bpy.ops.object.hashnoise_displace(direction="NORMAL", position="SPACE", scale=3.0, strength=0.5, seed=4)
        moves = hashnoise.fbm(*(before * numpy.float32(3)).T, seed=4, arithmetic="fixed") * numpy.float32(0.5)
        expected = before + moves[:, numpy.newaxis] * normals
        self.assertEqual(displace.read(mesh.vertices, "co").tobytes(), expected.tobytes())
        self.assertGreater(abs(expected - before).max(), 0.05)

    def test_it_can_be_undone(self) -> None:
        import bpy
        bpy.context.preferences.edit.use_global_undo = True
        self.heights.select([(0.5, 0.25, 0.0), (0.25, 0.75, 0.0)])
        name = bpy.context.object.name
        bpy.ops.ed.undo_push(message="before")

        def height() -> float:
            return bpy.data.objects[name].data.vertices[0].co.z
        bpy.ops.object.hashnoise_displace("EXEC_DEFAULT", True)
        self.assertNotEqual(height(), 0.0)
        bpy.ops.ed.undo()
        self.assertEqual(height(), 0.0)
        bpy.ops.ed.redo()
        self.assertNotEqual(height(), 0.0)
        self.heights.scene = bpy.context.scene  # the undone change was made anew

    def test_what_is_wrong_is_told_and_nothing_moves(self) -> None:
        import bpy
        displace = bpy.ops.object.hashnoise_displace
        self.heights.select(None)
        self.refused(displace, "Select a mesh")
        self.heights.select([])
        self.refused(displace, "has no vertices")
        self.heights.select([(0.5, 0.25, 0.0)])
        mesh = bpy.context.object.data
        with mock.patch.dict(sys.modules, {"hashnoise": None}):
            self.refused(displace, re.escape(sys.executable) + r" -m pip install hashnoise-VERSION-\.\.\.\.whl")
        self.refused(displace, r"another noise \(Perlin, Simplex, Value, Cubic Value\)", fractal="fbm",
                     noise="cellular")
        bpy.ops.object.mode_set(mode="EDIT")
        self.refused(displace, "Change to Object Mode")
        bpy.ops.object.mode_set(mode="OBJECT")
        bpy.context.object.shape_key_add(name="key")
        self.refused(displace, "has shape keys")
        bpy.context.object.shape_key_clear()
        self.assertEqual(tuple(mesh.vertices[0].co), (0.5, 0.25, 0.0))
        library = str(self.root / "library.blend")
        bpy.data.libraries.write(library, {mesh})
        with bpy.data.libraries.load(library, link=True) as (there, here):
            here.meshes = [mesh.name]
        bpy.context.object.data = here.meshes[0]
        self.refused(displace, "is linked from another file")
        bpy.context.object.data = mesh
        self.assertEqual(displace(), {"FINISHED"})
        self.assertNotEqual(mesh.vertices[0].co.z, 0.0)

    # The node groups.

    @staticmethod
    def rendered_points() -> list:
        """Coordinates of pixels with OFFSET, at a scale of 0.37."""
        import numpy
        y, x = numpy.meshgrid(*2 * [numpy.arange(SIDE, dtype=numpy.float32)], indexing="ij")
        return [(axis + numpy.float32(add)) * numpy.float32(0.37) for axis, add in zip((x, y, 0 * x), OFFSET)]

    def test_each_group_renders_the_bits_of_the_package(self) -> None:
        import hashnoise
        import numpy
        at = self.rendered_points()
        for form in files.FORMS:
            name, size = re.fullmatch(r"(\w+)(\d)", files.shader(form)).groups()
            with self.subTest(form):
                expected = getattr(hashnoise, name)(*at[:int(size)], seed=7, arithmetic="fixed")
                expected = expected.reshape(-1, SIDE, SIDE)
                if name == "warp":  # to be added to Vector
                    expected = expected / numpy.float32(0.37)
                got = self.heights.rendered(files.shader(form), SIDE, OFFSET, self.root, Scale=0.37, Seed=7)
                self.assertTrue((got[:len(expected)] == expected).all(), abs(got[:len(expected)] - expected).max())
                self.assertGreater(expected.std(), 0.01)
        other = self.heights.rendered("perlin2", SIDE, OFFSET, self.root, Scale=0.37, Seed=8)
        self.assertLess((other[0] == hashnoise.perlin(*at[:2], seed=7, arithmetic="fixed")).mean(), 0.5)

    def test_a_group_of_cells_has_the_jitter_of_its_socket(self) -> None:
        import hashnoise
        at = self.rendered_points()
        for name, size in itertools.product(("cellular", "cell_border"), (2, 3)):
            with self.subTest(name, size=size):
                function, settings = getattr(hashnoise, name), {"seed": 7, "arithmetic": "fixed"}
                expected = function(*at[:size], jitter=0.25, **settings).reshape(-1, SIDE, SIDE)
                got = self.heights.rendered(f"{name}{size}", SIDE, OFFSET, self.root, Scale=0.37, Jitter=0.25, Seed=7)
                self.assertTrue((got[:len(expected)] == expected).all(), abs(got[:len(expected)] - expected).max())
                usual = function(*at[:size], **settings).reshape(-1, SIDE, SIDE)
                self.assertLess((expected == usual).mean(), 0.5)

    def test_a_displacement_by_a_scale_of_0_is_0(self) -> None:
        got = self.heights.rendered("warp2", SIDE, OFFSET, self.root, Scale=0.0, Seed=7)
        self.assertEqual([got.min(), got.max()], [0, 0])

    def test_a_group_is_made_once_and_put_at_the_coordinates_of_the_object(self) -> None:
        import bpy
        self.heights.select([(0, 0, 0)])
        material = self.heights.new_material()
        self.scene.cycles.shading_system = False
        for _ in range(2):
            bpy.ops.node.hashnoise_add(shader="simplex3")
        first, second = (node for node in material.node_tree.nodes if node.type == "GROUP")
        self.assertEqual(first.node_tree, second.node_tree)
        self.assertEqual(first.node_tree.name, "hashnoise Simplex 3D")
        self.assertEqual(first.inputs["Vector"].links[0].from_socket.name, "Object")
        self.assertTrue(self.scene.cycles.shading_system)
        bpy.ops.node.hashnoise_add(shader="cell_border3")
        *_, border = (node for node in material.node_tree.nodes if node.type == "GROUP")
        self.assertEqual(border.node_tree.name, "hashnoise Cell Border 3D")
        self.assertEqual([one.name for one in border.inputs], ["Vector", "Scale", "Jitter", "Seed"])
        self.assertEqual(border.inputs["Jitter"].default_value, 1.0)

    def test_what_is_wrong_with_a_group_is_told_and_nothing_is_left(self) -> None:
        import bpy
        self.heights.select([(0, 0, 0)])
        add = bpy.ops.node.hashnoise_add
        self.refused(add, "There is no material with nodes", shader="fbm2")
        material = self.heights.new_material()
        before = [len(bpy.data.texts), len(bpy.data.node_groups), len(material.node_tree.nodes)]
        self.scene.render.engine = "BLENDER_WORKBENCH"
        self.refused(add, "need Cycles", shader="fbm2")
        self.scene.render.engine = "CYCLES"
        (self.root / "random2.osl").write_text("shader wrong(output float value = 0) { value = no_such(); }\n")
        with mock.patch.object(self.add_on.shaders, "FOLDER", self.root):
            self.refused(add, "Cycles does not compile random2.osl", shader="random2")
        self.assertEqual([len(bpy.data.texts), len(bpy.data.node_groups), len(material.node_tree.nodes)], before)
        library = str(self.root / "materials.blend")
        bpy.data.libraries.write(library, {material})
        with bpy.data.libraries.load(library, link=True) as (_, here):
            here.materials = [material.name]
        linked = bpy.context.object.material_slots[0].material = here.materials[0]
        self.refused(add, "are linked from another file", shader="fbm2")
        self.assertEqual(len(linked.node_tree.nodes), before[-1])

    def add(self, shader: str):
        """The node of a group in a new material."""
        import bpy
        self.heights.select([(0, 0, 0)])
        tree = self.heights.new_material().node_tree
        bpy.ops.node.hashnoise_add(shader=shader)
        return tree.nodes.active

    def test_a_group_is_taken_from_the_file_only_as_it_was_made(self) -> None:
        import bpy
        first = self.add("ridged2").node_tree
        script, = (node for node in first.nodes if node.type == "SCRIPT")
        self.assertEqual(self.add("ridged2").node_tree, first)
        written = script.script.as_string()
        version = written.replace(f"// Of hashnoise {files.version()}", "// Of hashnoise 9.9.9", 1)
        self.assertNotEqual(version, written)
        script.script.from_string(version)
        self.assertEqual(self.add("ridged2").node_tree, first)
        texts = len(bpy.data.texts)

        def changed(change, undo) -> None:
            change()
            other = self.add("ridged2").node_tree
            self.assertNotEqual(other, first)
            bpy.data.texts.remove(next(node.script for node in other.nodes if node.type == "SCRIPT"))
            bpy.data.node_groups.remove(other)
            undo()
            self.assertEqual(self.add("ridged2").node_tree, first)
        sockets = first.interface
        for change, undo in (
                (lambda: script.script.from_string(f"{written}int more() {{ return 1; }}\n"),
                 lambda: script.script.from_string(written)),
                (lambda: first.__delitem__("hashnoise"), lambda: first.__setitem__("hashnoise", "ridged2")),
                (lambda: setattr(first, "name", "A rock"), lambda: setattr(first, "name", "hashnoise Ridged 2D")),
                (lambda: first.nodes.new("ShaderNodeMath"), lambda: first.nodes.remove(first.nodes[-1])),
                (lambda: sockets.new_socket("More", in_out="INPUT", socket_type="NodeSocketFloat"),
                 lambda: sockets.remove(sockets.items_tree["More"]))):
            changed(change, undo)
        self.assertEqual(len(bpy.data.texts), texts)

    def test_a_regrouped_script_is_no_group_of_the_add_on(self) -> None:
        import bpy
        made = self.add("billow2").node_tree
        rock = bpy.data.node_groups.new("A rock", "ShaderNodeTree")  # sorted before
        script = rock.nodes.new("ShaderNodeScript")
        script.script = next(node.script for node in made.nodes if node.type == "SCRIPT")
        self.assertEqual(self.add("billow2").node_tree, made)

    def test_a_group_is_never_put_into_itself(self) -> None:
        import bpy
        first = self.add("turbulence2").node_tree
        material = bpy.context.object.active_material
        with mock.patch.object(self.add_on.nodes, "edited", return_value=first):
            for _ in range(2):
                bpy.ops.node.hashnoise_add(shader="turbulence2")
        inner = [node.node_tree for node in first.nodes if node.type == "GROUP"]
        self.assertEqual([tree.name for tree in inner], 2 * ["hashnoise Turbulence 2D.001"])
        with mock.patch.object(self.add_on.nodes, "edited", return_value=inner[0]):
            bpy.ops.node.hashnoise_add(shader="turbulence2")
        self.assertEqual(inner[0].nodes.active.node_tree.name, "hashnoise Turbulence 2D.002")
        self.assertEqual(material.node_tree.nodes.active.node_tree, first)

    def test_a_new_node_is_the_active_one_and_stands_alone(self) -> None:
        import bpy
        self.add("perlin2")
        tree = bpy.context.object.active_material.node_tree
        bpy.ops.node.hashnoise_add(shader="perlin2")
        active = tree.nodes.active
        beside = active.inputs["Vector"].links[0].from_node
        self.assertEqual({node for node in tree.nodes if node.select}, {active, beside})
        places = [tuple(node.location) for node in tree.nodes]
        self.assertEqual(len(set(places)), len(places))
        self.assertLess(active.location.x, min(node.location.x for node in tree.nodes if node not in (active, beside)))
        cursor = mock.Mock(type="NODE_EDITOR", cursor_location=(30.0, 40.0))
        context = mock.Mock(space_data=cursor)
        for y in (40.0, 40.0 - self.add_on.nodes.STEP):
            place = self.add_on.nodes.free_place(tree, context)
            self.assertEqual(place, (30.0, y))
            tree.nodes.new("ShaderNodeMath").location = place

    def test_sockets_have_the_ranges_and_the_texts_of_the_catalog(self) -> None:
        import bpy
        node = self.add("cellular3")
        self.assertEqual([one.name for one in node.outputs], ["F1", "F2"])
        self.assertEqual({one.type for one in node.outputs}, {"VALUE"})
        of = {one.name: one for one in node.node_tree.interface.items_tree}
        self.assertEqual([of["Jitter"].min_value, of["Jitter"].max_value], [0, 1])
        self.assertEqual([of["Metric"].min_value, of["Metric"].max_value], [1, 5])
        self.assertIn("4 chebyshev", of["Metric"].description)
        of = {one.name: one for one in self.add("fbm3").node_tree.interface.items_tree}
        self.assertEqual([(of[name].min_value, of[name].max_value) for name in ("Octaves", "Lacunarity", "Gain")],
                         [(1, 32), (0, 255), (0, 1)])
        self.assertEqual([of[name].default_value for name in ("Octaves", "Lacunarity", "Gain")], [6, 2, 0.5])
        self.assertEqual([name for name, one in of.items() if one.in_out == "INPUT" and not one.description], [])
        self.assertLess(of["Seed"].min_value, -2**30)
        operator = bpy.ops.object.hashnoise_displace.get_rna_type().properties
        self.assertEqual([(operator[name].hard_min, operator[name].hard_max)
                          for name in ("octaves", "lacunarity", "gain")], [(1, 32), (0, 255), (0, 1)])

    def test_outputs_are_those_of_the_page(self) -> None:
        kinds = {"float": "VALUE", "vec2": "VECTOR", "vec3": "VECTOR"}
        for form in files.FORMS:
            found = {one.name: one.type for one in self.add(files.shader(form)).outputs}
            self.assertEqual(found, {name: kinds[of] for name, of in files.outputs(form).items()}, form)

    def test_integers_have_no_derivatives_but_blenders_bump_works(self) -> None:
        """As the pages state, with the slopes that they name in place of Dx()."""
        import bpy
        import numpy

        from translate.pick.osl import without_shader
        from translate.pick.osl_render import pixels, render

        def derivative(form: str, arithmetic: str, lines: str):
            functions = without_shader(files.picker()((form,), files.Choice("osl", arithmetic)))
            (self.root / "dx.osl").write_text(
                f"{functions}shader dx(output color shown = 0) {{\n  point p = 0.37 * P + 0.2;\n  {lines}\n"
                "  shown = color(max(d, 0), max(-d, 0), 0);\n}\n")
            render(self.scene, self.root / "dx.osl", SIDE, SIDE)
            found = numpy.frombuffer((self.root / "dx.pixels").read_bytes(), numpy.float32).reshape(-1, 4)
            return found[:, 0] - found[:, 1]
        integers, floats = (derivative("hn_perlin2", arithmetic, "float d = Dx(hn_perlin2(p[0], p[1], 7));")
                            for arithmetic in ("fixed", "fast"))
        slopes = derivative("hn_perlin_d2", "fixed", "hn_vec3 n = hn_perlin_d2(p[0], p[1], 7);\n"
                            "  float d = n.y * Dx(p[0]) + n.z * Dx(p[1]);")
        self.assertEqual([integers.min(), integers.max()], [0, 0])
        self.assertGreater(floats.std(), 0.1)
        self.assertLess(abs(slopes - floats).max(), 1e-4)
        square = self.scene.objects["square"]
        tree = square.data.materials[0].node_tree
        bpy.context.view_layer.objects.active = square
        bpy.ops.node.hashnoise_add(shader="perlin2")
        bump = tree.nodes.new("ShaderNodeBump")
        bump.inputs["Distance"].default_value = 1.0
        tree.links.new(tree.nodes.active.outputs["Value"], bump.inputs["Height"])
        shown = numpy.array(pixels(self.scene, bump.outputs["Normal"], self.root / "bump.exr", SIDE, SIDE))
        self.assertGreater(shown.reshape(-1, 4)[:, 0].std(), 0.05)

    def test_a_negative_seed_is_a_word(self) -> None:
        import hashnoise
        height, = self.heights.displaced([(0.3, 0.2, 0.0)], scale=1.0, strength=1.0, seed=-1)
        self.assertEqual(height, hashnoise.fbm(0.3, 0.2, seed=2**32 - 1, arithmetic="fixed"))
        got = self.heights.rendered("perlin2", SIDE, OFFSET, self.root, Scale=0.37, Seed=-1)
        at = self.rendered_points()
        self.assertTrue((got[0] == hashnoise.perlin(*at[:2], seed=2**32 - 1, arithmetic="fixed")).all())

    # The page.

    def test_its_lines_of_python_run(self) -> None:
        import bpy
        self.heights.select([(0.3, 0.2, 0.0)])
        material = self.heights.new_material()
        mesh = bpy.context.object.data
        for lines in re.findall(r"```python\n(.*?)```", (files.PACKAGE / "README.md").read_text(), re.DOTALL):
            exec(lines, {"bpy": bpy})
        groups = [node.node_tree.name for node in material.node_tree.nodes if node.type == "GROUP"]
        self.assertEqual(groups, ["hashnoise fBm 2D"])
        self.assertNotEqual(mesh.vertices[0].co.z, 0.0)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as user:
        with skipped_without(NoBlender):
            AddOn.environment = Path(sys.argv.pop(1))
            found(AddOn.environment, Path(user))
        unittest.main(defaultTest="AddOn", verbosity=2)
