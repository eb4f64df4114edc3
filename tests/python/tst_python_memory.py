"""Trees that come and go leave nothing behind. RAMURE_TREES=1000 for the long run."""
import ctypes
import gc
import os
import unittest

import ramure

TREES = int(os.environ.get("RAMURE_TREES", "250"))


def resident():
    """Of what is in use: the allocator gives back what it only keeps for later, which differs by a megabyte from run to run."""
    gc.collect()
    ctypes.CDLL(None).malloc_trim(0)
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def use(seed):
    tree = ramure.grow("TinyTree", seed=seed % 7, progress=lambda share: None)
    tree.mesh()
    tree.leaves()
    tree.axes()
    tree.steps.add("sag").remove()
    tree.validate()
    try:
        tree["grammar.seed"] = -1
    except ramure.Error:
        pass
    try:
        tree.validate(crossings=True, progress=lambda share: 1 / 0)
    except ZeroDivisionError:
        pass


class Memory(unittest.TestCase):
    def test_a_loop_of_trees(self):
        for seed in range(150):  # what the allocator and NumPy keep once
            use(seed)
        before = resident()
        for seed in range(TREES):
            use(seed)
        grown = resident() - before
        print(f"{TREES} trees: {grown / 1024:.0f} KiB more")
        self.assertLess(grown, 1 << 20)


if __name__ == "__main__":
    unittest.main()
