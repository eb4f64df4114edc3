"""Blender reads our GLB:  blender -b --factory-startup -P blender_glb.py -- RAMURE_CLI FOLDER

Of each tree: as many triangles as we say, the same height, a material with its pictures; of a clip: an armature whose
tree moves to where it stands in a file of that moment.
"""
import json
import subprocess
import sys
from pathlib import Path

import bpy
import numpy

numpy.bool = bool  # its importer of 3.4 still asks for it, the NumPy of Debian 12 has it no more

cli, folder = sys.argv[sys.argv.index("--") + 1:]
folder = Path(folder)
folder.mkdir(parents=True, exist_ok=True)
findings = []


def find(condition, text):
    if not condition:
        findings.append(text)


def ramure(*words):
    return subprocess.run([cli, *words], check=True, capture_output=True, text=True).stdout


def opened(name, source, *options):
    path = folder / name
    ramure("export", source, "-o", str(path), *options)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(path))
    return [thing for thing in bpy.data.objects if thing.type == "MESH"]


def points(thing):
    """In the world, as the armature has them."""
    graph = bpy.context.evaluated_depsgraph_get()
    mesh = thing.evaluated_get(graph).to_mesh()
    return [thing.matrix_world @ vertex.co for vertex in mesh.vertices]


def branches(things):
    return next(thing for thing in things if thing.data.name.startswith("branches"))


def height(places):
    return max(place.z for place in places) - min(place.z for place in places)  # Blender's Z is our Y


def height_in_obj(name):
    path = folder / (name + ".obj")
    ramure("export", "preset:" + name, "-o", str(path), "--part", "branches", "--map-size", "0")
    up = [float(line.split()[2]) for line in path.read_text().splitlines() if line.startswith("v ")]
    return max(up) - min(up)


def trees():
    names = ["SmallTree", "SilverBirch1995", "ScotsPine1995"]
    for name in names:
        things = opened(name + ".glb", "preset:" + name, "--map-size", "64", "--part", "branches")
        bark = branches(things)
        said = json.loads(ramure("validate", "preset:" + name, "--json"))
        find(len(bark.data.polygons) == said["faces"], f"{name}: {len(bark.data.polygons)} triangles, {said['faces']} said")
        tall = height_in_obj(name)
        find(abs(height(points(bark)) - tall) < 1e-5 * tall, f"{name}: another height")
        nodes = bark.data.materials[0].node_tree.nodes
        pictures = [node.image for node in nodes if node.type == "TEX_IMAGE"]
        find(len(pictures) >= 3 and all(picture.size[0] == 64 for picture in pictures), f"{name}: {len(pictures)} pictures")
    return len(names)


def clip():
    options = ["--set", "skin.method=linear", "--map-size", "0", "--part", "branches"]
    still = points(branches(opened("still.glb", "preset:TinyTree", "--time", "0.5", *options)))
    tall = height(still)
    bark = branches(opened("clip.glb", "preset:TinyTree", "--frames", "0:24", "--fps", "24", "--joints", "all", *options))
    bpy.context.scene.render.fps = 24
    bpy.context.scene.frame_set(12)
    moved = points(bark)
    find(len(moved) == len(still), "the clip has other vertices")
    off = max((a - b).length for a, b in zip(moved, still)) / tall
    find(off < 1e-4, f"the clip is {off:.1e} of the height off")
    return off


def fbx():
    """The FBX that Blender makes of a GLB moves as that does."""
    options = ["--frames", "0:24", "--fps", "24", "--joints", "64", "--set", "skin.method=linear", "--map-size", "64", "--part",
               "branches"]
    frames = (0, 6, 12, 18, 24)

    def poses(things, first):
        out = []
        for frame in frames:
            bpy.context.scene.frame_set(first + frame)
            out.append(points(branches(things)))
        return out
    played = poses(opened("same.glb", "preset:TinyTree", *options), 0)
    path = folder / "clip.fbx"
    ramure("export", "preset:TinyTree", "-o", str(path), *options)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.fbx(filepath=str(path))
    things = [thing for thing in bpy.data.objects if thing.type == "MESH"]
    action = max(bpy.data.actions, key=lambda one: one.frame_range[1] - one.frame_range[0])
    first, last = action.frame_range
    find(abs(last - first - 24.0) < 1e-3, f"the clip of the FBX has {last - first} frames")
    find(len(branches(things).data.materials) == 1 and any(image.size[0] == 64 for image in bpy.data.images), "no picture in the FBX")
    tall = height(played[0])
    again = poses(things, int(round(first)))
    find(len(again[0]) == len(played[0]), "the FBX has other vertices")
    miss = max((a - b).length for one, other in zip(played, again) for a, b in zip(one, other)) / tall
    find(miss < 1e-4, f"the FBX is {miss:.1e} of the height off")
    return miss


count, off, apart = trees(), clip(), fbx()
print(f"blender {bpy.app.version_string}: {count + 4} files, triangles, heights and pictures as said, a clip within "
      f"{off:.1e} of the height, its FBX within {apart:.1e}" + (f"; FOUND: {'; '.join(findings)}" if findings else ""))
sys.exit(1 if findings else 0)
