#include "widgets/base/theme/preferences.h"

#include "core/base/file_writer.h"
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QVariantMap>
#include <algorithm>
#include <cmath>
#include <utility>

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
const QString exportKey = QStringLiteral("files/export");
const QString exportSpaceKey = QStringLiteral("files/exportSpace");
const QString findsKey = QStringLiteral("window/recentFinds");
const QString tourKey = QStringLiteral("window/tourSeen");
const QString favouritesKey = QStringLiteral("gallery/favourites");
const QString foldedKey = QStringLiteral("properties/folded");
const QString lightKey = QStringLiteral("view/light");
const QString toolsKey = QStringLiteral("window/tools");
const QString columnsKey = QStringLiteral("scene/columns");
const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");

// In the order of the enumerations; what is not stored is the first.
const QStringList angleNames{QStringLiteral("degrees"), QStringLiteral("radians")};
const QStringList themeNames{QStringLiteral("system"), QStringLiteral("light"), QStringLiteral("dark")};
const QStringList navigationNames{QStringLiteral("blender"), QStringLiteral("maya")};
const QStringList timeNames{QStringLiteral("frames"), QStringLiteral("seconds"), QStringLiteral("timecode")};

template <class Enum> Enum named(const QVariant& stored, const QStringList& names)
{
    return static_cast<Enum>(std::max<qsizetype>(names.indexOf(stored.toString()), 0));
}

} // namespace

Preferences::Preferences(QObject* parent)
    : QObject(parent)
    , m_rest(this)
{
    constexpr int restMs = 200; // changes come in groups
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMs);
    connect(&m_rest, &QTimer::timeout, this, &Preferences::write);
}

Preferences::~Preferences()
{
    if (m_rest.isActive())
        write();
}

void Preferences::store(const QString& key, const QVariant& value)
{
    if (m_settings.value(key) == value)
        return;
    set(key, value);
    emit changed();
}

void Preferences::set(const QString& key, const QVariant& value)
{
    m_settings.setValue(key, value);
    m_rest.start();
}

/// Qt writes beside and renames, but its settings do not say why they could not, and it leaves the folder to
/// the system.
void Preferences::write()
{
    m_rest.stop();
    QSettings settings; // the same ones; an object that has failed once says so for ever
    settings.sync();
    const std::string path = QFile::encodeName(settings.fileName()).toStdString();
    Expected<void> written;
    if (settings.status() != QSettings::NoError) {
        const auto reason = FileWriter::open(path);
        written = reason ? fail(ErrorCode::Io, RAMURE_NOOP("cannot be written: is the disk full?"))
                         : fail(reason.error());
        written.error().file = path;
    } else if (QFile::exists(settings.fileName())) { // not before anything is set
        written = syncFile(path);
    }
    if (!std::exchange(m_isFailing, !written) && !written)
        emit failed(written.error());
}

AngleUnit Preferences::angleUnit() const
{
    return named<AngleUnit>(m_settings.value(angleKey), angleNames);
}

void Preferences::setAngleUnit(AngleUnit unit)
{
    store(angleKey, angleNames[static_cast<int>(unit)]);
}

ThemeChoice Preferences::theme() const
{
    return named<ThemeChoice>(m_settings.value(themeKey), themeNames);
}

void Preferences::setTheme(ThemeChoice theme)
{
    store(themeKey, themeNames[static_cast<int>(theme)]);
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
    return named<NavigationStyle>(m_settings.value(navigationKey), navigationNames);
}

void Preferences::setNavigationStyle(NavigationStyle style)
{
    store(navigationKey, navigationNames[static_cast<int>(style)]);
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
    return named<TimeDisplay>(m_settings.value(timeKey), timeNames);
}

void Preferences::setTimeDisplay(TimeDisplay display)
{
    store(timeKey, timeNames[static_cast<int>(display)]);
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
    m_rest.start();
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

QVariantMap Preferences::exportSettings() const
{
    return m_settings.value(exportKey).toMap();
}

void Preferences::setExportSettings(const QVariantMap& settings)
{
    set(exportKey, settings);
}

QVariantMap Preferences::viewLight() const
{
    return m_settings.value(lightKey).toMap();
}

void Preferences::setViewLight(const QVariantMap& light)
{
    if (light != viewLight())
        store(lightKey, light);
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
    set(findsKey, names.mid(0, maxRecentFinds));
}

bool Preferences::tourSeen() const
{
    return m_settings.value(tourKey, false).toBool();
}

void Preferences::setTourSeen()
{
    set(tourKey, true);
}

QStringList Preferences::favouritePresets() const
{
    return m_settings.value(favouritesKey).toStringList();
}

void Preferences::setFavouritePresets(const QStringList& presets)
{
    store(favouritesKey, presets);
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
    set(geometryKey, geometry);
    set(stateKey, state);
}

} // namespace ramure
