#include "core/qt/session/jobs/autosave.h"

#include "core/qt/document/project/project_json.h"
#include "core/qt/session/jobs/job.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QLockFile>
#include <QPointer>
#include <QStandardPaths>
#include <QTimer>
#include <QUuid>
#include <algorithm>

namespace ramure {

static const QLatin1String noteKey("recovery");
static const QLatin1String projectEnding(".ramure");

static const QLatin1String lockEnding(".lock");

/// Also given by the lock of a program that was killed, as soon as its process is gone; never by age.
static std::shared_ptr<QLockFile> lockOf(const QString& recoveryPath)
{
    auto lock = std::make_shared<QLockFile>(recoveryPath + lockEnding);
    lock->setStaleLockTime(0);
    return lock;
}

/// With what writings that were cut short left beside it.
static void removeWithParts(const QFileInfo& recoveryFile)
{
    const QStringList names{recoveryFile.fileName(), recoveryFile.fileName() + QStringLiteral(".new-*")};
    for (const QFileInfo& file : recoveryFile.absoluteDir().entryInfoList(names, QDir::Files))
        QFile::remove(file.absoluteFilePath());
}

/// Programs killed before their first recovery file was complete leave a lock, and perhaps a part of one.
static void removeOrphans(const QDir& folder)
{
    for (const QFileInfo& file : folder.entryInfoList({u'*' + projectEnding + lockEnding}, QDir::Files)) {
        const QFileInfo owner(file.absoluteFilePath().chopped(lockEnding.size()));
        if (owner.exists())
            continue;
        const auto lock = lockOf(owner.absoluteFilePath());
        if (lock->tryLock(0)) // its program is gone; giving the lock up removes it
            removeWithParts(owner);
    }
}

static QJsonObject objectOf(const std::string& extras)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(extras)).object();
}

static Project withNote(Project project, const QString& originalPath)
{
    QJsonObject extras = objectOf(project.extras);
    extras.insert(noteKey, QJsonObject{{QStringLiteral("path"), originalPath},
                                       {QStringLiteral("time"),
                                        QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs)}});
    project.extras = json::extrasText(extras);
    return project;
}

struct Autosave::Private
{
    explicit Private(Autosave* autosave, Document* doc, const QString& folder)
        : q(autosave)
        , document(doc)
        , path(QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + projectEnding))
    {
        claim();
    }

    [[nodiscard]] bool isDue() const
    {
        return document && document->isModified() && document->revision() != savedRevision;
    }
    void claim();
    void tick();
    void tell(const Expected<void>& result);
    void finished(quint64 revision, const Expected<void>& result);
    void discard();

    Autosave* q;
    QPointer<Document> document;
    QString path;
    std::shared_ptr<QLockFile> lock;
    QTimer timer;
    quint64 savedRevision = 0; ///< that the recovery file holds; 0 = there is none
    bool discardLater = false; ///< what is being written is no longer wanted
    bool failing = false;
    Job writer;
};

/// The folder with the lock: there may have been no room for them yet, or somebody has cleared them away.
void Autosave::Private::claim()
{
    QDir().mkpath(QFileInfo(path).path());
    if (lock && QFile::exists(path + lockEnding))
        return;
    lock.reset(); // before the new one is there: it removes its file
    lock = lockOf(path);
    lock->tryLock(0);
}

/// Writing waits for the disk, so another thread does it; it gets a copy of the scene.
void Autosave::Private::tick()
{
    if (!isDue() || writer.isRunning())
        return;
    claim();
    writer.start(
        [file = path,
         project = withNote(document->project(), document->filePath())](const Progress& progress) {
            auto result = saveProjectFile(project, file);
            if (progress.cancelled())
                QFile::remove(file);
            return result;
        },
        [this, revision = document->revision()](const Expected<void>& result) {
            finished(revision, result);
        });
}

