/// \file
/// FBX through Blender: the program writes a GLB, and Blender, where it is installed, turns that into an FBX.
/// What is known of FBX is secret or second-hand, and Blender's exporter is what engines have been tried
/// with.

#include "core/base/child_process.h"
#include "core/base/file_writer.h"
#include "core/base/number_text.h"
#include "core/io/formats/file_format.h"
#include "core/io/read_parts.h"
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace ramure {

extern const FileFormat glbFormat;

namespace {

/// NumPy has lost a name that the importer of Blender 3.4 asks for. Pictures go into the file.
constexpr const char* script = R"(
import sys, bpy, numpy
if "bool" not in vars(numpy):
    numpy.bool = bool
source, target, frames, rate = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.render.fps = max(1, round(float(rate)))
scene.render.fps_base = scene.render.fps / float(rate)
scene.frame_start, scene.frame_end = 0, int(frames) - 1
bpy.ops.import_scene.gltf(filepath=source)
bpy.ops.export_scene.fbx(filepath=target, path_mode="COPY", embed_textures=True, add_leaf_bones=False,
                         bake_anim_use_all_actions=False, bake_anim_use_nla_strips=False,
                         bake_anim_simplify_factor=0.0, mesh_smooth_type="FACE")
)";

/// A folder that is gone when this is.
class Folder
{
public:
    Folder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "ramure-fbx-XXXXXX").string();
        if (mkdtemp(name.data()))
            m_path = name;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder()
    {
        std::error_code ignored;
        if (!m_path.empty())
            std::filesystem::remove_all(m_path, ignored);
    }
    [[nodiscard]] std::string file(const char* name) const { return m_path + "/" + name; }
    [[nodiscard]] bool exists() const { return !m_path.empty(); }

private:
    std::string m_path;
};

/// The last line that tells of an error; else the last one.
std::string reasonIn(const std::string& said)
{
    std::istringstream lines(said);
    std::string reason;
    bool isError = false;
    for (std::string line; std::getline(lines, line);) {
        const bool tells = line.find("Error") != std::string::npos;
        if (tells || (!isError && !line.empty()))
            reason = line;
        isError = isError || tells;
    }
    return reason;
}

/// Frames a second.
double rateOf(const ExportScene& scene)
{
    const double length = scene.frames.back().seconds - scene.frames.front().seconds;
    return length > 0.0 ? double(scene.frames.size() - 1) / length : 24.0;
}

Expected<void> exportFbx(const std::string& path, const ExportScene& scene, const WriteOptions& options,
                         const Progress& progress)
{
    if (!isInstalled("blender"))
        return fail(
            ErrorCode::Unknown,
            RAMURE_NOOP("FBX is written by Blender, which is not installed: install it, or write a GLB"));
    const Folder folder;
    if (!folder.exists())
        return fail(ErrorCode::Io, RAMURE_NOOP("no temporary folder can be made"));
    RAMURE_TRY(glbFormat.write(folder.file("tree.glb"), scene, options, progress.part(0.0, 0.3)));
    const auto ran =
        runProcess({"blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python-expr", script,
                    "--", folder.file("tree.glb"), folder.file("tree.fbx"),
                    std::to_string(scene.frames.size()), numberText(rateOf(scene))},
                   progress.part(0.3, 0.9));
    RAMURE_TRY(ran);
    if (ran->exitCode != 0 || !std::filesystem::exists(folder.file("tree.fbx")))
        return fail(ErrorCode::Io, RAMURE_NOOP("Blender cannot write the FBX: %1"), {reasonIn(ran->said)});
    const auto bytes = reading::loadFile(folder.file("tree.fbx"));
    RAMURE_TRY(bytes);
    return writeFile(path, *bytes);
}

FileRates fbxRates(bool texture, double /*digits*/)
{
    return {texture ? 60.0 : 40.0, 20.0};
}

} // namespace

extern const FileFormat fbxFormat;
const FileFormat fbxFormat = {
    .id = "fbx",
    .ending = "fbx",
    .name = RAMURE_NOOP("FBX, by Blender"),
    .choice = RAMURE_NOOP("FBX, written by Blender where it is installed"),
    .help = "by Blender, where it is installed: meshes, materials with their pictures, skins and motion",
    .holds = holdsObjects | holdsTexture | holdsClip,
    .write = &exportFbx,
    .rates = &fbxRates,
};

} // namespace ramure
