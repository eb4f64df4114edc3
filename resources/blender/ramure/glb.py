"""A GLB of ramure-cli as arrays. Blender's own importer stops the window for seconds; this reads what the program writes."""
import json
import struct

import numpy

TYPES = {5121: "<u1", 5123: "<u2", 5125: "<u4", 5126: "<f4", 5120: "<i1", 5122: "<i2"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Glb:
    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        magic, _, _, length, _ = struct.unpack_from("<4sIIII", data)
        if magic != b"glTF":
            raise ValueError(f"{path} is no GLB")
        self.json = json.loads(data[20:20 + length])
        self._bytes = memoryview(data)[20 + length + 8:]

    def nodes(self):
        """Each with its children, which are numbers."""
        return self.json.get("nodes", [])

    def roots(self):
        return self.json["scenes"][self.json.get("scene", 0)]["nodes"]

    def view(self, number):
        view = self.json["bufferViews"][number]
        start = view.get("byteOffset", 0)
        return self._bytes[start:start + view["byteLength"]]

    def array(self, number):
        """An accessor, a row an element; normalised integers as floats."""
        accessor = self.json["accessors"][number]
        kind = numpy.dtype(TYPES[accessor["componentType"]])
        width = WIDTHS[accessor["type"]]
        values = numpy.frombuffer(self.view(accessor["bufferView"]), kind, accessor["count"] * width,
                                  accessor.get("byteOffset", 0)).reshape(-1, width)
        if accessor.get("normalized"):
            values = values.astype("<f4") / float(numpy.iinfo(kind).max)
        return values

    def image(self, texture):
        """Name, ending and bytes of the picture of a texture."""
        image = self.json["images"][self.json["textures"][texture]["source"]]
        ending = ".jpg" if image.get("mimeType") == "image/jpeg" else ".png"
        return image.get("name", "picture"), ending, bytes(self.view(image["bufferView"]))


def upright(points):
    """From Y up to Blender's Z up."""
    return numpy.stack([points[:, 0], -points[:, 2], points[:, 1]], axis=1)
