"""Writes the open scene for Ramure: for each object NAME.obj with a line TRANSFORM, and NAME.animation with its keys.

In Blender (3.4 and later, slotted actions too): install as an add-on or run in the text editor, then File > Export >
Ramure. From the command line:

    blender -b scene.blend --python ramure_export.py -- FOLDER [--bake] [--selected] [--frame N]

Keys are written as they are where all channels of an object have theirs at the same times and with the same modes,
and where nothing but these keys moves the object. Otherwise, and with --bake, a key is written for every frame; the
report says for which objects. At the end the script checks itself: it reads its files again, evaluates them, and
prints the largest deviation from Blender's own matrices.

The format: time,MODE,loc.xyz,rot.xyzw,scale.xyz in seconds, Z up; then easing,back,amplitude,period and for each of the
ten channels the handles in.dt,in.dv,out.dt,out.dv. TRANSFORM is row-major and Y up, like the geometry.
"""

import math
import os
import re
import sys

import bpy
from mathutils import Matrix, Quaternion, Vector

bl_info = {
    "name": "Ramure export",
    "author": "Ramure",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "File > Export > Ramure (folder)",
    "description": "Objects as .obj with TRANSFORM, their keys as .animation",
    "category": "Import-Export",
}

# Z up to Y up.
TO_Y_UP = Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))
MODES = ("CONSTANT", "LINEAR", "BEZIER", "SINE", "QUAD", "CUBIC", "QUART", "QUINT", "EXPO", "CIRC", "BACK", "BOUNCE",
         "ELASTIC")
WITH_MESH = ("MESH", "CURVE", "SURFACE", "META", "FONT")
PATHS = (("location", 3), ("rotation_quaternion", 4), ("scale", 3))
# How far Blender's matrices may be from the file's own before the script warns.
TOLERANCE = 1e-4


def file_name(name, used):
    """A name that every file system takes, once."""
    base = re.sub(r'[\x00-\x1f/\\:*?"<>|]', "_", name) or "_"
    if base[0] == ".":
        base = "_" + base
    unique, count = base, 2
    while unique.lower() in used:
        unique, count = "%s %d" % (base, count), count + 1
    used.add(unique.lower())
    return unique


def number(value):
    """The shortest text that reads back as the same number."""
    text = repr(float(value) + 0.0)
    return text[:-2] if text.endswith(".0") else text


def channel_bag(action, slot):
    """The curves of one slot, None where it has none. Releases before 4.5 have no function for it."""
    if slot is None:
        return None
    try:
        from bpy_extras import anim_utils
        return anim_utils.action_get_channelbag_for_slot(action, slot)
    except (ImportError, AttributeError):
        bags = (strip.channelbag(slot) for layer in action.layers for strip in layer.strips)
        return next((bag for bag in bags if bag), None)


def curves_of(obj):
    """The curves of an object's own action, by (path, index); None where more than an action moves it."""
    data = obj.animation_data
    if not data:
        return {}
    if data.nla_tracks and any(not track.mute for track in data.nla_tracks) or data.drivers:
        return None
    action = data.action
    if not action:
        return {}
    curves = getattr(action, "fcurves", None)
    if getattr(action, "is_action_layered", False) or curves is None:
        bag = channel_bag(action, data.action_slot)
        curves = bag.fcurves if bag else ()
    return {(curve.data_path, curve.array_index): curve for curve in curves if not curve.mute}


def basis_place(obj):
    """What stands left of the keys in the object's local matrix: the inverse that parenting stored. None where it
    cannot be put into the keys (shear, or a scale that differs by axis)."""
    inverse = obj.matrix_parent_inverse if obj.parent else Matrix.Identity(4)
    location, rotation, scale = inverse.decompose()
    even = max(abs(scale[i] - scale[0]) for i in range(3)) < 1e-6 * max(1.0, abs(scale[0])) and scale[0] > 0
    back = Matrix.Translation(location) @ rotation.to_matrix().to_4x4() @ Matrix.Scale(scale[0], 4)
    same = max(abs(back[r][c] - inverse[r][c]) for r in range(4) for c in range(4)) < 1e-5
    return (location, rotation, scale[0]) if even and same else None


