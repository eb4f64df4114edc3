"""Where to stand for a close-up of bark: a tree's foot, its first fork, a limb and a twig.

The axes come from the skeleton that ramure-cli writes as lines, their radii from the vertices of the mesh beside them.
"""
import math

import numpy

ANGLE = 40.0
CLOSE_UPS = ("foot", "fork", "limb", "twig")


def lines_of(path):
    """Places, and for each the one below it."""
    places, below = [], {}
    for line in path.read_text().splitlines():
        words = line.split()
        if line.startswith("v "):
            places.append([float(w) for w in words[1:4]])
        elif line.startswith("l "):
            below[int(words[2]) - 1] = int(words[1]) - 1
    return numpy.array(places), below


class Skeleton:
    def __init__(self, path, vertices):
        self.places, self.below = lines_of(path)
        self.vertices = vertices
        self.above = {}
        for top, foot in self.below.items():
            self.above.setdefault(foot, []).append(top)
        self.weight = numpy.ones(len(self.places))
        for top in sorted(self.below, reverse=True):  # what is above has a higher number
            self.weight[self.below[top]] += self.weight[top]

    def radius(self, node):
        """Half of the ring of vertices around it lies nearer than that."""
        away = numpy.linalg.norm(self.vertices - self.places[node], axis=1)
        return float(numpy.sort(away)[:8].mean())

    def stem(self, node):
        """The way from there to a tip, always where more grows."""
        way = [node]
        while way[-1] in self.above:
            way.append(max(self.above[way[-1]], key=lambda n: self.weight[n]))
        return way

    def limbs(self, node):
        """What leaves there to the side, the heaviest first."""
        return sorted(self.above.get(node, []), key=lambda n: -self.weight[n])[1:]


def beside(target, along, distance, rise):
    """An eye to the side of a branch, a little above it."""
    side = numpy.cross(along, [0.0, 1.0, 0.0])
    if numpy.linalg.norm(side) < 0.2 * numpy.linalg.norm(along):
        side = numpy.array([math.sin(0.5), 0.0, math.cos(0.5)])
    side = side / numpy.linalg.norm(side)
    if side[2] < 0:
        side = -side  # where the sun is
    eye = target + distance * (side * math.cos(rise) + numpy.array([0.0, math.sin(rise), 0.0]))
    eye[1] = max(eye[1], 0.15)
    return eye, target


def close_ups(skeleton):
    """Eye and target of each."""
    places, trunk = skeleton.places, skeleton.stem(0)
    breast = min(trunk, key=lambda n: abs(places[n][1] - 1.3))
    thick = skeleton.radius(breast)
    up = numpy.array([0.0, 1.0, 0.0])
    out = {"foot": beside(places[0] + 2.5 * thick * up, up, max(10.0 * thick, 0.8), 0.25)}
    forks = [n for n in trunk[1:-1] if skeleton.limbs(n) and places[n][1] > 0.7]
    fork = max(forks, key=lambda n: skeleton.weight[skeleton.limbs(n)[0]], default=trunk[len(trunk) // 2])
    out["fork"] = beside(places[fork], up, max(8.0 * skeleton.radius(fork), 0.6), 0.15)
    limb = skeleton.stem(skeleton.limbs(fork)[0]) if skeleton.limbs(fork) else trunk[len(trunk) // 2:]
    at = limb[len(limb) // 4]
    along = places[limb[min(len(limb) // 4 + 1, len(limb) - 1)]] - places[skeleton.below[at]]
    out["limb"] = beside(places[at], along, max(10.0 * skeleton.radius(at), 0.4), 0.35)
    tip = limb[-min(3, len(limb))]
    along = places[limb[-1]] - places[skeleton.below[tip]]
    out["twig"] = beside(places[tip], along, 0.5, 0.35)
    return out
