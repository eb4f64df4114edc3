"""The package as a whole: its versions, its names, its stubs."""
import ast
import inspect
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import ramure
from ramure import _ramure

CLI = os.environ["RAMURE_CLI"]
FOLDER = pathlib.Path(ramure.__file__).parent


class Package(unittest.TestCase):
    def test_the_version_is_the_programs(self):
        said = subprocess.run([CLI, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(said, f"ramure-cli {ramure.__version__}\n")
        self.assertEqual(ramure.check_program(CLI), CLI)

    def test_a_program_of_another_version_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            for text, code in (("ramure-cli 0.1.0", "version"), ("hello", "invalid"), ("", "invalid")):
                fake = pathlib.Path(folder, "ramure-cli")
                fake.write_text(f"#!/bin/sh\necho '{text}'\n")
                fake.chmod(0o755)
                with self.assertRaises(ramure.Error) as caught:
                    ramure.check_program(str(fake))
                self.assertEqual((caught.exception.code, caught.exception.file), (code, str(fake)))
        with self.assertRaises(ramure.Error) as caught:
            ramure.check_program("no-such-program")
        self.assertEqual(caught.exception.code, "io")

    def test_a_library_of_another_version_is_not_taken(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(FOLDER, pathlib.Path(folder, "ramure"), ignore=shutil.ignore_patterns("__pycache__"))
            pathlib.Path(folder, "ramure/version.py").write_text('__version__ = "9.9.9"\n')
            done = subprocess.run([sys.executable, "-c", "import ramure"], capture_output=True, text=True, check=False,
                                  env={**os.environ, "PYTHONPATH": folder})
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, f"ImportError: ramure 9.9.9 finds the library of version {ramure.__version__}")

    def test_every_name_is_there_and_is_explained(self):
        for name in ramure.__all__:
            thing = getattr(ramure, name)
            if name != "__version__":
                self.assertTrue(inspect.getdoc(thing), name)
        for kind in (ramure.Project, ramure.Tree, ramure.Steps, ramure.Step):
            for name, member in vars(kind).items():
                if not name.startswith("_") and callable(member):
                    self.assertIn("return", inspect.signature(member).return_annotation and "return", name)
                    self.assertTrue(member.__annotations__.get("return"), f"{kind.__name__}.{name}")

    def test_the_stub_is_the_library(self):
        stub = ast.parse((FOLDER / "_ramure.pyi").read_text())
        names = {node.name for node in stub.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
        self.assertEqual(names, {name for name in dir(_ramure) if not name.startswith("_") and name != "version"})
        work = next(node for node in stub.body if isinstance(node, ast.ClassDef))
        there = {name for name in vars(_ramure.Work) if not name.startswith("_")}
        self.assertEqual({node.name for node in work.body}, there)
        for node in work.body:  # the names of the arguments, as pybind11 tells them
            told = getattr(_ramure.Work, node.name).__doc__
            for argument in node.args.args[1:]:
                self.assertIn(f"{argument.arg}: ", told, node.name)
        self.assertTrue((FOLDER / "py.typed").exists())

    def test_options_are_those_of_the_program(self):
        told = subprocess.run([CLI, "export", "--help"], capture_output=True, text=True, check=True).stdout
        options = ramure.export_options()
        self.assertIn("levels", options)
        for name in options:
            self.assertIn("--" + name.replace("_", "-"), told)
        for line in told.splitlines():
            if line.startswith("  --"):
                name = line.split()[0].lstrip("-").rstrip(",").replace("-", "_")
                self.assertTrue(name in options or name in ("help", "version", "set"), name)

    def test_presets_and_parameters(self):
        names = [preset["name"] for preset in ramure.presets()]
        self.assertIn("EnglishOak", names)
        oak = ramure.presets()[names.index("EnglishOak")]
        self.assertEqual((oak["latin"], len(oak["ages"])), ("Quercus robur", 3))
        keys = [facts["key"] for facts in ramure.parameters()]
        self.assertEqual(len(keys), len(set(keys)))
        self.assertIn("growth.age", keys)
        self.assertIn("sag.amount", keys)


if __name__ == "__main__":
    unittest.main()
