# Puts the instances of a list where it says, and compares them with the mesh that holds them all; then says
# which colours the vertices of a .ply have.
# blender -b --factory-startup --python blender_instances.py -- LIST.json MERGED.obj COLOURS.ply OUT.json
import json
import os
import sys

import bpy
from mathutils import Matrix

listed, merged, colours, target = sys.argv[sys.argv.index("--") + 1:]


def read_obj(path):
    bpy.ops.wm.obj_import(filepath=path, forward_axis="Y", up_axis="Z")
    return {o.name: o.data for o in bpy.context.selected_objects}


whole = read_obj(merged)
with open(listed, encoding="utf-8") as file:
    objects = json.load(file)["objects"]
said = {"instances": 0, "vertices": 0, "farthest": 0.0, "missing": 0, "size": 0.0}
for entry in objects:
    shape = list(read_obj(os.path.join(os.path.dirname(listed), entry["mesh"])).values())[0]
    mesh = whole[entry["object"]]
    at = 0
    for instance in entry["instances"]:
        m = instance["matrix"]
        place = Matrix((m[0:4], m[4:8], m[8:12], (0, 0, 0, 1)))
        for vertex in shape.vertices:
            if at < len(mesh.vertices):
                there = mesh.vertices[at].co
                said["farthest"] = max(said["farthest"], (place @ vertex.co - there).length)
                said["size"] = max(said["size"], there.length)
            at += 1
        said["instances"] += 1
    said["vertices"] += at
    said["missing"] += abs(len(mesh.vertices) - at)
bpy.ops.import_mesh.ply(filepath=colours)
mesh = bpy.context.selected_objects[0].data
corners = mesh.vertex_colors[0].data
said["colours"] = sorted({tuple(round(255 * c) for c in corner.color[:3]) for corner in corners})
with open(target, "w", encoding="utf-8") as out:
    json.dump(said, out)
