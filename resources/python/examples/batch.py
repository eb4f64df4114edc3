"""A batch on all processors: one process a tree, a manifest of hashes, and a tree that fails does not stop the others."""
import hashlib
import json
import multiprocessing
import sys
from pathlib import Path

import ramure

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "batch")
JOBS = [(species, seed) for species in ("SilverBirch", "Hawthorn", "NoSuchTree") for seed in (1, 2, 3)]


def make(job):
    species, seed = job
    file = folder / f"{species}_{seed}.ply"
    try:
        ramure.grow(species, seed=seed, age=10).export(file, require_valid=True)
    except ramure.Error as error:
        return {"species": species, "seed": seed, "error": str(error)}
    return {"species": species, "seed": seed, "sha256": hashlib.sha256(file.read_bytes()).hexdigest()}


if __name__ == "__main__":
    folder.mkdir(exist_ok=True)
    with multiprocessing.Pool() as pool:
        rows = pool.map(make, JOBS, chunksize=1)
    (folder / "manifest.json").write_text(json.dumps(rows, indent=1), encoding="utf-8")
    print(sum("sha256" in row for row in rows), "of", len(rows), "trees in", folder)
