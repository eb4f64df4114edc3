#include "widgets/panels/animation/key_actions.h"

#include "widgets/base/action_set.h"
#include "widgets/panels/animation/key_commands.h"
#include "widgets/panels/animation/key_texts.h"
#include <QCoreApplication>
#include <QMenu>

namespace ramure {
namespace {

/// Filled whenever it opens: texts and colours may be others by then.
QMenu* freshMenu(QWidget* parent, std::function<void(QMenu*)> fill)
{
    auto* menu = new QMenu(parent);
    menu->setToolTipsVisible(true);
    const auto refill = [menu, fill = std::move(fill)] {
        menu->clear();
        fill(menu);
    };
    QObject::connect(menu, &QMenu::aboutToShow, menu, refill);
    refill();
    return menu;
}

} // namespace

KeyActions::KeyActions(KeyCommands* commands, ActionSet* set, QObject* parent)
    : QObject(parent)
    , m_commands(commands)
    , m_set(set)
{
    KeyCommands* c = commands;
    set->add(this,
             {{"keys.insert", Actions::tr("&Insert key"), "key-insert", Qt::Key_I,
               Actions::tr("Keys of position, rotation and scale of the selected nodes, at the frame "
                           "on show"),
               [c] { c->insert(KeyParts::Transform); }},
              {"keys.removeHere", Actions::tr("&Remove key here"), nullptr, Qt::CTRL | Qt::SHIFT | Qt::Key_I,
               Actions::tr("Take out all keys that the selected nodes have at this frame"),
               [c] { c->removeAtPlayhead(); }},
              {"keys.auto", Actions::tr("Auto-ke&y"), "key-auto", noKeys,
               Actions::tr("A changed parameter without keys gets one, too")},
              {"keys.previous", Actions::tr("Pre&vious key"), "key-previous", Qt::ALT | Qt::Key_Comma,
               Actions::tr("Go to the key before this frame"), [c] { c->seekKey(false); }},
              {"keys.next", Actions::tr("&Next key"), "key-next", Qt::ALT | Qt::Key_Period,
               Actions::tr("Go to the key behind this frame"), [c] { c->seekKey(true); }}});
    autoAction()->setCheckable(true);
    m_inserts =
        set->add(this, {{"keys.insertLocation", Actions::tr("&Position"), nullptr, noKeys, QString(),
                         [c] { c->insert(KeyParts::Location); }},
                        {"keys.insertRotation", Actions::tr("&Rotation"), nullptr, noKeys, QString(),
                         [c] { c->insert(KeyParts::Rotation); }},
                        {"keys.insertScale", Actions::tr("&Scale"), nullptr, noKeys, QString(),
                         [c] { c->insert(KeyParts::Scale); }},
                        {"keys.insertLocal", Actions::tr("&Geometry alone"), nullptr, noKeys,
                         Actions::tr("Position, rotation and scale that children do not follow"),
                         [c] { c->insert(KeyParts::Local); }},
                        {"keys.insertAnimated", Actions::tr("&All that has keys"), nullptr, noKeys,
                         Actions::tr("A key in every channel of the selected nodes that has keys already"),
                         [c] { c->insert(KeyParts::Animated); }}});
    addEdits();
    addSelects();
}

void KeyActions::addEdits()
{
    KeyCommands* c = m_commands;
    m_edits = m_set->add(
        this,
        {{"keys.duplicate", Actions::tr("&Duplicate keys"), "duplicate", noKeys,
          Actions::tr("Copies right behind the selected keys; in the dope sheet Ctrl+D, or Ctrl+drag to any "
                      "place"),
          [c] { c->duplicate(); }},
         {"keys.cut", Actions::tr("C&ut keys"), nullptr, noKeys, Actions::tr("In the dope sheet Ctrl+X"),
          [c] { c->cut(); }},
         {"keys.copy", Actions::tr("&Copy keys"), "copy", noKeys, Actions::tr("In the dope sheet Ctrl+C"),
          [c] { c->copy(); }},
         {"keys.paste", Actions::tr("&Paste keys"), "paste", noKeys,
          Actions::tr("The first key comes to the frame on show; in the dope sheet Ctrl+V"),
          [c] { c->paste(false); }},
         {"keys.pasteInPlace", Actions::tr("Paste keys in p&lace"), nullptr, noKeys,
          Actions::tr("At the times they were copied from; in the dope sheet Ctrl+Shift+V"),
          [c] { c->paste(true); }},
         {"keys.mirror", Actions::tr("&Mirror keys"), nullptr, noKeys,
          Actions::tr("Backwards, about the frame on show; in the dope sheet Ctrl+M"), [c] { c->mirror(); }},
         {"keys.snapFrames", Actions::tr("Move to the nearest &frames"), nullptr, noKeys, QString(),
          [c] { c->snap(KeySnap::Frame); }},
         {"keys.snapSeconds", Actions::tr("Move to the nearest &seconds"), nullptr, noKeys, QString(),
          [c] { c->snap(KeySnap::Second); }},
         {"keys.delete", Actions::tr("D&elete keys"), "delete", noKeys, Actions::tr("In the dope sheet Del"),
          [c] { c->remove(); }}});
}

void KeyActions::addSelects()
{
    KeyCommands* c = m_commands;
    m_selects = m_set->add(
        this, {{"keys.selectAll", Actions::tr("&All keys"), nullptr, noKeys,
                Actions::tr("In the dope sheet Ctrl+A"), [c] { c->selectAll(); }},
               {"keys.selectNone", Actions::tr("&No key"), nullptr, noKeys,
                Actions::tr("In the dope sheet Esc"), [c] { c->selectNone(); }},
               {"keys.selectColumn", Actions::tr("All at this &frame"), nullptr, noKeys,
                Actions::tr("In the dope sheet K, or Alt+click on a key"), [c] { c->selectColumn(); }},
               {"keys.selectBefore", Actions::tr("All &up to this frame"), nullptr, noKeys,
                Actions::tr("In the dope sheet ["), [c] { c->selectBefore(); }},
               {"keys.selectBehind", Actions::tr("All f&rom this frame on"), nullptr, noKeys,
                Actions::tr("In the dope sheet ]"), [c] { c->selectBehind(); }}});
}

QMenu* KeyActions::insertMenu(QWidget* parent) const
{
    auto* menu = new QMenu(parent);
    m_set->fill(menu, {"keys.insert"});
    menu->addActions(m_inserts);
    return menu;
}

QMenu* KeyActions::modeMenu(QWidget* parent) const
{
    return freshMenu(parent, [c = m_commands](QMenu* menu) {
        for (int i = 0; i < keyModeCount; ++i) {
            const auto mode = static_cast<KeyMode>(i);
            if (mode == firstEasingMode)
                menu->addSection(tr("Easings"));
            const bool late = mode == KeyMode::Back || mode == KeyMode::Bounce || mode == KeyMode::Elastic;
            QAction* action = menu->addAction(
                keyModeIcon(mode, late ? Easing::Out : Easing::In, menu->palette()), keyModeText(mode));
            action->setToolTip(keyModeTip(mode));
            connect(action, &QAction::triggered, c, [c, mode] { c->setMode(mode); });
        }
    });
}

QMenu* KeyActions::easingMenu(QWidget* parent) const
{
    return freshMenu(parent, [c = m_commands](QMenu* menu) {
        for (int i = 0; i < easingCount; ++i) {
            const auto easing = static_cast<Easing>(i);
            QAction* action =
                menu->addAction(keyModeIcon(KeyMode::Cubic, easing, menu->palette()), easingText(easing));
            if (easing != Easing::Auto)
                action->setIcon(keyModeIcon(KeyMode::Quart, easing, menu->palette()));
            action->setToolTip(tr("End of the segment on which the easing acts"));
            connect(action, &QAction::triggered, c, [c, easing] { c->setEasing(easing); });
        }
    });
}

QMenu* KeyActions::handleMenu(QWidget* parent) const
{
    return freshMenu(parent, [c = m_commands](QMenu* menu) {
        for (int i = 0; i < handleTypeCount; ++i) {
            const auto type = static_cast<HandleType>(i);
            QAction* action = menu->addAction(handleTypeText(type));
            action->setToolTip(tr("Position of the handles of Bézier keys"));
            connect(action, &QAction::triggered, c, [c, type] { c->setHandles(type); });
        }
    });
}

QMenu* KeyActions::extrapolationMenu(QWidget* parent) const
{
    return freshMenu(parent, [c = m_commands](QMenu* menu) {
        for (const bool before : {true, false}) {
            menu->addSection(before ? tr("Before the first key") : tr("Behind the last key"));
            for (int i = 0; i < extrapolationCount; ++i) {
                const auto extrapolation = static_cast<Extrapolation>(i);
                QAction* action = menu->addAction(extrapolationText(extrapolation));
                action->setToolTip(tr("For every channel with a selected key"));
                connect(action, &QAction::triggered, c,
                        [c, before, extrapolation] { c->extrapolate(before, !before, extrapolation); });
            }
        }
    });
}

void KeyActions::fillMenu(QMenu* menu)
{
    const auto add = [menu](QMenu* submenu, const QString& title) {
        submenu->setTitle(title);
        menu->addMenu(submenu);
        return submenu;
    };
    menu->setToolTipsVisible(true);
    m_set->fill(menu, {"keys.insert"});
    QMenu* inserts = add(new QMenu(menu), QCoreApplication::translate("keys", "Insert &only"));
    inserts->addActions(m_inserts);
    inserts->setToolTipsVisible(true);
    m_set->fill(menu, {"keys.removeHere", "keys.auto", "keys.previous", "keys.next", nullptr});
    QMenu* selects = add(new QMenu(menu), QCoreApplication::translate("keys", "Select &keys"));
    selects->addActions(m_selects);
    selects->setToolTipsVisible(true);
    menu->addActions(m_edits);
    menu->addSeparator();
    add(modeMenu(menu), QCoreApplication::translate("keys", "In&terpolation"));
    add(easingMenu(menu), QCoreApplication::translate("keys", "E&asing"));
    add(handleMenu(menu), QCoreApplication::translate("keys", "&Handles"));
    add(extrapolationMenu(menu), QCoreApplication::translate("keys", "E&xtrapolation"));
}

} // namespace ramure
