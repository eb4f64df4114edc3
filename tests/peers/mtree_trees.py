#!/usr/bin/env python3
"""Trees of the library inside the Blender add-on Modular Tree, without Blender: mtree_trees.py WHAT SEED FOLDER SOURCE.
SOURCE is a checkout, its compiled library beside it. WHAT is one of its presets, put together as the add-on's own "quick
generate" does: trunk, branches and, where the preset has them, twigs; 32 corners a ring, 4 rounds of smoothing. Writes
FOLDER/bark.ply and prints one line of JSON. The add-on's leaves are made by Blender's nodes and are not here."""

import importlib.util
import json
import os
import sys
import time
import types

import numpy

import mesh_files


def presets_of(source, library):
    """The add-on's table of presets, which asks for the library by a wrapper."""
    for name in ("mtree", "mtree.presets", "mtree.m_tree_wrapper"):
        sys.modules[name] = types.ModuleType(name)
        sys.modules[name].__path__ = []
    sys.modules["mtree.m_tree_wrapper"].lazy_m_tree = library
    place = os.path.join(source, "python_classes", "presets", "tree_presets.py")
    spec = importlib.util.spec_from_file_location("mtree.presets.tree_presets", place)
    found = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = found
    spec.loader.exec_module(found)
    return found


def grown(m_tree, presets, what, seed):
    tree, trunk, branches = m_tree.Tree(), m_tree.TrunkFunction(), m_tree.BranchFunction()
    trunk.seed, branches.seed = seed, seed + 1
    presets.apply_trunk_preset(trunk, what)
    presets.apply_preset(branches, what)
    trunk.add_child(branches)
    if presets.TREE_PRESETS[what].sub_branches:
        twigs = m_tree.BranchFunction()
        twigs.seed = seed + 2
        presets.apply_sub_branch_preset(twigs, what)
        branches.add_child(twigs)
    tree.set_trunk_function(trunk)
    tree.execute_functions()
    mesher = m_tree.ManifoldMesher()
    mesher.radial_n_points, mesher.smooth_iterations = 32, 4
    return mesher.mesh_tree(tree)


if __name__ == "__main__":
    what, seed, folder, source = sys.argv[1:]
    sys.path.insert(0, os.path.dirname(source))
    import m_tree

    presets = presets_of(source, m_tree)
    begun = time.perf_counter()
    mesh = grown(m_tree, presets, what, int(seed))
    seconds = time.perf_counter() - begun
    quads = mesh.get_polygons().reshape(-1, 4).astype(numpy.int64)
    uv = mesh.get_uvs().reshape(-1, 2)[mesh.get_uv_loops().reshape(-1, 4)]
    cut = [[2, 1, 0], [3, 2, 0]]  # the add-on turns faces about, too
    mesh_files.write_ply(os.path.join(folder, "bark.ply"), mesh.get_vertices().reshape(-1, 3),
                         quads[:, cut].reshape(-1, 3), uv[:, cut].reshape(-1, 3, 2))
    print(json.dumps({"seconds": seconds}))
