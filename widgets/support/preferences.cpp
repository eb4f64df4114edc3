#include "widgets/support/preferences.h"

#include <QDir>
#include <QFileInfo>

namespace ramure {
namespace {

const QString angleKey = QStringLiteral("units/angle");
const QString themeKey = QStringLiteral("view/theme");
const QString languageKey = QStringLiteral("view/language");
const QString recentKey = QStringLiteral("files/recent");
const QString folderKey = QStringLiteral("files/folder");
const QString foldedKey = QStringLiteral("properties/folded");
const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");

} // namespace

Preferences::Preferences(QObject* parent)
    : QObject(parent)
{
}

void Preferences::store(const QString& key, const QVariant& value)
{
    if (m_settings.value(key) == value)
        return;
    m_settings.setValue(key, value);
    emit changed();
}

AngleUnit Preferences::angleUnit() const
{
    return m_settings.value(angleKey) == QVariant(QStringLiteral("radians")) ? AngleUnit::Radians
                                                                             : AngleUnit::Degrees;
}

void Preferences::setAngleUnit(AngleUnit unit)
{
    store(angleKey, unit == AngleUnit::Radians ? QStringLiteral("radians") : QStringLiteral("degrees"));
}

ThemeChoice Preferences::theme() const
{
    const QString name = m_settings.value(themeKey).toString();
    if (name == QLatin1String("light"))
        return ThemeChoice::Light;
    return name == QLatin1String("dark") ? ThemeChoice::Dark : ThemeChoice::System;
}

void Preferences::setTheme(ThemeChoice theme)
{
    store(themeKey, theme == ThemeChoice::Light  ? QStringLiteral("light")
                    : theme == ThemeChoice::Dark ? QStringLiteral("dark")
                                                 : QStringLiteral("system"));
}

QString Preferences::language() const
{
    return m_settings.value(languageKey).toString();
}

void Preferences::setLanguage(const QString& language)
{
    store(languageKey, language);
}

QStringList Preferences::recentFiles() const
{
    return m_settings.value(recentKey).toStringList();
}

void Preferences::addRecentFile(const QString& path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList files = recentFiles();
    files.removeAll(absolute);
    files.prepend(absolute);
    store(recentKey, QStringList(files.mid(0, maxRecentFiles)));
}

void Preferences::removeRecentFile(const QString& path)
{
    QStringList files = recentFiles();
    files.removeAll(path);
    store(recentKey, files);
}

void Preferences::clearRecentFiles()
{
    store(recentKey, QStringList());
}

QString Preferences::lastFolder() const
{
    const QString folder = m_settings.value(folderKey).toString();
    return !folder.isEmpty() && QDir(folder).exists() ? folder : QDir::homePath();
}

void Preferences::setLastFolder(const QString& folder)
{
    store(folderKey, folder);
}

QStringList Preferences::foldedGroups() const
{
    return m_settings.value(foldedKey).toStringList();
}

void Preferences::setFoldedGroups(const QStringList& groups)
{
    store(foldedKey, groups);
}

QByteArray Preferences::windowGeometry() const
{
    return m_settings.value(geometryKey).toByteArray();
}

QByteArray Preferences::windowState() const
{
    return m_settings.value(stateKey).toByteArray();
}

void Preferences::setWindow(const QByteArray& geometry, const QByteArray& state)
{
    m_settings.setValue(geometryKey, geometry);
    m_settings.setValue(stateKey, state);
}

} // namespace ramure
