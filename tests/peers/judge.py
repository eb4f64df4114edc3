#!/usr/bin/env python3
"""What a tree's mesh is worth, whoever made it: judge.py FILE.ply|FILE.obj... [--up z] prints one JSON object.
Parts whose names speak of leaves or twigs are foliage, all others bark. Nothing here is of Ramure: it knows positions,
triangles, texture coordinates and normals. See judgement() for what each number is."""

import argparse
import json

import numpy

import mesh_files

WELD = 1e-6  # of the box' diagonal: corners so near to each other are one place
SAMPLE = 20000  # triangles, evenly strewn, whose crossings are looked for; and leaves that are measured


def components(count, first, second):
    """A number for each of count things, the same where links first-second join them."""
    root = numpy.arange(count)
    while len(first):
        first, second = root[first], root[second]
        apart = first != second
        first, second = first[apart], second[apart]
        root[numpy.maximum(first, second)] = numpy.minimum(first, second)
        while True:
            further = root[root]
            if (further == root).all():
                break
            root = further
    return root


def welded(positions):
    """For each vertex the number of its place."""
    low = positions.min(0)
    cell = max(float(numpy.linalg.norm(positions.max(0) - low)) * WELD * 2, 1e-300)
    count = len(positions)
    links = []
    # Whatever is nearer than half a cell shares one in at least one of eight grids.
    for shift in range(8):
        offset = [(shift >> k & 1) * 0.5 for k in range(3)]
        grid = numpy.floor((positions - low) / cell + offset).astype(numpy.int64)
        key = (grid[:, 0] << 42) | (grid[:, 1] << 21) | grid[:, 2]
        order = numpy.argsort(key, kind="stable")
        same = numpy.flatnonzero(key[order][1:] == key[order][:-1])
        links.append((order[same], order[same + 1]))
    root = components(count, *(numpy.concatenate([link[k] for link in links]) for k in (0, 1)))
    return numpy.unique(root, return_inverse=True)[1]


def exact_places(positions):
    """As welded(), but only vertices with the same three numbers; fast where there are millions."""
    bits = (positions.astype(numpy.float32) + 0.0).view(numpy.uint32).astype(numpy.int64)
    plane = numpy.unique(bits[:, 0] << 32 | bits[:, 1], return_inverse=True)[1]
    return numpy.unique(plane << 32 | bits[:, 2], return_inverse=True)[1]


