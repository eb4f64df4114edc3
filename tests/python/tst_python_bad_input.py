"""What is refused, and how it is told."""
import gc
import json
import os
import pathlib
import tempfile
import unittest

import numpy
import ramure

NAN, INFINITE = float("nan"), float("inf")


class BadInput(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tree = ramure.grow("TinyTree", seed=1)
        cls.birch = ramure.grow("SilverBirch", seed=1, age=2)

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def refused(self, code, act, **facts):
        with self.assertRaises(ramure.Error) as caught:
            act()
        self.assertEqual(caught.exception.code, code, str(caught.exception))
        self.assertTrue(caught.exception.reason)
        self.assertIn(caught.exception.reason, str(caught.exception))
        for name, value in facts.items():
            self.assertEqual(getattr(caught.exception, name), value)
        return str(caught.exception)

    def test_species(self):
        for wrong, right in (("englishoak", "EnglishOak"), ("SilverBrich", "SilverBirch"), ("Tiny Tree", "TinyTree"),
                             ("Oak", "RedOak")):
            self.assertIn(right, self.refused("unknown", lambda: ramure.grow(wrong)))
        for wrong in ("", "Zzzzzzz", "preset:TinyTree", "Tiny\0Tree", "\udc80", "x" * 100000):
            self.refused("unknown", lambda: ramure.grow(wrong))
        for wrong in (None, 3, b"TinyTree", ["TinyTree"]):
            with self.assertRaises(TypeError):
                ramure.grow(wrong)

    def test_numbers(self):
        for age in (-1, -0.001, NAN, INFINITE, -INFINITE, 1e9):
            self.refused("invalid", lambda: ramure.grow("SilverBirch", age=age), path="growth.age")
        for seed in (-1, 2**63, -2**70, 10**30):
            self.refused("invalid", lambda: ramure.grow("TinyTree", seed=seed), path="grammar.seed")
        for seed in (1.5, "3", True, [1], numpy.float64(2), 1j):
            with self.assertRaises(TypeError):
                ramure.grow("TinyTree", seed=seed)
        for age in ("60", True, [60], {}, 1j, b"6"):
            with self.assertRaises(TypeError):
                ramure.grow("SilverBirch", age=age)
        self.refused("unknown", lambda: ramure.grow("SilverBirch1995", age=30))

    def test_numbers_of_numpy_are_numbers(self):
        tree = ramure.grow("SilverBirch", seed=numpy.int32(4), age=numpy.float32(3))
        self.assertEqual((tree["grammar.seed"], tree["growth.age"]), (4, 3.0))
        tree["simplify.enabled"] = numpy.bool_(False)
        tree["local.translation"] = numpy.array([1.0, 2.0, 3.0])
        self.assertEqual((tree["simplify.enabled"], tree["local.translation"]), (False, (1.0, 2.0, 3.0)))

    def test_every_parameter_takes_its_default_and_nothing_else(self):
        wrong = {"bool": "yes", "int": 1.5, "float": "1", "str": 1, "tuple": 1.0}
        tree = ramure.open("preset:TinyTree").trees[0]
        seen = 0
        for facts in ramure.parameters():
            try:
                tree[facts["key"]]
            except ramure.Error:
                continue  # of a step that the tree has not
            if facts["key"] == "generator.kind":
                continue  # changes which parameters there are
            with self.subTest(facts["key"]):
                tree[facts["key"]] = facts["default"]
                self.assertEqual(tree[facts["key"]], facts["default"])
                with self.assertRaises(TypeError):
                    tree[facts["key"]] = wrong[facts["type"]]
                with self.assertRaises(TypeError):
                    tree[facts["key"]] = None
                if facts["type"] == "float":
                    self.refused("invalid", lambda: tree.set({facts["key"]: NAN}), path=facts["key"])
                if "choices" in facts:
                    self.refused("invalid", lambda: tree.set({facts["key"]: "no such choice"}))
                self.assertEqual(tree[facts["key"]], facts["default"])
                seen += 1
        self.assertGreater(seen, 100)

    def test_vectors_and_choices(self):
        for wrong in ((1, 2), (1, 2, 3, 4), "abc", (1, 2, "3"), 5):
            with self.assertRaises(TypeError):
                self.tree["local.translation"] = wrong
        self.refused("invalid", lambda: self.tree.set({"local.translation": (1, 2, NAN)}))

    def test_keys(self):
        for key in ("", "no.such", "growth.", "#9.sag.amount", "step:Nobody.sag.amount", "sag.amount", "\0"):
            self.refused("unknown", lambda: self.tree[key])
            self.refused("unknown", lambda: self.tree.set({key: 1}))
        with self.assertRaises(TypeError):
            self.tree[3]

    def test_files(self):
        for path in ("/no/such/file.ramure", "/no/such/file.obj"):
            text = self.refused("io", lambda: ramure.open(path), file=path)
            self.assertIn("No such file", text)
        self.refused("unknown", lambda: ramure.open("tree.xyz"))
        self.refused("unknown", lambda: ramure.open("preset:Nothing"))
        self.refused("unknown", lambda: ramure.open("demo:nothing"))
        self.refused("unknown", lambda: ramure.open(""))
        with self.assertRaises(ValueError):
            ramure.open("a\0b")
        with self.assertRaises(TypeError):
            ramure.open(None)
        for text, code, line in (("{", "syntax", 1), ("[]", "invalid", 0), ('{\n"format":"ramure",\n"version":}', "syntax", 3)):
            path = self.folder / "broken.ramure"
            path.write_text(text)
            self.refused(code, lambda: ramure.open(path), file=str(path), line=line)

    def test_a_file_of_a_newer_version(self):
        path = self.folder / "new.ramure"
        self.tree.save(path)
        held = json.loads(path.read_text())
        held["version"] += 1
        path.write_text(json.dumps(held))
        self.refused("version", lambda: ramure.open(path))

    def test_a_place_inside_of_a_file(self):
        path = self.folder / "bad.ramure"
        self.tree.save(path)
        held = json.loads(path.read_text())
        held["nodes"][0]["params"]["sections.radialDivisions"] = -5
        path.write_text(json.dumps(held))
        self.refused("invalid", lambda: ramure.open(path), path="nodes[0].params.sections.radialDivisions")

    def test_names_of_bytes_that_are_no_text(self):
        path = os.path.join(os.fsencode(self.folder), b"tr\xffe.ply")
        self.tree.export(path)
        self.assertTrue(os.path.exists(path))
        self.assertGreater(ramure.open(os.fsdecode(path)).info()["faces"], 100)

    def test_export(self):
        target = self.folder / "x.glb"
        for keywords in ({"levles": 3}, {"set": "a=b"}, {"help": True}, {"output": "x"}, {"levels": {}}, {"variants": 1},
                         {"levels": True}, {"frames": range(5, 2)}, {"levels": [object()]}):
            with self.assertRaises(TypeError, msg=str(keywords)):
                self.tree.export(target, **keywords)
        for keywords in ({"levels": 99}, {"levels": "x"}, {"budget": [10, 100]}, {"switch": ["60%"]}, {"map_size": -1},
                         {"time": 1, "frames": "0:3"}, {"time": NAN}, {"fps": 0}, {"model": "cube"}, {"print": "fdm"},
                         {"node": "Nobody"}, {"wind_loop": -1}, {"height": "1m"}, {"require_valid": True, "frames": "0:2"}):
            with self.assertRaises(ramure.Error, msg=str(keywords)):
                self.tree.export(target, **keywords)
        self.assertFalse(target.exists())
        self.refused("invalid", lambda: self.tree.export([]))
        self.refused("unknown", lambda: self.tree.export("tree.doc"))
        self.refused("io", lambda: self.tree.export("/no/such/folder/tree.glb"))
        with self.assertRaises(TypeError):
            self.tree.export(3)

    def test_a_file_in_the_place_of_a_folder(self):
        path = self.folder / "file"
        path.write_text("as before")
        self.refused("io", lambda: self.tree.export(path / "x.ply"))
        self.refused("io", lambda: self.tree.save(path / "x.ramure"))
        self.assertEqual(path.read_text(), "as before")

    def test_steps(self):
        steps = self.birch.steps
        for kind in ("", "nothing", "cut", "draw"):
            self.refused("unknown", lambda: steps.add(kind))
        self.refused("invalid", lambda: steps.add("sag", {"sag.amount": NAN}))
        self.refused("unknown", lambda: steps.add("sag", {"gnarl.angle": 1.0}))
        self.refused("unknown", lambda: steps.add("sag", {"nothing": 1.0}))
        self.refused("invalid", lambda: steps.add("sag", place=-1))
        with self.assertRaises(TypeError):
            steps.add("sag", {"sag.amount": "much"})
        self.assertEqual(len(steps), 1, "what failed adds nothing")
        source = steps[0]
        self.refused("invalid", source.remove)
        self.refused("invalid", lambda: source.move(1))
        with self.assertRaises(ramure.Error):
            source.enabled = False
        gone = steps.add("sag")
        gone.remove()
        for act in (gone.remove, lambda: gone.kind, lambda: gone["sag.amount"], lambda: gone.state, lambda: gone.move(1)):
            self.refused("unknown", act)
        with self.assertRaises(KeyError):
            steps["nobody"]
        with self.assertRaises(IndexError):
            steps[7]

    def test_edits(self):
        for line in ({}, {"op": "fly"}, {"op": "cut"}, {"op": "cut", "target": "00", "at": 0.5},
                     {"op": "cut", "target": "0000000000000001", "at": 0.5}):
            with self.assertRaises(ramure.Error):
                self.birch.edit(line)
        self.assertEqual(len(self.birch.steps), 1)

    def test_a_mesh_has_no_trees(self):
        path = self.folder / "x.ply"
        self.tree.export(path)
        mesh = ramure.open(path)
        self.assertEqual(mesh.trees, [])
        self.refused("invalid", lambda: mesh.save(self.folder / "x.ramure"))
        with self.assertRaises(ramure.Error):
            mesh.export(self.folder / "y.ply", levels=2)

    def test_use_after_close(self):
        tree = ramure.grow("TinyTree", seed=1)
        mesh, step = tree.mesh(), tree.steps[0]
        total = float(mesh.positions.sum())
        tree.close()
        tree.close()
        for act in (tree.mesh, tree.info, tree.validate, tree.grow, tree.axes, lambda: tree["grammar.seed"], lambda: tree.steps[0],
                    lambda: step.kind, lambda: tree.export(self.folder / "x.ply"), lambda: tree.save(self.folder / "x.ramure"),
                    lambda: tree.trees):
            self.refused("invalid", act)
        gc.collect()
        self.assertEqual(float(mesh.positions.sum()), total)
        with ramure.grow("TinyTree") as other:
            pass
        self.refused("invalid", other.info)


if __name__ == "__main__":
    unittest.main()
