#include "widgets/view/render/display_mode.h"

#include <algorithm>

namespace ramure {

const DisplayModeRow& rowOf(DisplayMode mode)
{
    return *std::ranges::find(displayModes(), mode, &DisplayModeRow::mode);
}

std::optional<DisplayMode> displayModeFromName(std::string_view name)
{
    for (const DisplayModeRow& row : displayModes())
        if (name == row.name())
            return row.mode;
    return std::nullopt;
}

} // namespace ramure
