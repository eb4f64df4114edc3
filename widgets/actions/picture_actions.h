/// \file
/// Pictures of the view, to a file and to the clipboard; and the selection of branches by keyboard.
#pragma once

#include "core/qt/session/jobs/job.h"
#include <QObject>

class QAction;
class QMenu;

namespace ramure {

class ActionSet;
class Chooser;
class Document;
class OffscreenRenderer;
class PictureDialog;
class Preferences;
class ViewportHost;
struct ViewPicture;

class PictureActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions.
    PictureActions(Document* document, ViewportHost* host, Preferences* preferences, Chooser* chooser,
                   ActionSet* set, QObject* parent);

    [[nodiscard]] QList<QAction*> selectionActions() const { return m_selectionActions; }
    /// The job that writes a picture, for its progress and for cancelling it.
    [[nodiscard]] Job* job() { return &m_job; }

signals:
    /// Something was done that cannot be seen: a line for the status bar.
    void messageRaised(const QString& text);

private:
    void ask();
    void pickFocus(PictureDialog* dialog);
    void save(const ViewPicture& wish);
    void taken(const Expected<void>& done, const QString& path);

    Document* m_document;
    ViewportHost* m_host;
    Preferences* m_preferences;
    Chooser* m_chooser;
    QList<QAction*> m_selectionActions;
    std::shared_ptr<OffscreenRenderer> m_renderer; ///< its surface belongs to the application's thread
    Job m_job;
};

} // namespace ramure
