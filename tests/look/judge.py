"""The pictures of ramure-cli against a path tracer: Blender's Cycles, from our own export.

    blender -b --factory-startup -P tests/look/judge.py -- build/release/bin/ramure-cli FOLDER [NAME...]

The same tree, camera, sun and sky. For each row: intersection over union of the silhouettes, mean difference of
colour (CIE76) of crown and of bark at a quarter of the size, structural similarity of the grey pictures at that size.
Pictures of both stay in FOLDER.

Species have four close-ups as well, without leaves: foot, fork, limb and twig. There the rows have the difference of bark
and the structure alone; close_ours.png and close_cycles.png show all of them, a row for each species. --close makes
nothing else.
"""
import json
import math
import subprocess
import sys
from pathlib import Path

import bpy
import mathutils
import numpy

sys.path.insert(0, str(Path(__file__).parent))
from cameras import ANGLE, CLOSE_UPS, Skeleton, close_ups

SIZE = 512
SMALL = 128
SAMPLES = 64
# Of silhouettes: pictures of 64 parts a pixel, four samples in each. With samples thrown all over the pixel, the noise
# of both keeps thin needles from covering each other.
FINE = 8 * SIZE
FINE_SAMPLES = 4
EXPOSURE = 0.8  # renderer.cpp
MEADOW = (0.0931, 0.2051, 0.0612)
THROUGH = 0.5  # material.cpp, of leaves, and what mesh.frag tints it with
THROUGH_TINT = (1.5, 1.25, 0.4)
CLOSE_SIZE = 320
CLOSE_SAMPLES = 24
BARS = (0.97, 12.0, 12.0, 0.80)

ROWS = {
    "SmallTree": ("SmallTree", []),
    "FanTree": ("FanTree", []),
    "TinyTree": ("TinyTree", []),
    "Fern2D": ("Fern2D", []),
    "birch": ("FanTree", ["foliage.leaf=birch", "foliage.applesProbability=0", "bark.family=ringed"]),
    "oak": ("TinyTree", ["foliage.leaf=oak", "foliage.fruit=acorn", "bark.family=furrowed"]),
    "pine": ("TinyTree", ["foliage.leaf=scotsPine", "foliage.fruit=cone", "bark.family=plated"]),
    "maple": ("SmallTree", ["foliage.leaf=maple", "foliage.applesProbability=0", "bark.family=plated"]),
    "palm": ("TinyTree", ["foliage.leaf=palm", "foliage.fruit=coconut", "bark.family=palmScars"]),
    "apple": ("SmallTree", ["foliage.leaf=apple", "foliage.fruit=apple", "bark.family=scaly"]),
}
# Presets as they are; any other may be named, too.
SPECIES = ["QuakingAspen", "SilverBirch1995", "EnglishOak1995", "EuropeanBeech1995", "WeepingWillow1995", "SugarMaple", "LondonPlane",
           "OliveTree1995", "ScotsPine1995", "NorwaySpruce1995", "CoconutPalm", "TreeFern"]
CLOSE_SPECIES = ["EnglishOak", "EuropeanBeech", "SilverBirch", "ScotsPine", "NorwaySpruce", "SmallLeavedLinden", "WeepingWillow",
                 "OrchardApple", "OliveTree", "LebanonCedar", "Hawthorn", "JapaneseMaple"]
BARE = ["--set", "foliage.leavesDensity=0", "--set", "foliage.applesProbability=0"]


def run(*arguments):
    return subprocess.run([str(a) for a in arguments], check=True, stdout=subprocess.PIPE).stdout


def camera_of(info):
    """Eye and target: from the front, a little from the right and above, all in the picture."""
    low, high = numpy.array(info["min"]), numpy.array(info["max"])
    target = 0.5 * (low + high)
    reach = 0.58 * float((high - low).max()) + 0.25
    way = numpy.array([math.sin(0.5), 0.12, math.cos(0.5)])
    eye = target + way / numpy.linalg.norm(way) * reach / math.tan(math.radians(ANGLE) / 2)
    return eye, target


def blender(v):
    """Y up to Z up."""
    return mathutils.Vector((v[0], -v[2], v[1]))


