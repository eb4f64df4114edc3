"""Trees of programs inside Blender: blender -b --factory-startup -P blender_trees.py -- PROGRAM WHAT SEED FOLDER ply|glb
[SOURCE]. WHAT is the name of a preset. Writes FOLDER/bark.ply and FOLDER/leaves.ply, or FOLDER/tree.glb as Blender's own
exporter has it, and prints one line of JSON: the seconds from the values to the objects."""

import ast
import importlib
import json
import os
import sys
import time

import bpy
import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import mesh_files  # noqa: E402


def sapling(what, seed, _):
    import addon_utils

    addon_utils.enable("add_curve_sapling")
    folder = os.path.join(os.path.dirname(sys.modules["add_curve_sapling"].__file__), "presets")
    with open(os.path.join(folder, what + ".py"), encoding="utf-8") as source:
        values = ast.literal_eval(source.read())
    known = bpy.ops.curve.tree_add.get_rna_type().properties.keys()
    values = {name: value for name, value in values.items() if name in known}
    # Presets save neither of these the same way: a tree with round branches and with its leaves is meant.
    values.update(seed=seed, bevel=True, showLeaves=True, do_update=True, useArm=False)
    return lambda: bpy.ops.curve.tree_add(**values)


def tree_gen(what, seed, source):
    sys.path.insert(0, os.path.dirname(source))
    addon = importlib.import_module(os.path.basename(source))
    addon.register()
    gen = importlib.import_module(addon.__name__ + ".parametric.gen")
    values = importlib.import_module(f"{addon.__name__}.parametric.tree_params.{what}").params
    return lambda: gen.construct(values, seed)


def mesh_of(thing, looked_at):
    """Arrays of an object where it stands: positions, triangles, texture coordinates, normals."""
    mesh = thing.evaluated_get(looked_at).to_mesh()
    mesh.calc_loop_triangles()

    def numbers(rows, name, width, kind):
        out = numpy.empty(len(rows) * width, kind)
        rows.foreach_get(name, out)
        return out.reshape(-1, width)

    matrix = numpy.array(thing.matrix_world)
    positions = numbers(mesh.vertices, "co", 3, "f4") @ matrix[:3, :3].T + matrix[:3, 3]
    triangles = numbers(mesh.loop_triangles, "vertices", 3, "i4")
    uv = None
    if mesh.uv_layers:
        uv = numbers(mesh.uv_layers[0].data, "uv", 2, "f4")[numbers(mesh.loop_triangles, "loops", 3, "i4")]
    normals = numbers(mesh.vertices, "normal", 3, "f4")[triangles]
    return mesh_files.part(positions, triangles.astype(numpy.int64), uv, normals)


def write_plies(folder):
    looked_at = bpy.context.evaluated_depsgraph_get()
    parts = {"bark": [], "leaves": []}
    for thing in bpy.context.scene.objects:
        if thing.type in ("CURVE", "MESH"):
            leafy = mesh_files.LEAF.search(thing.name)
            parts["leaves" if leafy else "bark"].append(mesh_of(thing, looked_at))
    for name, found in parts.items():
        one = mesh_files.joined(found)
        if one is None:
            continue
        normals = numpy.zeros(one.positions.shape)
        normals[one.triangles] = one.normals
        mesh_files.write_ply(os.path.join(folder, name + ".ply"), one.positions, one.triangles, one.uv, normals)


def write_glb(folder):
    numpy.bool = bool  # which the exporter of Debian's Blender asks a NumPy for that has it no longer
    bpy.ops.export_scene.gltf(filepath=os.path.join(folder, "tree.glb"), export_materials="NONE")


if __name__ == "__main__":
    program, what, seed, folder, kind = sys.argv[sys.argv.index("--") + 1 :][:5]
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    grow = {"sapling": sapling, "tree_gen": tree_gen}[program](what, int(seed), sys.argv[-1])
    begun = time.perf_counter()
    grow()
    bpy.context.evaluated_depsgraph_get().update()
    seconds = time.perf_counter() - begun
    (write_glb if kind == "glb" else write_plies)(folder)
    print(json.dumps({"seconds": seconds}))
