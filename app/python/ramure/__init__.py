"""Ramure for Python: trees, grown by the code of the editor and of ramure-cli, with the same bytes.

    import ramure
    tree = ramure.grow("EnglishOak", seed=3, age=60)
    tree.export("oak.glb", levels=3)
"""
from .version import __version__

from . import _ramure

if _ramure.version != __version__:
    raise ImportError(f"ramure {__version__} finds the library of version {_ramure.version} ({_ramure.__file__}): parts of "
                      "two installations are mixed")

from .errors import Error
from .meshes import Axes, Copies, Mesh, Skeleton
from .options import export_options
from .program import check_program
from .steps import Step, Steps, step_kinds
from .trees import Project, Tree, grow, open, parameters, presets

__all__ = ["Axes", "Copies", "Error", "Mesh", "Project", "Skeleton", "Step", "Steps", "Tree", "__version__",
           "check_program", "export_options", "grow", "open", "parameters", "presets", "step_kinds"]
