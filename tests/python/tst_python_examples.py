"""The examples of the handbook run, are short, and are named by its pages."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOP = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = sorted((TOP / "resources/python/examples").glob("*.py"))


class Examples(unittest.TestCase):
    def test_there_are_ten_and_none_is_long(self):
        self.assertEqual(len(EXAMPLES), 10)
        for path in EXAMPLES:
            self.assertLessEqual(len(path.read_text().splitlines()), 40, path.name)

    def test_both_handbooks_name_them(self):
        for page in ("resources/handbook/python.md", "resources/handbook/fr/python.md"):
            text = (TOP / page).read_text(encoding="utf-8")
            for path in EXAMPLES:
                self.assertIn(path.name, text, page)

    def test_they_run(self):
        with tempfile.TemporaryDirectory() as holder:
            for path in EXAMPLES:
                if path.name == "check_folder.py":
                    continue
                with self.subTest(path.name):
                    folder = pathlib.Path(holder, path.stem)
                    done = subprocess.run([sys.executable, path, folder], capture_output=True, text=True, check=False)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertTrue(done.stdout.strip())
                    self.assertGreater(len(list(folder.iterdir())), 0)
            check = TOP / "resources/python/examples/check_folder.py"
            good = subprocess.run([sys.executable, check, pathlib.Path(holder, "batch")], capture_output=True, text=True,
                                  check=False)
            self.assertEqual(good.returncode, 0, good.stderr)
            self.assertEqual(good.stdout.count(".ply:"), 6)
            pathlib.Path(holder, "batch/broken.ramure").write_text("{")
            bad = subprocess.run([sys.executable, check, pathlib.Path(holder, "batch")], capture_output=True, text=True,
                                 check=False)
            self.assertEqual(bad.returncode, 1)
            self.assertIn("broken.ramure: ", bad.stdout)


if __name__ == "__main__":
    unittest.main()
