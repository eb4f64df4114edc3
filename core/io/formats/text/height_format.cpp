#include "core/io/formats/file_format.h"
#include "core/io/formats/text/blender_scene.h"
#include "core/io/grey_picture.h"
#include "core/io/read_parts.h"
#include <algorithm>

namespace ramure {

namespace {

/// Vertices a side: what the view and half-edges carry easily.
constexpr int mostVertices = 1024;
/// A picture of bytes or words does not say how high white is: a tenth of its longer side.
constexpr double whiteHeight = 0.1;

/// Upright, the picture's upper edge at the least Z, its middle at the origin; a pixel is a metre.
TriangleMesh gridOf(const GreyPicture& picture, double scale)
{
    const auto columns = static_cast<Index>(std::clamp(picture.width, 2, mostVertices));
    const auto rows = static_cast<Index>(std::clamp(picture.height, 2, mostVertices));
    TriangleMesh mesh;
    for (Index row = 0; row < rows; ++row)
        for (Index column = 0; column < columns; ++column) {
            const double u = double(column) / (columns - 1), v = double(row) / (rows - 1);
            mesh.positions.emplace_back((u - 0.5) * picture.width, scale * picture.at(u, v),
                                        (v - 0.5) * picture.height);
            mesh.uv.emplace_back(u, 1.0 - v);
        }
    for (Index row = 0; row + 1 < rows; ++row)
        for (Index column = 0; column + 1 < columns; ++column) {
            const Index a = row * columns + column, b = a + 1, c = a + columns, d = c + 1;
            mesh.triangles.emplace_back(a, c, b);
            mesh.triangles.emplace_back(b, c, d);
        }
    return mesh;
}

Expected<ReadMesh> readHeights(const std::string& path, const Progress& progress)
{
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    const auto picture = readGreyPicture(path);
    RAMURE_TRY(picture);
    const int longer = std::max(picture->width, picture->height);
    ReadMesh out;
    const bool areMetres = picture->kind == GreyPicture::Kind::Numbers;
    out.objects.push_back(
        {reading::stem(path), gridOf(*picture, areMetres ? 1.0 : whiteHeight * longer), {}});
    if (longer > mostVertices)
        out.notes.push_back("thinned out to " + std::to_string(mostVertices) + " vertices a side");
    progress.report(1.0);
    return out;
}

} // namespace

extern const FileFormat heightPngFormat, heightExrFormat;
const FileFormat heightPngFormat = {
    .id = "heights-png",
    .ending = "png",
    .name = RAMURE_NOOP("Picture of heights"),
    .read = &readHeights,
    .import = &importBlender,
};
const FileFormat heightExrFormat = {
    .id = "heights-exr",
    .ending = "exr",
    .name = RAMURE_NOOP("Picture of heights"),
    .read = &readHeights,
    .import = &importBlender,
};

} // namespace ramure
