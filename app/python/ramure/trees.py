"""Trees and projects."""
from __future__ import annotations

import json
import os
import warnings
from typing import Any, Callable, List, Mapping, Optional, Union

from . import _ramure, meshes, options
from .errors import Error
from .steps import Steps

Progress = Optional[Callable[[float], Any]]
Path = Union[str, "os.PathLike[str]"]


def _name(path: Path) -> bytes:
    name = os.fsencode(path)
    if b"\0" in name:
        raise ValueError("embedded null byte")
    return name


class Project:
    """What a file holds, or the scene of one tree. All functions may be called from any thread; one project works for one
    at a time.

    progress is a function that is called now and then with the share that is done, 0 to 1. What it raises ends the work
    and comes out of the function."""

    def __init__(self, work: Any, only: int = 0):
        self._work, self._only = work, only

    def __enter__(self) -> "Project":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<ramure.Project of {len(self.trees)} trees>"

    @property
    def trees(self) -> List["Tree"]:
        """Its trees, in their order."""
        return [Tree(self._work, number, name) for number, name in self._work.trees()]

    def export(self, path: Union[Path, List[Path]], *, progress: Progress = None, **keywords: Any) -> Optional[dict]:
        """Writes a file, or several, as `ramure-cli export` does: the same bytes. The keywords are its options, with _ for -:
        export("oak.glb", levels=3, budget=[40000, 10000, 2500], billboard=True). export_options() lists them.

        Returns the report of a print. What the command line would remark is a warning."""
        paths = list(path) if isinstance(path, (list, tuple)) else [path]
        if keywords.get("print"):
            keywords["json"] = True
        words = options.words(keywords) + [b"--output=" + _name(each) for each in paths]
        report, notes = self._work.export(self._only, words, progress)
        for note in notes:
            warnings.warn(note, stacklevel=2)
        return json.loads(report) if report else None

    def validate(self, *, crossings: bool = False, texture: bool = False, progress: Progress = None) -> dict:
        """Checks the meshes, as `ramure-cli validate --json` does: "valid", "verdict", and a count for each kind of defect.

        crossings  also counts triangles that run through each other (--self-intersections)
        texture    also says how texture coordinates fit"""
        return json.loads(self._work.validate(self._only, crossings, texture, progress))

    def info(self, *, axes: bool = False, progress: Progress = None) -> dict:
        """Counts and measures, as `ramure-cli info --json` prints them."""
        return json.loads(self._work.info(axes, progress))

    def save(self, path: Path) -> None:
        """Writes a .ramure file, which the editor opens."""
        self._work.save(_name(path))

    def close(self) -> None:
        """Gives the memory back. Arrays stay good; all else raises Error from then on."""
        self._work.close()


class Tree(Project):
    """One tree. tree["growth.age"] reads a parameter, tree["growth.age"] = 80 sets it; the tree grows anew when it is
    next looked at."""

    def __init__(self, work: Any, number: int, name: str):
        super().__init__(work, number)
        self._id, self.name = number, name

    def __enter__(self) -> "Tree":
        return self

    def __repr__(self) -> str:
        return f"<ramure.Tree {self.name}>"

    def __getitem__(self, key: str) -> Any:
        return self._work.value(self._id, key)

    def __setitem__(self, key: str, value: Any) -> None:
        self._work.set_value(self._id, key, value)

    def set(self, values: Mapping[str, Any]) -> "Tree":
        """Sets several parameters, one after the other."""
        for key, value in values.items():
            self[key] = value
        return self

    @property
    def steps(self) -> Steps:
        """Its recipe."""
        return Steps(self._work, self._id)

    def edit(self, *lines: Mapping[str, Any]) -> None:
        """What a hand does: each line is one of a script of `ramure-cli edit`, such as
        {"op": "cut", "target": "00c0ffee00c0ffee", "at": 0.5}. All lines together, or none."""
        self._work.edit(self._id, "\n".join(json.dumps(dict(line)) for line in lines))

    def grow(self, *, progress: Progress = None) -> "Tree":
        """Grows it, if it has not been since its last change: whatever is asked of it next is there at once."""
        self._work.grow(self._id, progress)
        return self

    def mesh(self, *, texture: bool = False, progress: Progress = None) -> meshes.Mesh:
        """The one closed mesh of all branches."""
        words = [b"--part=branches", b"--texture" if texture else b"--no-texture"]
        return meshes.mesh(self._work.meshes(self._id, words, progress)[0])

    def meshes(self, *, progress: Progress = None, **keywords: Any) -> List[meshes.Mesh]:
        """All meshes that export() would write with these options: levels=3, leaves="merged" ..."""
        return [meshes.mesh(each) for each in self._work.meshes(self._id, options.words(keywords), progress)]

    def leaves(self, *, texture: bool = False, progress: Progress = None) -> Optional[meshes.Copies]:
        """Its leaves as copies of one; None: it has none."""
        found = self._work.copies(self._id, texture, progress)
        return meshes.copies(found["leaves"]) if "leaves" in found else None

    def fruit(self, *, texture: bool = False, progress: Progress = None) -> Optional[meshes.Copies]:
        """Its fruit and flowers, likewise."""
        found = self._work.copies(self._id, texture, progress)
        return meshes.copies(found["fruit"]) if "fruit" in found else None

    def skeleton(self, *, simplified: bool = False, progress: Progress = None) -> meshes.Skeleton:
        """Its branches. simplified: nearly straight runs are one branch, as the mesh counts them."""
        return meshes.skeleton(self._work.skeleton(self._id, simplified, progress))

    def axes(self, *, progress: Progress = None) -> meshes.Axes:
        """The stems of skeleton()."""
        return meshes.axes(self._work.axes(self._id, progress))


def presets() -> List[dict]:
    """The trees that ship with the program: "name", "latin", "group", "description", and "ages" (young, mature, old) of
    those that grow by years."""
    return _ramure.presets()


def parameters() -> List[dict]:
    """All parameters of trees and of steps: "key", "label", "help", "type", "default", "range" or "choices"."""
    return _ramure.parameters()


def open(path: Path, *, progress: Progress = None) -> Project:  # noqa: A001
    """Opens a .ramure file, a mesh file, or "preset:NAME" or "demo:NAME"."""
    return Project(_ramure.open(_name(path), progress))


def grow(species: str, *, seed: Optional[int] = None, age: Optional[float] = None,
         parameters: Optional[Mapping[str, Any]] = None, progress: Progress = None) -> Tree:
    """Grows a tree of a species that ships with the program.

    seed        another seed is another tree of the species
    age         in years, of species that grow by years
    parameters  further ones by their keys, such as {"mesh.targetTriangles": 20000}"""
    if not isinstance(species, str):
        raise TypeError(f"the name of a species expected, not {type(species).__name__}")
    names = [preset["name"] for preset in _ramure.presets()]
    if species not in names:
        raise Error(f'there is no species "{species}"' + (options.near(species, names) or
                                                            ": presets() lists those there are"), "unknown")
    work = _ramure.open(b"preset:" + species.encode(), None)
    tree = Tree(work, *work.trees()[0])
    if seed is not None:
        tree["grammar.seed"] = seed
    if age is not None:
        tree["growth.age"] = age
    return tree.set(parameters or {}).grow(progress=progress)
