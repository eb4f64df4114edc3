#!/usr/bin/env python3
"""Writes the handbook's page of speeds in English and in French (FOLDER/performance.md and FOLDER/fr/performance.md)
from what Google Benchmark wrote in one round or several, and all rounds into one file: performance_table.py FOLDER
ALL.json ROUND.json...
Translates the French page anew from the English one: performance_table.py FOLDER"""

import json
import re
import sys

# Bars were set on a machine where these two yardsticks give so much, and hold as a ratio to them: work that waits for
# the processor as a ratio to the first, work that waits for memory as a ratio to the second.
REFERENCE_SPHERE = 181.0  # ns per triangle
REFERENCE_COPY = 27.0  # GB/s
# What a stage costs, how the benchmark is called, the bar in nanoseconds (None: measured without one). Memory: arrays
# far larger than the caches are read or written once, and little is done to them.
COMPUTE, MEMORY = False, True
STAGES = [
    ("grammar, per output symbol", "BM_grammar/0", 2, COMPUTE),
    ("skeleton, per branch", "BM_turtle/0", 25, COMPUTE),
    ("simplify, per input branch", "BM_simplify/0", 8, COMPUTE),
    ("sections, per ring vertex", "BM_sections/12", 5, MEMORY),
    ("branch mesh with forks and caps, per triangle", "BM_BranchMesh/SmallTree/iterations:12/threads:1", 90, COMPUTE),
    ("rough model, per triangle", "BM_roughModel/12", 3, MEMORY),
    ("full check, 100,000 triangles, per triangle", "BM_ValidateMesh/8", 15, COMPUTE),
    ("full check, 1,600,000 triangles, per triangle", "BM_ValidateMesh/12", 15, COMPUTE),
    ("normals, per triangle", "BM_Normals/12", 5, COMPUTE),
    ("physics step, per branch", "BM_physicsStep/12/1", 80, COMPUTE),
    ("skin, per vertex", "BM_skinRigid/12", 1.0, MEMORY),
    ("skin with normals, per vertex", "BM_skinRigidNormals/12", 2.0, MEMORY),
    ("OBJ written, per triangle", "BM_writeObj/plain", 90, COMPUTE),
    ("OBJ written with normals", "BM_writeObj/everything", None, COMPUTE),
    ("OBJ read, per triangle", "BM_readObj/plain", 60, COMPUTE),
    ("OBJ read with normals", "BM_readObj/everything", None, COMPUTE),
    ("PLY written, per triangle", "BM_writePly/plain", 15, MEMORY),
    ("PLY written with normals, colours, branches", "BM_writePly/everything", None, MEMORY),
    ("PLY read, per triangle", "BM_readPly/plain", 8, MEMORY),
    ("PLY read with normals, colours, branches", "BM_readPly/everything", None, MEMORY),
]
# From the parameters to the checked mesh with normals, SmallTree with 12 iterations; milliseconds. Of one thread the
# processor's time, of two what the clock shows: that means little while other programs work.
END_TO_END = [
    ("one thread", "BM_pipeline/iterations:12/threads:1/leaves:0", "cpu_time", 200),
    ("two threads, by the clock", "BM_pipeline/iterations:12/threads:2/leaves:0", "real_time", 110),
]
# What grows, milliseconds of the processor's time.
GROWING = [
    ("aspen of Weber and Penn, 1,500 stems", "BM_weberPenn", 3),
    ("24,000 points colonised", "BM_colonisation", 150),
    ("an oak of 80 years", "BM_growHistory/80/0", 500),
    ("a quarter of a million metamers born", "BM_growHistory/28/1", 250),
    ("any age of an oak of 2,000 axes", "BM_skeletonAtAge", 33),
    ("1,000 edits find their places on 10,000 axes", "BM_editPlaces", 20),
    ("100,000 leaves on a day when they turn", "BM_foliageOnDay/12/298/100000", 4),
]
GROWTH = [
    ("branch mesh", "BM_growthMesh"),
    ("full check", "BM_growthCheck"),
    ("normals", "BM_growthNormals"),
    ("rough model", "BM_growthRough"),
    ("texture coordinates", "BM_growthTexture"),
    ("leaves, per triangle of them", "BM_growthFoliage"),
    ("crossings", "BM_growthCrossings"),
    ("GLB written", "BM_growthGlb"),
    ("OBJ written", "BM_growthWrite/obj"),
    ("OBJ read", "BM_growthRead/obj"),
    ("PLY written", "BM_growthWrite/ply"),
    ("PLY read", "BM_growthRead/ply"),
    ("parameters to checked mesh", "BM_growthAll"),
]


