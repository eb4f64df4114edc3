/// \file
/// Baking the motion and freeing it again: actions, messages, and a button for the timeline.
#pragma once

#include "core/qt/session/motion/baker.h"
#include "core/qt/session/motion/motion.h"
#include <QObject>
#include <functional>

class QAction;
class QMenu;
class QToolButton;
class QWidget;

namespace ramure {

class ActionSet;
class Chooser;
class Player;

class BakeActions : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the object. \param chooser reports errors
    BakeActions(Document* document, Player* player, Chooser* chooser, ActionSet* set,
                QObject* parent = nullptr);

    /// Sets the function that saves a project without a file; it returns true if there is a file afterwards.
    void setSave(std::function<bool()> save) { m_save = std::move(save); }
    [[nodiscard]] Job* job() { return m_baker.job(); }
    void fillMenu(QMenu* menu) const;
    /// Makes the button whose menu bakes and frees. Its icon and tooltip tell the state of the bake.
    QToolButton* makeButton(QWidget* parent);

signals:
    void messageRaised(const QString& text);

private:
    [[nodiscard]] bool saveFirst();
    void bake();
    void free();
    void finish(const std::optional<Error>& error);
    void update();
    void complain(const QString& what, const Error& error);

    Document* m_document;
    Player* m_player;
    Chooser* m_chooser;
    ActionSet* m_set;
    Baker m_baker;
    std::function<bool()> m_save;
    QToolButton* m_button = nullptr;
};

} // namespace ramure
