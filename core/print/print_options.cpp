#include "core/print/print_options.h"

#include "core/base/number_text.h"
#include <charconv>
#include <cmath>
#include <string_view>

namespace ramure {
namespace {

constexpr PrintProcessFacts facts[] = {
    {"fdm", RAMURE_NOOP("Filament (FDM)"), 0.0020},
    {"resin", RAMURE_NOOP("Resin"), 0.0008},
    {"powder", RAMURE_NOOP("Powder"), 0.0010},
};

constexpr const char* leafNames[] = {"off", "shells"};

std::string inMillimetres(double metres)
{
    return numberText(1000.0 * metres);
}

Expected<void> checkLength(const char* text, double metres, double least, double most)
{
    if (metres >= least && metres <= most)
        return {};
    return fail(ErrorCode::Invalid, text, {inMillimetres(metres), inMillimetres(least), inMillimetres(most)});
}

} // namespace

std::span<const PrintProcessFacts> printProcesses()
{
    return facts;
}

const char* nameOf(PrintLeaves leaves)
{
    return leafNames[static_cast<std::size_t>(leaves)];
}

double PrintOptions::smallestDiameter() const
{
    return thinnest == 0.0 ? facts[static_cast<std::size_t>(process)].thinnest : thinnest;
}

Expected<void> checkPrint(const PrintOptions& options)
{
    if (auto height = checkLength(RAMURE_NOOP("a print of %1 mm: a height from %2 to %3 mm expected"),
                                  options.height, PrintOptions::leastHeight, PrintOptions::mostHeight);
        !height)
        return height;
    const double thinnest = options.smallestDiameter();
    if (auto thin = checkLength(RAMURE_NOOP("twigs of %1 mm: a thickness from %2 to %3 mm expected"),
                                thinnest, PrintOptions::leastThinnest, PrintOptions::mostThinnest);
        !thin)
        return thin;
    if (thinnest > 0.2 * options.height)
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("twigs of %1 mm are too thick for a print of %2 mm: a fifth at most"),
                    {inMillimetres(thinnest), inMillimetres(options.height)});
    if (options.mostTriangles < 1000)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a print needs 1000 triangles at least"));
    return {};
}

Expected<double> printLength(const std::string& text)
{
    double number = 0.0;
    const char* const last = text.data() + text.size();
    const auto [end, problem] = std::from_chars(text.data(), last, number);
    std::string_view unit(end, static_cast<std::size_t>(last - end));
    while (unit.starts_with(' '))
        unit.remove_prefix(1);
    constexpr std::pair<std::string_view, double> units[] = {
        {"", 1e-3}, {"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"in", 0.0254}};
    for (const auto& [name, metres] : units)
        if (problem == std::errc() && std::isfinite(number) && unit == name)
            return number * metres;
    return fail(ErrorCode::Syntax, RAMURE_NOOP("\"%1\" is no length: such as 180mm, 18cm or 7in expected"),
                {text});
}

} // namespace ramure
