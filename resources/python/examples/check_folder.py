"""Are all meshes and projects of a folder closed? Ends with 1 where one is not, for continuous integration."""
import sys
from pathlib import Path

import ramure

folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
bad = 0
for path in sorted(folder.rglob("*")):
    if path.suffix.lower() not in (".ramure", ".obj", ".ply", ".glb", ".stl"):
        continue
    try:
        with ramure.open(path) as project:
            found = project.validate(crossings=True)
    except ramure.Error as error:
        print(f"{path.name}: {error.reason} (line {error.line}, {error.path or 'no place'})")
        bad += 1
        continue
    print(f"{path.name}: {found['verdict']}, {found['faces']} triangles, {found['selfIntersections']['total']} crossings")
    bad += not found["valid"]
sys.exit(1 if bad else 0)
