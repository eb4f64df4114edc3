"""A GLB becomes objects below the one that holds the tree, a little at a time, so that the window goes on answering."""
import hashlib
import os

import bpy
import mathutils
import numpy

from . import glb

BLOCK = 60_000  # triangles that are handed over at once: some milliseconds


def clear(holder):
    """What the tree was before goes, with all that only it used."""
    def below(thing):
        for child in thing.children:
            yield from below(child)
            yield child
    for thing in list(below(holder)):
        data = thing.data
        bpy.data.objects.remove(thing)
        if data and data.users == 0:
            (bpy.data.meshes if isinstance(data, bpy.types.Mesh) else bpy.data.armatures).remove(data)
    for collection in [one for one in bpy.data.collections if one.get("ramure") == holder.name_full]:
        bpy.data.collections.remove(collection)
    for material in [one for one in bpy.data.materials if one.get("ramure") and one.users == 0]:
        bpy.data.materials.remove(material)
    for image in [one for one in bpy.data.images if one.get("ramure") and one.users == 0]:
        bpy.data.images.remove(image)


class Builder:
    def __init__(self, holder, path):
        self._holder = holder
        self._glb = glb.Glb(path)
        self._folder = os.path.dirname(path)
        self._meshes, self._materials, self._images = {}, {}, {}
        self._hash = hashlib.sha256()

    def steps(self):
        """A generator: each step is a piece of the work. The last one sets the hash of the tree."""
        yield from self._below(self._glb.roots(), self._holder)
        yield from self._levels()
        self._holder.ramure.grown = self._hash.hexdigest()[:16]
        yield

    def _below(self, numbers, parent):
        for number in numbers:
            node = self._glb.nodes()[number]
            thing = parent
            if "mesh" in node:
                yield from self._mesh(node["mesh"])
                thing = self._object(node, parent)
                yield
                instances = node.get("extensions", {}).get("EXT_mesh_gpu_instancing")
                if instances:
                    yield from self._instances(thing, instances["attributes"], parent)
            yield from self._below(node.get("children", []), thing)

    def _object(self, node, parent):
        thing = bpy.data.objects.new(self._name(node), self._meshes[node["mesh"]])
        thing.parent = parent
        for collection in self._holder.users_collection:
            collection.objects.link(thing)
        return thing

    def _name(self, node):
        """A tree of one mesh is a node with its own name: here it hangs on an object of that name already."""
        return self._glb.json["meshes"][node["mesh"]].get("name", "tree")

    def _levels(self):
        """Coarser levels stand in no scene of the file: each level is a collection, and only the first is shown."""
        named = {}
        for node in self._glb.nodes():
            level = self._name(node).rpartition("_LOD")[2] if "mesh" in node else ""
            if level.isdigit():
                named.setdefault(int(level), []).append(node)
        shown = {thing.name.split(".")[0]: thing for thing in self._holder.children}
        for level, nodes in sorted(named.items()):
            collection = bpy.data.collections.new(f"{self._holder.name} LOD{level}")
            collection["ramure"] = self._holder.name_full
            (self._holder.users_collection[0] if self._holder.users_collection else
             bpy.context.scene.collection).children.link(collection)
            for node in nodes:
                thing = shown.get(self._name(node))
                if not thing:
                    yield from self._mesh(node["mesh"])
                    thing = self._object(node, self._holder)
                for other in list(thing.users_collection):
                    other.objects.unlink(thing)
                collection.objects.link(thing)
            collection.hide_viewport = collection.hide_render = level > 0
            yield

    def _mesh(self, number):
        """Points, triangles, normals, coordinates and colours of all primitives of a mesh."""
        if number in self._meshes:
            return
        source = self._glb.json["meshes"][number]
        primitive = source["primitives"][0]
        attributes = primitive["attributes"]
        points = glb.upright(self._glb.array(attributes["POSITION"]))
        triangles = self._glb.array(primitive["indices"]).reshape(-1, 3).astype("<i4")
        self._hash.update(points.tobytes())
        self._hash.update(triangles.tobytes())
        yield
        mesh = bpy.data.meshes.new(source.get("name", "tree"))
        self._meshes[number] = mesh
        mesh.vertices.add(len(points))
        mesh.vertices.foreach_set("co", points.ravel().astype("<f4"))
        yield
        mesh.loops.add(triangles.size)
        mesh.loops.foreach_set("vertex_index", triangles.ravel())
        yield
        mesh.polygons.add(len(triangles))
        mesh.polygons.foreach_set("loop_start", numpy.arange(0, triangles.size, 3, dtype="<i4"))
        if bpy.app.version < (4, 0, 0):  # later ones find it themselves
            mesh.polygons.foreach_set("loop_total", numpy.full(len(triangles), 3, dtype="<i4"))
        yield
        if "TEXCOORD_0" in attributes:
            coordinates = self._glb.array(attributes["TEXCOORD_0"]).copy()
            coordinates[:, 1] = 1.0 - coordinates[:, 1]
            layer = mesh.uv_layers.new(name="UVMap")
            layer.data.foreach_set("uv", coordinates[triangles.ravel()].ravel().astype("<f4"))
            yield
        if "COLOR_0" in attributes:
            colours = self._glb.array(attributes["COLOR_0"])
            if colours.shape[1] == 3:
                colours = numpy.concatenate([colours, numpy.ones((len(colours), 1), "<f4")], axis=1)
            layer = mesh.color_attributes.new("Color", "FLOAT_COLOR", "POINT")
            layer.data.foreach_set("color", colours.ravel().astype("<f4"))
            yield
        mesh.polygons.foreach_set("use_smooth", numpy.ones(len(triangles), dtype=bool))
        mesh.update(calc_edges=True)
        yield
        if "material" in primitive:
            mesh.materials.append(self._material(primitive["material"], "COLOR_0" in attributes))
        yield

    def _instances(self, shape, attributes, parent):
        """Instances on the faces of a mesh: a triangle says where one stands, how it is turned and how large it is."""
        places = glb.upright(self._glb.array(attributes["TRANSLATION"]))
        turns = self._glb.array(attributes["ROTATION"]).astype("<f8")
        sizes = self._glb.array(attributes["SCALE"])[:, :1].astype("<f8")
        self._hash.update(places.tobytes())
        x, y, z, w = turns.T
        # Blender takes a face's normal as Z and its first edge as X.
        right = glb.upright(numpy.stack([1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)], 1))
        ahead = -glb.upright(numpy.stack([2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)], 1))
        yield
        # Of a face the square root of its area is the size of the instance.
        half = sizes * 0.5
        corners = numpy.stack([places - right * half - ahead * half, places + right * half - ahead * half,
                               places + right * half + ahead * half, places - right * half + ahead * half], 1)
        mesh = bpy.data.meshes.new(shape.name + " places")
        mesh.vertices.add(corners.shape[0] * 4)
        mesh.vertices.foreach_set("co", corners.ravel().astype("<f4"))
        mesh.loops.add(corners.shape[0] * 4)
        mesh.loops.foreach_set("vertex_index", numpy.arange(corners.shape[0] * 4, dtype="<i4"))
        yield
        mesh.polygons.add(corners.shape[0])
        mesh.polygons.foreach_set("loop_start", numpy.arange(0, corners.shape[0] * 4, 4, dtype="<i4"))
        if bpy.app.version < (4, 0, 0):
            mesh.polygons.foreach_set("loop_total", numpy.full(corners.shape[0], 4, dtype="<i4"))
        mesh.update(calc_edges=True)
        yield
        carrier = bpy.data.objects.new(shape.name + " places", mesh)
        carrier.parent = parent
        for collection in self._holder.users_collection:
            collection.objects.link(carrier)
        carrier.instance_type = "FACES"
        carrier.use_instance_faces_scale = True
        carrier.show_instancer_for_render = carrier.show_instancer_for_viewport = False
        shape.parent = carrier
        yield

    def _picture(self, texture, is_colour):
        key = (texture, is_colour)
        if key not in self._images:
            name, ending, data = self._glb.image(texture)
            path = os.path.join(self._folder, f"{texture}{ending}")
            with open(path, "wb") as file:
                file.write(data)
            image = bpy.data.images.load(path)
            image.name = name
            image["ramure"] = True
            image.pack()
            if not is_colour:
                image.colorspace_settings.name = "Non-Color"
            self._images[key] = image
        return self._images[key]

    def _material(self, number, coloured):
        key = (number, coloured)
        if key in self._materials:
            return self._materials[key]
        source = self._glb.json["materials"][number]
        material = bpy.data.materials.new(source.get("name", "tree"))
        material["ramure"] = True
        material.use_nodes = True
        nodes, links = material.node_tree.nodes, material.node_tree.links
        surface = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
        metal = source.get("pbrMetallicRoughness", {})
        factor = metal.get("baseColorFactor", [1.0, 1.0, 1.0, 1.0])
        surface.inputs["Base Color"].default_value = factor
        surface.inputs["Roughness"].default_value = metal.get("roughnessFactor", 1.0)
        surface.inputs["Metallic"].default_value = metal.get("metallicFactor", 0.0)
        colour = None
        if "baseColorTexture" in metal:
            picture = nodes.new("ShaderNodeTexImage")
            picture.image = self._picture(metal["baseColorTexture"]["index"], True)
            colour = picture.outputs["Color"]
            if source.get("alphaMode", "OPAQUE") != "OPAQUE":
                links.new(picture.outputs["Alpha"], surface.inputs["Alpha"])
                if hasattr(material, "blend_method"):
                    material.blend_method = "CLIP"
        if coloured:
            painted = nodes.new("ShaderNodeVertexColor")
            painted.layer_name = "Color"
            if colour:
                mix = nodes.new("ShaderNodeMixRGB")
                mix.blend_type = "MULTIPLY"
                mix.inputs["Fac"].default_value = 1.0
                links.new(colour, mix.inputs["Color1"])
                links.new(painted.outputs["Color"], mix.inputs["Color2"])
                colour = mix.outputs["Color"]
            else:
                colour = painted.outputs["Color"]
        if colour:
            links.new(colour, surface.inputs["Base Color"])
        if "normalTexture" in source:
            picture = nodes.new("ShaderNodeTexImage")
            picture.image = self._picture(source["normalTexture"]["index"], False)
            bump = nodes.new("ShaderNodeNormalMap")
            links.new(picture.outputs["Color"], bump.inputs["Color"])
            links.new(bump.outputs["Normal"], surface.inputs["Normal"])
        material.use_backface_culling = not source.get("doubleSided", False)
        self._materials[key] = material
        return material


def imported(holder, path):
    """A tree in the wind, by Blender's importer, which knows armatures and actions. It stops the window while it works."""
    if "bool" not in vars(numpy):  # the importer of Blender 3.4 asks for a name that NumPy no longer has
        numpy.bool = bool
    before = set(bpy.data.objects)
    bpy.ops.import_scene.gltf(filepath=path)
    hashed = hashlib.sha256()
    for thing in sorted(set(bpy.data.objects) - before, key=lambda one: one.name):
        if thing.parent is None:
            thing.parent = holder
            thing.matrix_parent_inverse = mathutils.Matrix.Identity(4)
        if thing.type == "MESH":
            places = numpy.empty(3 * len(thing.data.vertices), "<f4")
            thing.data.vertices.foreach_get("co", places)
            hashed.update(places.tobytes())
            for material in thing.data.materials:
                material["ramure"] = True
    for thing in bpy.context.selected_objects:
        thing.select_set(False)
    holder.select_set(True)
    bpy.context.view_layer.objects.active = holder
    holder.ramure.grown = hashed.hexdigest()[:16]
