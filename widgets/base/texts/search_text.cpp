#include "widgets/base/texts/search_text.h"

namespace ramure {

QString searchable(const QString& text)
{
    QString plain = text;
    for (QChar& letter : plain) {
        if (letter.decompositionTag() == QChar::Canonical)
            letter = letter.decomposition().front();
        letter = letter.toLower();
    }
    return plain;
}

QStringList searchWords(const QString& typed)
{
    return searchable(typed).split(u' ', Qt::SkipEmptyParts);
}

bool isWordStart(const QString& text, qsizetype place)
{
    return place == 0 || (text[place].isLetterOrNumber() && !text[place - 1].isLetterOrNumber());
}

} // namespace ramure
