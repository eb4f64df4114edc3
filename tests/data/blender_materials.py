# Opens an .obj in Blender and says what its first material is made of.
# blender -b --factory-startup --python blender_materials.py -- FILE.obj OUT.json
import json
import sys

import bpy

source, target = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.obj_import(filepath=source)
material = bpy.context.selected_objects[0].active_material
links = {}
for link in material.node_tree.links:
    said = {"from": link.from_node.type}
    if link.from_node.type == "TEX_IMAGE":
        image = link.from_node.image
        said |= {"size": list(image.size), "hasData": image.has_data or len(image.pixels) > 0,
                 "space": image.colorspace_settings.name,
                 "lowest": list(image.pixels[:3])}
    links[link.to_node.type + " " + link.to_socket.name] = said
with open(target, "w", encoding="utf-8") as out:
    json.dump({"name": material.name, "links": links}, out)
