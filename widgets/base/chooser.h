/// \file
/// Questions that actions ask the user. The program shows dialogs and a banner; tests pass answers.
#pragma once

#include <QDateTime>
#include <QList>
#include <QString>

namespace ramure {

enum class Severity { Info, Warning, Error };

/// A document that a crash left behind.
struct RecoveryEntry
{
    QString file;           ///< path of its own file; empty: it was never saved
    QDateTime time;         ///< time of the last saved change
    QDateTime savedLater{}; ///< when its own file was saved after that; else invalid
};

struct RecoveryAnswer
{
    enum class Action { Recover, Discard, Later };
    Action action = Action::Later;
    int index = 0; ///< which entry
};

class Chooser
{
public:
    enum class Unsaved { Save, Discard, Cancel };

    virtual ~Chooser() = default;
    /// The path of an existing file; empty: cancelled. \p filter as QFileDialog has it.
    virtual QString openFile(const QString& title, const QString& folder, const QString& filter) = 0;
    /// The path of an existing folder; empty: cancelled.
    virtual QString openFolder(const QString& /*title*/, const QString& /*folder*/) { return {}; }
    /// A path to write to, whose overwriting the user has agreed to; empty: cancelled.
    /// \param suffix added where the user gave none, without its dot.
    virtual QString saveFile(const QString& title, const QString& suggestion, const QString& filter,
                             const QString& suffix) = 0;
    /// The document would be lost: what now?
    virtual Unsaved unsavedChanges(const QString& documentName) = 0;
    /// Something else has to come first: does the user agree? The question is
    /// one short sentence; \a why says the reason, \a yes is the text of the button that agrees.
    virtual bool agrees(const QString& /*title*/, const QString& /*question*/, const QString& /*why*/,
                        const QString& /*yes*/)
    {
        return true;
    }
    /// Documents from before a crash are there: what now? Asked again after a Discard, while there are any.
    virtual RecoveryAnswer recovery(const QList<RecoveryEntry>& /*entries*/) { return {}; }
    /// Tells something without asking for an answer and without blocking.
    virtual void report(Severity severity, const QString& text) = 0;
};

} // namespace ramure
