#include "core/io/pivot_files.h"

#include "core/io/exr_file.h"

namespace ramure {

PivotPaths pivotPaths(const std::string& path, const ExportPivots& pivots)
{
    const std::size_t name = path.find_last_of('/') + 1, dot = path.find_last_of('.');
    const bool hasEnding = dot != std::string::npos && dot > name;
    const std::string stem = path.substr(0, hasEnding ? dot : path.size()) + pivots.suffix;
    return {stem + "_pivots.exr", stem + "_axes.exr"};
}

Expected<void> writePivots(const std::string& path, const ExportScene& scene)
{
    for (const ExportPivots& pivots : scene.pivots) {
        const PivotPaths paths = pivotPaths(path, pivots);
        const PivotTextures& textures = pivots.textures;
        const int width = static_cast<int>(textures.width), height = static_cast<int>(textures.height);
        if (auto written = writeExr(paths.pivots, width, height, textures.pivots); !written)
            return written;
        if (auto written = writeExr(paths.axes, width, height, textures.axes); !written)
            return written;
    }
    return {};
}

} // namespace ramure
