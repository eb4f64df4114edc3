"""Levels of detail for an engine: four meshes and a billboard in one GLB, with data for wind and convex collision."""
import sys
from pathlib import Path

import ramure

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "game")
folder.mkdir(exist_ok=True)
tree = ramure.grow("SilverBirch", seed=2, age=15)
levels = {"levels": 4, "budget": [20000, 8000, 3000, 1000], "leaf_cards": True, "billboard": True}
tree.export(folder / "birch.glb", **levels, wind="plain", collision="godot", map_size=512)

triangles = {}
for mesh in tree.meshes(**levels, texture=True):
    triangles[mesh.lod] = triangles.get(mesh.lod, 0) + len(mesh.triangles)
for lod, count in sorted(triangles.items()):
    print(f"LOD{lod}: {count} triangles")
assert list(triangles.values()) == sorted(triangles.values(), reverse=True)
