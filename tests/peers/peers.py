#!/usr/bin/env python3
"""Runs Ramure and other programs that make trees on the same tasks and lets one judge measure what they make:
peers.py RAMURE_CLI FOLDER. What can be had is installed into FOLDER; a program that cannot be had, or dies, has an error
in its place. Writes FOLDER/peers.json; page.py makes the handbook's page of it."""

import datetime
import hashlib
import json
import os
import platform
import re
import resource
import shutil
import statistics
import subprocess
import sys
import threading
import time
from pathlib import Path

import mesh_files
import skeleton

HERE = Path(__file__).resolve().parent
SEEDS = range(1, 6)
PATIENCE = 150  # seconds of the processor for one tree
LONG = 12  # seconds of the processor: of a program that takes longer, two seeds are grown and one run is timed
TASKS = {
    "broadleaf": "A broad-leaved tree, an oak where there is one, as its preset is",
    "conifer": "A conifer, a pine where there is one, as its preset is",
    "small": "An aspen or what is small, as its preset is",
    "game": "A broad-leaved tree for games, of 10,000 triangles with its leaves",
}
PROCTREE = {  # the example of its README
    "segments": 6, "levels": 5, "vMultiplier": 2.36, "twigScale": 0.39, "initalBranchLength": 0.49,
    "lengthFalloffFactor": 0.85, "lengthFalloffPower": 0.99, "clumpMax": 0.454, "clumpMin": 0.404, "branchFactor": 2.45,
    "dropAmount": -0.1, "growAmount": 0.235, "sweepAmount": 0.01, "maxRadius": 0.139, "climbRate": 0.371,
    "trunkKink": 0.093, "treeSteps": 5, "taperRate": 0.947, "radiusFalloffRate": 0.73, "twistRate": 3.02,
    "trunkLength": 2.4,
}


class Failed(Exception):
    """Why a program is not here, or made no tree."""


def spent(argv, folder, patience=PATIENCE):
    """Runs a program to its end: seconds of the processor, which other programs disturb less than those of the clock, bytes
    of memory at most, what it printed. Raises Failed."""
    with open(folder / "log", "wb") as log:
        process = subprocess.Popen(
            [str(a) for a in argv], cwd=folder, stdout=log, stderr=log, stdin=subprocess.DEVNULL,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (patience, patience)))
        clock = threading.Timer(5 * patience, process.kill)  # one that only sleeps
        clock.start()
        _, status, usage = os.wait4(process.pid, 0)
        clock.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
    seconds = usage.ru_utime + usage.ru_stime
    said = (folder / "log").read_text(encoding="utf-8", errors="replace")
    if process.returncode:
        last = (said.strip().splitlines() or [f"exit code {process.returncode}"])[-1]
        raise Failed(f"no end within {patience} s" if seconds >= patience - 1 else last[:200])
    return {"seconds": seconds, "memory": usage.ru_maxrss * 1024, "said": said}


class Ramure:
    """The program of this repository, by its command line alone."""

    name, up = "Ramure", "y"
    presets = {"broadleaf": "EnglishOak", "conifer": "ScotsPine", "small": "QuakingAspen", "game": "EnglishOak"}

    def __init__(self, cli):
        self.cli = cli

    def install(self, folder):
        self.version = subprocess.run([self.cli, "--version"], capture_output=True, text=True).stdout.split()[-1]

    def commands(self, task, seed, kind):
        base = [self.cli, "export", "preset:" + self.presets[task], "--set", f"grammar.seed={seed}"]
        base += ["--levels", "1", "--budget", "10000"] if task == "game" else []
        if kind == "file" or task == "game":  # the budget is for bark, leaves and fruit together
            return [base + ["--map-size", "16", "-o", "tree.glb" if kind == "file" else "tree.obj"]]
        parts = [("branches", "bark.ply"), ("leaves", "leaves.ply")][: 1 if kind == "bark" else 2]
        return [base + ["--part", part, "-o", name] for part, name in parts]

    def skeleton(self, task, seed, folder):
        told = [self.cli, "info", "preset:" + self.presets[task], "--set", f"grammar.seed={seed}", "--json", "--axes"]
        return json.loads(spent(told, folder)["said"])["axes"]


