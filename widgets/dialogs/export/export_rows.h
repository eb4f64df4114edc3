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
    WindRow,
    MapRow,
    SpaceRow,
    TreesRow,
    MomentRow,
    JointRow,
    PictureRow,
    FileRow
};

/// Pixels a side; 0: no pictures.
inline constexpr int mapSizes[] = {0, 256, 512, 1024, 2048, 4096};
/// Of a tree that moves, at most; 0: all that it has.
inline constexpr int jointLimits[] = {64, 110, 256, 0};

} // namespace ramure
