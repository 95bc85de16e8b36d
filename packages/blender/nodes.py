"""Node groups for materials: each holds a script in Open Shading Language, which Cycles compiles."""

import re

import bpy
from bpy.props import EnumProperty

from . import shaders

# Sockets of a group for parameters of a script.
SOCKETS = {"VALUE": "NodeSocketFloat", "INT": "NodeSocketInt", "VECTOR": "NodeSocketVector"}
POSITION = "p"  # of a script
SCALE = 5.0  # cells in a unit, as the operator has it
# Outputs of noises that have two numbers, as other languages name them.
PAIRS = {"cellular": ("F1", "F2"), "phasor": ("Value", "Quadrature")}
NAMES = {"fbm": "fBm", "phasor": "Gabor"}  # of groups
MARK = "hashnoise"  # the property of a group that has the name of its shader
PLAIN = ("GROUP_INPUT", "GROUP_OUTPUT", "SCRIPT", "VECT_MATH")  # nodes in each group
STEP = 400  # from one node that is added to the next


class NotCompiled(Exception):
    """Why there is no group."""


def label(shader):
    """cell_border2 is Cell Border 2D."""
    words, size = re.fullmatch(r"(\w+?)(\d)", shader).groups()
    return f"{NAMES.get(words, title(words))} {size}D"


def title(name):
    """wave_x is Wave X."""
    return name.replace("_", " ").title()


def pair(shader):
    return PAIRS.get(shader[:-1], ())


def entries():
    return [(name, label(name), "") for name in shaders.names()]


def group(shader, into):
    """The group of a shader: one that the file has and that can be in a tree, or a new one."""
    name, text = f"hashnoise {label(shader)}", shaders.text(shader)
    for tree in bpy.data.node_groups:
        if tree.name.startswith(name) and is_made(tree, shader, text) and not has(tree, into):
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
    tree[MARK] = shader
    connect(tree, shader, script, shaders.described(text))
    return tree


def is_made(tree, shader, text):
    """Whether a group is as it was made, and nobody has changed its nodes, its sockets or its text."""
    if tree.get(MARK) != shader or sorted(one.type for one in tree.nodes) != sorted([*PLAIN, *more_nodes(shader)]):
        return False
    script, = (one for one in tree.nodes if one.type == "SCRIPT")
    found = [(one.name, one.in_out, one.socket_type) for one in tree.interface.items_tree if one.item_type == "SOCKET"]
    wanted = [(name, way, SOCKETS[kind]) for name, way, kind in sockets(shader, script)]
    return (sorted(found) == sorted(wanted) and script.script is not None
            and shaders.code(script.script.as_string()) == shaders.code(text))


def has(tree, other):
    """Whether another tree is this one or in it: then this one cannot be in that."""
    return tree == other or any(one.type == "GROUP" and one.node_tree and has(one.node_tree, other)
                                for one in tree.nodes)


def more_nodes(shader):
    return ["SEPXYZ"] if pair(shader) else ["VECT_MATH"] if shader.startswith("warp") else []


def sockets(shader, script):
    """The name of each socket of a group, its direction, and its kind."""
    inputs = [(title(one.name), one.type) for one in script.inputs if one.name != POSITION]
    outputs = [(one.name.title(), one.type) for one in script.outputs]
    if pair(shader):
        outputs = [(name, "VALUE") for name in pair(shader)]
    return [*((name, "INPUT", kind) for name, kind in (("Vector", "VECTOR"), ("Scale", "VALUE"), *inputs)),
            *((name, "OUTPUT", kind) for name, kind in outputs)]


