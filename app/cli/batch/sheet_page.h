/// \file
/// A contact sheet: one page of HTML with a card for each row of a manifest, that needs nothing from
/// elsewhere.
#pragma once

#include "app/cli/batch/manifest.h"
#include <QStringList>
#include <optional>

namespace ramure::cli {

/// What one can tell rows by, in the order of a card.
struct SheetFigure
{
    const char* key;  ///< of "counts" or "measures"
    const char* unit; ///< empty: a number of things
};
inline constexpr SheetFigure sheetFigures[] = {{"faces", ""},   {"branches", ""},    {"leaves", ""},
                                               {"height", "m"}, {"crownWidth", "m"}, {"stemDiameter", "m"},
                                               {"volume", "m³"}};

/// What a row says of it; nothing where it failed.
std::optional<double> figureOf(const QJsonObject& line, const SheetFigure& figure);

/// Which figures of a row stand apart from those of the other rows of its input: by more than five times the
/// median deviation from their median, and a tenth of that. Inputs of fewer than eight rows have none.
std::map<std::int64_t, QStringList> outliersOf(const ManifestLines& lines);

/// \param pictures bytes of JPEG files by row; a row without one has a card without a picture
QByteArray sheetPage(const ManifestLines& lines, const std::map<std::int64_t, QByteArray>& pictures);

} // namespace ramure::cli
