/// \file
/// Writes billboards of the visible scene to files. Billboards stand for trees far away.
#pragma once

#include "core/qt/session/jobs/job.h"
#include "widgets/view/render/passes/billboard_files.h"
#include <QObject>

class QAction;

namespace ramure {

class ActionSet;
class Chooser;
class Document;
class Preferences;
class ViewportHost;

class BillboardActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions.
    BillboardActions(Document* document, ViewportHost* host, Preferences* preferences, Chooser* chooser,
                     ActionSet* set, QObject* parent);

    /// The job that draws and writes a billboard, for its progress and for cancelling it.
    [[nodiscard]] Job* job() { return &m_job; }

signals:
    /// It ended without anything that can be seen: a line for the status bar.
    void messageRaised(const QString& text);
    /// \param place of the file; of several their folder, with a slash at its end
    void exported(const QString& place);

private:
    void update();
    [[nodiscard]] QString reasonAgainst() const;
    void ask();
    [[nodiscard]] QString chosenPlace(bool isAtlas, bool isFolder);
    void draw(const BillboardWish& wish, bool selectionOnly, const QString& place);
    void taken(const Expected<void>& done, const QString& place);

    Document* m_document;
    ViewportHost* m_host;
    Preferences* m_preferences;
    Chooser* m_chooser;
    ActionSet* m_set;
    std::shared_ptr<OffscreenRenderer> m_renderer; ///< its surface belongs to the application's thread
    Job m_job;
};

} // namespace ramure