# The English page's texts in French: patterns that stand for whole lines, then cells of its tables.
FRENCH_LINES = [
    (r"# Speed", "# La vitesse"),
    (
        r"Written by `./dev bench` from its own results; do not edit\. Nanoseconds .* for one",
        "Page écrite par `./dev bench` à partir de ses propres résultats ; ne pas la modifier. Nanosecondes de temps\n"
        "processeur pour un élément, sur un seul fil,",
    ),
    (
        r"element, on one thread, the best of all repetitions in (.+) rounds\.",
        r"la meilleure de toutes les répétitions en \1 tours.",
    ),
    (
        r"Bars hold as a ratio .* of (.+)",
        r"Les limites valent comme rapport à deux étalons mesurés dans la même exécution : OpenMesh qui construit, face par "
        r"face,\nune sphère de \1 triangles",
    ),
    (
        r"triangles face by face \((.+) ns per triangle .* copying 256 MB \((.+)",
        r"(\1 ns par triangle là où les limites ont été fixées), et la copie de 256 Mo (\2 là-bas).",
    ),
    (
        r"there\)\. Rows that only wait for memory .*",
        "Ce qui n’attend que la mémoire peut être jugé d’après le second ; le tableau dit où celui-là seul est respecté.",
    ),
    (r"The bars of OBJ and PLY .*", "Les limites d’OBJ et de PLY concernent les positions et les triangles."),
    (
        r"Machine: (.+) processors at (.+) MHz\. Yardsticks: (.+) ns per triangle of the sphere \((.+) times the reference\); "
        r"256 MB copied at (.+) GB/s \((.+) times slower\)\. Programs .* began: (.+); more than .*",
        r"Machine : \1 processeurs à \2 MHz. Étalons : \3 ns par triangle de la sphère (\4 fois la référence) ; 256 Mo "
        r"copiés à \5 Go/s (\6 fois plus lentement). Programmes qui voulaient un processeur au début du dernier tour : \7 ; "
        r"s’il y en a plus que de processeurs, tous les chiffres sont moins bons.",
    ),
    (r"## End to end", "## D’un bout à l’autre"),
    (
        r"The SmallTree with 12 iterations, (.+) triangles, from .*",
        r"SmallTree avec 12 itérations, \1 triangles, de ses paramètres au maillage vérifié avec normales.",
    ),
    (r"## What grows", "## Ce qui pousse"),
    (r"## Growth", "## La croissance"),
    (
        r"The SmallTree with 2, 5, 8, 12 and 15 iterations\. .*",
        "SmallTree avec 2, 5, 8, 12 et 15 itérations. Nanosecondes par triangle ; la croissance est le rapport de la dernière",
    ),
    (r"the second\.", "taille à la deuxième."),
    (r"## Ten million vertices", "## Dix millions de sommets"),
    (
        r"Written, read back and compared, 20 million triangles:",
        "Écrits, relus et comparés, 20 millions de triangles :",
    ),
    (r"- (\w+): (.+) s of the processor, equal\.", r"- \1 : \2 s de processeur, identiques."),
]
FRENCH_CELLS = {
    "stage": "étape",
    "bar": "limite",
    "by sphere": "selon la sphère",
    "by copying": "selon la copie",
    "met": "respectée",
    "yes": "oui",
    "no": "non",
    "growth": "croissance",
    "grammar, per output symbol": "grammaire, par symbole produit",
    "skeleton, per branch": "squelette, par branche",
    "simplify, per input branch": "simplification, par branche reçue",
    "sections, per ring vertex": "sections, par sommet d’anneau",
    "branch mesh with forks and caps, per triangle": "maillage des branches avec fourches et bouts, par triangle",
    "rough model, per triangle": "modèle grossier, par triangle",
    "full check, 100,000 triangles, per triangle": "vérification complète, 100,000 triangles, par triangle",
    "full check, 1,600,000 triangles, per triangle": "vérification complète, 1,600,000 triangles, par triangle",
    "normals, per triangle": "normales, par triangle",
    "physics step, per branch": "pas de physique, par branche",
    "skin, per vertex": "peau, par sommet",
    "skin with normals, per vertex": "peau avec normales, par sommet",
    "OBJ written, per triangle": "OBJ écrit, par triangle",
    "OBJ written with normals": "OBJ écrit avec normales",
    "OBJ read, per triangle": "OBJ lu, par triangle",
    "OBJ read with normals": "OBJ lu avec normales",
    "PLY written, per triangle": "PLY écrit, par triangle",
    "PLY written with normals, colours, branches": "PLY écrit avec normales, couleurs, branches",
    "PLY read, per triangle": "PLY lu, par triangle",
    "PLY read with normals, colours, branches": "PLY lu avec normales, couleurs, branches",
    "one thread": "un fil",
    "two threads, by the clock": "deux fils, à l’horloge",
    "aspen of Weber and Penn, 1,500 stems": "tremble de Weber et Penn, 1,500 tiges",
    "24,000 points colonised": "24,000 points colonisés",
    "1,000 edits find their places on 10,000 axes": "1,000 retouches trouvent leur place sur 10,000 axes",
    "100,000 leaves on a day when they turn": "100,000 feuilles un jour où elles virent",
    "branch mesh": "maillage des branches",
    "full check": "vérification complète",
    "normals": "normales",
    "rough model": "modèle grossier",
    "texture coordinates": "coordonnées de texture",
    "leaves, per triangle of them": "feuilles, par triangle des feuilles",
    "crossings": "croisements",
    "GLB written": "GLB écrit",
    "OBJ written": "OBJ écrit",
    "OBJ read": "OBJ lu",
    "PLY written": "PLY écrit",
    "PLY read": "PLY lu",
    "parameters to checked mesh": "des paramètres au maillage vérifié",
}


