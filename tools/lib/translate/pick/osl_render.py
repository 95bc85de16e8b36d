"""Renders shaders of OSL by Blender's Cycles, pixel by pixel: python3 osl_render.py FOLDER, where bpy can be imported.

FOLDER/jobs.json has a list of {"shader": FILE, "width": N, "height": N, "node": FILE}. A shader has an output `shown`,
a color, and sees a pixel as P: the first is at 0.5, 0.5. For each it writes FILE.pixels, four floats a pixel. `node` is
a shader that is compiled, and must have outputs; it may be left out. Exit status: 0 done, 1 not.
"""

from __future__ import annotations

import json
import sys
from array import array
from pathlib import Path

import bpy

# Where Blender's own Python has the header that Cycles needs for a shader.
sys.path += map(str, Path(bpy.utils.resource_path("LOCAL")).glob("python/lib/python*/site-packages"))


def prepared() -> bpy.types.Scene:
    """A square of 1 by 1 that shines as its shader computes, and nothing that changes a value on its way."""
    import addon_utils

    addon_utils.enable("cycles")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.shading_system = True
    scene.cycles.samples = 1
    scene.cycles.use_adaptive_sampling = scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 0
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 0.01
    scene.cycles.sample_clamp_direct = scene.cycles.sample_clamp_indirect = 0
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.color_depth = "32"
    scene.view_settings.view_transform = "Raw"
    scene.render.dither_intensity = 0
    mesh = bpy.data.meshes.new("square")
    mesh.from_pydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [], [(0, 1, 2, 3)])
    square = bpy.data.objects.new("square", mesh)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type = "ORTHO"
    for one in (square, camera):
        scene.collection.objects.link(one)
    scene.camera = camera
    material = bpy.data.materials.new("shader")
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    emission, output = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
    material.node_tree.links.new(emission.outputs[0], output.inputs[0])
    mesh.materials.append(material)
    return scene


def compiled(tree: bpy.types.NodeTree, shader: Path) -> bpy.types.Node:
    """A shader as a node. It is a new one, since a node keeps its old one if a shader is not compiled."""
    script = tree.nodes.new("ShaderNodeScript")
    script.mode = "EXTERNAL"
    script.filepath = str(shader)
    if not script.outputs:
        raise RuntimeError(f"{shader} is not compiled")
    return script


def pixels(scene: bpy.types.Scene, shown: bpy.types.NodeSocket, file: Path, width: int, height: int) -> array:
    """The color of the square's material, four floats a pixel, from the first row on; an image goes into a file."""
    square, camera = scene.objects["square"], scene.objects["camera"]
    square.scale = (width, height, 1)
    camera.location = (width / 2, height / 2, 1)
    camera.data.ortho_scale = max(width, height)
    scene.render.resolution_x, scene.render.resolution_y = width, height
    tree = square.data.materials[0].node_tree
    tree.links.new(shown, tree.nodes["Emission"].inputs["Color"])
    scene.render.filepath = str(file)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    image.colorspace_settings.name = "Non-Color"
    if tuple(image.size) != (width, height):
        raise RuntimeError(f"{scene.render.filepath} has another size")
    found = array("f", image.pixels[:])
    bpy.data.images.remove(image)
    return found


def render(scene: bpy.types.Scene, shader: Path, width: int, height: int) -> None:
    tree = scene.objects["square"].data.materials[0].node_tree
    script = compiled(tree, shader)
    found = pixels(scene, script.outputs["shown"], shader.with_suffix(".exr"), width, height)
    shader.with_suffix(".pixels").write_bytes(found.tobytes())
    tree.nodes.remove(script)


def main() -> int:
    folder = Path(sys.argv[1])
    scene = prepared()
    tree = scene.objects["square"].data.materials[0].node_tree
    for job in json.loads((folder / "jobs.json").read_text(encoding="utf-8")):
        if "node" in job:
            tree.nodes.remove(compiled(tree, folder / job["node"]))
        render(scene, folder / job["shader"], job["width"], job["height"])
    return 0


if __name__ == "__main__":
    sys.exit(main())
