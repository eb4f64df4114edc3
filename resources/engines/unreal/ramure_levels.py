"""Makes the imported meshes NAME_LOD1, NAME_LOD2 ... the levels of NAME_LOD0: Tools > Execute Python Script."""
import unreal

NAME = "@NAME@"
SIZES = [@UNREAL_SIZES@]  # of the screen, from which on each level is shown

found = {}
for asset in unreal.EditorAssetLibrary.list_assets("/Game", recursive=True):
    name = asset.split("/")[-1].split(".")[0]
    if name.startswith(NAME + "_LOD") and name[len(NAME) + 4:].isdigit():
        mesh = unreal.EditorAssetLibrary.load_asset(asset)
        if isinstance(mesh, unreal.StaticMesh):
            found[int(name[len(NAME) + 4:])] = mesh
editor = unreal.get_editor_subsystem(unreal.StaticMeshEditorSubsystem)
for level in sorted(found)[1:]:
    editor.set_lod_from_static_mesh(found[0], level, found[level], 0, True)
editor.set_lod_screen_sizes(found[0], SIZES[:len(found)])
unreal.EditorAssetLibrary.save_loaded_asset(found[0])
