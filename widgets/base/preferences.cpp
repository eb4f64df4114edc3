#include "widgets/base/preferences.h"

#include <QDir>
#include <QFileInfo>
#include <QVariantMap>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

const QString angleKey = QStringLiteral("units/angle");
const QString themeKey = QStringLiteral("view/theme");
const QString languageKey = QStringLiteral("view/language");
const QString navigationKey = QStringLiteral("view/navigation");
const QString groundKey = QStringLiteral("view/ground");
const QString autosaveKey = QStringLiteral("files/autosaveMinutes");
const QString timeKey = QStringLiteral("units/time");
const QString motionMemoryKey = QStringLiteral("motion/memoryMb");
const QString welcomeKey = QStringLiteral("view/welcomeAtStart");
const QString shortcutsKey = QStringLiteral("shortcuts");
const QString recentKey = QStringLiteral("files/recent");
const QString folderKey = QStringLiteral("files/folder");
const QString exportSpaceKey = QStringLiteral("files/exportSpace");
const QString findsKey = QStringLiteral("window/recentFinds");
const QString tourKey = QStringLiteral("window/tourSeen");
const QString foldedKey = QStringLiteral("properties/folded");
const QString toolsKey = QStringLiteral("window/tools");
const QString columnsKey = QStringLiteral("scene/columns");
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

NavigationStyle Preferences::navigationStyle() const
{
    return m_settings.value(navigationKey) == QVariant(QStringLiteral("maya")) ? NavigationStyle::Maya
                                                                               : NavigationStyle::Blender;
}

void Preferences::setNavigationStyle(NavigationStyle style)
{
    store(navigationKey, style == NavigationStyle::Maya ? QStringLiteral("maya") : QStringLiteral("blender"));
}

bool Preferences::groundVisible() const
{
    return m_settings.value(groundKey, true).toBool();
}

void Preferences::setGroundVisible(bool on)
{
    store(groundKey, on);
}

int Preferences::autosaveMs() const
{
    constexpr double msPerMinute = 60'000.0;
    bool good = false;
    const double minutes = m_settings.value(autosaveKey).toDouble(&good);
    if (!good || !std::isfinite(minutes))
        return defaultAutosaveMinutes * static_cast<int>(msPerMinute);
    return static_cast<int>(std::clamp(minutes, 0.0, double{maxAutosaveMinutes}) * msPerMinute);
}

int Preferences::autosaveMinutes() const
{
    constexpr int msPerMinute = 60'000;
    return (autosaveMs() + msPerMinute - 1) / msPerMinute;
}

void Preferences::setAutosaveMinutes(int minutes)
{
    store(autosaveKey, std::clamp(minutes, 0, maxAutosaveMinutes));
}

TimeDisplay Preferences::timeDisplay() const
{
    const QString name = m_settings.value(timeKey).toString();
    if (name == QLatin1String("seconds"))
        return TimeDisplay::Seconds;
    return name == QLatin1String("timecode") ? TimeDisplay::Timecode : TimeDisplay::Frames;
}

void Preferences::setTimeDisplay(TimeDisplay display)
{
    store(timeKey, display == TimeDisplay::Seconds    ? QStringLiteral("seconds")
                   : display == TimeDisplay::Timecode ? QStringLiteral("timecode")
                                                      : QStringLiteral("frames"));
}

int Preferences::motionMemoryMb() const
{
    bool good = false;
    const int megabytes = m_settings.value(motionMemoryKey).toInt(&good);
    return good ? std::clamp(megabytes, leastMotionMb, mostMotionMb) : defaultMotionMb;
}

void Preferences::setMotionMemoryMb(int megabytes)
{
    store(motionMemoryKey, std::clamp(megabytes, leastMotionMb, mostMotionMb));
}

bool Preferences::welcomeAtStart() const
{
    return m_settings.value(welcomeKey, true).toBool();
}

void Preferences::setWelcomeAtStart(bool on)
{
    store(welcomeKey, on);
}

void Preferences::restoreDefaults()
{
    for (const QString& key : {angleKey, timeKey, themeKey, languageKey, navigationKey, groundKey,
                               autosaveKey, motionMemoryKey, welcomeKey})
        m_settings.remove(key);
    emit changed();
}

QMap<QString, QKeySequence> Preferences::shortcuts() const
{
    QMap<QString, QKeySequence> found;
    const QVariantMap stored = m_settings.value(shortcutsKey).toMap();
    for (auto it = stored.begin(); it != stored.end(); ++it)
        found.insert(it.key(), QKeySequence::fromString(it.value().toString(), QKeySequence::PortableText));
    return found;
}

void Preferences::setShortcut(const QString& action, const std::optional<QKeySequence>& keys)
{
    QVariantMap stored = m_settings.value(shortcutsKey).toMap();
    if (keys)
        stored.insert(action, keys->toString(QKeySequence::PortableText));
    else
        stored.remove(action);
    store(shortcutsKey, stored);
}

void Preferences::clearShortcuts()
{
    store(shortcutsKey, QVariantMap());
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

FileSpace Preferences::exportSpace() const
{
    const QString text = m_settings.value(exportSpaceKey).toString();
    return fileSpaceIn("# " + text.toStdString()).value_or(FileSpace());
}

void Preferences::setExportSpace(const FileSpace& space)
{
    store(exportSpaceKey, QString::fromStdString(space.comment()));
}

QVariantMap Preferences::toolSettings() const
{
    return m_settings.value(toolsKey).toMap();
}

void Preferences::setToolSettings(const QVariantMap& settings)
{
    if (settings != toolSettings())
        store(toolsKey, settings);
}

QStringList Preferences::recentFinds() const
{
    return m_settings.value(findsKey).toStringList();
}

void Preferences::addRecentFind(const QString& name)
{
    QStringList names = recentFinds();
    names.removeAll(name);
    names.prepend(name);
    m_settings.setValue(findsKey, names.mid(0, maxRecentFinds));
}

bool Preferences::tourSeen() const
{
    return m_settings.value(tourKey, false).toBool();
}

void Preferences::setTourSeen()
{
    m_settings.setValue(tourKey, true);
}

QStringList Preferences::foldedGroups() const
{
    return m_settings.value(foldedKey).toStringList();
}

void Preferences::setFoldedGroups(const QStringList& groups)
{
    store(foldedKey, groups);
}

std::optional<QStringList> Preferences::sceneColumns() const
{
    const QVariant stored = m_settings.value(columnsKey);
    return stored.isValid() ? std::optional(stored.toStringList()) : std::nullopt;
}

void Preferences::setSceneColumns(const QStringList& columns)
{
    store(columnsKey, columns);
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
