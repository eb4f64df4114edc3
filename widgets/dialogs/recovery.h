/// \file
/// Saves unsaved changes aside while the program runs, and offers the changes that a crash left behind.
#pragma once

#include "core/qt/session/jobs/autosave.h"
#include <QObject>

namespace ramure {

class Chooser;
class Preferences;

class Recovery : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the object. From now on recovery files are written at the interval
    /// of the preferences; writing is done by another thread.
    /// \param folder of the recovery files.
    Recovery(Document* document, Preferences* preferences, Chooser* chooser,
             const QString& folder = Autosave::defaultFolder(), QObject* parent = nullptr);

    /// Asks about changes left behind, if any. Returns true if a document was recovered: it replaces the open
    /// document, belongs to its original file, and is not saved.
    bool offer();
    [[nodiscard]] Autosave* autosave() { return &m_autosave; }

private:
    void takePreferences();
    bool recover(Recoverable& lost);

    Document* m_document;
    Preferences* m_preferences;
    Chooser* m_chooser;
    QString m_folder;
    int m_intervalMs = -1;
    Autosave m_autosave;
};

} // namespace ramure
