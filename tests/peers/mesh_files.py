"""Meshes of any program as arrays, read from PLY (binary) and OBJ, and written as PLY. A part has `positions`
(float64, vertices x 3), `triangles` (int64, triangles x 3), `uv` (triangles x 3 x 2 or None) and `normals`
(triangles x 3 x 3 or None): what belongs to a corner stands at the corner, however the file keeps it."""

import re
from types import SimpleNamespace

import numpy

TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2",
    "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4",
    "double": "f8", "float64": "f8",
}
LEAF = re.compile(r"lea[fv]|twig|foliage|needle", re.I)
NEITHER = re.compile(r"fruit|flower|blossom", re.I)


def part(positions, triangles, uv=None, normals=None):
    return SimpleNamespace(positions=positions, triangles=triangles, uv=uv, normals=normals)


def read(path):
    """The parts by name: those of an OBJ by its objects and groups, that of a PLY by the file's own name."""
    return read_obj(path) if str(path).endswith(".obj") else {str(path): read_ply(path)}


def read_ply(path):
    """A binary file of triangles. Raises ValueError where it is not one."""
    data = numpy.memmap(path, mode="r")
    end = bytes(data[:4096]).find(b"end_header\n")
    if end < 0 or bytes(data[:3]) != b"ply":
        raise ValueError(f"{path}: no header of a PLY file")
    end += len(b"end_header\n")
    elements = []
    for line in bytes(data[:end]).decode("ascii").splitlines():
        words = line.split()
        if words[0] == "format" and words[1] != "binary_little_endian":
            raise ValueError(f"{path}: {words[1]}; only binary_little_endian is read")
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property" and words[1] == "list":
            elements[-1][2].append((words[4], TYPES[words[2]], TYPES[words[3]]))
        elif words[0] == "property":
            elements[-1][2].append((words[2], None, TYPES[words[1]]))
    found = {}
    for name, count, properties in elements:
        found[name], end = ply_rows(data, end, count, properties)
    vertices, faces = found["vertex"], found["face"]
    triangles = faces["vertex_indices"].astype(numpy.int64)
    normals = uv = None
    if "nx" in vertices.dtype.names:
        normals = numpy.stack([vertices[k] for k in ("nx", "ny", "nz")], 1).astype(float)[triangles]
    if "texcoord" in (faces.dtype.names or ()):
        uv = faces["texcoord"].astype(float).reshape(-1, 3, 2)
    positions = numpy.stack([vertices[k] for k in ("x", "y", "z")], 1).astype(float)
    return part(positions, triangles, uv, normals)


def ply_rows(data, start, count, properties):
    """Rows of one element, all lists as long as those of its first row, and where it ends."""
    fields, at = [], start
    for name, length, kind in properties:
        if length is None:
            fields.append((name, "<" + kind))
            at += numpy.dtype(kind).itemsize
        else:
            size = int(numpy.frombuffer(data, "<" + length, 1, at)[0]) if count else 3
            fields += [(name + " length", "<" + length), (name, "<" + kind, (size,))]
            at += numpy.dtype(length).itemsize + size * numpy.dtype(kind).itemsize
    rows = numpy.frombuffer(data, numpy.dtype(fields), count, start)
    for name, length, _ in properties:
        if length is not None and (rows[name + " length"] != rows[name].shape[1]).any():
            raise ValueError("faces with more corners and faces with fewer; only triangles are read")
    return rows, start + rows.nbytes


def read_obj(path):
    """Polygons are cut into triangles from their first corner."""
    places, coordinates, directions, corners = [], [], [], {}
    name = "branches"
    with open(path, encoding="utf-8", errors="replace") as source:
        for line in source:
            key, _, rest = line.partition(" ")
            if key == "v":
                places.append(rest)
            elif key == "vt":
                coordinates.append(rest)
            elif key == "vn":
                directions.append(rest)
            elif key == "f":
                corner = [one.split("/") for one in rest.split()]
                for k in range(1, len(corner) - 1):
                    corners.setdefault(name, []).append((corner[0], corner[k], corner[k + 1]))
            elif key in ("o", "g"):
                name = rest.strip() or name
    tables = [numpy.array([row.split()[:n] for row in rows], float).reshape(-1, n)
              for rows, n in ((places, 3), (coordinates, 2), (directions, 3))]
    return {name: obj_part(tables, found) for name, found in corners.items()}


def obj_part(tables, corners):
    def indices(which):
        if any(len(c) <= which or not c[which] for triangle in corners for c in triangle):
            return None
        found = numpy.array([[int(c[which]) for c in triangle] for triangle in corners], numpy.int64)
        return numpy.where(found > 0, found - 1, found + len(tables[which]))

    places, uv, normals = (indices(k) for k in range(3))
    used, triangles = numpy.unique(places, return_inverse=True)
    return part(tables[0][used], triangles.reshape(-1, 3), None if uv is None else tables[1][uv],
                None if normals is None else tables[2][normals])


def joined(parts):
    """Several parts as one, or None; texture coordinates and normals where all have them."""
    parts = [p for p in parts if len(p.triangles)]
    if not parts:
        return None
    first = numpy.cumsum([0] + [len(p.positions) for p in parts])
    return part(
        numpy.concatenate([p.positions for p in parts]),
        numpy.concatenate([p.triangles + offset for p, offset in zip(parts, first)]),
        *(numpy.concatenate([getattr(p, k) for p in parts]) if all(getattr(p, k) is not None for p in parts) else None
          for k in ("uv", "normals")))


def bark_and_leaves(paths):
    """All parts of all files, joined: (bark, leaves), each None where there is none. Fruit and flowers are neither."""
    parts = [(name.rsplit("/", 1)[-1], p) for path in paths for name, p in read(path).items()]
    parts = [(name, p) for name, p in parts if not NEITHER.search(name)]
    return tuple(joined([p for name, p in parts if bool(LEAF.search(name)) == leafy]) for leafy in (False, True))


def write_ply(path, positions, triangles, corner_uv=None, vertex_normals=None):
    """Positions and normals one a vertex, texture coordinates three a triangle."""
    fields = [(k, "<f4") for k in "xyz"]
    columns = [positions[:, k] for k in range(3)]
    if vertex_normals is not None:
        fields += [("n" + k, "<f4") for k in "xyz"]
        columns += [vertex_normals[:, k] for k in range(3)]
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(positions)}"]
    header += [f"property float {name}" for name, _ in fields]
    header += [f"element face {len(triangles)}", "property list uchar int vertex_indices"]
    kinds = [("n", "u1"), ("corners", "<i4", 3)]
    if corner_uv is not None:
        header.append("property list uchar float texcoord")
        kinds += [("m", "u1"), ("uv", "<f4", 6)]
    vertices = numpy.empty(len(positions), fields)
    for (name, _), column in zip(fields, columns):
        vertices[name] = column
    faces = numpy.empty(len(triangles), kinds)
    faces["n"], faces["corners"] = 3, triangles
    if corner_uv is not None:
        faces["m"], faces["uv"] = 6, corner_uv.reshape(-1, 6)
    with open(path, "wb") as target:
        target.write(("\n".join(header) + "\nend_header\n").encode("ascii"))
        target.write(vertices.tobytes())
        target.write(faces.tobytes())
