"""What a tree is made of, as arrays of NumPy. They share the memory of the library, cannot be written, and stay good
whatever becomes of the tree. Lengths are metres, Y points up; a number of -1 is none."""
from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Optional

import numpy


def _of(kind: type, arrays: dict) -> Any:
    return kind(**{field.name: arrays[field.name] for field in fields(kind) if field.name in arrays})


@dataclass(frozen=True, eq=False)
class Mesh:
    """A mesh of triangles, counter-clockwise seen from outside."""
    positions: numpy.ndarray  #: float32, n x 3
    triangles: numpy.ndarray  #: uint32, m x 3
    normals: Optional[numpy.ndarray] = None  #: float32, n x 3
    uv: Optional[numpy.ndarray] = None  #: float32, k x 2; k is n where uv_triangles is None
    uv_triangles: Optional[numpy.ndarray] = None  #: uint32, m x 3: the corners' rows of uv
    branch: Optional[numpy.ndarray] = None  #: int32, n: the row of the simplified skeleton
    level: Optional[numpy.ndarray] = None  #: int32, n: how many forks lie below
    radius: Optional[numpy.ndarray] = None  #: float32, n: of the wood
    colours: Optional[numpy.ndarray] = None  #: uint8, m x 3, sRGB
    name: str = ""  #: "branches", "cuts", "leaves", "fruit", "billboard"
    lod: int = 0  #: level of detail, 0 is the finest


@dataclass(frozen=True, eq=False)
class Copies:
    """Leaves or fruit: copies of one shape."""
    shape: Mesh
    kind: str  #: "oak", "acorn"
    matrices: numpy.ndarray  #: float64, n x 4 x 4: points of the shape, as columns, into the tree
    tint: numpy.ndarray  #: float32, n x 3: times the shape's colour
    branch: numpy.ndarray  #: int32, n: the row of the simplified skeleton

    def __len__(self) -> int:
        return len(self.matrices)


@dataclass(frozen=True, eq=False)
class Skeleton:
    """Branches from their foot to their tip, a row each; parents stand before children."""
    parent: numpy.ndarray  #: int32
    start: numpy.ndarray  #: float64, n x 3
    end: numpy.ndarray  #: float64, n x 3
    start_radius: numpy.ndarray  #: float64
    end_radius: numpy.ndarray  #: float64
    level: numpy.ndarray  #: int32: 0 is the trunk
    key: numpy.ndarray  #: uint64: a name that stays when the tree changes elsewhere

    def __len__(self) -> int:
        return len(self.parent)


@dataclass(frozen=True, eq=False)
class Axes:
    """Stems as an artist sees them: branches that continue each other, a row each; parents stand before children."""
    address: numpy.ndarray  #: uint64: its name, as info(axes=True) writes it in hexadecimal digits
    parent: numpy.ndarray  #: int32
    order: numpy.ndarray  #: int32: 0 is the trunk
    place: numpy.ndarray  #: float64, m from the foot of the parent
    share: numpy.ndarray  #: float64: the same of the parent's length
    down_angle: numpy.ndarray  #: float64, rad against the parent
    azimuth: numpy.ndarray  #: float64, rad about it
    length: numpy.ndarray  #: float64, m
    radius: numpy.ndarray  #: float64, m at the foot
    first: numpy.ndarray  #: int32: where its rows in `branches` begin
    count: numpy.ndarray  #: int32: how many they are
    branches: numpy.ndarray  #: int32: rows of the skeleton, axis by axis
    axis_of_branch: numpy.ndarray  #: int32, a row each branch

    def __len__(self) -> int:
        return len(self.address)


def mesh(arrays: dict) -> Mesh:
    return _of(Mesh, arrays)


def copies(arrays: dict) -> Copies:
    return _of(Copies, {**arrays, "shape": mesh(arrays["shape"])})


def skeleton(arrays: dict) -> Skeleton:
    return _of(Skeleton, arrays)


def axes(arrays: dict) -> Axes:
    return _of(Axes, arrays)