class Npm:
    """A library that npm has, of the version that the lock names."""

    up = "y"

    def __init__(self, name, key, package, presets):
        self.name, self.key, self.package, self.presets = name, key, package, presets

    def install(self, folder):
        if not shutil.which("npm"):
            raise Failed("npm is not installed")
        self.script = folder / "npm" / "javascript_trees.mjs"
        described = folder / "npm" / "node_modules" / self.package / "package.json"
        if not described.exists():
            (folder / "npm").mkdir(exist_ok=True)
            for name in ("package.json", "package-lock.json", "javascript_trees.mjs"):
                shutil.copy(HERE / name, folder / "npm")
            spent(["npm", "ci", "--no-audit", "--no-fund", "--silent"], folder / "npm", 300)
        shutil.copy(HERE / "javascript_trees.mjs", folder / "npm")
        self.version = json.loads(described.read_text())["version"]

    def commands(self, task, seed, kind):
        what = self.presets[task]
        return [["node", self.script, self.key, what, seed, ".", "glb" if kind == "file" else "ply"]]


class Checkout:
    """A program of a public repository, at one commit. RAMURE_PEER_REPOSITORIES may name a folder with copies
    (OWNER+NAME), which are asked first."""

    repository = commit = folder_name = None

    def install(self, folder):
        self.source = folder / "sources" / self.folder_name
        if not (self.source / ".git").exists():
            self.source.parent.mkdir(exist_ok=True)
            shutil.rmtree(self.source, ignore_errors=True)
            copies = Path(os.environ.get("RAMURE_PEER_REPOSITORIES", "/nowhere"), self.repository.replace("/", "+"))
            places = [copies / "repo" / ".git", copies / "repo", copies, f"https://github.com/{self.repository}.git"]
            place = next(p for p in places if isinstance(p, str) or (p / "HEAD").exists())
            environment = {**os.environ, "GIT_TERMINAL_PROMPT": "0", "GIT_LFS_SKIP_SMUDGE": "1"}
            clone = subprocess.run(["git", "-c", "http.lowSpeedLimit=1000", "-c", "http.lowSpeedTime=20", "clone", "-q",
                                    str(place), str(self.source)], env=environment, capture_output=True, timeout=300)
            if clone.returncode:
                raise Failed("its repository could not be reached")
        checkout = subprocess.run(["git", "-C", str(self.source), "checkout", "-q", self.commit], capture_output=True)
        if checkout.returncode:
            raise Failed(f"its repository has no commit {self.commit[:7]}")
        self.version = self.told + " " + self.commit[:7]


class Proctree(Checkout):
    name, up, told = "proctree.js", "y", "2017"
    repository, commit = "supereggbert/proctree.js", "c1ea9dc2c1b0d3cc37cb7645b50b27c984505382"
    folder_name = "proctree"
    presets = {"broadleaf": json.dumps(PROCTREE), "small": json.dumps({**PROCTREE, "levels": 3}),
               "game": json.dumps({**PROCTREE, "levels": 6})}

    def install(self, folder):
        Npm(self.name, "proctree", "three", {}).install(folder)
        super().install(folder)
        self.script = folder / "npm" / "javascript_trees.mjs"

    def commands(self, task, seed, kind):
        return [["node", self.script, "proctree", self.presets[task], seed, ".", "glb" if kind == "file" else "ply",
                 self.source / "proctree.js"]]


class InBlender:
    def commands(self, task, seed, kind):
        return [["blender", "-b", "--factory-startup", "--python-exit-code", "1", "-P", HERE / "blender_trees.py", "--",
                 self.key, self.presets[task], seed, ".", "glb" if kind == "file" else "ply", getattr(self, "source", "")]]


class Sapling(InBlender):
    name, up, key = "Sapling", "z", "sapling"
    presets = {"broadleaf": "white_birch", "conifer": "small_pine", "small": "quaking_aspen"}

    def install(self, folder):
        if not shutil.which("blender"):
            raise Failed("Blender is not installed")
        blender = subprocess.run(["blender", "--version"], capture_output=True, text=True).stdout.split()[1]
        addon = Path("/usr/share/blender/scripts/addons/add_curve_sapling/__init__.py")
        if not addon.exists():
            raise Failed(f"Blender {blender} has it no longer")
        own = re.search(r'"version": \((.+?)\)', addon.read_text())[1].replace(", ", ".")
        self.version = f"{own} in Blender {blender}"