def same_keys(curves):
    """Do all curves have keys at the same times and with the same modes?"""
    lists = [[(round(k.co.x, 4), k.interpolation, k.easing, k.back, k.amplitude, k.period) for k in c.keyframe_points]
             for c in curves]
    return all(entry == lists[0] for entry in lists)


def plain(curves):
    """Nothing that a line of the file cannot say."""
    return all(not [m for m in c.modifiers if not m.mute] and c.extrapolation == "CONSTANT" and
               c.keyframe_points and not getattr(c, "sampled_points", None) for c in curves)


def elastic_stays(obj, curves):
    """Is ELASTIC the same in the file? Y comes out reversed, and the swing of a change that is smaller than the
    amplitude is another one backwards; turned by a parent, or as part of a rotation, it mixes with other axes. And
    Blender swings where nothing changes at all, which a share of the change cannot say."""
    place = basis_place(obj)
    upright = place is not None and abs(abs(place[1].w) - 1.0) < 1e-6 and abs(place[2] - 1.0) < 1e-6
    for (path, axis), curve in curves.items():
        points = list(curve.keyframe_points)
        for point, after in zip(points, points[1:]):
            change = abs(after.co[1] - point.co[1])
            if point.interpolation != "ELASTIC" or path not in dict(PATHS):
                continue
            turns = path == "rotation_quaternion" or path == "location" and not upright
            if turns or change == 0.0 or (path == "location" and axis == 1 and change <= point.amplitude):
                return False
    return True


def reasons_to_bake(obj, curves):
    if curves is None:
        return "NLA or drivers"
    if any(not constraint.mute for constraint in obj.constraints):
        return "constraints"
    if obj.parent and obj.parent_type != "OBJECT":
        return "parented to a bone or to vertices"
    moving = [curve for (path, _), curve in curves.items() if path in dict(PATHS) or path.startswith("rotation")
              or path.startswith("delta")]
    if any(path.startswith("delta") for path, _ in curves):
        return "delta transforms"
    if any(path.startswith("rotation_euler") or path.startswith("rotation_axis") for path, _ in curves):
        return "rotation by angles, not by quaternions"
    if obj.rotation_mode != "QUATERNION" and any(path == "rotation_quaternion" for path, _ in curves):
        return "quaternion keys that the rotation mode does not use"
    if not elastic_stays(obj, curves):
        return "ELASTIC, which is not the same along a turned axis"
    if not plain(moving):
        return "modifiers, or curves that go on"
    if moving and not same_keys(moving):
        return "channels with different keys"
    if basis_place(obj) is None:
        return "a parent that stretches"
    return ""


def local_matrix(obj, depsgraph):
    """In the space of its parent, as it is drawn."""
    world = obj.evaluated_get(depsgraph).matrix_world
    return obj.parent.evaluated_get(depsgraph).matrix_world.inverted_safe() @ world if obj.parent else world.copy()


class Line:
    """One key: time in seconds, ten values, their handles."""

    def __init__(self, time, mode, values, shape=("AUTO", 1.70158, 0.8, 4.1 / 24.0), handles=None):
        self.time, self.mode, self.values, self.shape, self.handles = time, mode, values, shape, handles

    def text(self):
        cells = [number(self.time), self.mode] + [number(v) for v in self.values]
        if self.handles:
            cells += [self.shape[0]] + [number(v) for v in self.shape[1:]]
            cells += [number(v) for handle in self.handles for v in handle]
        return ",".join(cells) + "\n"


def aligned(quaternion, before):
    return -quaternion if before is not None and quaternion.dot(before) < 0 else quaternion