def ours(cli, preset, settings, folder, name):
    options = [o for s in settings for o in ("--set", s)]
    tree = f"preset:{preset}"
    eye, target = camera_of(json.loads(run(cli, "info", tree, "--json", *options)))
    common = ["--camera", placed(eye, target), *options]
    run(cli, "render", tree, "-o", folder / f"{name}_ours.png", "--background", "sky",
        "--sky-picture", folder / "sky.hdr", "--size", f"{SIZE}x{SIZE}", "--quality", "best", *common)
    run(cli, "render", tree, "-o", folder / f"{name}_mask.png", "--background", "none",
        "--size", f"{FINE}x{FINE}", *common)
    run(cli, "export", tree, "-o", folder / f"{name}.obj", "--part", "all", *options)
    return eye, target


def header_of(path):
    lines = {}
    for line in path.read_bytes().split(b"\n\n")[0].decode().splitlines():
        words = line.split()
        if len(words) == 5 and words[0] == "#":
            lines[words[1]] = tuple(float(w) for w in words[2:])
    return lines


def light(sky):
    header = header_of(sky)
    world = bpy.data.worlds.new("sky")
    bpy.context.scene.world = world
    world.use_nodes = True
    picture = world.node_tree.nodes.new("ShaderNodeTexEnvironment")
    picture.image = bpy.data.images.load(str(sky))
    background = world.node_tree.nodes["Background"]
    world.node_tree.links.new(picture.outputs["Color"], background.inputs["Color"])
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.color = header["sunlight"]
    sun.data.energy = math.pi
    sun.data.angle = math.radians(0.53)
    sun.rotation_euler = blender(header["sun"]).to_track_quat("Z", "Y").to_euler()
    bpy.context.collection.objects.link(sun)


def ground():
    bpy.ops.mesh.primitive_plane_add(size=4000)
    material = bpy.data.materials.new("meadow")
    material.use_nodes = True
    material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (*MEADOW, 1)
    material.node_tree.nodes["Principled BSDF"].inputs["Specular"].default_value = 0
    bpy.context.object.data.materials.append(material)
    return bpy.context.object


def let_light_through(material):
    """Leaves: what falls on the one side is seen from the other, tinted."""
    tree = material.node_tree
    principled = tree.nodes["Principled BSDF"]
    output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")
    through = tree.nodes.new("ShaderNodeBsdfTranslucent")
    tint = tree.nodes.new("ShaderNodeMixRGB")
    tint.blend_type = "MULTIPLY"
    tint.inputs[0].default_value = 1
    colour = principled.inputs["Base Color"]
    if colour.is_linked:
        tree.links.new(colour.links[0].from_socket, tint.inputs[1])
    else:
        tint.inputs[1].default_value = colour.default_value
    tint.inputs[2].default_value = (*(THROUGH * t for t in THROUGH_TINT), 1)
    tree.links.new(tint.outputs[0], through.inputs["Color"])
    both = tree.nodes.new("ShaderNodeAddShader")
    tree.links.new(principled.outputs[0], both.inputs[0])
    tree.links.new(through.outputs[0], both.inputs[1])
    tree.links.new(both.outputs[0], output.inputs["Surface"])


def dress():
    """Materials as the importers leave them."""
    for material in bpy.data.materials:
        for node in material.node_tree.nodes:
            if node.type == "TEX_IMAGE" and "_normal" in node.image.name:
                node.image.colorspace_settings.name = "Non-Color"
        principled = material.node_tree.nodes.get("Principled BSDF")
        principled.inputs["Specular"].default_value = 0.2


def arrange(folder, name):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.obj_import(filepath=str(folder / f"{name}.obj"), forward_axis="NEGATIVE_Z", up_axis="Y")
    dress()
    for material in bpy.data.materials:
        colour = material.node_tree.nodes["Principled BSDF"].inputs["Base Color"]
        if not colour.is_linked:  # Kd is sRGB, and taken over as if it were linear
            colour.default_value = (*linear(numpy.array(colour.default_value[:3])), 1)
        if material.name.startswith("leaves"):
            let_light_through(material)


def stand(eye, target):
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.sensor_fit = "VERTICAL"
    camera.data.angle = math.radians(ANGLE)
    camera.data.clip_start = 0.01
    camera.location = blender(eye)
    camera.rotation_euler = (blender(eye) - blender(target)).to_track_quat("Z", "Y").to_euler()
    bpy.context.collection.objects.link(camera)
    scene = bpy.context.scene
    scene.camera = camera
    scene.render.engine = "CYCLES"
    scene.cycles.pixel_filter_type = "BOX"  # as the samples of our pictures count
    scene.cycles.filter_width = 1.0
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.color_mode = "RGBA"


def rendered(path, size, samples, transparent):
    scene = bpy.context.scene
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.render.film_transparent = transparent
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    return pixels_of(path)


