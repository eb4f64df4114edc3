#include "app/cli/file_space_options.h"

#include <iterator>

namespace ramure::cli {

void addSpaceOptions(CommandLine& line)
{
    QStringList units;
    for (const LengthUnit& unit : lengthUnits)
        units << QLatin1String(unit.name);
    line.add({QStringLiteral("up")},
             QStringLiteral("The axis of the mesh file that points up; in the program it is y."),
             QStringLiteral("y|z"));
    line.add({QStringLiteral("unit")}, QStringLiteral("What a 1 in the mesh file is; m is the default."),
             units.join(QLatin1Char('|')));
    line.add({QStringLiteral("scale")},
             QStringLiteral("How much larger than in the program things are in the mesh file besides."),
             QStringLiteral("NUMBER"));
}

Expected<std::optional<FileSpace>> fileSpaceFrom(const CommandLine& line)
{
    if (!line.has("up") && !line.has("unit") && !line.has("scale"))
        return std::optional<FileSpace>();
    const auto named = [](const char* option, Error error) {
        error.path = option;
        return fail(std::move(error));
    };
    FileSpace space;
    if (line.has("up")) {
        const auto up = upAxisNamed(line.value("up").toStdString());
        if (!up)
            return named("--up", up.error());
        space.up = *up;
    }
    if (line.has("unit")) {
        const auto unit = lengthUnitNamed(line.value("unit").toStdString());
        if (!unit)
            return named("--unit", unit.error());
        space.unit = *unit;
    }
    if (line.has("scale")) {
        bool isNumber = false;
        const double number = line.value("scale").toDouble(&isNumber);
        const auto scale =
            isNumber ? fileScaleOf(number)
                     : fail(ErrorCode::Syntax, "\"%1\" is not a number", {line.value("scale").toStdString()});
        if (!scale)
            return named("--scale", scale.error());
        space.scale = *scale;
    }
    return std::optional(space);
}

} // namespace ramure::cli