class TreeGen(InBlender, Checkout):
    name, up, key, told = "tree-gen", "z", "tree_gen", "0.0.4"
    repository, commit = "friggog/tree-gen", "f9b616ad269bb95abfd54cdd7ca733785cb98f9c"
    folder_name = "tree_gen"
    presets = {"broadleaf": "cambridge_oak", "conifer": "small_pine", "small": "quaking_aspen"}

    def install(self, folder):
        if not shutil.which("blender"):
            raise Failed("Blender is not installed")
        Checkout.install(self, folder)


class Arbaro(Checkout):
    name, up, told = "Arbaro", "y", "1.9.9"
    repository, commit = "wdiestel/arbaro", "e01a77657f8c831b1049f4b0ebb20f1fcb2f7c31"
    folder_name = "arbaro"
    presets = {"broadleaf": "ca_black_oak", "conifer": "european_larch", "small": "quaking_aspen"}

    def install(self, folder):
        if not shutil.which("javac"):
            raise Failed("Java is not installed")
        super().install(folder)
        self.classes = folder / "arbaro-classes"
        if not (self.classes / "net").exists():
            self.classes.mkdir(exist_ok=True)
            source = self.source / "src"
            spent(["javac", "-nowarn", "-encoding", "ISO-8859-1", "-d", self.classes, "-sourcepath", source,
                   source / "net/sourceforge/arbaro/arbaro.java"], self.classes)

    def commands(self, task, seed, kind):
        # Each --uv option of 1.9.9 swallows the word behind it.
        return [["java", "-cp", self.classes, "net.sourceforge.arbaro.arbaro", "-q", "-s", seed, "-f", "OBJ", "--uvstems",
                 "-", "--uvleaves", "-", "-o", "tree.obj", self.source / "trees" / (self.presets[task] + ".xml")]]


class Mtree(Checkout):
    name, up, told = "Modular Tree", "z", "5.5.1"
    repository, commit = "GoodPie/modular_tree", "eca242d1b7208ea2b0834a1d8723f5732c43dd2a"
    folder_name = "mtree"
    presets = {"broadleaf": "OAK", "conifer": "PINE"}

    def install(self, folder):
        super().install(folder)
        include = subprocess.run(["/usr/bin/python3-config", "--includes"], capture_output=True, text=True).stdout.split()
        own = self.source / "m_tree"
        library = self.source.parent / "m_tree.so"
        if not library.exists():
            sources = sorted(p for where in ("source", "python_bindings") for p in (own / where).rglob("*.cpp"))
            spent(["g++", "-std=c++20", "-O3", "-w", "-fPIC", "-shared", "-I", own / "source", "-I", own,
                   "-I/usr/include/eigen3", *include, *sources, "-o", library], self.source.parent, 400)

    def commands(self, task, seed, kind):
        return [["/usr/bin/python3", HERE / "mtree_trees.py", self.presets[task], seed, ".", self.source]]


def programs(cli):
    return [
        Ramure(cli),
        Npm("ez-tree", "eztree", "@dgreenheck/ez-tree",
            {"broadleaf": "Oak Medium", "conifer": "Pine Medium", "small": "Aspen Small", "game": "Oak Small"}),
        Npm("three.js TreeGenerator", "three", "three",
            {"broadleaf": '{"Levels":4}', "conifer": '{"Levels":5}', "small": '{"Levels":3}', "game": '{"Levels":4}'}),
        Sapling(), Mtree(), TreeGen(), Arbaro(), Proctree(),
    ]