def connect(tree, shader, script, about):
    """Gives the group what its script takes, with a scale for the position, and what comes back."""
    taken, given = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    scaled = scaling(tree, "SCALE")
    taken.location, scaled.location, given.location = (-400, 0), (-200, 0), (400, 0)
    about = {**about, "vector": {"description": "The position. Link coordinates: one vector has one value"},
             "scale": {"description": "Cells in a unit of Vector"}}
    for name, way, kind in sockets(shader, script):
        made = tree.interface.new_socket(name, in_out=way, socket_type=SOCKETS[kind])
        described = about.get(name.lower().replace(" ", "_"), {}) if way == "INPUT" else {}
        made.description = described.get("description", "")
        made.min_value, made.max_value = described.get("min", made.min_value), described.get("max", made.max_value)
    tree.interface.items_tree["Vector"].hide_value = True
    tree.interface.items_tree["Scale"].default_value = SCALE
    tree.links.new(taken.outputs["Vector"], scaled.inputs["Vector"])
    tree.links.new(taken.outputs["Scale"], scaled.inputs["Scale"])
    for one in script.inputs:
        if one.name == POSITION:
            tree.links.new(scaled.outputs["Vector"], one)
        else:
            tree.interface.items_tree[title(one.name)].default_value = one.default_value
            tree.links.new(taken.outputs[title(one.name)], one)
    results = list(script.outputs)
    if pair(shader):
        parts = tree.nodes.new("ShaderNodeSeparateXYZ")
        parts.location = (200, 0)
        tree.links.new(results[0], parts.inputs[0])
        results = parts.outputs[:len(pair(shader))]
    elif shader.startswith("warp"):  # from cells to units of Vector. By a scale of 0 it is 0
        divided = scaling(tree, "DIVIDE")
        divided.location = (200, 0)
        tree.links.new(results[0], divided.inputs[0])
        tree.links.new(taken.outputs["Scale"], divided.inputs[1])
        results = [divided.outputs["Vector"]]
    for one, socket in zip(results, given.inputs):
        tree.links.new(one, socket)


def scaling(tree, operation):
    made = tree.nodes.new("ShaderNodeVectorMath")
    made.operation = operation
    return made


def in_editor(context):
    return context.space_data is not None and context.space_data.type == "NODE_EDITOR"


def edited(context):
    """The shader that the editor shows, or that of the active object's material."""
    if in_editor(context):
        return context.space_data.edit_tree if context.space_data.tree_type == "ShaderNodeTree" else None
    material = context.object and context.object.active_material
    return material and material.node_tree


def at(node):
    return getattr(node, "location_absolute", node.location)  # the first, which adds frames, is new in Blender 4.4


def free_place(tree, context):
    """For a node: at the cursor of the editor, else on the left of all nodes; and not on another node."""
    if in_editor(context):
        x, y = context.space_data.cursor_location
    else:
        x, y = min((tuple(at(one)) for one in tree.nodes), default=(STEP, 0))
        x -= STEP
    while any(abs(at(one).x - x) < 1 and abs(at(one).y - y) < 1 for one in tree.nodes):
        y -= STEP
    return x, y


class NODE_OT_hashnoise_add(bpy.types.Operator):
    """Add a node group with noise of hashnoise, at the object's coordinates"""
    bl_idname = "node.hashnoise_add"
    bl_label = "Add Noise of hashnoise"
    bl_options = {"REGISTER", "UNDO"}

    shader: EnumProperty(name="Noise", items=entries())

    def invoke(self, context, event):
        if in_editor(context):  # the cursor is where the mouse is, as for Blender's own nodes
            space = context.space_data
            if context.region.type == "WINDOW":
                space.cursor_location_from_region(event.mouse_region_x, event.mouse_region_y)
            elif space.edit_tree is not None:
                space.cursor_location = space.edit_tree.view_center
        return self.execute(context)

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
        if tree.library is not None:  # Blender would forget what is added there
            return self.refused("These nodes are linked from another file. Make the material or the group local first")
        try:
            made = group(self.shader, tree)
        except NotCompiled as error:
            return self.refused(str(error))
        context.scene.cycles.shading_system = True  # without it Cycles draws scripts black
        x, y = free_place(tree, context)
        for one in tree.nodes:
            one.select = False
        place = tree.nodes.new("ShaderNodeTexCoord")
        node = tree.nodes.new("ShaderNodeGroup")
        node.node_tree = made
        place.location, node.location = (x - STEP / 2, y), (x, y)
        place.select = node.select = True  # so that both move together
        tree.nodes.active = node
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
