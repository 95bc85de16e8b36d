"""The add-on in Blender, for tests: PyPI's bpy, in this process."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path

from base.debian import Missing
from base.pypi import installed
from translate.pick.osl_runner import PACKAGE


class NoBlender(Exception):
    """Why there is none here, or no package."""


def found(environment: Path, user: Path) -> None:
    """Puts bpy and the Python package of a folder of python.wheel onto the path, with the NumPy that bpy comes with.
    Blender's user files go into a folder."""
    os.environ["BLENDER_USER_RESOURCES"] = str(user)
    packages = list(environment.glob("venv/lib/python*/site-packages/hashnoise"))
    if not packages:
        raise NoBlender(f"{environment} has no Python package: python.wheel was skipped, or did not run")
    try:
        sys.path.insert(0, str(installed(PACKAGE)))
        import bpy  # noqa: F401
        sys.path.append(str(packages[0].parent))
        import hashnoise  # noqa: F401
    except (Missing, ImportError) as reason:
        raise NoBlender(str(reason)) from reason


class Heights:
    """Blender with the add-on of a zip file, which is installed as a user does."""

    def __init__(self, file: Path) -> None:
        import bpy

        from translate.pick.osl_render import prepared
        self.scene = prepared()
        bpy.ops.extensions.package_install_files(filepath=str(file), repo="user_default", enable_on_install=True)

    @staticmethod
    def extensions_program() -> Path:
        import bpy
        return Path(bpy.utils.system_resource("SCRIPTS"), "addons_core", "bl_pkg", "cli", "blender_ext.py")

    @staticmethod
    def random_points(count: int):
        """Rows x, y and z of float32, from near the origin to far from it, where z is 0: so the operator
        moves a point to its height."""
        import numpy
        of = numpy.random.default_rng(35)
        spans = 2.0 ** (numpy.arange(count) % 16)
        points = (of.uniform(-1, 1, (count, 3)) * spans[:, numpy.newaxis]).astype(numpy.float32)
        points[:, 2] = 0
        return points

    def select(self, points: Sequence | None) -> None:
        """Makes a mesh of points, and its object the active one; or none is active."""
        import bpy
        layer = bpy.context.view_layer
        layer.objects.active = None
        if points is not None:
            mesh = bpy.data.meshes.new("points")
            mesh.from_pydata(points, [], [])
            made = bpy.data.objects.new("points", mesh)
            bpy.context.scene.collection.objects.link(made)
            layer.objects.active = made

    @staticmethod
    def new_material():
        """One with nodes, of the active object."""
        import bpy
        material = bpy.data.materials.new("plain")
        material.use_nodes = True
        bpy.context.object.data.materials.append(material)
        return material

    def displaced(self, points, **settings):
        """How high the operator moves points, in float32."""
        import bpy
        import numpy
        self.select(points)
        bpy.ops.object.hashnoise_displace(**settings)
        vertices = bpy.context.object.data.vertices
        moved = numpy.empty(3 * len(vertices), numpy.float32)
        vertices.foreach_get("co", moved)
        return moved.reshape(-1, 3)[:, 2]

    def rendered(self, shader: str, side: int, offset: Sequence[float], folder: Path, **inputs):
        """A group's values in each pixel of a square, three numbers in order, at the pixel's number plus an offset,
        those of a vector, or of one output after the other. A color is not negative, so there are two pictures."""
        import bpy
        import numpy

        from translate.pick.osl_render import pixels
        square = self.scene.objects["square"]
        bpy.context.view_layer.objects.active = square
        tree = square.data.materials[0].node_tree
        before = set(tree.nodes)
        bpy.ops.node.hashnoise_add(shader=shader)
        group, = (node for node in tree.nodes if node.type == "GROUP" and node not in before)
        at = tree.nodes.new("ShaderNodeNewGeometry").outputs["Position"]
        for operation, other in (("MULTIPLY", (1, 1, 0)), ("FLOOR", ()), ("ADD", offset)):
            at = self._vector(tree, operation, at, other)
        tree.links.new(at, group.inputs["Vector"])
        for name, value in inputs.items():
            group.inputs[name].default_value = value
        result, *others = group.outputs
        if others:
            made = tree.nodes.new("ShaderNodeCombineXYZ")
            for one, part in zip(group.outputs, made.inputs):
                tree.links.new(one, part)
            result = made.outputs[0]
        parts = []
        for sign in (1, -1):
            signed = self._vector(tree, "MULTIPLY", result, (sign, sign, sign))
            shown = self._vector(tree, "MAXIMUM", signed, (0, 0, 0))
            found = numpy.array(pixels(self.scene, shown, folder / "group.exr", side, side), numpy.float32)
            parts.append(found.reshape(side, side, 4)[:, :, :3])
        for node in set(tree.nodes) - before:
            tree.nodes.remove(node)
        return numpy.moveaxis(parts[0] - parts[1], 2, 0)

    @staticmethod
    def _vector(tree, operation: str, first, second: Sequence[float]):
        node = tree.nodes.new("ShaderNodeVectorMath")
        node.operation = operation
        tree.links.new(first, node.inputs[0])
        if second:
            node.inputs[1].default_value = second
        return node.outputs["Vector"]
