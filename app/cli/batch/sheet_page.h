/// \file
/// A contact sheet: one page of HTML with a card for each row of a manifest, that needs nothing from
/// elsewhere.
#pragma once

#include "app/cli/batch/manifest.h"
#include <QStringList>
#include <optional>

namespace ramure::cli {

/// A number by which rows can be told apart. A card shows them in the order of sheetFigures.
struct SheetFigure
{
    const char* key;  ///< key inside "counts" or "measures"
    const char* unit; ///< empty: a number of things
};
inline constexpr SheetFigure sheetFigures[] = {{"faces", ""},   {"branches", ""},    {"leaves", ""},
                                               {"height", "m"}, {"crownWidth", "m"}, {"stemDiameter", "m"},
                                               {"volume", "m³"}};

/// Returns the number of this row, or nothing if the row failed.
std::optional<double> figureOf(const QJsonObject& line, const SheetFigure& figure);

/// Finds the figures of each row that lie far from those of the other rows of its input: they differ from the
/// median by more than five times the median deviation, and by more than a tenth of the median. Inputs of
/// fewer than eight rows have no outliers.
std::map<std::int64_t, QStringList> outliersOf(const ManifestLines& lines);

/// Makes the page. \param pictures the bytes of JPEG files, by row; a row without one has a card without a
/// picture
QByteArray sheetPage(const ManifestLines& lines, const std::map<std::int64_t, QByteArray>& pictures);

} // namespace ramure::cli