def pixels_of(path):
    """Rows from the top; RGBA as they are in the file."""
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    image.alpha_mode = "CHANNEL_PACKED"
    out = numpy.empty(image.size[0] * image.size[1] * 4, dtype=numpy.float32)
    image.pixels.foreach_get(out)
    out = out.reshape(image.size[1], image.size[0], 4)[::-1]
    bpy.data.images.remove(image)
    return out


def kinds_only():
    """Leaves red, bark green, the rest blue, each shining by itself."""
    for material in bpy.data.materials:
        name = material.name
        colour = (1, 0, 0, 1) if name.startswith("leaves") else (0, 1, 0, 1) if name.startswith("bark") else (0, 0, 1, 1)
        tree = material.node_tree
        shine = tree.nodes.new("ShaderNodeEmission")
        shine.inputs["Color"].default_value = colour
        output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")
        tree.links.new(shine.outputs[0], output.inputs["Surface"])


def film(light):
    """lighting.glsl's response, to sRGB."""
    c = EXPOSURE * numpy.maximum(light, 0)
    c = c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14)
    grey = c @ numpy.array([0.2126, 0.7152, 0.0722])
    c = numpy.clip(0.2 * grey[..., None] + 0.8 * c, 0, 1)
    return numpy.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055)


def shrunk(picture, size):
    step = len(picture) // size
    return picture.reshape(size, step, size, step, -1).mean(axis=(1, 3))


def linear(srgb):
    return numpy.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def lab(srgb):
    xyz = linear(srgb) @ numpy.array([[0.4124, 0.2126, 0.0193], [0.3576, 0.7152, 0.1192], [0.1805, 0.0722, 0.9505]])
    t = xyz / numpy.array([0.9505, 1.0, 1.089])
    f = numpy.where(t > 0.008856, numpy.cbrt(t), 7.787 * t + 16 / 116)
    return numpy.stack([116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])], -1)


def similarity(a, b):
    """Wang et al. 2004, over squares of 8 pixels."""
    def windows(x):
        return numpy.lib.stride_tricks.sliding_window_view(x, (8, 8)).reshape(-1, 64)
    x, y = windows(a), windows(b)
    mx, my = x.mean(1), y.mean(1)
    vx, vy, cov = x.var(1), y.var(1), ((x - mx[:, None]) * (y - my[:, None])).mean(1)
    c1, c2 = 0.01 ** 2, 0.03 ** 2
    return float((((2 * mx * my + c1) * (2 * cov + c2)) / ((mx ** 2 + my ** 2 + c1) * (vx + vy + c2))).mean())


def judged(cli, folder, name):
    preset, settings = ROWS.get(name, (name, []))
    eye, target = ours(cli, preset, settings, folder, name)
    arrange(folder, name)
    stand(eye, target)
    light(folder / "sky.hdr")
    plane = ground()
    traced = rendered(folder / f"{name}_cycles.exr", SIZE, SAMPLES, False)
    bpy.data.objects.remove(plane)
    kinds_only()
    kinds = shrunk(rendered(folder / f"{name}_kinds.exr", FINE, FINE_SAMPLES, True), SIZE)
    ours_picture = pixels_of(folder / f"{name}_ours.png")[..., :3]
    theirs = film(traced[..., :3])
    save(folder / f"{name}_cycles.png", theirs)
    mask = shrunk(pixels_of(folder / f"{name}_mask.png"), SIZE)[..., 3]
    both = numpy.minimum(mask, kinds[..., 3]).sum()
    overlap = both / numpy.maximum(mask, kinds[..., 3]).sum()
    a, b, shares = (shrunk(picture, SMALL) for picture in (ours_picture, theirs, kinds[..., :3]))
    difference = numpy.linalg.norm(lab(a) - lab(b), axis=-1)
    crown, bark = (float(difference[shares[..., i] > 0.5].mean()) if (shares[..., i] > 0.5).any() else math.nan
                   for i in (0, 1))
    grey = numpy.array([0.2126, 0.7152, 0.0722])
    return float(overlap), crown, bark, similarity(a @ grey, b @ grey)


def save(path, srgb):
    image = bpy.data.images.new("out", srgb.shape[1], srgb.shape[0])
    image.colorspace_settings.name = "Non-Color"
    rgba = numpy.ones((*srgb.shape[:2], 4), dtype=numpy.float32)
    rgba[..., :3] = srgb
    image.pixels.foreach_set(rgba[::-1].ravel())
    image.filepath_raw = str(path)
    image.file_format = "PNG"
    image.save()


