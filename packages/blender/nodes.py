"""Node groups for materials: each holds a script in Open Shading Language, which Cycles compiles."""

import re
from pathlib import Path

import bpy
from bpy.props import EnumProperty

SHADERS = Path(__file__).parent / "shaders"
# Sockets of a group for parameters of a script.
SOCKETS = {"VALUE": "NodeSocketFloat", "INT": "NodeSocketInt", "VECTOR": "NodeSocketVector"}
POSITION = "p"  # of a script
SCALE = 5.0  # cells in a unit, as the operator has it


class NotCompiled(Exception):
    """Why there is no group."""


def label(shader):
    """cell_border2 is Cell Border 2D."""
    words, size = re.fullmatch(r"(\w+?)(\d)", shader).groups()
    return f"{'fBm' if words == 'fbm' else words.replace('_', ' ').title()} {size}D"


def entries():
    return [(path.stem, label(path.stem), "") for path in sorted(SHADERS.glob("*.osl"))]


def group(shader):
    """The group of a shader: the one that the file has, or a new one."""
    name, text = f"hashnoise {label(shader)}", (SHADERS / f"{shader}.osl").read_text(encoding="utf-8")
    for tree in bpy.data.node_groups:
        if any(one.type == "SCRIPT" and one.script and one.script.as_string() == text for one in tree.nodes):
            return tree
    source = bpy.data.texts.new(f"hashnoise {shader}.osl")
    source.from_string(text)
    tree = bpy.data.node_groups.new(name, "ShaderNodeTree")
    script = tree.nodes.new("ShaderNodeScript")
    script.script = source
    if not script.outputs:
        bpy.data.node_groups.remove(tree)
        bpy.data.texts.remove(source)
        raise NotCompiled(f"Cycles does not compile {shader}.osl; see the console")
    connect(tree, script)
    return tree


def connect(tree, script):
    """Gives the group what its script takes, with a scale for the position, and what comes back."""
    taken, given = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    scaled = tree.nodes.new("ShaderNodeVectorMath")
    scaled.operation = "SCALE"
    taken.location, scaled.location, given.location = (-400, 0), (-200, 0), (200, 0)
    for name, kind in (("Vector", "VECTOR"), ("Scale", "VALUE")):
        socket(tree, name, "INPUT", kind)
        tree.links.new(taken.outputs[name], scaled.inputs[name])
    tree.interface.items_tree["Vector"].hide_value = True
    tree.interface.items_tree["Scale"].default_value = SCALE
    for one in script.inputs:
        if one.name == POSITION:
            tree.links.new(scaled.outputs["Vector"], one)
        else:
            title = one.name.title()
            socket(tree, title, "INPUT", one.type).default_value = one.default_value
            tree.links.new(taken.outputs[title], one)
    for one in script.outputs:
        title = one.name.title()
        socket(tree, title, "OUTPUT", one.type)
        tree.links.new(one, given.inputs[title])


def socket(tree, name, in_out, kind):
    return tree.interface.new_socket(name, in_out=in_out, socket_type=SOCKETS[kind])


def edited(context):
    """The shader that the editor shows, or that of the active object's material."""
    space = context.space_data
    if space is not None and space.type == "NODE_EDITOR":
        return space.edit_tree if space.tree_type == "ShaderNodeTree" else None
    material = context.object and context.object.active_material
    return material and material.node_tree


class NODE_OT_hashnoise_add(bpy.types.Operator):
    """Add a node group with noise of hashnoise, at the object's coordinates"""
    bl_idname = "node.hashnoise_add"
    bl_label = "Add Noise of hashnoise"
    bl_options = {"REGISTER", "UNDO"}

    shader: EnumProperty(name="Noise", items=entries())

    def refused(self, message):
        self.report({"ERROR"}, message)
        return {"CANCELLED"}

    def execute(self, context):
        if context.scene.render.engine != "CYCLES":
            return self.refused("Nodes of Open Shading Language need Cycles: choose it in the properties of the render")
        tree = edited(context)
        if tree is None:
            return self.refused("There is no material with nodes: open one in the shader editor, or give the object "
                                "one")
        try:
            made = group(self.shader)
        except NotCompiled as error:
            return self.refused(str(error))
        context.scene.cycles.shading_system = True  # without it Cycles draws scripts black
        place = tree.nodes.new("ShaderNodeTexCoord")
        node = tree.nodes.new("ShaderNodeGroup")
        node.node_tree = made
        place.location, node.location = (-600, 0), (-400, 0)
        tree.links.new(place.outputs["Object"], node.inputs["Vector"])
        return {"FINISHED"}


class NODE_MT_hashnoise(bpy.types.Menu):
    bl_idname = "NODE_MT_hashnoise"
    bl_label = "hashnoise"

    def draw(self, context):
        for shader, title, _ in entries():
            self.layout.operator(NODE_OT_hashnoise_add.bl_idname, text=title).shader = shader


def draw(menu, context):
    if context.space_data.tree_type == "ShaderNodeTree":
        menu.layout.menu(NODE_MT_hashnoise.bl_idname)


CLASSES = (NODE_OT_hashnoise_add, NODE_MT_hashnoise)
MENUS = (("NODE_MT_add", draw),)
