/// \file
/// What ramure-cli says of itself and of the editor. All of it comes from the tables of commands and options.
#pragma once

#include <QString>

namespace ramure::cli {

/// What `ramure-cli --help` shows.
QString helpText();
/// The manual pages, in the macros of man(7).
QString manualText();
QString editorManualText();
/// A script that bash-completion loads: one function for both programs.
QString completionText();

} // namespace ramure::cli
