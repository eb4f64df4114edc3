"""A mesh in any format: the arrays are all that a writer needs. Here OBJ, in a dozen lines."""
import sys
from pathlib import Path

import ramure

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "plain")
folder.mkdir(exist_ok=True)
tree = ramure.grow("SilverBirch", seed=1, age=8)
bark, leaves = tree.mesh(), tree.leaves()
with open(folder / "birch.obj", "w", encoding="ascii") as file:
    def write(name, points, triangles, before):
        file.write(f"o {name}\n")
        file.writelines("v {:.6g} {:.6g} {:.6g}\n".format(*point) for point in points.tolist())
        file.writelines("f {} {} {}\n".format(*corners) for corners in (triangles + (1 + before)).tolist())
        return before + len(points)

    count = write("bark", bark.positions, bark.triangles, 0)
    for number, matrix in enumerate(leaves.matrices[::20]):  # every twentieth leaf
        corners = leaves.shape.positions @ matrix[:3, :3].T + matrix[:3, 3]
        count = write(f"leaf_{number}", corners, leaves.shape.triangles, count)
print(count, "points; read back:", ramure.open(folder / "birch.obj").info()["vertices"])
