/// \file
/// Recovery files: unsaved changes are stored at an interval, so that a crash loses no more than that.
///
/// Each open document has one file of its own in a folder of the program: an ordinary project with a note of
/// its original place, and beside it a lock that names the running program. A recovery file whose program is
/// gone is offered at the next start. A document without unsaved changes has no recovery file.
#pragma once

#include "core/base/error.h"
#include "core/qt/document/document.h"

#include <QDateTime>
#include <QObject>
#include <QString>
#include <memory>
#include <vector>

class QLockFile;

namespace ramure {

class Autosave : public QObject
{
    Q_OBJECT
public:
    /// QStandardPaths::AppDataLocation/recovery.
    static QString defaultFolder();

    /// \param folder is made if it is missing, also if it is deleted later
    explicit Autosave(Document* document, const QString& folder = defaultFolder(), QObject* parent = nullptr);
    /// The document was closed in good order: nothing is left to recover.
    ~Autosave() override;

    /// Default 60 s; 0 = off.
    void setInterval(int milliseconds);
    /// Milliseconds; 0 = off.
    [[nodiscard]] int interval() const;
    /// At once and to the end, where there are unsaved changes. Errors: Io, which failed() tells too.
    Expected<void> saveNow();
    /// Path of the recovery file, whether it exists or not.
    [[nodiscard]] QString recoveryPath() const;

signals:
    /// The recovery file has been written.
    void saved();
    /// It cannot be written; once until it can be again.
    void failed(const ramure::Error& error);
    /// It can be written again; once after failed().
    void worksAgain();

private:
    struct Private;
    std::unique_ptr<Private> m_private;
};

/// A recovery file left behind, claimed: as long as this object (or a copy) lives no other program is offered
/// it.
struct Recoverable
{
    QString recoveryPath;
    QString originalPath; ///< path of the project; empty if it was never saved
    QDateTime time;       ///< when it was written
    std::shared_ptr<QLockFile> claim;
    QDateTime savedLater{}; ///< when the project was written, where that was after this; else invalid
};

/// Newest first. Files that cannot be read are passed over, not deleted.
std::vector<Recoverable> recoverableProjects(const QString& folder = Autosave::defaultFolder());
/// The project without the note. Put it into a document by reset and markModified, and discard the file when
/// the document has been saved, or saved aside by its own Autosave.
Expected<Project> loadRecoverable(const Recoverable& recoverable);
/// Deletes the file and gives up the claim.
void discardRecoverable(Recoverable& recoverable);

} // namespace ramure
