#!/usr/bin/env python3
"""Writes the handbook's page of the other programs in both languages from what peers.py measured and what documents.json
quotes: page.py PEERS.json FOLDER writes FOLDER/peers.md and FOLDER/fr/peers.md."""

import json
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
TEXTS = json.loads((HERE / "texts.json").read_text(encoding="utf-8"))
LOW, HIGH, NEITHER = -1, 1, 0  # which values are better
REAL = {17: (2, 8), 18: (3, 5)}  # what real trees have


class Check:
    """A row of the tables. `value` gives a number or None for a program's results; `show` writes it."""

    def __init__(self, number, better, value, show=None):
        self.number, self.better, self.value, self.show = number, better, value, show
        self.texts = [TEXTS["checks"][str(number)][language] for language in ("en", "fr")]


def of(name, over=None, times=1):
    def value(found):
        if name not in found or (over and not found.get(over)):
            return None
        return None if found[name] is None else found[name] / (found[over] if over else 1) * times

    return value


def plain(value):
    if value == 0:
        return "0"
    if abs(value) >= 100 or value == int(value):
        return f"{value:,.0f}"
    return f"{value:.2g}" if abs(value) < 1 else f"{value:.3g}"


def both(first, second):
    return lambda found: found[first] + found[second] if first in found else None


def off_budget(found):
    return abs(found["allTriangles"] / found["asked"] - 1) * 100 if "asked" in found and "allTriangles" in found else None


def given(name):
    return lambda found: None if "triangles" not in found else float(found.get(name) is not None)


# Number, which is better, the value; names and how it is measured stand in texts.json.
CHECKS = [
    Check(1, LOW, of("boundaryEdges")),
    Check(2, LOW, of("crowdedEdges")),
    Check(3, LOW, of("bowTies")),
    Check(4, LOW, of("pieces")),
    Check(5, LOW, of("extraVertices", "vertices", 100)),
    Check(6, LOW, both("facesTwice", "flatFaces")),
    Check(7, LOW, of("crossing")),
    Check(8, LOW, both("turnedEdges", "piecesInsideOut")),
    Check(9, LOW, of("seconds")),
    Check(10, LOW, of("seconds", "allTriangles", 1e6)),
    Check(11, LOW, of("memory", None, 1e-6)),
    Check(12, LOW, of("bytes", "allTriangles")),
    Check(13, HIGH, of("sameAgain"), "yes"),
    Check(14, HIGH, of("distinct", "seeds", 100)),
    Check(15, LOW, off_budget),
    Check(16, NEITHER, of("leafReach")),
    Check(17, NEITHER, of("leafAreaIndex")),
    Check(18, NEITHER, of("horton")),
    Check(19, NEITHER, of("forkLoss")),
    Check(20, LOW, of("textureSpread")),
    Check(21, HIGH, given("texturePerMetre"), "yes"),
    Check(22, LOW, of("normalsAway", None, 100)),
]


