"""The module writes what ramure-cli writes, byte for byte."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import ramure

CLI = os.environ["RAMURE_CLI"]


def cli(*words):
    done = subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, check=True)
    return done.stdout


class Bytes(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def same(self, tree, source, ending, keywords, words):
        ours, theirs = self.folder / f"ours{ending}", self.folder / "cli" / f"ours{ending}"
        theirs.parent.mkdir(exist_ok=True)
        tree.export(ours, **keywords)
        cli("export", *source, "-o", theirs, *words)
        self.assertGreater(ours.stat().st_size, 100)
        names = sorted(path.name for path in self.folder.iterdir() if path.is_file())
        self.assertEqual(names, sorted(path.name for path in theirs.parent.iterdir()))
        for name in names:
            self.assertEqual((self.folder / name).read_bytes(), (theirs.parent / name).read_bytes(), name)

    def test_every_format(self):
        tree = ramure.grow("TinyTree", seed=7)
        for ending in (".obj", ".ply", ".glb", ".usda", ".stl"):
            with self.subTest(ending):
                self.same(tree, ["preset:TinyTree", "--set", "grammar.seed=7"], ending, {"map_size": 64},
                          ["--map-size", 64])

    def test_age_seed_and_parameters(self):
        tree = ramure.grow("SilverBirch", seed=3, age=6, parameters={"season.day": 120, "mesh.targetTriangles": 30000})
        source = ["preset:SilverBirch", "--set", "grammar.seed=3", "--set", "growth.age=6", "--set", "season.day=120", "--set",
                  "mesh.targetTriangles=30000"]
        self.same(tree, source, ".glb", {"map_size": 0, "leaves": "instances"}, ["--map-size", 0, "--leaves", "instances"])

    def test_levels_wind_and_collision(self):
        tree = ramure.grow("TinyTree", seed=2)
        self.same(tree, ["preset:TinyTree", "--set", "grammar.seed=2"], ".glb",
                  {"levels": 2, "budget": [3000, 900], "switch": ["50%", "20%"], "billboard": True, "wind": "pivot-painter",
                   "collision": "unreal", "map_size": 64},
                  ["--levels", 2, "--budget", "3000,900", "--switch", "50%,20%", "--billboard", "--wind", "pivot-painter",
                   "--collision", "unreal", "--map-size", 64])

    def test_a_clip(self):
        tree = ramure.grow("TinyTree", seed=2)
        tree["physics.windStrength"] = 4.0
        source = ["preset:TinyTree", "--set", "grammar.seed=2", "--set", "physics.windStrength=4"]
        self.same(tree, source, ".glb", {"frames": range(0, 5, 2), "fps": 12, "map_size": 0, "joints": "all"},
                  ["--frames", "0:4:2", "--fps", 12, "--map-size", 0, "--joints", "all"])

    def test_a_print_tells_its_report(self):
        tree = ramure.grow("TinyTree", seed=2)
        path = self.folder / "print.stl"
        report = tree.export(path, print="resin", height="60mm")
        other = self.folder / "cli.stl"
        theirs = json.loads(cli("export", "preset:TinyTree", "--set", "grammar.seed=2", "--print", "resin", "--height", "60mm",
                                "--json", "-o", other))
        self.assertEqual(path.read_bytes(), other.read_bytes())
        self.assertEqual(report["triangles"], theirs["triangles"])

    def test_projects(self):
        tree = ramure.grow("TinyTree", seed=9)
        tree.steps.add("sag", {"sag.amount": 0.7})
        path = self.folder / "tiny.ramure"
        tree.save(path)
        project = ramure.open(path)
        self.assertEqual([one.name for one in project.trees], ["TinyTree"])
        before = path.read_bytes()
        project.save(path)
        self.assertEqual(path.read_bytes(), before)
        project.export(self.folder / "ours.ply")
        cli("export", path, "-o", self.folder / "cli.ply")
        self.assertEqual((self.folder / "ours.ply").read_bytes(), (self.folder / "cli.ply").read_bytes())

    def test_unknown_keys_of_a_project_stay(self):
        path = self.folder / "tiny.ramure"
        ramure.grow("TinyTree").save(path)
        held = json.loads(path.read_text())
        held["ofTomorrow"] = {"a": 1}
        path.write_text(json.dumps(held))
        ramure.open(path).save(path)
        self.assertEqual(json.loads(path.read_text())["ofTomorrow"], {"a": 1})

    def test_info_and_validate_say_what_the_program_says(self):
        tree = ramure.grow("TinyTree", seed=5)
        source = ["preset:TinyTree", "--set", "grammar.seed=5", "--json"]
        self.assertEqual(tree.info(axes=True), json.loads(cli("info", *source, "--axes")))
        self.assertEqual(tree.validate(crossings=True, texture=True),
                         json.loads(cli("validate", *source, "--self-intersections", "--texture")))
        path = self.folder / "tiny.ply"
        tree.export(path)
        self.assertEqual(ramure.open(path).validate(), json.loads(cli("validate", path, "--json")))
        self.assertEqual(ramure.open(path).info(), json.loads(cli("info", path, "--json")))

    def test_one_tree_of_several(self):
        project = ramure.open("demo:Recipes")
        self.assertGreater(len(project.trees), 1)
        for tree in project.trees:
            tree.export(self.folder / "one.ply")
            cli("export", "demo:Recipes", "--node", tree.name, "-o", self.folder / "cli.ply")
            self.assertEqual((self.folder / "one.ply").read_bytes(), (self.folder / "cli.ply").read_bytes())
            self.assertEqual(tree.validate()["vertices"], len(tree.mesh().positions))

    def test_remarks_are_warnings(self):
        tree = ramure.grow("SilverBirch", seed=1, age=10, parameters={"mesh.targetTriangles": 500})
        with self.assertWarnsRegex(UserWarning, "smallest mesh"):
            tree.export(self.folder / "few.ply")


if __name__ == "__main__":
    unittest.main()