def ten(location, rotation, scale):
    return [*location, rotation.x, rotation.y, rotation.z, rotation.w, *scale]


def keyed_lines(obj, curves, fps):
    """The keys as they are, what parenting stored put into them."""
    shown = [c for (path, _), c in curves.items() if path in dict(PATHS)]
    place, turn, size = basis_place(obj)
    lines = []
    for index in range(len(shown[0].keyframe_points)):
        point = shown[0].keyframe_points[index]
        channels = {}
        for path, count in PATHS:
            start = getattr(obj, path) if path != "rotation_quaternion" else obj.matrix_basis.to_quaternion()
            for axis in range(count):
                curve = curves.get((path, axis))
                if curve is None:
                    channels[(path, axis)] = (start[axis], (0.0, 0.0), (0.0, 0.0))
                    continue
                key = curve.keyframe_points[index]
                left = ((key.handle_left.x - key.co.x) / fps, key.handle_left.y - key.co.y)
                right = ((key.handle_right.x - key.co.x) / fps, key.handle_right.y - key.co.y)
                channels[(path, axis)] = (key.co.y, left, right)

        def parts(what):
            """The location, rotation and scale part of values or of one side's handles."""
            return [[what(channels[(path, axis)]) for axis in range(count)] for path, count in PATHS]

        loc, rot, scl = parts(lambda c: c[0])
        values = ten(turn @ (Vector(loc) * size) + place, turn @ Quaternion(rot), Vector(scl) * size)
        sides = []
        for side in (1, 2):
            times = parts(lambda c: c[side][0])
            loc_v, rot_v, scl_v = parts(lambda c: c[side][1])
            flat = lambda group: max(group, key=abs) if any(group) else 0.0
            moved = ten(turn @ (Vector(loc_v) * size), turn @ Quaternion(rot_v), Vector(scl_v) * size)
            if turn.angle < 1e-7:  # nothing mixes the channels: each keeps its own time
                spans = [*times[0], times[1][1], times[1][2], times[1][3], times[1][0], *times[2]]
            else:
                spans = [flat(times[0])] * 3 + [flat(times[1])] * 4 + list(times[2])
            sides.append(list(zip(spans, moved)))
        handles = [before + behind for before, behind in zip(*sides)]
        lines.append(Line(point.co.x / fps, point.interpolation if point.interpolation in MODES else "LINEAR", values,
                          (point.easing, point.back, point.amplitude, point.period / fps), handles))
    return lines


def still(matrices):
    first = matrices[0]
    return all(abs(m[r][c] - first[r][c]) < 1e-7 for m in matrices for r in range(4) for c in range(4))


