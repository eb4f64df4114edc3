#include "core/io/formats/file_format.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/io/read_parts.h"

namespace ramure {

static Expected<void> exportPly(const std::string& path, const ExportScene& scene,
                                const WriteOptions& options, const Progress& progress)
{
    return scene.lines ? writePlyLines(path, *scene.lines, options)
                       : writePly(path, flattened(scene).parts(), options, progress);
}

static FileRates textRates(bool texture, double digits)
{
    return {75.0, 3.0 * (digits + 1.0) + 2.0 + (texture ? 60.0 : 0.0)};
}

static FileRates binaryRates(bool texture, double /*digits*/)
{
    return {35.0, texture ? 38.0 : 13.0};
}

extern const FileFormat plyFormat, plyTextFormat;
const FileFormat plyFormat = {
    .id = "ply",
    .ending = "ply",
    .name = RAMURE_NOOP("Stanford PLY"),
    .choice = RAMURE_NOOP("PLY, binary"),
    .help = "binary unless --ascii; vertices with normal, colour, branch id and level",
    .holds = holdsTexture | holdsSpace | holdsLines,
    .read = &reading::readPlyFile,
    .import = &importBlender,
    .write = &exportPly,
    .rates = &binaryRates,
};
const FileFormat plyTextFormat = {
    .id = "ply-text",
    .ending = "ply",
    .name = RAMURE_NOOP("Stanford PLY"),
    .choice = RAMURE_NOOP("PLY, text"),
    .holds = holdsTexture | holdsSpace | holdsLines,
    .isText = true,
    .write = &exportPly,
    .rates = &textRates,
};

} // namespace ramure
