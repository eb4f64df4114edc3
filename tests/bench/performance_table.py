#!/usr/bin/env python3
"""Writes the handbook's page of speeds from what Google Benchmark wrote: performance_table.py BENCH.json PAGE.md"""

import json
import sys

# What a stage costs, how the benchmark is called, the bar in nanoseconds. Machines differ: bars were set on one where
# the sphere yardstick takes 181 ns per triangle, and hold as a ratio to it.
REFERENCE_SPHERE = 181.0
STAGES = [
    ("grammar, per output symbol", "BM_grammar/0", 2),
    ("skeleton, per branch", "BM_turtle/0", 25),
    ("simplify, per input branch", "BM_simplify/0", 8),
    ("sections, per ring vertex", "BM_sections/12", 5),
    ("branch mesh with forks and caps, per triangle", "BM_BranchMesh/SmallTree/iterations:12/threads:1", 90),
    ("from parameters to the checked mesh, per triangle", "BM_pipeline/iterations:12/threads:1/leaves:0", 126),
    ("rough model, per triangle", "BM_roughModel/12", 3),
    ("full check, 100,000 triangles, per triangle", "BM_ValidateMesh/8", 15),
    ("full check, 1,600,000 triangles, per triangle", "BM_ValidateMesh/12", 15),
    ("normals, per triangle", "BM_Normals/12", 5),
    ("physics step, per branch", "BM_physicsStep/12/1", 80),
    ("skin, per vertex", "BM_skinRigid/12", 1.0),
    ("skin with normals, per vertex", "BM_skinRigidNormals/12", 2.0),
    ("OBJ written, per triangle", "BM_writeObj", 45),
    ("OBJ read, per triangle", "BM_readObj", 45),
    ("PLY written, per triangle", "BM_writePly", 15),
    ("PLY read, per triangle", "BM_readPly", 8),
]
GROWTH = [
    ("branch mesh", "BM_growthMesh"),
    ("full check", "BM_growthCheck"),
    ("normals", "BM_growthNormals"),
    ("rough model", "BM_growthRough"),
    ("OBJ written", "BM_growthWrite/obj"),
    ("OBJ read", "BM_growthRead/obj"),
    ("PLY written", "BM_growthWrite/ply"),
    ("PLY read", "BM_growthRead/ply"),
    ("parameters to checked mesh", "BM_growthAll"),
]


def nanoseconds(run):
    """For one element, from the processor's time."""
    if "items_per_second" in run and "real_time" not in run["name"]:
        return 1e9 / run["items_per_second"]
    factor = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}[run["time_unit"]]
    elements = run.get("triangles")
    if elements:
        return run["cpu_time"] * factor / elements
    return run.get("ns/triangle")


def best(runs, name):
    """The fastest of the repetitions, or None."""
    found = [r for r in runs if r["name"] == name or r["name"].startswith(name + "/")]
    found = [r for r in found if r.get("run_type") == "iteration" and not r.get("error_occurred")]
    return min(found, key=nanoseconds, default=None)


def number(value):
    return f"{value:.1f}" if value < 20 else f"{value:.0f}"


def page(data):
    runs = data["benchmarks"]
    sphere, copy = best(runs, "BM_openMeshSphere"), None
    copies = [r for r in runs if r["name"].startswith("BM_copy256MB") and r.get("run_type") == "iteration"]
    if copies:
        copy = max(r["bytes_per_second"] for r in copies) / 1e9
    if not sphere or not copy:
        sys.exit("the two yardsticks are not among the results: run ./dev bench without a filter")
    ratio = nanoseconds(sphere) / REFERENCE_SPHERE
    context = data["context"]
    out = [
        "# Speed",
        "",
        "Written by `./dev bench` from its own results; do not edit. Nanoseconds for one element, on one thread, the",
        "best of the repetitions. Bars hold as a ratio to a yardstick measured in the same run: OpenMesh building a",
        f"sphere of 1,001,112 triangles face by face, {REFERENCE_SPHERE:.0f} ns per triangle where the bars were set.",
        "",
        f"Machine: {context['num_cpus']} processors at {context['mhz_per_cpu']} MHz. "
        f"Yardsticks: {nanoseconds(sphere):.0f} ns per triangle of the sphere ({ratio:.2f} times the reference); "
        f"256 MB copied at {copy:.1f} GB/s. Programs that wanted a processor when the run began: "
        f"{context['load_avg'][0]:.0f}; more than there are processors make all figures worse.",
        "",
        "| stage | ns | bar | bar here | met |",
        "| --- | ---: | ---: | ---: | --- |",
    ]
    for text, name, bar in STAGES:
        run = best(runs, name)
        if run:
            ns = nanoseconds(run)
            met = "yes" if ns <= bar * ratio else "no"
            out.append(f"| {text} | {number(ns)} | {bar:g} | {number(bar * ratio)} | {met} |")
    rows = {text: {} for text, _ in GROWTH}
    for text, name in GROWTH:
        for run in runs:
            if run["name"].startswith(name + "/") and run.get("run_type") == "iteration":
                size = run["name"].split("/")[-1]
                old = rows[text].get(size)
                ns = run["cpu_time"] * {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}[run["time_unit"]] / run["triangles"]
                rows[text][size] = min(ns, old) if old else ns
    sizes = ["2", "5", "8", "12", "15"]
    if any(rows.values()):
        out += [
            "",
            "## Growth",
            "",
            "The SmallTree with 2, 5, 8, 12 and 15 iterations. Nanoseconds for one triangle; growth is the last size over",
            "the second.",
            "",
            "| stage | 1,000 | 12,000 | 100,000 | 1,600,000 | 12,700,000 | growth |",
            "| --- | ---: | ---: | ---: | ---: | ---: | ---: |",
        ]
        for text, _ in GROWTH:
            row = rows[text]
            cells = [number(row[s]) if s in row else "" for s in sizes]
            growth = f"{row['15'] / row['5']:.2f}" if "15" in row and "5" in row else ""
            out.append(f"| {text} | " + " | ".join(cells) + f" | {growth} |")
    big = [r for r in runs if r["name"].startswith("BM_tenMillionVertices") and not r.get("error_occurred")]
    if big:
        out += ["", "## Ten million vertices", "", "Written, read back and compared, 20 million triangles:", ""]
        for run in big:
            out.append(f"- {run['name'].split('/')[1].upper()}: {run['cpu_time']:.1f} s of the processor, equal.")
    return "\n".join(out) + "\n"


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as source:
        text = page(json.load(source))
    with open(sys.argv[2], "w", encoding="utf-8") as target:
        target.write(text)
