/// \file
/// Rows of the form of the export dialog. Internal to export_dialog.cpp and its parts.
#pragma once

namespace ramure {

/// Rows of the form, from the top.
enum Row {
    KeptRow,
    FormatRow,
    PrintRow,
    ModelRow,
    PartsRow,
    FoliageRow,
    LevelRow,
    MapRow,
    SpaceRow,
    TreesRow,
    MomentRow,
    PictureRow,
    FileRow
};

/// Pixels a side; 0: no pictures.
inline constexpr int mapSizes[] = {0, 256, 512, 1024, 2048, 4096};

} // namespace ramure
