"""Slicers judge what is to be printed:  python3 print_judges.py RAMURE_CLI FOLDER

Of each tree for each process: admesh has nothing to mend, PrusaSlicer calls it manifold, in one part, and both find the
volume that we say within 0.01 %; G-code comes out of some. A line a program, with its version and what was found.
"""
import json
import re
import subprocess
import sys
from pathlib import Path

cli, folder = sys.argv[1:]
folder = Path(folder)
folder.mkdir(parents=True, exist_ok=True)
TREES = ("SmallTree", "TinyTree", "HondaTree", "QuakingAspen")
HEIGHTS = {"fdm": "150mm", "resin": "60mm", "powder": "90mm"}
LEAFY = (("SmallTree", "resin", "120mm"), ("OrchardApple1995", "fdm", "180mm"))  # with leaves as shells
SLICED = 3  # trees of the first process
NEAR = 1e-4
findings = []


def said(*words):
    run = subprocess.run(words, capture_output=True, text=True, errors="replace")
    if run.returncode != 0:
        findings.append(f"{' '.join(map(str, words))}: {run.stdout[-300:]}{run.stderr[-300:]}")
    return run.stdout + run.stderr


def number(pattern, text):
    found = re.search(pattern, text)
    return float(found.group(1)) if found else float("nan")


def find(condition, text):
    if not condition:
        findings.append(text)


def judge_admesh(name, stl, volume):
    text = said("admesh", stl)
    for what in ("Degenerate facets", "Edges fixed", "Facets removed", "Facets added", "Facets reversed",
                 "Backwards edges", "Normals fixed"):
        find(number(rf"{what}\s*:\s*(\d+)", text) == 0, f"{name}: admesh: {what}")
    find(number(r"Total disconnected facets\s*:\s*(\d+)", text) == 0, f"{name}: admesh: open edges")
    find(number(r"Number of parts\s*:\s*(\d+)", text) == 1, f"{name}: admesh: parts")
    return abs(number(r"Volume\s*:\s*([\d.]+)", text) / volume - 1.0)


def judge_slicer(name, file, volume):
    text = said("prusa-slicer", "--info", file)
    find("manifold = yes" in text, f"{name}: PrusaSlicer: not manifold")
    find("open_edges" not in text or number(r"open_edges\s*=\s*(\d+)", text) == 0, f"{name}: PrusaSlicer: open edges")
    find(number(r"number_of_parts\s*=\s*(\d+)", text) == 1, f"{name}: PrusaSlicer: parts")
    return abs(number(r"volume\s*=\s*([\d.]+)", text) / volume - 1.0)


def judge(tree, process, height, *options):
    """The files' names without their endings; None where nothing was made."""
    name = "-".join([tree, process, *[option for option in options if not option.startswith("-")]])
    stl, packed = folder / f"{name}.stl", folder / f"{name}.3mf"
    text = said(cli, "export", f"preset:{tree}", "-o", stl, "-o", packed, "--print", process, "--height", height,
                "--json", *options)
    if not text.lstrip().startswith("{"):
        return None
    report = json.loads(text)
    find(report["closed"] and report["pieces"] == 1 and report["crossings"] == 0, f"{name}: not one closed surface")
    find(report["thinnest"] >= 0.99 * report["smallestDiameter"], f"{name}: {report['thinnest']} mm thin")
    find(not options or report["shells"] > 0, f"{name}: no leaves")
    worst["admesh"] = max(worst["admesh"], judge_admesh(name, stl, report["volume"]))
    worst["slicer"] = max(worst["slicer"], judge_slicer(name, stl, report["volume"]),
                          judge_slicer(name, packed, report["volume"]))
    return name


worst = {"admesh": 0.0, "slicer": 0.0}
prints = leafy = layers = codes = 0
for process, height in HEIGHTS.items():
    for index, tree in enumerate(TREES):
        name = judge(tree, process, height)
        if not name:
            continue
        prints += 1
        if process == "fdm" and index < SLICED:
            code = folder / f"{name}.gcode"
            said("prusa-slicer", "--export-gcode", "--layer-height", "0.3", "--dont-arrange", "--center", "100,100",
                 "--output", code, folder / f"{name}.3mf")
            if code.exists():
                codes += 1
                layers += code.read_text().count(";LAYER_CHANGE")
for tree, process, height in LEAFY:
    leafy += judge(tree, process, height, "--print-leaves", "shells") is not None
for who, off in worst.items():
    find(off < NEAR, f"{who}: a volume is {off:.2e} off")
find(prints == len(HEIGHTS) * len(TREES) and leafy == len(LEAFY), f"only {prints} prints, {leafy} with leaves")
prints += leafy
find(codes == SLICED and layers > 0, f"G-code of {codes} trees, {layers} layers")
version = re.search(r"version ([\d.]+)", said("admesh", "--version"))
print(f"admesh {version.group(1) if version else '?'}: {prints} prints ({leafy} with leaves), nothing to mend, volumes within {worst['admesh']:.1e}")
version = re.search(r"PrusaSlicer-([\d.]+)", said("prusa-slicer", "--help"))
print(f"PrusaSlicer {version.group(1) if version else '?'}: {2 * prints} files manifold in one part, volumes within "
      f"{worst['slicer']:.1e}, G-code of {codes} trees with {layers} layers")
for finding in findings:
    print(f"Error: {finding}", file=sys.stderr)
sys.exit(1 if findings else 0)
