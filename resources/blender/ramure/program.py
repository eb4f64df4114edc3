"""ramure-cli as a child process: where it is, which version it has, what it is asked."""
import json
import os
import re
import shutil
import subprocess
import tempfile

import bpy

LEAST_VERSION = (0, 2)  # of ramure-cli, whose options this add-on uses
_known = {}  # what programs answered, by path


class Problem(Exception):
    """What went wrong, for the one who clicked."""


class RamurePreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    path: bpy.props.StringProperty(
        name="ramure-cli", subtype="FILE_PATH", description="The program; empty: the one in the PATH")

    def draw(self, _context):
        self.layout.prop(self, "path")
        try:
            self.layout.label(text="Version " + ".".join(map(str, version(cli()))), icon="CHECKMARK")
        except Problem as problem:
            self.layout.label(text=str(problem), icon="ERROR")


def cli():
    """The path of the program. RAMURE_CLI in the environment comes first, for tests and farms."""
    entry = bpy.context.preferences.addons.get(__package__)
    wanted = os.environ.get("RAMURE_CLI") or (entry.preferences.path if entry and entry.preferences else "")
    found = shutil.which(bpy.path.abspath(wanted) if wanted else "ramure-cli")
    if not found:
        raise Problem(f"there is no program {wanted or 'ramure-cli'}: install Ramure, or say in the preferences of "
                      "the add-on where it is")
    return found


def _asked(path, *words):
    try:
        done = subprocess.run([path, *words], capture_output=True, text=True, timeout=20, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise Problem(f"{path} does not answer: {error}") from error
    if done.returncode != 0:
        raise Problem(f"{path} {words[0]}: {done.stderr.strip() or done.returncode}")
    return done.stdout


def version(path):
    """Asked once; an older program is refused before it is asked for trees."""
    if path not in _known:
        match = re.search(r"(\d+)\.(\d+)\.(\d+)", _asked(path, "--version"))
        if not match:
            raise Problem(f"{path} is not ramure-cli")
        _known[path] = {"version": tuple(map(int, match.groups()))}
    found = _known[path]["version"]
    if found < LEAST_VERSION:
        raise Problem(f"ramure-cli {'.'.join(map(str, found))} is too old: this add-on needs "
                      f"{'.'.join(map(str, LEAST_VERSION))} or later")
    return found


def species():
    """The trees that ship with the program, as it lists them."""
    path = cli()
    version(path)
    if "species" not in _known[path]:
        _known[path]["species"] = json.loads(_asked(path, "list", "presets", "--json"))
    return _known[path]["species"]


class Growing:
    """One tree that is being grown. Nothing waits for it: ask isDone()."""

    def __init__(self, words):
        path = cli()
        version(path)
        self.folder = tempfile.mkdtemp(prefix="ramure-")
        self.file = os.path.join(self.folder, "tree.glb")
        self._said = open(os.path.join(self.folder, "said"), "w+", encoding="utf-8", errors="replace")
        self._child = subprocess.Popen([path, "export", *words, "-o", self.file], stdin=subprocess.DEVNULL,
                                       stdout=subprocess.DEVNULL, stderr=self._said)

    def is_done(self):
        return self._child.poll() is not None

    def wait(self):
        self._child.wait()

    def result(self):
        """The file. Raises Problem with what the program said."""
        self._said.seek(0)
        said = self._said.read().strip()
        if self._child.returncode != 0:
            raise Problem(said.replace("ramure-cli: ", "") or f"ramure-cli ended with {self._child.returncode}")
        return self.file

    def end(self):
        """Stops the program where it still runs, and takes its files away."""
        if self._child.poll() is None:
            self._child.terminate()
            try:
                self._child.wait(2)
            except subprocess.TimeoutExpired:
                self._child.kill()
                self._child.wait()
        self._said.close()
        shutil.rmtree(self.folder, ignore_errors=True)


def register():
    bpy.utils.register_class(RamurePreferences)


def unregister():
    bpy.utils.unregister_class(RamurePreferences)
    _known.clear()
