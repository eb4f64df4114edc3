"""The frames of a film: one tree, a mesh for every second year of its life."""
import sys
from pathlib import Path

import ramure

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "growth")
folder.mkdir(exist_ok=True)
tree = ramure.grow("SilverBirch", seed=4, age=2, parameters={"mesh.targetTriangles": 0})
for frame, age in enumerate(range(2, 21, 2)):
    tree["growth.age"] = age
    tree.export(folder / f"birch_{frame:04}.obj", map_size=0, part="branches")
    height = tree.info()["measures"]["height"]
    print(f"{age:3} years: {height:5.2f} m")
