#include "widgets/base/theme/preferences.h"

#include "core/base/file_writer.h"
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <cmath>

namespace ramure {
namespace {

const QString autosaveKey = QStringLiteral("files/autosaveMinutes");
const QString motionMemoryKey = QStringLiteral("motion/memoryMb");

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

void Preferences::store(const QString& key, const QVariant& value, bool isTold)
{
    if (m_settings.value(key) == value)
        return;
    m_settings.setValue(key, value);
    m_rest.start();
    if (isTold)
        emit changed();
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

void Preferences::restoreDefaults()
{
    for (const char* key : {"units/angle", "units/time", "view/theme", "view/language", "view/navigation",
                            "view/ground", "files/autosaveMinutes", "motion/memoryMb", "view/welcomeAtStart"})
        m_settings.remove(QLatin1String(key));
    m_rest.start();
    emit changed();
}

QMap<QString, QKeySequence> Preferences::shortcuts() const
{
    QMap<QString, QKeySequence> found;
    const QVariantMap stored = m_shortcuts();
    for (auto it = stored.begin(); it != stored.end(); ++it)
        found.insert(it.key(), QKeySequence::fromString(it.value().toString(), QKeySequence::PortableText));
    return found;
}

void Preferences::setShortcut(const QString& action, const std::optional<QKeySequence>& keys)
{
    QVariantMap stored = m_shortcuts();
    if (keys)
        stored.insert(action, keys->toString(QKeySequence::PortableText));
    else
        stored.remove(action);
    m_shortcuts.set(stored);
}

void Preferences::clearShortcuts()
{
    m_shortcuts.set({});
}

void Preferences::addRecentFile(const QString& path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList files = recentFiles();
    files.removeAll(absolute);
    files.prepend(absolute);
    recentFiles.set(files.mid(0, maxRecentFiles));
}

void Preferences::removeRecentFile(const QString& path)
{
    QStringList files = recentFiles();
    files.removeAll(path);
    recentFiles.set(files);
}

QString Preferences::lastFolder() const
{
    const QString folder = m_folder();
    return !folder.isEmpty() && QDir(folder).exists() ? folder : QDir::homePath();
}

FileSpace Preferences::exportSpace() const
{
    return fileSpaceIn("# " + m_exportSpace().toStdString()).value_or(FileSpace());
}

void Preferences::setExportSpace(const FileSpace& space)
{
    m_exportSpace.set(QString::fromStdString(space.comment()));
}

void Preferences::addRecentFind(const QString& name)
{
    QStringList names = recentFinds();
    names.removeAll(name);
    names.prepend(name);
    recentFinds.set(names.mid(0, maxRecentFinds));
}

} // namespace ramure
