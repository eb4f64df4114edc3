"""Trees of Ramure in Blender: a species, a seed and an age become an object that a click grows anew."""

bl_info = {
    "name": "Ramure",
    "author": "The Ramure authors",
    "version": (0, 2, 0),
    "blender": (3, 4, 0),
    "location": "Add > Mesh > Ramure Tree; View3D > Sidebar > Ramure",
    "description": "Grows trees with ramure-cli and keeps what they were grown from",
    "category": "Add Mesh",
}

from . import operators, panels, program, settings  # noqa: E402

MODULES = (program, settings, operators, panels)


def register():
    for module in MODULES:
        module.register()


def unregister():
    for module in reversed(MODULES):
        module.unregister()