void Autosave::Private::tell(const Expected<void>& result)
{
    if (std::exchange(failing, !result) == !result)
        return;
    if (result)
        emit q->worksAgain();
    else
        emit q->failed(result.error());
}

void Autosave::Private::finished(quint64 revision, const Expected<void>& result)
{
    const bool unwanted = std::exchange(discardLater, false);
    tell(result);
    if (!result)
        return;
    if (unwanted) { // saved, or another document, while this was on its way
        QFile::remove(path);
        return;
    }
    savedRevision = revision;
    emit q->saved();
}

/// The interface must not wait for the disk: what is on its way is removed when it has arrived.
void Autosave::Private::discard()
{
    discardLater = writer.isRunning();
    QFile::remove(path);
    savedRevision = 0;
}

QString Autosave::defaultFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/recovery");
}

Autosave::Autosave(Document* document, const QString& folder, QObject* parent)
    : QObject(parent)
    , m_private(std::make_unique<Private>(this, document, folder))
{
    connect(&m_private->timer, &QTimer::timeout, this, [this] { m_private->tick(); });
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeFile | changeReset) && !m_private->document->isModified())
            m_private->discard();
    });
    setInterval(60000);
}

Autosave::~Autosave()
{
    m_private->writer.cancel(); // before the file goes: what is finished later is removed there
    m_private->discard();
}

void Autosave::setInterval(int milliseconds)
{
    if (milliseconds > 0)
        m_private->timer.start(milliseconds);
    else
        m_private->timer.stop();
}

int Autosave::interval() const
{
    return m_private->timer.isActive() ? m_private->timer.interval() : 0;
}

QString Autosave::recoveryPath() const
{
    return m_private->path;
}

Expected<void> Autosave::saveNow()
{
    m_private->writer.wait();
    if (!m_private->isDue())
        return {};
    m_private->claim();
    const quint64 revision = m_private->document->revision();
    const auto result = saveProjectFile(
        withNote(m_private->document->project(), m_private->document->filePath()), m_private->path);
    if (result)
        m_private->savedRevision = revision;
    m_private->tell(result);
    return result;
}

std::vector<Recoverable> recoverableProjects(const QString& folder)
{
    removeOrphans(QDir(folder));
    std::vector<Recoverable> found;
    const QStringList pattern{QStringLiteral("*") + projectEnding};
    for (const QFileInfo& file : QDir(folder).entryInfoList(pattern, QDir::Files)) {
        Recoverable entry;
        entry.recoveryPath = file.absoluteFilePath();
        entry.claim = lockOf(entry.recoveryPath);
        // On a disk that is full nothing can be claimed: work is offered all the same.
        if (!entry.claim->tryLock(0) && entry.claim->error() == QLockFile::LockFailedError)
            continue; // its program runs
        const auto project = loadProjectFile(entry.recoveryPath);
        if (!project)
            continue;
        const QJsonObject note = objectOf(project->extras).value(noteKey).toObject();
        entry.originalPath = note.value(QLatin1String("path")).toString();
        entry.time = QDateTime::fromString(note.value(QLatin1String("time")).toString(), Qt::ISODateWithMs);
        // A program may be killed between saving the project and clearing away what it had kept aside.
        if (const QFileInfo own(entry.originalPath); own.exists() && own.lastModified() > entry.time)
            entry.savedLater = own.lastModified();
        found.push_back(std::move(entry));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Recoverable& a, const Recoverable& b) { return a.time > b.time; });
    return found;
}

Expected<Project> loadRecoverable(const Recoverable& recoverable)
{
    auto project = loadProjectFile(recoverable.recoveryPath);
    if (!project)
        return project;
    QJsonObject extras = objectOf(project->extras);
    extras.remove(noteKey);
    project->extras = json::extrasText(extras);
    return project;
}

void discardRecoverable(Recoverable& recoverable)
{
    const QFileInfo file(recoverable.recoveryPath);
    removeWithParts(file);
    recoverable.claim.reset();
}

} // namespace ramure

#include "moc_autosave.cpp"
