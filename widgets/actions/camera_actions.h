/// \file
/// View > Camera: look through a camera node, and bring it to where the view is.
#pragma once

#include "core/scene/scene.h"
#include <QObject>

class QAction;
class QMenu;

namespace ramure {

class ActionSet;
class Document;
class ViewportHost;

class CameraActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions.
    CameraActions(Document* document, ViewportHost* host, ActionSet* set, QObject* parent);

    void fillMenu(QMenu* menu);

signals:
    /// Why there is nothing to look through.
    void messageRaised(const QString& text);

private:
    [[nodiscard]] NodeId meant() const;
    void lookThrough();
    void moveHere();

    Document* m_document;
    ViewportHost* m_host;
    ActionSet* m_set;
};

} // namespace ramure
