"""Twenty seeds of a species, measured with NumPy: which of them is the most usual tree?"""
import sys
from pathlib import Path

import numpy
import ramure

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "sweep")
folder.mkdir(exist_ok=True)
rows = []
for seed in range(20):
    bones = ramure.grow("Hawthorn", seed=seed, age=12).skeleton()
    lengths = numpy.linalg.norm(bones.end - bones.start, axis=1)
    wood = numpy.pi * lengths * (bones.start_radius**2 + bones.start_radius * bones.end_radius + bones.end_radius**2) / 3
    spread = numpy.hypot(bones.end[:, 0], bones.end[:, 2]).max()
    rows.append((len(bones), bones.end[:, 1].max(), spread, wood.sum() * 1000))
table = numpy.array(rows)
numpy.savetxt(folder / "hawthorns.csv", table, "%.4g", ",", header="branches,height,spread,litres", comments="")
unusual = numpy.abs((table - table.mean(0)) / table.std(0)).max(1)
print("mean:", table.mean(0).round(2), "deviation:", table.std(0).round(2))
print("the most usual seed is", unusual.argmin(), "and the oddest", unusual.argmax())