class Export:
    def __init__(self, context, folder, bake=False, selected=False, frame=None):
        self.context, self.scene, self.folder = context, context.scene, folder
        self.bake, self.selected = bake, selected
        self.frame = self.scene.frame_current if frame is None else frame
        self.fps = self.scene.render.fps / self.scene.render.fps_base
        self.report, self.files = [], {}

    def run(self):
        os.makedirs(self.folder, exist_ok=True)
        objects = [o for o in self.scene.objects if not self.selected or o.select_get()]
        used = set()
        self.names = {obj: file_name(obj.name, used) for obj in objects}
        curves = {obj: curves_of(obj) for obj in objects}
        why = {obj: "--bake" if self.bake and curves[obj] != {} else reasons_to_bake(obj, curves[obj])
               for obj in objects}
        sampled = self.sample([obj for obj in objects if why[obj]])
        self.scene.frame_set(self.frame)
        depsgraph = self.context.evaluated_depsgraph_get()
        for obj in objects:
            self.write_mesh(obj, depsgraph)
            keys = {k: c for k, c in (curves[obj] or {}).items() if k[0] in dict(PATHS)}
            if why[obj]:
                lines = self.baked_lines(sampled[obj])
                if lines:
                    self.report.append("%s: a key for every frame (%s)" % (obj.name, why[obj]))
            else:
                lines = keyed_lines(obj, keys, self.fps) if keys else []
            if lines:
                self.write_keys(obj, lines)
        return self.check(objects)

    def sample(self, objects):
        """Local matrices of all frames."""
        out = {obj: [] for obj in objects}
        if not objects:
            return out
        for frame in range(self.scene.frame_start, self.scene.frame_end + 1):
            self.scene.frame_set(frame)
            depsgraph = self.context.evaluated_depsgraph_get()
            for obj in objects:
                out[obj].append(local_matrix(obj, depsgraph))
        return out

    def baked_lines(self, matrices):
        if not matrices or still(matrices):
            return []
        lines, before = [], None
        for index, matrix in enumerate(matrices):
            location, rotation, scale = matrix.decompose()
            before = rotation = aligned(rotation, before)
            lines.append(Line((self.scene.frame_start + index) / self.fps, "LINEAR", ten(location, rotation, scale)))
        return lines

    def parent_line(self, obj):
        return "# parent=%s\n" % self.names[obj.parent] if obj.parent in self.names else ""

    def write_mesh(self, obj, depsgraph):
        with open(os.path.join(self.folder, self.names[obj] + ".obj"), "w", encoding="utf-8", newline="\n") as out:
            out.write("# Ramure export from Blender %s\n" % bpy.app.version_string)
            out.write(self.parent_line(obj))
            out.write("o %s\n" % self.names[obj])
            evaluated = obj.evaluated_get(depsgraph)
            mesh = evaluated.to_mesh() if obj.type in WITH_MESH else None
            if mesh:
                for vertex in mesh.vertices:
                    p = vertex.co
                    out.write("v %s %s %s\n" % (number(p.x), number(p.z), number(-p.y)))
                for vertex in mesh.vertices:
                    n = vertex.normal
                    out.write("vn %s %s %s\n" % (number(n.x), number(n.z), number(-n.y)))
                for polygon in mesh.polygons:
                    out.write("f " + " ".join("%d//%d" % (v + 1, v + 1) for v in polygon.vertices) + "\n")
                evaluated.to_mesh_clear()
            matrix = TO_Y_UP @ local_matrix(obj, depsgraph) @ TO_Y_UP.inverted()
            rows = [number(matrix[r][c]) for r in range(3) for c in range(4)] + ["0", "0", "0", "1"]
            out.write("\nTRANSFORM " + " ".join(rows) + "\n")

    def write_keys(self, obj, lines):
        path = os.path.join(self.folder, self.names[obj] + ".animation")
        with open(path, "w", encoding="utf-8", newline="\n") as out:
            out.write("# ramure-animation 1\n# fps=%s\n" % number(self.fps))
            out.write(self.parent_line(obj))
            for line in lines:
                out.write(line.text())
        self.files[obj] = path

    def check(self, objects):
        """Reads the files again and compares them with Blender, at every frame and half-way between."""
        read = {obj: read_lines(path) for obj, path in self.files.items()}
        worst, where = 0.0, None
        for half in range(2 * self.scene.frame_start, 2 * self.scene.frame_end + 1):
            frame = half / 2.0
            self.scene.frame_set(half // 2, subframe=0.5 * (half % 2))
            depsgraph = self.context.evaluated_depsgraph_get()
            for obj, lines in read.items():
                if half % 2 and not lines[0].handles:
                    continue  # baked: exact at frames
                location, rotation, scale = value_at(lines, frame / self.fps)
                made = Matrix.Translation(location) @ rotation.to_matrix().to_4x4() @ Matrix.Diagonal((*scale, 1.0))
                have = local_matrix(obj, depsgraph)
                off = max(abs(made[r][c] - have[r][c]) for r in range(3) for c in range(4))
                if off > worst:
                    worst, where = off, (obj.name, frame)
        self.scene.frame_set(self.frame)
        return worst, where


def read_lines(path):
    lines = []
    with open(path, encoding="utf-8") as source:
        for text in source:
            if text.startswith("#") or not text.strip():
                continue
            cells = text.strip().split(",")
            values = [float(c) for c in cells[2:12]]
            handles = None
            if len(cells) > 12:
                numbers = [float(c) for c in cells[16:]]
                handles = [tuple(numbers[4 * i:4 * i + 4]) for i in range(10)]
            shape = (cells[12], *(float(c) for c in cells[13:16])) if len(cells) > 12 else ("AUTO", 0, 0, 0)
            lines.append(Line(float(cells[0]), cells[1], values, shape, handles))
    return lines


def bezier(x, duration, v0, out, into, v1):
    """As Blender: handles shortened to the segment, then the cubic in time solved by bisection."""
    def short(handle):
        return handle if abs(handle[0]) <= duration else tuple(h * duration / abs(handle[0]) for h in handle)
    (dt0, dv0), (dt1, dv1) = short(out), short(into)
    low, high = 0.0, 1.0
    for _ in range(60):
        u = 0.5 * (low + high)
        w = 1.0 - u
        at = 3 * w * w * u * dt0 + 3 * w * u * u * (duration + dt1) + u * u * u * duration
        low, high = (u, high) if at < x * duration else (low, u)
    return w ** 3 * v0 + 3 * w * w * u * (v0 + dv0) + 3 * w * u * u * (v1 + dv1) + u ** 3 * v1


def elastic(line, x, duration, change):
    """The share of the change at x; amplitude in units of the value, period in seconds."""
    easing, _, amplitude, period = line.shape
    if change == 0.0:
        return x
    both = easing == "EASE_IN_OUT"
    period = period or duration * (0.45 if both else 0.3)
    tau = -abs(2 * x - 1) if both else x - 1 if easing == "EASE_IN" else -x
    rising = x < 0.5 if both else easing == "EASE_IN"
    size, shift, blend = amplitude / change, period / 4, 1.0
    if not amplitude or amplitude < abs(change):
        size, blend = 1.0, amplitude / abs(change)
        if abs(tau * duration) < abs(shift):
            near = abs(tau * duration) / abs(shift)
            blend = blend * near + 1 - near
    else:
        shift = period / (2 * math.pi) * math.asin(change / amplitude)
    swing = (0.5 if both else 1.0) * blend * size * 2 ** (10 * tau) * math.sin(
        (tau * duration - shift) * 2 * math.pi / period)
    return -swing if rising else 1 + swing


def eased(mode, easing, x, back):
    """Every easing but ELASTIC."""
    def into(t, s):
        if mode == "SINE":
            return 1 - math.cos(t * math.pi / 2)
        if mode in ("QUAD", "CUBIC", "QUART", "QUINT"):
            return t ** (2 + ("QUAD", "CUBIC", "QUART", "QUINT").index(mode))
        if mode == "EXPO":
            return (2 ** (10 * (t - 1)) - 2 ** -10) / (1 - 2 ** -10)
        if mode == "CIRC":
            return 1 - math.sqrt(max(0.0, 1 - t * t))
        if mode == "BACK":
            return t * t * ((s + 1) * t - s)
        if mode == "BOUNCE":
            n, k, r = 7.5625, 2.75, 1 - t
            for limit, shift, add in ((1, 0, 0), (2, 1.5, .75), (2.5, 2.25, .9375), (9, 2.625, .984375)):
                if r < limit / k or limit == 9:
                    return 1 - (n * (r - shift / k) ** 2 + add)
        return None
    if easing == "AUTO":
        easing = "EASE_OUT" if mode in ("BACK", "BOUNCE") else "EASE_IN"
    if easing == "EASE_IN":
        return into(x, back)
    if easing == "EASE_OUT":
        return 1 - into(1 - x, back)
    return 0.5 * into(2 * x, back * 1.525) if x < 0.5 else 1 - 0.5 * into(2 - 2 * x, back * 1.525)


def value_at(lines, time):
    """Location, rotation and scale of the lines of a file at a time."""
    values = lines[0].values if time <= lines[0].time else lines[-1].values
    for a, b in zip(lines, lines[1:]):
        if a.time < time < b.time:
            duration, x = b.time - a.time, (time - a.time) / (b.time - a.time)
            share = None if a.mode in ("CONSTANT", "LINEAR", "BEZIER", "ELASTIC") else eased(a.mode, a.shape[0], x, a.shape[1])
            values = []
            for i in range(10):
                v0, v1 = a.values[i], b.values[i]
                if a.mode == "CONSTANT":
                    values.append(v0)
                elif a.mode == "BEZIER" and a.handles and b.handles:
                    values.append(bezier(x, duration, v0, a.handles[i][2:], b.handles[i][:2], v1))
                elif a.mode == "ELASTIC":
                    values.append(v0 + (v1 - v0) * elastic(a, x, duration, v1 - v0))
                else:
                    values.append(v0 + (v1 - v0) * (x if share is None else share))
        elif abs(time - a.time) <= 1e-9:
            values = a.values
    rotation = Quaternion((values[6], values[3], values[4], values[5])).normalized()
    return Vector(values[0:3]), rotation, Vector(values[7:10])


def export(context, folder, **options):
    job = Export(context, folder, **options)
    worst, where = job.run()
    for text in job.report:
        print("ramure: " + text)
    print("ramure: %d objects, %d with keys, largest deviation from Blender %.3g%s" %
          (len(job.names), len(job.files), worst, " (%s, frame %g)" % where if where else ""))
    if worst > TOLERANCE:
        print("ramure: more than %g: --bake writes a key for every frame" % TOLERANCE)
    return job, worst


class EXPORT_OT_ramure(bpy.types.Operator):
    """Write objects and keys for Ramure into a folder"""
    bl_idname = "export_scene.ramure"
    bl_label = "Export for Ramure"
    directory: bpy.props.StringProperty(subtype="DIR_PATH")
    bake: bpy.props.BoolProperty(name="Bake", description="Write a key for every frame")
    selected: bpy.props.BoolProperty(name="Selected only", description="Leave out objects that are not selected")

    def execute(self, context):
        job, worst = export(context, self.directory, bake=self.bake, selected=self.selected)
        for text in job.report:
            self.report({"INFO"}, text)
        self.report({"WARNING" if worst > TOLERANCE else "INFO"}, "Largest deviation %.3g" % worst)
        return {"FINISHED"}

    def invoke(self, context, _event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}


def menu(self, _context):
    self.layout.operator(EXPORT_OT_ramure.bl_idname, text="Ramure (folder)")


def register():
    bpy.utils.register_class(EXPORT_OT_ramure)
    bpy.types.TOPBAR_MT_file_export.append(menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(menu)
    bpy.utils.unregister_class(EXPORT_OT_ramure)


def main(arguments):
    folder, options = None, {}
    rest = list(arguments)
    while rest:
        word = rest.pop(0)
        if word == "--bake":
            options["bake"] = True
        elif word == "--selected":
            options["selected"] = True
        elif word == "--frame" and rest and re.fullmatch(r"-?\d+", rest[0]):
            options["frame"] = int(rest.pop(0))
        elif folder is None and not word.startswith("--"):
            folder = word
        else:
            sys.exit("ramure: unknown argument %s: FOLDER [--bake] [--selected] [--frame N] expected" % word)
    if folder is None:
        sys.exit("ramure: a folder is expected: blender -b FILE.blend --python ramure_export.py -- FOLDER")
    export(bpy.context, folder, **options)


if __name__ == "__main__":
    if "--" in sys.argv:
        main(sys.argv[sys.argv.index("--") + 1:])
    else:
        register()
