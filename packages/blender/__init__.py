"""Noise of hashnoise in Blender: node groups for Cycles with Open Shading Language, and an operator that displaces the
vertices of a mesh. Both compute in integers, so they have the same heights at the same positions."""

import bpy

from . import displace, nodes

CLASSES = (*displace.CLASSES, *nodes.CLASSES)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    for menu, draw in (*displace.MENUS, *nodes.MENUS):
        getattr(bpy.types, menu).append(draw)


def unregister():
    for menu, draw in (*displace.MENUS, *nodes.MENUS):
        getattr(bpy.types, menu).remove(draw)
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