def placed(eye, target):
    return ",".join(f"{v:.6f}" for v in (*eye, *target, ANGLE))


def judged_close(cli, folder, preset):
    """Of each close-up the difference of bark and the structure; and the pictures, ours and theirs."""
    tree = f"preset:{preset}"
    run(cli, "export", tree, "--model", "skeleton", "-o", folder / f"{preset}_skeleton.obj")
    run(cli, "export", tree, "-o", folder / f"{preset}.glb", "--part", "branches")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    numpy.bool = bool  # the importer of 3.4 asks for a name that numpy gave up
    bpy.ops.import_scene.gltf(filepath=str(folder / f"{preset}.glb"))
    dress()
    mesh = next(o for o in bpy.data.objects if o.type == "MESH").data
    vertices = numpy.empty(3 * len(mesh.vertices), dtype=numpy.float32)
    mesh.vertices.foreach_get("co", vertices)
    vertices = vertices.reshape(-1, 3)[:, [0, 2, 1]] * [1, 1, -1]  # Y is up in ours
    out = {}
    for number, (kind, (eye, target)) in enumerate(close_ups(Skeleton(folder / f"{preset}_skeleton.obj", vertices)).items()):
        name = f"{preset}_{kind}"
        run(cli, "render", tree, "-o", folder / f"{name}_ours.png", "--background", "sky", "--sky-picture",
            folder / "sky.hdr", "--size", f"{CLOSE_SIZE}x{CLOSE_SIZE}", "--quality", "best", "--camera", placed(eye, target),
            *BARE)
        stand(eye, target)
        if number == 0:
            light(folder / "sky.hdr")
            ground()
        traced = film(rendered(folder / f"{name}_cycles.exr", CLOSE_SIZE, CLOSE_SAMPLES, False)[..., :3])
        save(folder / f"{name}_cycles.png", traced)
        picture = pixels_of(folder / f"{name}_ours.png")[..., :3]
        a, b = shrunk(picture, CLOSE_SIZE // 4), shrunk(traced, CLOSE_SIZE // 4)
        middle = slice(len(a) // 3, 2 * len(a) // 3)
        difference = numpy.linalg.norm(lab(a) - lab(b), axis=-1)[middle, middle].mean()
        grey = numpy.array([0.2126, 0.7152, 0.0722])
        out[kind] = (float(difference), similarity(a @ grey, b @ grey), picture, traced)
    return out


def close(cli, folder, names):
    rows = ["| close-up | " + " | ".join(CLOSE_UPS) + " | (difference in the middle, structure)",
            "| --- | ---: | ---: | ---: | ---: |"]
    print("\n".join(rows))
    sheets = [[], []]
    for name in names:
        found = judged_close(cli, folder, name)
        rows.append("| %s | %s |" % (name, " | ".join("%.1f, %.2f" % found[kind][:2] for kind in CLOSE_UPS)))
        print(rows[-1], flush=True)
        for sheet, which in zip(sheets, (2, 3)):
            sheet.append(numpy.concatenate([found[kind][which] for kind in CLOSE_UPS], axis=1))
    for sheet, name in zip(sheets, ("close_ours", "close_cycles")):
        save(folder / f"{name}.png", numpy.concatenate(sheet, axis=0))
    (folder / "close.md").write_text("\n".join(rows) + "\n")


def main():
    arguments = sys.argv[sys.argv.index("--") + 1:]
    cli, folder = Path(arguments[0]), Path(arguments[1]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    names = [a for a in arguments[2:] if a != "--close"]
    if "--close" not in arguments:
        whole(cli, folder, names)
    close(cli, folder, [n for n in names if n not in ROWS] if names else CLOSE_SPECIES)


def whole(cli, folder, names):
    rows = ["| tree | silhouette | crown | bark | structure | bars |", "| --- | ---: | ---: | ---: | ---: | --- |"]
    print("\n".join(rows))
    for name in names or [*ROWS, *SPECIES]:
        found = judged(cli, folder, name)
        held = [not value < bar if i in (0, 3) else not value > bar for i, (value, bar) in enumerate(zip(found, BARS))]
        said = "met" if all(held) else "not met"
        rows.append("| %s | %.3f | %.1f | %.1f | %.2f | %s |" % (name, *found, said))
        print(rows[-1], flush=True)
    (folder / "table.md").write_text("\n".join(rows) + "\n")


main()
