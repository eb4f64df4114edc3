/// \file
/// View > Bookmarks: nine views that are kept in the project, by their digits. Ctrl and a digit goes to one,
/// Ctrl+Alt and the digit keeps the present view there.
#pragma once

#include "core/scene/view_bookmarks.h"
#include "widgets/view/render/camera.h"
#include <QList>
#include <QObject>

class QAction;
class QMenu;

namespace ramure {

class ActionSet;
class Document;
class ViewportHost;

/// The same view; angles and lengths are those of the camera.
ViewBookmark bookmarkOf(const Camera& camera);
Camera cameraOf(const ViewBookmark& bookmark);

class BookmarkActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions.
    BookmarkActions(Document* document, ViewportHost* host, ActionSet* set, QObject* parent);

    void fillMenu(QMenu* menu);

signals:
    /// What was kept, or why there is nothing to go to.
    void messageRaised(const QString& text);

private:
    void goTo(std::size_t place);
    void keep(std::size_t place);
    void update();

    Document* m_document;
    ViewportHost* m_host;
    QList<QAction*> m_go, m_keep, m_forget; ///< by place
    QMenu* m_forgetMenu = nullptr;
};

} // namespace ramure