class Page:
    """One language's page; `french` chooses it."""

    def __init__(self, run, documents, french):
        self.run, self.documents, self.french, self.lines = run, documents, french, []

    def word(self, english):
        return TEXTS["words"][english] if self.french else english

    def reason(self, english):
        """Why something is missing; words of other programs stay as they are."""
        for one, other in TEXTS["reasons"].items() if self.french else ():
            english = english.replace(one, other)
        return english.replace("|", "/")

    def numbers(self, text):
        if not self.french:
            return text
        return text.replace(",", "\u202f").replace(".", ",")

    def add(self, name, **values):
        self.lines += [TEXTS["paragraphs"][name][self.french].format(**values), ""]

    def table(self, head, rows, right=False):
        self.lines.append("| " + " | ".join(head) + " |")
        self.lines.append("| --- |" + (" ---: |" if right else " --- |") * (len(head) - 1))
        self.lines += ["| " + " | ".join(row) + " |" for row in rows]
        self.lines.append("")

    def measured_table(self, task):
        programs = self.run["programs"]
        found = [{"error": p["error"]} if "error" in p else p["tasks"].get(task) for p in programs]
        rows = [[self.word("preset")] + [self.preset(f) for f in found]]
        for name, key in (("of bark", "triangles"), ("of leaves", "leafTriangles"), ("height, m", "height")):
            label = self.word(name) if key == "height" else f"{self.word('triangles')} {self.word(name)}"
            rows.append([label] + [self.count(f, key) for f in found])
        for check in CHECKS:
            if check.number == 15 and task != "game":
                continue
            values = [check.value(f) if f and "error" not in f else None for f in found]
            best = self.best(check, values)
            cells = [self.cell(check, f, v, v is not None and v == best) for f, v in zip(found, values)]
            rows.append([f"{check.number} {check.texts[self.french][0]}"] + cells)
        names = [f"{p['name']} {p.get('version', '')}".strip() for p in programs]
        self.table([self.word("check")] + names, rows, right=True)

    def count(self, found, key):
        if not found or "error" in found:
            return ""
        return self.numbers(plain(found[key])) if key in found else self.word("none")

    def preset(self, found):
        if not found:
            return self.word("no such")
        if "error" in found:
            return self.reason(found["error"])
        return found["preset"] or self.word("own values")

    def nothing(self, found):
        return "" if not found or "error" in found else self.word("not given")

    @staticmethod
    def best(check, values):
        known = [v for v in values if v is not None]
        if not check.better or len(known) < 2 or min(known) == max(known):
            return None
        return max(known) if check.better == HIGH else min(known)

    def cell(self, check, found, value, best):
        if value is None:
            ofFile = found and 9 <= check.number <= 12 and "noFile" in found
            return self.reason(found["noFile"]) if ofFile else self.nothing(found)
        text = self.word("yes" if value else "no") if check.show else self.numbers(plain(value))
        if check.number == 16 and found.get("height"):
            text += self.numbers(f" ({plain(100 * value / found['height'])} %)")
        return f"**{text}**" if best else text

    def losses(self, task):
        """Where Ramure is not the best: one line each."""
        found = {p["name"]: p["tasks"].get(task) for p in self.run["programs"] if not p.get("error")}
        if not found.get("Ramure") or "error" in found["Ramure"]:
            return
        for check in CHECKS:
            values = {n: check.value(f) for n, f in found.items() if f and "error" not in f}
            own, best = values.get("Ramure"), self.best(check, list(values.values()))
            self.unreal(check, own)
            if own is None or best is None or own == best:
                continue
            winners = ", ".join(n for n, v in values.items() if v == best)
            show = (lambda v: self.word("yes" if v else "no")) if check.show else (lambda v: self.numbers(plain(v)))
            name = f"- {check.number} {check.texts[self.french][0]}"
            self.lines.append(f"{name} : {show(own)} ; le meilleur est {winners} avec {show(best)}." if self.french else
                              f"{name}: {show(own)}; the best is {winners} with {show(best)}.")
        self.lines.append("")

    def unreal(self, check, own):
        low, high = REAL.get(check.number, (float("-inf"), float("inf")))
        if own is not None and not low <= own <= high:
            name, value = f"- {check.number} {check.texts[self.french][0]}", self.numbers(plain(own))
            self.lines.append(f"{name} : {value} ; les vrais arbres ont de {low} à {high}." if self.french else
                              f"{name}: {value}; real trees have {low} to {high}.")

    def place(self, name):
        target = self.documents["places"][name]
        if target.startswith("https://"):
            return f"[{list(self.documents['places']).index(name) + 1}]({target})"
        isPage = target in ("files.md", "command-line.md", "growth.md", "hand.md", "python.md")
        return f"[{target[:-3]}]({target})" if isPage else f"`{target}`"

    def stated_cell(self, program, number):
        cell = self.documents["programs"][program].get(str(number))
        if not cell:
            return self.word("not stated"), ""
        return cell[self.french], " ".join(self.place(name) for name in cell[2].split())

    def write(self):
        machine = self.run["machine"]
        self.add("title")
        self.add("written")
        self.add("machine", date=self.run["date"], minutes=f"{self.run['minutes']:.0f}", processor=machine["processor"],
                 cores=machine["cores"], memory=self.numbers(plain(machine["memory"] / 1e9)), system=machine["system"],
                 load=f"{max(0, machine['load'] - 1):.0f}")
        self.add("judge")
        for task, titles in TEXTS["tasks"].items():
            self.lines += [f"## {titles[self.french]}", ""]
            self.measured_table(task)
        self.add("loses")
        for task in TEXTS["tasks"]:
            self.lines += [TEXTS["tasks"][task][self.french] + (" :" if self.french else ":"), ""]
            self.losses(task)
        self.add("linux")
        self.add("how")
        for check in CHECKS:
            name, how = check.texts[self.french]
            self.lines.append(f"- {check.number} **{name}**{' ' if self.french else ''}: {how}.")
        self.lines.append("")
        self.add("stated")
        self.add("sources", read=self.documents["read"])
        for number, titles in TEXTS["stated"].items():
            self.lines += [f"### {number} {titles[self.french]}", ""]
            rows = [[name, *self.stated_cell(name, number)] for name in self.documents["programs"]]
            self.table([self.word("program"), self.word("says"), self.word("place")], rows)
        self.unrun()
        return "\n".join(self.lines).rstrip("\n") + "\n"

    def unrun(self):
        """Checks 1 to 22 of programs that cannot be run, from their documents."""
        ran = {p["name"] for p in self.run["programs"]}
        names = [name for name in self.documents["programs"] if name not in ran]
        self.add("unrun")
        rows = []
        for check in CHECKS:
            cells = [" ".join(self.stated_cell(name, check.number)).strip() for name in names]
            rows.append([f"{check.number} {check.texts[self.french][0]}"] + cells)
        self.table([self.word("check")] + names, rows)


if __name__ == "__main__":
    measured = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    quoted = json.loads((HERE / "documents.json").read_text(encoding="utf-8"))
    for place, french in (("peers.md", False), ("fr/peers.md", True)):
        Path(sys.argv[2], place).write_text(Page(measured, quoted, french).write(), encoding="utf-8")
