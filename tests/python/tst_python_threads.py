"""Progress, cancelling, and many threads and processes at once."""
import hashlib
import multiprocessing
import os
import pathlib
import signal
import tempfile
import threading
import unittest
from concurrent.futures import ThreadPoolExecutor

import ramure


class Stop(Exception):
    pass


def hash_of(seed):
    mesh = ramure.grow("TinyTree", seed=seed, parameters={"grammar.stochastic": True}).mesh()
    return hashlib.sha256(mesh.positions.tobytes() + mesh.triangles.tobytes()).hexdigest()


class Threads(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def test_progress_is_told(self):
        told = []
        tree = ramure.grow("SilverBirch", seed=1, age=8, progress=told.append)
        self.assertGreater(len(told), 3)
        self.assertTrue(all(0.0 <= share <= 1.0 for share in told))
        told.clear()
        tree.export(self.folder / "birch.glb", map_size=0, progress=told.append)
        self.assertGreater(max(told), 0.9)

    def test_a_callback_that_throws_ends_the_work(self):
        def stop(share):
            raise Stop(share)
        with self.assertRaises(Stop):
            ramure.grow("SilverBirch", seed=1, age=8, progress=stop)
        tree = ramure.grow("SilverBirch", seed=1, age=4)
        path = self.folder / "birch.glb"
        path.write_text("as before")
        for act in (lambda: tree.export(path, progress=stop), lambda: tree.validate(crossings=True, progress=stop),
                    lambda: tree.meshes(levels=2, progress=stop)):
            self.assertRaises(Stop, act)
        self.assertEqual(path.read_text(), "as before", "a file that was not finished is not there")
        self.assertEqual([one.name for one in self.folder.iterdir()], ["birch.glb"])
        tree["grammar.seed"] = 2
        self.assertRaises(Stop, lambda: tree.grow(progress=stop))
        self.assertTrue(tree.validate()["valid"], "the tree can be used afterwards")

    def test_it_throws_once_and_no_more(self):
        calls = []

        def late(share):
            calls.append(share)
            if share > 0.3:
                raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            ramure.grow("SilverBirch", seed=1, age=8, progress=late)
        self.assertEqual(sum(share > 0.3 for share in calls), 1)

    def test_ctrl_c_is_heard(self):
        calls = []

        def interrupt(share):
            calls.append(share)
            if len(calls) == 2:
                signal.raise_signal(signal.SIGINT)
        with self.assertRaises(KeyboardInterrupt):
            ramure.grow("SilverBirch", seed=1, age=8, progress=interrupt)

    def test_a_callback_that_uses_its_tree_is_told(self):
        tree = ramure.grow("TinyTree", seed=1)
        for use in (tree.info, tree.close, lambda: tree["grammar.seed"]):
            with self.assertRaises(ramure.Error):
                tree.validate(crossings=True, progress=lambda share: use())
        other = ramure.grow("TinyTree", seed=2)
        tree.validate(progress=lambda share: other.info())

    def test_others_run_while_it_works(self):
        tree = ramure.grow("SilverBirch", seed=1, age=4)
        counted, done = [0], threading.Event()

        def count():
            while not done.is_set():
                counted[0] += 1
        thread = threading.Thread(target=count)
        thread.start()
        seen = []
        tree.validate(crossings=True, progress=lambda share: seen.append(counted[0]))
        done.set()
        thread.join()
        self.assertGreater(seen[-1], seen[0])

    def test_threads_at_once_give_the_same_bytes(self):
        alone = [hash_of(seed) for seed in range(8)]
        self.assertEqual(len(set(alone)), 8)
        with ThreadPoolExecutor(8) as pool:
            for _ in range(3):
                self.assertEqual(list(pool.map(hash_of, range(8))), alone)

    def test_threads_at_one_tree(self):
        tree = ramure.grow("TinyTree", seed=1)
        problems = []

        def use(seed):
            try:
                for turn in range(6):
                    tree["grammar.seed"] = seed * 10 + turn
                    tree.mesh()
                    tree.steps.add("sag").remove()
                    tree.export(self.folder / f"{seed}.ply", progress=lambda share: None)
            except BaseException as problem:  # noqa: B902
                problems.append(problem)
        threads = [threading.Thread(target=use, args=(seed,)) for seed in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(problems, [])
        self.assertEqual(len(tree.steps), 1)

    def test_closing_while_another_thread_works(self):
        tree = ramure.grow("SilverBirch", seed=1, age=4)
        begun = threading.Event()
        closer = threading.Thread(target=lambda: (begun.wait(), tree.close()))
        closer.start()
        tree.validate(crossings=True, progress=lambda share: begun.set())
        closer.join()
        self.assertRaises(ramure.Error, tree.info)

    def test_processes_give_the_same_bytes(self):
        alone = [hash_of(seed) for seed in range(4)]  # the library's threads run by now
        for method in ("fork", "spawn"):
            with multiprocessing.get_context(method).Pool(2) as pool:
                self.assertEqual(pool.map(hash_of, range(4)), alone, method)

    def test_without_a_display(self):
        for name in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
            os.environ.pop(name, None)
        ramure.grow("TinyTree").export(self.folder / "tree.glb", map_size=64, levels=2, billboard=True)


if __name__ == "__main__":
    unittest.main()
