"""A recipe by script: limbs that sag, twigs that wander, and a storm that broke the longest limb of three trees."""
import sys
from pathlib import Path

import numpy
import ramure

folder = Path(sys.argv[1] if len(sys.argv) > 1 else "storm")
folder.mkdir(exist_ok=True)
for seed in (1, 2, 3):
    tree = ramure.grow("SmallTree", seed=seed)
    tree.steps.add("gnarl", {"gnarl.angle": 0.2}, name="Twigs wander")
    sag = tree.steps.add("sag", {"sag.amount": 0.4})
    axes = tree.axes()
    limbs = numpy.flatnonzero(axes.order == 1)
    longest = limbs[numpy.argmax(axes.length[limbs])]
    tree.edit({"op": "cut", "target": f"{axes.address[longest]:016x}", "at": 0.3, "name": "Storm"})
    sag.move(1)  # before the twigs
    tree.save(folder / f"storm_{seed}.ramure")
    print(seed, [(step.name, step.state) for step in tree.steps])
