/// \file
/// Texts as a search compares them.
#pragma once

#include <QString>
#include <QStringList>

namespace ramure {

/// Lower case without accents. Letter for letter: a place in the result is the same place in \p text.
QString searchable(const QString& text);
/// Splits a typed text into words, as searchable() writes them.
QStringList searchWords(const QString& typed);
/// Whether a word begins at \p place.
bool isWordStart(const QString& text, qsizetype place);

} // namespace ramure