def french(text):
    """The page in French; a text without a translation ends the program."""
    out = []
    for line in text.splitlines():
        if line.startswith("|"):
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            unknown = [c for c in cells if c not in FRENCH_CELLS and re.search(r"[a-z]{3}", c)]
            if unknown:
                sys.exit(f"no French for the cell {unknown[0]!r}: see FRENCH_CELLS")
            line = "| " + " | ".join(FRENCH_CELLS.get(cell, cell) for cell in cells) + " |"
        elif line:
            found = [(pattern, words) for pattern, words in FRENCH_LINES if re.fullmatch(pattern, line)]
            if not found:
                sys.exit(f"no French for the line {line!r}: see FRENCH_LINES")
            line = re.sub(*found[0], line)
        line = re.sub(r"(?<=\d),(?=\d{3})", "\u202f", line)
        out.append(re.sub(r"(?<=\d)\.(?=\d)", ",", line).replace("GB/s", "Go/s"))
    return "\n".join(out) + "\n"


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


def verdict(value, bar, bySphere, byCopy, waitsForMemory):
    """The cells behind the measured value."""
    if bar is None:
        return "| | |"
    met = "yes" if value <= bar * bySphere else "no"
    if waitsForMemory and met == "no" and value <= bar * byCopy:
        met = "by copying"
    copying = number(bar * byCopy) if waitsForMemory else ""
    return f"{bar:g} | {number(bar * bySphere)} | {copying} | {met}"


def tables(runs, bySphere, byCopy):
    """Measured values beside the bars."""
    out = [
        "| stage | ns | bar | by sphere | by copying | met |",
        "| --- | ---: | ---: | ---: | ---: | --- |",
    ]
    for text, name, bar, waitsForMemory in STAGES:
        run = best(runs, name)
        if run:
            ns = nanoseconds(run)
            out.append(f"| {text} | {number(ns)} | {verdict(ns, bar, bySphere, byCopy, waitsForMemory)} |")
    out += [
        "",
        "## End to end",
        "",
        "The SmallTree with 12 iterations, 1,600,000 triangles, from its parameters to the checked mesh with normals.",
        "",
        "| | ms | bar | by sphere | met |",
        "| --- | ---: | ---: | ---: | --- |",
    ]
    for text, name, clock, bar in END_TO_END:
        found = [r for r in runs if r["name"].startswith(name) and r.get("run_type") == "iteration"]
        if found:
            ms = min(r[clock] * {"ms": 1, "s": 1e3, "us": 1e-3, "ns": 1e-6}[r["time_unit"]] for r in found)
            met = "yes" if ms <= bar * bySphere else "no"
            out.append(f"| {text} | {number(ms)} | {bar} | {number(bar * bySphere)} | {met} |")
    out += ["", "## What grows", "", "| | ms | bar | by sphere | met |", "| --- | ---: | ---: | ---: | --- |"]
    for text, name, bar in GROWING:
        found = [r for r in runs if r["name"].split("/")[0] == name and r.get("run_type") == "iteration"]
        if found:
            ms = min(r["cpu_time"] * {"ms": 1, "s": 1e3, "us": 1e-3, "ns": 1e-6}[r["time_unit"]] for r in found)
            met = "yes" if ms <= bar * bySphere else "no"
            out.append(f"| {text} | {number(ms)} | {bar} | {number(bar * bySphere)} | {met} |")
    return out