def made(program, task, seed, kind, folder):
    """One tree in an empty folder: its seconds, memory and files; of kind "file" its own, "mesh" what the judge reads,
    "bark" that without what is not bark, where it can be left out."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    runs = [spent(command, folder) for command in program.commands(task, seed, kind)]
    files = sorted(p for p in folder.iterdir() if p.suffix in (".glb", ".ply", ".obj"))
    if not files:
        raise Failed("it wrote no file")
    inner = re.findall(r'\{"seconds": ?([0-9.e-]+)\}', runs[-1]["said"])
    return {
        "seconds": sum(run["seconds"] for run in runs),
        "inside": float(inner[-1]) if inner else None,
        "memory": max(run["memory"] for run in runs),
        "bytes": sum(p.stat().st_size for p in files),
        "format": files[0].suffix[1:],
        "files": files,
        "hash": [fingerprint(p) for p in files] if kind != "file" else None,
    }


def fingerprint(path):
    """Of a PLY without its normals: Blender sums them up by several threads, and their last digits wander."""
    digest = hashlib.sha256()
    if path.suffix == ".ply":
        part = mesh_files.read_ply(path)
        for array in (part.positions, part.triangles, part.uv):
            digest.update(b"" if array is None else array.tobytes())
    else:
        digest.update(path.read_bytes())
    return digest.hexdigest()


def triangles_of(glb):
    """All that the meshes of a GLB have."""
    with open(glb, "rb") as source:
        length = int.from_bytes(source.read(16)[12:], "little")
        told = json.loads(source.read(4 + length)[4:])
    primitives = [p for mesh in told["meshes"] for p in mesh["primitives"]]
    return sum(told["accessors"][p["indices"]]["count"] // 3 for p in primitives)


def judged(files, up):
    told = subprocess.run([sys.executable, str(HERE / "judge.py"), "--up", up, *map(str, files)], capture_output=True,
                          text=True, timeout=400)
    if told.returncode:
        raise Failed("the judge: " + (told.stderr.strip().splitlines() or ["no word"])[-1][:200])
    return json.loads(told.stdout)


def filed(program, task, folder, times):
    """What its own file costs."""
    runs = [made(program, task, 1, "file", folder) for _ in range(times)]
    out = {
        "seconds": statistics.median(run["seconds"] for run in runs),
        "memory": max(run["memory"] for run in runs),
        "bytes": runs[0]["bytes"],
        "format": runs[0]["format"],
    }
    if out["format"] == "glb":
        out["allTriangles"] = triangles_of(runs[0]["files"][0])
    return out


def measured(program, task, folder):
    """All that is measured of one program at one task."""
    first = made(program, task, 1, "mesh", folder / "mesh")
    slow = first["seconds"] > LONG
    out = judged(first["files"], program.up)
    again = made(program, task, 1, "mesh", folder / "mesh")
    barks = [first["hash"][0]]
    for seed in list(SEEDS)[1:2 if slow else None]:
        barks.append(made(program, task, seed, "bark", folder / "mesh")["hash"][0])
    out["allTriangles"] = out.get("triangles", 0) + out.get("leafTriangles", 0)
    try:
        out.update(filed(program, task, folder / "file", 1 if slow else 3))
    except Failed as error:
        out["noFile"] = str(error)
    if task == "game":
        out["asked"] = 10000
    if hasattr(program, "skeleton"):
        out["horton"] = skeleton.horton_ratio(program.skeleton(task, 1, folder / "file"))
    out.update(
        preset=program.presets[task] if not program.presets[task].startswith("{") else "",
        inside=first["inside"],
        sameAgain=first["hash"] == again["hash"],
        seeds=len(barks),
        distinct=len(set(barks)),
    )
    shutil.rmtree(folder)
    return out


def whole(program, folder, only):
    """A program's column; an error wherever it fails."""
    out = {"name": program.name, "tasks": {}}
    try:
        program.install(folder)
        out["version"] = program.version
    except (Failed, OSError, subprocess.SubprocessError) as error:
        out["error"] = str(error)
        return out
    for task in only:
        if task not in program.presets:
            continue
        try:
            out["tasks"][task] = measured(program, task, folder / "work" / program.name / task)
        except (Failed, OSError, ValueError, KeyError, subprocess.SubprocessError) as error:
            out["tasks"][task] = {"error": str(error)}
        done = out["tasks"][task]
        print(f"{program.name}, {task}: " + done.get("error", f"{done.get('allTriangles')} triangles, "
              f"{done.get('boundaryEdges')} open edges, {done.get('seconds', 0):.2f} s"), flush=True)
    return out


def machine():
    model = re.search(r"model name\s*: (.+)", Path("/proc/cpuinfo").read_text())
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return {"processor": model[1] if model else platform.machine(), "cores": os.cpu_count(), "memory": memory,
            "load": os.getloadavg()[0], "system": platform.freedesktop_os_release().get("PRETTY_NAME", platform.system())}


if __name__ == "__main__":
    cli, folder = os.path.abspath(sys.argv[1]), Path(sys.argv[2]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    begun = time.time()
    wanted = sys.argv[3:]
    chosen = [p for p in programs(cli) if not wanted or p.name in wanted]
    # One at a time: two would slow each other down.
    columns = [whole(program, folder, TASKS) for program in chosen]
    result = {"date": datetime.date.today().isoformat(), "minutes": (time.time() - begun) / 60, "machine": machine(),
              "tasks": TASKS, "programs": columns}
    (folder / "peers.json").write_text(json.dumps(result, indent=1))
