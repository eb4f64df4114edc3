#include "core/io/formats/file_format.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/io/read_parts.h"

namespace ramure {

static Expected<ReadMesh> importObj(const std::string& path, const Progress& progress)
{
    return reading::readObjFile(path, progress, materialsBeside(path));
}

static Expected<void> exportObj(const std::string& path, const ExportScene& scene,
                                const WriteOptions& options, const Progress& progress)
{
    return scene.lines ? writeObjLines(path, *scene.lines, progress, options.comment)
                       : writeObj(path, flattened(scene).parts(), progress, options);
}

static FileRates objRates(bool texture, double digits)
{
    return {texture ? 90.0 : 62.0, 3.0 * ((texture ? 3.0 : 2.0) * digits + 3.0) + 2.0};
}

extern const FileFormat objFormat;
const FileFormat objFormat = {
    .id = "obj",
    .ending = "obj",
    .name = RAMURE_NOOP("Wavefront OBJ"),
    .choice = RAMURE_NOOP("Wavefront OBJ, with materials"),
    .help =
        "with an .mtl and the pictures of the bark beside it: objects branches, leaves, apples, with normals",
    .holds = holdsObjects | holdsTexture | holdsSpace | holdsLines,
    .beside = "mtl",
    .read = &importObj,
    .import = &importBlender,
    .write = &exportObj,
    .rates = &objRates,
};

} // namespace ramure
