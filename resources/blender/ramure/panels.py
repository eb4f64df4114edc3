"""The settings of a tree in the sidebar of the view."""
import bpy

from .operators import holder_of


class RAMURE_PT_tree(bpy.types.Panel):
    bl_label = "Tree"
    bl_idname = "RAMURE_PT_tree"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Ramure"

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        holder = holder_of(context.active_object)
        state = context.window_manager.ramure_state
        if holder is None:
            layout.label(text="No tree is selected")
            layout.operator("ramure.add", icon="ADD")
            return
        tree = holder.ramure
        column = layout.column()
        column.enabled = not state
        for name in ("species", "seed", "age", "day", "triangles", "leaves", "levels", "wind", "pictures", "more"):
            column.prop(tree, name)
        row = column.row(align=True)
        row.operator("ramure.grow", icon="FILE_REFRESH")
        row.operator("ramure.another", icon="RNA")
        if state:
            layout.label(text=state, icon="TIME")


def register():
    bpy.utils.register_class(RAMURE_PT_tree)


def unregister():
    bpy.utils.unregister_class(RAMURE_PT_tree)
