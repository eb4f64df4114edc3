"""Our folder for Godot before the importer of Debian's Godot 3:  godot_judge.py RAMURE_CLI FOLDER
Each level is a scene with its meshes, each piece for collision a body. One line; 1 where something was found."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

cli, folder = sys.argv[1], pathlib.Path(sys.argv[2])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
tree = folder / "tree"
subprocess.run([cli, "export", "preset:TinyTree", "--for", "godot", "--map-size", "64", "-o", tree], check=True)
for name in ("tree.tscn", "ramure_tree.gd", "ramure_wind.gdshader"):
    (tree / name).unlink()  # these are for Godot 4
(folder / "project.godot").write_text('config_version=4\n[application]\nconfig/name="judge"\n')
(folder / "judge.gd").write_text('''extends SceneTree
func tell(level, node):
	print("%d %s %s" % [level, node.get_class(), node.name])
	for child in node.get_children():
		tell(level, child)
func _init():
	for level in 4:
		tell(level, load("res://tree/tree_LOD%d.glb" % level).instance())
	quit()
''')


def start(*words):
    return subprocess.Popen(["godot3-server", "--path", folder, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            env={**os.environ, "HOME": str(folder)})


# The editor imports what it finds, and does not end by itself.
editor = start("--editor", "--quit")
for _ in range(240):
    if len(list(folder.glob(".import/*.md5"))) == 4 or editor.poll() is not None:
        break
    time.sleep(0.5)
editor.kill()
version = re.search(r"v(\d+\.\d+\.\d+)", editor.communicate()[0])
told = re.findall(r"^(\d) (\w+) (\S+)", start("-s", "judge.gd").communicate(timeout=120)[0], re.MULTILINE)
findings = []
for level in range(4):
    meshes = [name for number, kind, name in told if int(number) == level and kind == "MeshInstance"]
    bodies = [name for number, kind, name in told if int(number) == level and kind == "StaticBody"]
    if len(meshes) != (1 if level == 3 else 3):
        findings.append(f"level {level} has the meshes {meshes}")
    if (len(bodies) > 0) != (level == 0):
        findings.append(f"level {level} has {len(bodies)} bodies")
print(f"Godot {version.group(1) if version else '?'}: 4 levels, {sum(kind == 'StaticBody' for _, kind, _ in told)} bodies" +
      (f"; FOUND: {'; '.join(findings)}" if findings else ""))
sys.exit(1 if findings else 0)
