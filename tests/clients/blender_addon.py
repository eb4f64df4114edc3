"""The add-on in Blender:  blender -b --factory-startup -P blender_addon.py -- RAMURE_CLI ADDON_ZIP FOLDER

It is installed from its zip; a tree grows, is changed, grows again, is saved, opened and grown once more: the same tree. What
is wrong is told, and leaves the tree as it was. One line; 1 where something was found.
"""
import os
import stat
import subprocess
import sys
import time
from pathlib import Path

import bpy
import mathutils

cli, archive, folder = sys.argv[sys.argv.index("--") + 1:]
folder = Path(folder)
folder.mkdir(parents=True, exist_ok=True)
os.environ["RAMURE_CLI"] = cli
findings = []


def find(condition, text):
    if not condition:
        findings.append(text)


def refused(operator, **values):
    """What an operator says that does not do what it was asked."""
    try:
        operator(**values)
    except RuntimeError as error:
        return str(error)
    return ""


def meshes(holder):
    return [thing for thing in holder.children_recursive if thing.type == "MESH"]


def grown(**values):
    holder = bpy.context.active_object
    for name, value in values.items():
        setattr(holder.ramure, name, value)
    bpy.ops.ramure.grow()
    return holder.ramure.grown


bpy.ops.preferences.addon_install(filepath=archive, overwrite=True)
bpy.ops.preferences.addon_enable(module="ramure")
bpy.ops.ramure.add(species="SilverBirch", seed=3, age=12.0)
tree = bpy.context.active_object
first = tree.ramure.grown
find(first and len(meshes(tree)) >= 3, f"a birch has {len(meshes(tree))} meshes")
bark = next(thing for thing in meshes(tree) if thing.name.startswith("branches"))
find(not bark.data.validate(), "the mesh of the bark is not valid")
top = max(vertex.co.z for vertex in bark.data.vertices)
find(3.0 < top < 20.0, f"a birch of twelve years is {top} m high")
find(bark.data.materials[0].node_tree.nodes.get("Image Texture"), "the bark has no picture")
graph = bpy.context.evaluated_depsgraph_get()
leaves = sum(one.is_instance for one in graph.object_instances)
find(leaves > 500, f"{leaves} instances of leaves")
faces = len(bark.data.polygons)
told = folder / "bark.ply"
subprocess.run([cli, "export", "preset:SilverBirch", "--set", "grammar.seed=3", "--set", "growth.age=12", "--part", "branches",
                "-o", str(told)], check=True, capture_output=True)
find(b"element face %d\n" % faces in told.read_bytes()[:2000], f"{faces} triangles are not those of a PLY")

# Instances stand where the leaves of one mesh do.
instanced = [one.matrix_world @ vertex.co for one in graph.object_instances
             if one.is_instance and one.object.name.startswith("leaves") for vertex in one.object.data.vertices]
grown(leaves="MERGED")
one_mesh = next(thing for thing in meshes(tree) if thing.name.startswith("leaves"))
index = mathutils.kdtree.KDTree(len(instanced))
for i, place in enumerate(instanced):
    index.insert(place, i)
index.balance()
apart = max(index.find(one_mesh.matrix_world @ vertex.co)[2] for vertex in one_mesh.data.vertices)
find(apart < 2e-3, f"a leaf stands {apart} m from where its instance does")
find(grown(leaves="INSTANCES") == first, "instances are others now")

# Changed, and back again.
tree.location = (5.0, 6.0, 7.0)
find(grown(seed=4) != first, "another seed is the same tree")
find(grown(seed=3) == first, "the same seed is another tree")
find(tuple(tree.location) == (5.0, 6.0, 7.0), "the tree does not stand where it was put")
find(bpy.ops.ramure.another() == {"FINISHED"} and tree.ramure.seed == 4, "no other seed")
find(grown(seed=3) == first, "the same seed is another tree")
merged = grown(leaves="MERGED")
find(merged != first and len(meshes(tree)) >= 2, "leaves as one mesh")
find(grown(leaves="NONE") and len(meshes(tree)) == 1, "a bare tree has leaves")
grown(leaves="MERGED", levels="8000, 2000")
levels = sorted(one.name for one in bpy.data.collections if "LOD" in one.name)
find(levels == ["SilverBirch LOD0", "SilverBirch LOD1"], f"levels are {levels}")
find(bpy.data.collections["SilverBirch LOD1"].hide_render, "a coarse level is seen beside the fine one")
grown(levels="", wind=1.0, triangles=4000)
find(any(thing.type == "ARMATURE" for thing in tree.children_recursive), "no armature in the wind")
find(bpy.data.actions, "nothing moves in the wind")
grown(wind=0.0, triangles=0, leaves="INSTANCES")
find(tree.ramure.grown == first and not any(thing.type == "ARMATURE" for thing in bpy.data.objects), "what was before is still there")

# Saved, opened, grown again.
file = str(folder / "addon.blend")
bpy.ops.wm.save_as_mainfile(filepath=file)
bpy.ops.wm.open_mainfile(filepath=file)
tree = bpy.context.active_object
find(tree.ramure.grown == first and grown() == first, "after saving and opening the tree is another one")

# What is wrong.
count = len(meshes(tree))
tree.ramure.more = "growth.nothing=3"
find("growth.nothing" in refused(bpy.ops.ramure.grow), "an unknown parameter is not told")
tree.ramure.more = ""
tree.ramure.species = "NoSuchTree"
find("NoSuchTree" in refused(bpy.ops.ramure.grow), "an unknown species is not told")
find(len(meshes(tree)) == count, "after an error the tree has gone")
os.environ["RAMURE_CLI"] = "/nowhere/ramure-cli"
find("/nowhere/ramure-cli" in refused(bpy.ops.ramure.grow), "a missing program is not told")
for name, text, expected in [("old", "echo ramure-cli 0.1.0", "too old"), ("other", "echo something", "not ramure-cli"),
                             ("dying", "kill -9 $$", "dying")]:
    script = folder / name
    script.write_text(f"#!/bin/sh\n{text}\n")
    script.chmod(script.stat().st_mode | stat.S_IXUSR)
    os.environ["RAMURE_CLI"] = str(script)
    find(expected in refused(bpy.ops.ramure.grow), f"{name}: not told")
find(len(meshes(tree)) == count, "after an error the tree has gone")

# Stopped: the program is gone at once. And no step of the work is long.
from ramure import operators, program  # noqa: E402

os.environ["RAMURE_CLI"] = cli
tree.ramure.species, tree.ramure.age = "EnglishOak", 60.0
growing = program.Growing(tree.ramure.words())
begun = time.perf_counter()
growing.end()
find(time.perf_counter() - begun < 2.0 and growing.is_done() and not Path(growing.folder).exists(), "it cannot be stopped")
work = operators.Work(tree)
work.growing.wait()
longest = 0.0
while True:
    begun = time.perf_counter()
    is_done = work.go_on()
    longest = max(longest, time.perf_counter() - begun)
    if is_done:
        break
work.growing.end()
triangles = sum(len(thing.data.polygons) for thing in meshes(tree))
bpy.ops.preferences.addon_disable(module="ramure")
find(not hasattr(bpy.types.Object, "ramure"), "the add-on stays when it is switched off")
print(f"blender {bpy.app.version_string}: add-on, same tree after saving; longest step {1000.0 * longest:.0f} ms of "
      f"{triangles} faces" + (f"; FOUND: {'; '.join(findings)}" if findings else ""))
sys.exit(1 if findings else 0)
