/// \file
/// How numbers of one parameter are shown and read: the unit of the interface, the decimals, the ending.
#pragma once

#include "core/params/param_def.h"
#include <QString>

namespace ramure {

/// Angles are radians inside the program; the interface shows degrees or radians (a preference).
enum class AngleUnit { Degrees, Radians };

struct NumberFormat
{
    ParamUnit unit = ParamUnit::None;
    double factor = 1.0; ///< shown = value * factor
    QString suffix;      ///< with its space, such as " m"
    int decimals = 2;    ///< digits behind the point that are shown
    bool whole = false;  ///< an integer
    QString atZero{};    ///< shown in the place of 0, where that is no number but a wish; empty: 0

    /// Writes the value with the locale's decimal sign and without group separators. Small values get the
    /// decimals they need to show three digits, but only down to where the unit has no use any more: a rest
    /// of arithmetic is shown as 0, never as -0 nor with an exponent.
    [[nodiscard]] QString text(double value) const;
    /// Arithmetic and units (core/generators/parametric/quantity.h); integers are rounded.
    [[nodiscard]] Expected<double> parse(const QString& text) const;
};

NumberFormat numberFormat(const ParamDef& def, AngleUnit angles);

/// "1 to 64", "at least 0 m" ... of the numbers a parameter accepts; empty for texts and flags.
QString rangeText(const ParamDef& def, AngleUnit angles);

} // namespace ramure
