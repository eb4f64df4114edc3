"""Run by headless Blender before ramure_export.py: makes a scene, and writes what Blender itself says of it.

blender -b --factory-startup --python blender_oracle.py --python ramure_export.py -- FOLDER
"""

import json
import os
import random
import sys

import bpy
from mathutils import Matrix

folder = sys.argv[sys.argv.index("--") + 1]
random.seed(7)
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.frame_start, scene.frame_end, scene.render.fps = 1, 50, 30


def cube(name, parent=None):
    bpy.ops.mesh.primitive_cube_add(size=1)
    made = bpy.context.object
    made.name, made.rotation_mode, made.parent = name, "QUATERNION", parent
    return made


def key(obj, frame):
    obj.location = [random.uniform(-3, 3) for _ in range(3)]
    obj.rotation_quaternion = (1.0, *(random.uniform(-0.5, 0.5) for _ in range(3)))
    obj.rotation_quaternion.normalize()
    obj.scale = [random.uniform(0.5, 2)] * 3
    for path in ("location", "rotation_quaternion", "scale"):
        obj.keyframe_insert(path, frame=frame)


def curves(obj):
    return obj.animation_data.action.fcurves


body = cube("Body")
for frame in (1, 9, 20, 37.5, 50):
    key(body, frame)
arm = cube("Upper arm.001", body)  # blanks and points in names
modes = ("LINEAR", "CONSTANT", "BACK", "BOUNCE", "EXPO", "CUBIC", "SINE")
for frame in (1, 8, 15, 22, 30, 40, 50):
    key(arm, frame)
for curve in curves(arm):
    for point, mode in zip(curve.keyframe_points, modes):
        point.interpolation = mode
spring = cube("Spring", arm)  # must be baked
for frame in (1, 20, 50):
    key(spring, frame)
for curve in curves(spring):
    for point in curve.keyframe_points:
        point.interpolation = "ELASTIC"
swinging = cube("Swinging")  # may stay ELASTIC: along Y it goes further than the amplitude, and nothing turns
for frame, place in ((1, (0, 0, 0)), (20, (0.3, -2, 1)), (50, (3, 4, 5))):
    swinging.location = place
    swinging.keyframe_insert("location", frame=frame)
for curve in curves(swinging):
    for point in curve.keyframe_points:
        point.interpolation = "ELASTIC"
hand = cube("Hand", arm)
hand.location = (0, 1, 2)
bpy.context.view_layer.update()
turned = cube("Kept in place", body)  # its parent's inverse turns
turned.matrix_parent_inverse = Matrix.Rotation(0.7, 4, "X") @ Matrix.Translation((1, 2, 3))
for frame in (1, 25, 50):
    key(turned, frame)
for curve in curves(turned):
    for point in curve.keyframe_points:
        point.interpolation = "LINEAR"
euler = cube("Angles")  # must be baked
euler.rotation_mode = "XYZ"
euler.keyframe_insert("rotation_euler", frame=1)
euler.rotation_euler = (1, 2, 3)
euler.keyframe_insert("rotation_euler", frame=50)
bpy.ops.object.empty_add()
bpy.context.object.name = "Empty"
bpy.context.object.location = (1, 2, 3)
euler.parent = bpy.context.object

# World matrices, Y up.
up = Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))
places = []
for half in range(2, 101, 2):
    frame = half / 2
    scene.frame_set(int(frame))
    graph = bpy.context.evaluated_depsgraph_get()
    entry = {"seconds": frame / 30, "nodes": {}}
    for obj in scene.objects:
        matrix = up @ obj.evaluated_get(graph).matrix_world @ up.inverted()
        entry["nodes"][obj.name] = [matrix[r][c] for r in range(4) for c in range(4)]
    places.append(entry)

# Curves with the handles that Blender gives new keys, distances up to a thousandfold different.
samples = []
action = bpy.data.actions.new("Curves")
for index in range(60):
    curve = action.fcurves.new("location", index=index)
    frame, keys = 0.0, []
    for _ in range(random.randint(2, 12)):
        keys.append((frame, random.uniform(-5, 5) if random.random() < 0.8 or not keys else keys[-1][1]))
        frame += 10 ** random.uniform(-1, 2)
    for at, value in keys:
        point = curve.keyframe_points.insert(at, value)
        point.handle_left_type = point.handle_right_type = "AUTO_CLAMPED"
        point.interpolation = "BEZIER"
    curve.update()
    points = [(p.co.x, p.co.y) for p in curve.keyframe_points]
    times = [points[0][0] + (points[-1][0] - points[0][0]) * i / 200 for i in range(201)]
    samples.append({"keys": points, "samples": [(t, curve.evaluate(t)) for t in times]})
bpy.data.actions.remove(action)
scene.frame_set(1)
os.makedirs(folder, exist_ok=True)
with open(os.path.join(folder, "oracle.json"), "w", encoding="utf-8") as out:
    json.dump({"places": places, "curves": samples}, out)
