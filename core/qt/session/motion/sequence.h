/// \file
/// Sequences of files, one for each frame, for the export dialog and `ramure-cli --frames`.
#pragma once

#include "core/evaluate/evaluator.h"
#include "core/qt/session/export/export_options.h"
#include <cstdint>

namespace ramure {

inline constexpr std::int64_t mostSequenceFrames = 100'000;

/// Frames first, first + step ... up to last.
struct FrameSequence
{
    std::int64_t first = 0, last = 0, step = 1;
    double framesPerSecond = 24.0;

    [[nodiscard]] std::int64_t count() const { return (last - first) / step + 1; }
    [[nodiscard]] std::int64_t frame(std::int64_t index) const { return first + index * step; }
    [[nodiscard]] double timeOf(std::int64_t frameNumber) const
    {
        return double(frameNumber) / framesPerSecond;
    }
};

/// Errors: Invalid (a frame before 0, the last before the first, no step), Limit (more than
/// mostSequenceFrames); path = "first", "last" or "step".
Expected<void> checkSequence(const FrameSequence& frames);

/// "tree.obj" of frame 7: "tree_0007.obj". At least four digits.
std::string numberedFile(const std::string& path, std::int64_t frame);

/// Runs exportScene for every frame, to numbered files; \p rest gives the trees at rest. Errors: those of
/// checkSequence and exportScene. After an error or a cancel, the files written before are whole and stay; no
/// other file is left.
Expected<void> exportSequence(const Scene& scene, const ExportOptions& options, const FrameSequence& frames,
                              const TreeSource& rest, const std::string& path, const Progress& progress = {});

/// Estimates the bytes of one file of the export, for the space that it will take; 0 if unknown.
std::uint64_t estimatedFileBytes(const Scene& scene, const ExportOptions& options, const TreeSource& rest,
                                 const std::string& path);

} // namespace ramure
