/// \file
/// The reference of ramure-cli and the editor. All of it comes from the tables of commands and options.
#pragma once

#include <QString>

namespace ramure::cli {

/// Returns the text of `ramure-cli --help`.
QString helpText();
/// The manual pages, in the macros of man(7).
QString manualText();
QString editorManualText();
/// A script that bash-completion loads: one function for both programs.
QString completionText();

} // namespace ramure::cli
