"""A loop of wind as a GLB with an armature: four seconds that go on from their beginning without a seam."""
import sys
from pathlib import Path

import ramure

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "wind")
folder.mkdir(exist_ok=True)
tree = ramure.grow("SmallTree", seed=5)
tree["physics.windStrength"] = 6.0
shown = -1


def tell(share):
    global shown
    if int(share * 10) != shown:
        shown = int(share * 10)
        print(f"\r{shown * 10} %", end="", flush=True)


tree.export(folder / "wind.glb", wind_loop=4, fps=12, joints=64, map_size=0, progress=tell)
print("\r", (folder / "wind.glb").stat().st_size, "bytes")