def page(data):
    runs = data["benchmarks"]
    sphere = best(runs, "BM_openMeshSphere")
    copies = [r for r in runs if r["name"].startswith("BM_copy256MB") and r.get("run_type") == "iteration"]
    if not sphere or not copies:
        sys.exit("the two yardsticks are not among the results: run ./dev bench without a filter")
    copy = max(r["bytes_per_second"] for r in copies) / 1e9
    bySphere, byCopy = nanoseconds(sphere) / REFERENCE_SPHERE, REFERENCE_COPY / copy
    context = data["context"]
    out = [
        "# Speed",
        "",
        "Written by `./dev bench` from its own results; do not edit. Nanoseconds of the processor's time for one",
        f"element, on one thread, the best of all repetitions in {data['context'].get('rounds', 1)} rounds.",
        "",
        "Bars hold as a ratio to two yardsticks measured in the same run: OpenMesh building a sphere of 1,001,112",
        f"triangles face by face ({REFERENCE_SPHERE:.0f} ns per triangle where the bars were set), and copying 256 MB "
        f"({REFERENCE_COPY:.0f} GB/s",
        "there). Rows that only wait for memory may be judged by the second; the table says where only that one is met.",
        "The bars of OBJ and PLY are about positions and triangles.",
        "",
        f"Machine: {context['num_cpus']} processors at {context['mhz_per_cpu']} MHz. Yardsticks: "
        f"{nanoseconds(sphere):.0f} ns per triangle of the sphere ({bySphere:.2f} times the reference); 256 MB copied "
        f"at {copy:.1f} GB/s ({byCopy:.2f} times slower). Programs that wanted a processor when the last round began: "
        f"{context['load_avg'][0]:.0f}; more than there are processors make all figures worse.",
        "",
    ]
    out += tables(runs, bySphere, byCopy)
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
            last = row.get("15", row.get("12"))
            growth = f"{last / row['5']:.2f}" if last and "5" in row else ""
            out.append(f"| {text} | " + " | ".join(cells) + f" | {growth} |")
    big = [r for r in runs if r["name"].startswith("BM_tenMillionVertices") and not r.get("error_occurred")]
    if big:
        out += ["", "## Ten million vertices", "", "Written, read back and compared, 20 million triangles:", ""]
        for name in sorted({run["name"].split("/")[1] for run in big}):
            seconds = min(run["cpu_time"] for run in big if run["name"].split("/")[1] == name)
            out.append(f"- {name.upper()}: {seconds:.1f} s of the processor, equal.")
    return "\n".join(out) + "\n"


def merged(paths):
    """The runs of all rounds."""
    rounds = []
    for path in paths:
        with open(path, encoding="utf-8") as source:
            rounds.append(json.load(source))
    context = {**rounds[-1]["context"], "rounds": len(rounds)}
    return {"context": context, "benchmarks": [run for r in rounds for run in r["benchmarks"]]}


if __name__ == "__main__":
    english, translated = (f"{sys.argv[1]}/{name}" for name in ("performance.md", "fr/performance.md"))
    if len(sys.argv) > 2:
        data = merged(sys.argv[3:])
        with open(sys.argv[2], "w", encoding="utf-8") as target:
            json.dump(data, target, indent=1)
        text = page(data)
        print(text)
        with open(english, "w", encoding="utf-8") as target:
            target.write(text)
    with open(english, encoding="utf-8") as source:
        text = french(source.read())
    with open(translated, "w", encoding="utf-8") as target:
        target.write(text)
