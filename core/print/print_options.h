/// \file
/// How a tree is to be printed.
#pragma once

#include "core/base/error.h"
#include "core/base/index.h"
#include <span>
#include <string>

namespace ramure {

enum class PrintProcess : std::uint8_t {
    Fdm,    ///< melted filament
    Resin,  ///< cured by light
    Powder, ///< sintered
};

struct PrintProcessFacts
{
    const char* name;  ///< "fdm": on the command line and in reports
    const char* title; ///< English, context "core"
    double thinnest;   ///< m, the smallest diameter that comes out whole
};
/// Returns the facts of all processes, in the order of the enum.
std::span<const PrintProcessFacts> printProcesses();

enum class PrintLeaves : std::uint8_t {
    Off,
    Shells, ///< closed and as thick as the thinnest twig, each grown together with its twig
};
/// "off", "shells": on the command line and in reports.
const char* nameOf(PrintLeaves leaves);

struct PrintOptions
{
    static constexpr double leastHeight = 0.005, mostHeight = 2.0;       ///< m
    static constexpr double leastThinnest = 0.0001, mostThinnest = 0.05; ///< m

    PrintProcess process = PrintProcess::Fdm;
    double height = 0.18;    ///< m, from the ground to the top
    double thinnest = 0.0;   ///< m, diameter; 0: that of the process
    bool hasFootDisc = true; ///< on which it stands; else the trunk is cut flat at the ground
    PrintLeaves leaves = PrintLeaves::Off;
    Index mostTriangles = 900'000; ///< slicers choke on a million

    [[nodiscard]] double smallestDiameter() const; ///< m
    bool operator==(const PrintOptions&) const = default;
};

/// Errors: Invalid (no number, out of its range, thicker than a fifth of the height), with what was expected.
Expected<void> checkPrint(const PrintOptions& options);

/// "180mm", "18 cm", "1.2" (mm) as metres. Error: Syntax.
Expected<double> printLength(const std::string& text);

} // namespace ramure
