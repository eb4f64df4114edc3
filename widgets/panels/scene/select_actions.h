/// \file
/// The Select menu: steps through branches and nodes, isolating, order, copying names.
#pragma once

#include "core/qt/document/document.h"
#include "widgets/panels/scene/selection_steps.h"
#include <QList>
#include <QObject>

class QAction;
class QMenu;

namespace ramure {

class ActionSet;
class Isolation;

class SelectActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the actions.
    SelectActions(Document* document, Isolation* isolation, ActionSet* set, QObject* parent);

    void fillMenu(QMenu* menu);
    /// Entries of a row's context menu besides the actions on nodes.
    [[nodiscard]] QList<QAction*> stepActions() const;
    [[nodiscard]] QList<QAction*> rowActions() const;

signals:
    void searchRequested();
    void messageRaised(const QString& text);

private:
    void follow(const Change& change);
    void update();
    void addSteps();
    [[nodiscard]] bool hasAny() const;
    [[nodiscard]] bool isAnyHidden() const;
    void copyNames();
    void isolate();
    void showAll();
    void report(const Expected<void>& done);

    Document* m_document;
    Isolation* m_isolation;
    ActionSet* m_set;
};

} // namespace ramure
