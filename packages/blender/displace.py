"""The operator that displaces a mesh, by the Python package hashnoise."""

import sys

import bpy
import numpy
from bpy.props import EnumProperty, FloatProperty, IntProperty

from . import shaders

FRACTALS = (("NONE", "None", "The noise itself"),
        ("fbm", "fBm", "Octaves: hills and land"),
        ("ridged", "Ridged", "Octaves with crests, in [0, 1]: mountains"),
        ("billow", "Billow", "Octaves that are round above and creased below"),
        ("turbulence", "Turbulence", "Octaves with creases, in [0, 1]"),
        ("hybrid", "Hybrid", "Octaves that are smooth in valleys and rough on heights"),
        ("clouds", "Clouds", "The density of a sky, in [0, 1]"))
NOISES = (("perlin", "Perlin", "Gradient noise"),
          ("simplex", "Simplex", "Gradient noise without squares"),
          ("value", "Value", "Interpolated random numbers"),
          ("value_cubic", "Cubic Value", "Smoother value noise"),
          ("cellular", "Cellular", "The distance to the nearest of scattered points; no fractal takes it"))
POSITIONS = (("PLANE", "X and Y", "The noise is on the plane, so what stands above a place gets its height, too"),
             ("SPACE", "X, Y and Z", "The noise is in space"))
OF_SETTINGS = shaders.described(shaders.text("fbm2"))
DIRECTIONS = (("Z", "Z", "Up"), ("NORMAL", "Normal", "Along the normal of each vertex"))


def package():
    """The package hashnoise; an ImportError explains how to install it."""
    try:
        import hashnoise
    except ImportError as error:
        raise ImportError(f"Blender's Python cannot load the package hashnoise ({error}). Install its wheel: "
                          f"{sys.executable} -m pip install hashnoise-VERSION-....whl") from error
    return hashnoise


def heights(positions, fractal, noise, octaves, lacunarity, gain, seed):
    """Heights at positions in cells, an array of float32 with a row for each, with the bits of HN_FIXED."""
    of = package()
    axes = numpy.ascontiguousarray(positions.T)
    if fractal != "NONE":
        return getattr(of, fractal)(*axes, noise=noise, octaves=octaves, lacunarity=lacunarity, gain=gain, seed=seed,
                                 arithmetic="fixed")
    values = getattr(of, noise)(*axes, seed=seed, arithmetic="fixed")
    return values[0] if noise == "cellular" else values  # of several distances the first


def read(collection, attribute):
    """A vector of each vertex, as rows of float32."""
    found = numpy.empty(3 * len(collection), numpy.float32)
    collection.foreach_get(attribute, found)
    return found.reshape(-1, 3)


class OBJECT_OT_hashnoise_displace(bpy.types.Operator):
    """Move the vertices of the active mesh by noise of hashnoise"""
    bl_idname = "object.hashnoise_displace"
    bl_label = "Displace by hashnoise"
    bl_options = {"REGISTER", "UNDO"}

    fractal: EnumProperty(name="Fractal", items=FRACTALS, default="fbm")
    noise: EnumProperty(name="Noise", items=NOISES, default="perlin")
    scale: FloatProperty(name="Scale", default=5.0, description="Cells of the noise in a unit of the object")
    strength: FloatProperty(name="Strength", default=0.2, description="How far a height of 1 moves a vertex")
    octaves: IntProperty(name="Octaves", default=6, **OF_SETTINGS["octaves"])
    lacunarity: FloatProperty(name="Lacunarity", default=2.0, **OF_SETTINGS["lacunarity"])
    gain: FloatProperty(name="Gain", default=0.5, **OF_SETTINGS["gain"])
    seed: IntProperty(name="Seed", default=0, **OF_SETTINGS["seed"])
    position: EnumProperty(name="Position", items=POSITIONS, default="PLANE")
    direction: EnumProperty(name="Direction", items=DIRECTIONS, default="Z")

    @classmethod
    def poll(cls, context):
        if context.object is None or context.object.type != "MESH":
            cls.poll_message_set("Select a mesh")
            return False
        if context.object.mode != "OBJECT":
            cls.poll_message_set("Change to Object Mode")
            return False
        return True

    def refused(self, message):
        self.report({"ERROR"}, message)
        return {"CANCELLED"}

    def execute(self, context):
        mesh = context.object.data
        if mesh.library is not None:
            return self.refused(f"The mesh {mesh.name} is linked from another file. Make it local first")
        if mesh.shape_keys:
            return self.refused(f"The mesh {mesh.name} has shape keys, which hold its vertices. Remove them first")
        if self.fractal != "NONE" and self.noise == "cellular":
            others = ", ".join(title for name, title, _ in NOISES if name != self.noise)
            return self.refused(f"No fractal takes cellular noise. Choose another noise ({others}), or no fractal")
        if not mesh.vertices:
            return self.refused(f"The mesh {mesh.name} has no vertices")
        places = read(mesh.vertices, "co")
        at = places[:, :2 if self.position == "PLANE" else 3] * numpy.float32(self.scale)
        try:
            moves = heights(at, self.fractal, self.noise, self.octaves, self.lacunarity, self.gain,
                            self.seed & 0xFFFFFFFF)  # a word. Blender's numbers have a sign
        except (ImportError, TypeError, ValueError) as error:
            return self.refused(str(error))
        moves = moves * numpy.float32(self.strength)
        if self.direction == "NORMAL":
            places += moves[:, numpy.newaxis] * read(mesh.vertex_normals, "vector")
        else:
            places[:, 2] += moves
        mesh.vertices.foreach_set("co", places.ravel())
        mesh.update()
        return {"FINISHED"}


class VIEW3D_PT_hashnoise(bpy.types.Panel):
    bl_label = "hashnoise"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "hashnoise"

    def draw(self, context):
        self.layout.operator(OBJECT_OT_hashnoise_displace.bl_idname, icon="MOD_DISPLACE")


def draw(menu, context):
    menu.layout.operator(OBJECT_OT_hashnoise_displace.bl_idname, icon="MOD_DISPLACE")


CLASSES = (OBJECT_OT_hashnoise_displace, VIEW3D_PT_hashnoise)
MENUS = (("VIEW3D_MT_object", draw),)
