#include "widgets/view/render/display_mode.h"

#include <array>

namespace ramure {
namespace {
constexpr std::array<const char*, 7> names{"skeleton", "simplified", "rough",  "sections",
                                           "mesh",     "checker",    "stretch"};
}

std::span<const char* const> displayModeNames()
{
    return names;
}

const char* displayModeName(DisplayMode mode)
{
    return names[static_cast<std::size_t>(mode)];
}

std::optional<DisplayMode> displayModeFromName(std::string_view name)
{
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (name == names[i])
            return static_cast<DisplayMode>(i);
    }
    return std::nullopt;
}

} // namespace ramure
