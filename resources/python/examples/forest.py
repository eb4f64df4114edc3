"""A forest of variants: three species, five seeds each, and a table that says where they stand."""
import csv
import random
import sys
from pathlib import Path

import ramure

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "forest")
folder.mkdir(exist_ok=True)
lots = random.Random(7)
models = []
for species in ("SilverBirch", "ScotsPine", "Hawthorn"):
    for seed in range(1, 6):
        tree = ramure.grow(species, seed=seed, age=lots.randint(8, 14), parameters={"mesh.targetTriangles": 20000})
        name = f"{species}_{seed}.glb"
        tree.export(folder / name, map_size=256, leaves="instances")
        models.append((name, tree.info()["measures"]["crownWidth"]))

places = []  # x, z, radius: nobody stands in another's crown
with open(folder / "places.csv", "w", newline="", encoding="utf-8") as file:
    table = csv.writer(file)
    table.writerow(["model", "x", "z", "turn"])
    while len(places) < 60:
        name, width = lots.choice(models)
        x, z, radius = lots.uniform(-40, 40), lots.uniform(-40, 40), width / 2
        if all((x - a) ** 2 + (z - b) ** 2 > (radius + c) ** 2 for a, b, c in places):
            places.append((x, z, radius))
            table.writerow([name, round(x, 2), round(z, 2), lots.randrange(360)])
print(f"{len(models)} models, {len(places)} places in {folder}")