def topology(triangles, places):
    """Of triangles whose three corners are different places."""
    count = int(places.max()) + 1 if len(places) else 0
    start, end = triangles, numpy.roll(triangles, -1, 1)
    low, high = numpy.minimum(start, end).ravel(), numpy.maximum(start, end).ravel()
    forward = (start < end).ravel()
    corner = numpy.arange(3 * len(triangles)).reshape(-1, 3)
    onward = numpy.roll(corner, -1, 1)
    at_low = numpy.where(forward, corner.ravel(), onward.ravel())
    at_high = numpy.where(forward, onward.ravel(), corner.ravel())
    order = numpy.argsort(low * count + high, kind="stable")
    key = (low * count + high)[order]
    begins = numpy.flatnonzero(numpy.r_[True, key[1:] != key[:-1]])
    uses = numpy.diff(numpy.r_[begins, len(key)])
    ahead = numpy.add.reduceat(forward[order].astype(int), begins) if len(begins) else uses
    next_ = numpy.flatnonzero(key[1:] == key[:-1])
    links = [numpy.r_[at_low[order[next_]], at_high[order[next_]]],
             numpy.r_[at_low[order[next_ + 1]], at_high[order[next_ + 1]]]]
    fans = components(3 * len(triangles), *links)
    pairs = numpy.unique(triangles.ravel() * (3 * len(triangles) + 1) + fans)
    at_vertex = numpy.bincount(pairs // (3 * len(triangles) + 1), minlength=count)
    return {
        "boundaryEdges": int((uses == 1).sum()),
        "crowdedEdges": int((uses > 2).sum()),
        "turnedEdges": int(((uses == 2) & (ahead != 1)).sum()),
        "bowTies": int((at_vertex > 1).sum()),
    }


def pieces_of(triangles, count):
    """For each triangle the number of its connected piece, and how many there are."""
    root = components(count, *(triangles[:, [0, 1]].ravel(), triangles[:, [1, 2]].ravel()))
    found, piece = numpy.unique(root[triangles[:, 0]], return_inverse=True)
    return piece, len(found)


def inside_out(points, piece, pieces):
    """Pieces whose faces look inwards: the volume around their own middle is negative."""
    middle = numpy.stack([numpy.bincount(piece, points.mean(1)[:, k], pieces) for k in range(3)], 1)
    middle /= numpy.bincount(piece, minlength=pieces)[:, None]
    a, b, c = (points[:, k] - middle[piece] for k in range(3))
    volume = numpy.bincount(piece, numpy.einsum("ij,ij->i", a, numpy.cross(b, c)) / 6, pieces)
    return int((volume < 0).sum()), float(volume.sum())


def boxes_above(low, high):
    """Levels of boxes, each of two of the level below; the first is that of the triangles."""
    levels = [(low, high)]
    while len(levels[-1][0]) > 1:
        low, high = levels[-1]
        if len(low) % 2:
            low, high = numpy.r_[low, low[-1:]], numpy.r_[high, high[-1:]]
        levels.append((numpy.minimum(low[::2], low[1::2]), numpy.maximum(high[::2], high[1::2])))
    return levels


def nearness(points):
    """A function that gives for some triangles the pairs (one of them, any triangle) whose boxes touch."""
    low, high = points.min(1), points.max(1)
    size = numpy.maximum((high.max(0) - low.min(0)), 1e-300)
    grid = (((low + high) / 2 - low.min(0)) / size * 1023).astype(numpy.int64)
    code = numpy.zeros(len(points), numpy.int64)
    for bit in range(10):
        for axis in range(3):
            code |= (grid[:, axis] >> bit & 1) << (3 * bit + axis)
    order = numpy.argsort(code, kind="stable")
    levels = boxes_above(low[order], high[order])

    def pairs(queries):
        query, node = queries, numpy.zeros(len(queries), numpy.int64)
        for depth in range(len(levels) - 1, -1, -1):
            low_, high_ = levels[depth]
            there = node < len(low_)
            query, node = query[there], node[there]
            touch = ((low[query] <= high_[node]) & (high[query] >= low_[node])).all(1)
            query, node = query[touch], node[touch]
            if depth:
                query, node = numpy.repeat(query, 2), numpy.repeat(node * 2, 2)
                node[1::2] += 1
        return query, order[node]

    return pairs


def edges_through(edges, others):
    """Whether any edge of the one triangle goes through the other, pair by pair."""
    a = others[:, 0]
    u, v = others[:, 1] - a, others[:, 2] - a
    hit = numpy.zeros(len(edges), bool)
    for k in range(3):
        start, along = edges[:, k], edges[:, (k + 1) % 3] - edges[:, k]
        p = numpy.cross(along, v)
        det = numpy.einsum("ij,ij->i", u, p)
        with numpy.errstate(divide="ignore", invalid="ignore"):
            s = numpy.einsum("ij,ij->i", start - a, p) / det
            q = numpy.cross(start - a, u)
            t = numpy.einsum("ij,ij->i", along, q) / det
            r = numpy.einsum("ij,ij->i", v, q) / det
            hit |= (s > 0) & (t > 0) & (s + t < 1) & (r > 0) & (r < 1)
    return hit


def crossings(points, triangles):
    """How many of 1,000 triangles go through another that shares no corner with them."""
    queries = numpy.unique(numpy.linspace(0, len(points) - 1, min(SAMPLE, len(points))).astype(numpy.int64))
    crossing = numpy.zeros(len(points), bool)
    pairs = nearness(points)
    for some in numpy.array_split(queries, max(1, len(queries) // 2000)):
        query, other = pairs(some)
        shared = (triangles[query][:, :, None] == triangles[other][:, None, :]).any((1, 2))
        query, other = query[~shared], other[~shared]
        for part in range(0, len(query), 500000):
            one, two = query[part:part + 500000], other[part:part + 500000]
            hit = edges_through(points[one], points[two]) | edges_through(points[two], points[one])
            crossing[one[hit]] = True
    return {"crossing": 1000 * float(crossing.sum()) / len(queries), "crossingSample": len(queries)}


def share(values, weights, part):
    order = numpy.argsort(values)
    return float(values[order][numpy.searchsorted(numpy.cumsum(weights[order]), part * weights.sum())])


def texture(points, uv, area):
    """How evenly the texture lies: of square roots of area in it over area in space, the larger tenth over the smaller."""
    first, second = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    flat = numpy.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / 2
    solid = area > 0
    scale = numpy.sqrt(flat[solid] / area[solid])
    small, large = (share(scale, area[solid], part) for part in (0.1, 0.9))
    return {"textureSpread": large / small if small > 0 else None, "texturePerMetre": share(scale, area[solid], 0.5)}


def normals(points, given):
    """The part of all corners whose normal looks to the other side of its face."""
    face = numpy.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0])
    facing = numpy.einsum("ik,ijk->ij", face, given)
    return {"normalsAway": float((facing < 0).mean())}


def each_once(triangles):
    """Which triangles to keep so that no three places have two."""
    rows = numpy.sort(triangles, 1)
    edge = numpy.unique(rows[:, 0] * (rows.max() + 1) + rows[:, 1], return_inverse=True)[1]
    return numpy.unique(edge * (rows.max() + 1) + rows[:, 2], return_index=True)[1]


def hull_area(points):
    """Of the convex hull of points in the plane (Andrew's monotone chain)."""
    points = numpy.unique(numpy.round(points, 6), axis=0).tolist()
    if len(points) < 3:
        return 0.0
    def chain(rows):
        out = []
        for x, y in rows:
            while len(out) > 1 and ((out[-1][0] - out[-2][0]) * (y - out[-2][1])
                                    <= (out[-1][1] - out[-2][1]) * (x - out[-2][0])):
                out.pop()
            out.append((x, y))
        return out[:-1]
    hull = numpy.array(chain(points) + chain(points[::-1]))
    x, y = hull[:, 0], hull[:, 1]
    return float(abs(numpy.dot(x, numpy.roll(y, -1)) - numpy.dot(y, numpy.roll(x, -1))) / 2)


def foliage(leaves, up):
    """The median greatest length of connected pieces, their area on one side, and that over the ground below the crown."""
    places = exact_places(leaves.positions)
    triangles = places[leaves.triangles]
    count = int(places.max()) + 1
    where = numpy.empty((count, 3))
    where[places] = leaves.positions
    points = where[triangles]
    area = numpy.linalg.norm(numpy.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]), axis=1) / 2
    once = each_once(triangles)
    piece, pieces = pieces_of(triangles, count)
    chosen = numpy.zeros(pieces, bool)
    chosen[numpy.linspace(0, pieces - 1, min(SAMPLE, pieces)).astype(int)] = True
    kept = chosen[piece]
    ground = where[numpy.unique(triangles)][:, [k for k in range(3) if k != up]]
    below = hull_area(ground[:: max(1, len(ground) // 200000)])
    return {
        "leafTriangles": len(triangles),
        "leaves": pieces,
        "leafReach": float(numpy.median(reaches(points[kept], piece[kept]))),
        "leafArea": float(area[once].sum()),
        "leafAreaIndex": float(area[once].sum()) / below if below > 0 else None,
    }


def reaches(points, piece):
    """For each piece about its greatest length: from the corner farthest from its middle to the one farthest from there."""
    owner = numpy.repeat(numpy.unique(piece, return_inverse=True)[1], 3)
    corners = points.reshape(-1, 3)
    count = int(owner.max()) + 1

    def farthest(origin):
        distance = numpy.linalg.norm(corners - origin[owner], axis=1)
        order = numpy.lexsort((distance, owner))
        last = order[numpy.r_[owner[order][1:] != owner[order][:-1], True]]
        return corners[last], distance[last]

    middle = numpy.stack([numpy.bincount(owner, corners[:, k], count) for k in range(3)], 1)
    end, _ = farthest(middle / numpy.bincount(owner)[:, None])
    return farthest(end)[1]


def judgement(bark, leaves, up):
    """Numbers of the bark as it is when corners in one place are one vertex: edges with one face (boundaryEdges), with
    more than two (crowdedEdges), with two that run the same way (turnedEdges); vertices where faces meet in two fans or
    more (bowTies); pieces, and those inside out; vertices in the place of another (extraVertices) and all vertices;
    faces twice, faces without area (flatFaces); triangles of 1,000 that cross others; then texture, normals, foliage."""
    out = {"height": 0.0}
    if bark is not None:
        places = welded(bark.positions)
        triangles = places[bark.triangles]
        points = bark.positions[bark.triangles]
        area = numpy.linalg.norm(numpy.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]), axis=1) / 2
        whole = ((triangles[:, 0] != triangles[:, 1]) & (triangles[:, 1] != triangles[:, 2])
                 & (triangles[:, 2] != triangles[:, 0]))
        used = numpy.unique(bark.triangles)
        piece, pieces = pieces_of(triangles, int(places.max()) + 1)
        wrong, volume = inside_out(points, piece, pieces)
        out = {
            "height": float(numpy.ptp(bark.positions[:, up])),
            "triangles": len(triangles),
            "vertices": len(used),
            "extraVertices": int(len(used) - len(numpy.unique(places[used]))),
            "pieces": pieces,
            "piecesInsideOut": wrong,
            "volume": volume,
            "facesTwice": int(whole.sum()) - len(each_once(triangles[whole])),
            "flatFaces": int((~whole | (area == 0)).sum()),
            **topology(triangles[whole], places),
            **crossings(points[whole], triangles[whole]),
        }
        if bark.uv is not None:
            out.update(texture(points, bark.uv, area))
        if bark.normals is not None:
            out.update(normals(points, bark.normals))
    if leaves is not None:
        out.update(foliage(leaves, up))
        out["leafTexture"] = leaves.uv is not None
    return out


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("files", nargs="+")
    parser.add_argument("--up", choices="xyz", default="y")
    given = parser.parse_args()
    print(json.dumps(judgement(*mesh_files.bark_and_leaves(given.files), "xyz".index(given.up))))
