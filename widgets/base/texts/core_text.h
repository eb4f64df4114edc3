/// \file
/// Texts of the core in the interface's language (context "core").
#pragma once

#include "core/base/error.h"
#include <QString>

namespace ramure {

/// \param english a RAMURE_NOOP literal or a text of the parameter table.
QString coreText(const char* english);
/// The error's template in the interface's language with its arguments, without the place.
QString errorText(const Error& error);
/// Returns the text of the error with its place in front: "tree.ramure, line 3, column 7: ...".
QString errorTextWithPlace(const Error& error);

/// The name of a preset as it is read: "SilverBirch", "Silver Birch".
QString spacedName(const QString& preset);

} // namespace ramure
