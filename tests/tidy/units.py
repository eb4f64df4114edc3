"""What clang-tidy looks at in one go: most of its time is the reading of headers, so sources of the same flags go by the
dozen, but for those that give one name to different things. Prints a line each: UNIT SOURCE..., and writes the
compilation database of units and sources.

units.py compile_commands.json FOLDER SOURCE..."""
import json
import os
import re
import sys

MOST = 16
# Where a line starts at the margin, the last name before one of these: what it declares.
DECLARED = re.compile(r"^(?!using namespace|namespace|template|extern|public|private|protected|static_assert).*?(\w+)\s*(?:\(|=|\{|;|\[|:(?!:)|$)")


def names(path):
    found = set()
    with open(path, encoding="utf-8") as source:
        for line in source:
            match = DECLARED.match(line.rstrip()) if line[0].isalpha() else None
            if match and not line[:match.start(1)].endswith("::"):
                found.add(match.group(1))
    return found


def flags(entry):
    """Of its command: no warnings of the compiler, and no headers that it precompiled, which clang cannot read."""
    kept = re.sub(r" -include \S*cmake_pch\.hxx| -W\S+| -fpch-preprocess| -fno-math-errno", "", entry["command"])
    return re.sub(r" -o .*", " -w", kept)


def main():
    commands, folder, sources = sys.argv[1], sys.argv[2], sys.argv[3:]
    top = os.getcwd()
    with open(commands, encoding="utf-8") as database:
        by_file = {entry["file"]: entry for entry in json.load(database)}
    groups = {}  # flags: lists of sources, with all names of each
    for source in sources:
        declared = names(source)
        for group, taken in groups.setdefault(flags(by_file[os.path.join(top, source)]), []):
            if len(group) < MOST and not taken & declared:
                group.append(source)
                taken |= declared
                break
        else:
            groups[flags(by_file[os.path.join(top, source)])].append(([source], declared))
    os.makedirs(folder, exist_ok=True)
    entries = []
    for same, lists in groups.items():
        for group, _ in lists:
            unit = os.path.join(top, folder, f"{len(entries)}.cpp")
            for path in [unit] + [os.path.join(top, source) for source in group]:
                entries.append({"directory": by_file[os.path.join(top, group[0])]["directory"],
                                "command": f"{same} -c {path}", "file": path})
            print(unit, *group)
    with open(os.path.join(folder, "compile_commands.json"), "w", encoding="utf-8") as database:
        json.dump(entries, database)


main()
