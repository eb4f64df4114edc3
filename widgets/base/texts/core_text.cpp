#include "widgets/base/texts/core_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStringList>

namespace ramure {

QString coreText(const char* english)
{
    return QCoreApplication::translate("core", english);
}

QString errorText(const Error& error)
{
    const QByteArray translated = coreText(error.text).toUtf8();
    Error copy = error;
    copy.text = translated.constData();
    return QString::fromStdString(copy.plain());
}

QString errorTextWithPlace(const Error& error)
{
    QStringList place;
    if (!error.file.empty())
        place += QFileInfo(QString::fromStdString(error.file)).fileName();
    if (!error.path.empty())
        place += QString::fromStdString(error.path);
    if (error.line > 0)
        place += QCoreApplication::translate("Errors", "line %1").arg(error.line);
    if (error.column > 0)
        place += QCoreApplication::translate("Errors", "column %1").arg(error.column);
    const QString text = errorText(error);
    return place.isEmpty() ? text : QStringLiteral("%1: %2").arg(place.join(QStringLiteral(", ")), text);
}

QString spacedName(const QString& preset)
{
    static const QRegularExpression word(QStringLiteral("(?<=[a-z])(?=[A-Z][a-z]|1995$)"));
    return QString(preset).replace(word, QStringLiteral(" "));
}

} // namespace ramure
