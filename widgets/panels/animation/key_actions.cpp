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
    , m_insert(set->add(
          {"keys.insert", QT_TRANSLATE_NOOP("Actions", "&Insert key"), "key-insert", QKeySequence(Qt::Key_I),
           QT_TRANSLATE_NOOP("Actions", "Keys of position, rotation and scale of the selected nodes, at the "
                                        "frame on show")}))
    , m_removeHere(set->add(
          {"keys.removeHere", QT_TRANSLATE_NOOP("Actions", "&Remove key here"), nullptr,
           QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I),
           QT_TRANSLATE_NOOP("Actions", "Take out all keys that the selected nodes have at this frame")}))
    , m_auto(set->add(
          {"keys.auto",
           QT_TRANSLATE_NOOP("Actions", "Auto-ke&y"),
           "key-auto",
           {},
           QT_TRANSLATE_NOOP("Actions", "Parameters without keys get one, too, where they are changed")}))
    , m_previous(set->add({"keys.previous", QT_TRANSLATE_NOOP("Actions", "Pre&vious key"), "key-previous",
                           QKeySequence(Qt::ALT | Qt::Key_Comma),
                           QT_TRANSLATE_NOOP("Actions", "Go to the key before this frame")}))
    , m_next(set->add({"keys.next", QT_TRANSLATE_NOOP("Actions", "&Next key"), "key-next",
                       QKeySequence(Qt::ALT | Qt::Key_Period),
                       QT_TRANSLATE_NOOP("Actions", "Go to the key behind this frame")}))
{
    m_auto->setCheckable(true);
    KeyCommands* c = commands;
    connect(m_insert, &QAction::triggered, this, [c] { c->insert(KeyParts::Transform); });
    connect(m_removeHere, &QAction::triggered, c, &KeyCommands::removeAtPlayhead);
    connect(m_previous, &QAction::triggered, this, [c] { c->seekKey(false); });
    connect(m_next, &QAction::triggered, this, [c] { c->seekKey(true); });

    addInserts(set);
    addCopies(set);
    addEdits(set);
    addSelects(set);
}

void KeyActions::addInserts(ActionSet* set)
{
    KeyCommands* c = m_commands;
    const auto add = [this, set](const ActionSpec& spec, auto&& command) {
        m_inserts += set->add(spec);
        connect(m_inserts.back(), &QAction::triggered, this, command);
    };
    add({"keys.insertLocation", QT_TRANSLATE_NOOP("Actions", "&Position"), nullptr, {}},
        [c] { c->insert(KeyParts::Location); });
    add({"keys.insertRotation", QT_TRANSLATE_NOOP("Actions", "&Rotation"), nullptr, {}},
        [c] { c->insert(KeyParts::Rotation); });
    add({"keys.insertScale", QT_TRANSLATE_NOOP("Actions", "&Scale"), nullptr, {}},
        [c] { c->insert(KeyParts::Scale); });
    add({"keys.insertLocal",
         QT_TRANSLATE_NOOP("Actions", "&Geometry alone"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("Actions", "Position, rotation and scale that children do not follow")},
        [c] { c->insert(KeyParts::Local); });
    add({"keys.insertAnimated",
         QT_TRANSLATE_NOOP("Actions", "&All that has keys"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("Actions", "A key in every channel of the selected nodes that has keys already")},
        [c] { c->insert(KeyParts::Animated); });
}

void KeyActions::addCopies(ActionSet* set)
{
    KeyCommands* c = m_commands;
    const auto add = [this, set](const ActionSpec& spec, auto&& command) {
        m_edits += set->add(spec);
        connect(m_edits.back(), &QAction::triggered, this, command);
    };
    add({"keys.duplicate",
         QT_TRANSLATE_NOOP("Actions", "&Duplicate keys"),
         "duplicate",
         {},
         QT_TRANSLATE_NOOP("Actions", "Copies right behind the selected keys; in the dope sheet Ctrl+D, or "
                                      "Ctrl+drag to any place")},
        [c] { c->duplicate(); });
    add({"keys.cut",
         QT_TRANSLATE_NOOP("Actions", "C&ut keys"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("Actions", "In the dope sheet Ctrl+X")},
        [c] { c->cut(); });
    add({"keys.copy",
         QT_TRANSLATE_NOOP("Actions", "&Copy keys"),
         "copy",
         {},
         QT_TRANSLATE_NOOP("Actions", "In the dope sheet Ctrl+C")},
        [c] { c->copy(); });
    add({"keys.paste",
         QT_TRANSLATE_NOOP("Actions", "&Paste keys"),
         "paste",
         {},
         QT_TRANSLATE_NOOP("Actions", "The first key comes to the frame on show; in the dope sheet Ctrl+V")},
        [c] { c->paste(false); });
    add({"keys.pasteInPlace",
         QT_TRANSLATE_NOOP("Actions", "Paste keys in p&lace"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("Actions", "At the times they were copied from; in the dope sheet Ctrl+Shift+V")},
        [c] { c->paste(true); });
}

void KeyActions::addEdits(ActionSet* set)
{
    KeyCommands* c = m_commands;
    const auto add = [this, set](const ActionSpec& spec, auto&& command) {
        m_edits += set->add(spec);
        connect(m_edits.back(), &QAction::triggered, this, command);
    };
    add({"keys.mirror",
         QT_TRANSLATE_NOOP("Actions", "&Mirror keys"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("Actions", "Backwards, about the frame on show; in the dope sheet Ctrl+M")},
        [c] { c->mirror(); });
    add({"keys.snapFrames", QT_TRANSLATE_NOOP("Actions", "Move to the nearest &frames"), nullptr, {}},
        [c] { c->snap(KeySnap::Frame); });
    add({"keys.snapSeconds", QT_TRANSLATE_NOOP("Actions", "Move to the nearest &seconds"), nullptr, {}},
        [c] { c->snap(KeySnap::Second); });
    add({"keys.delete",
         QT_TRANSLATE_NOOP("Actions", "D&elete keys"),
         "delete",
         {},
         QT_TRANSLATE_NOOP("Actions", "In the dope sheet Del")},
        [c] { c->remove(); });
}

void KeyActions::addSelects(ActionSet* set)
{
    KeyCommands* c = m_commands;
    const auto add = [this, set](const ActionSpec& spec, auto&& command) {
        m_selects += set->add(spec);
        connect(m_selects.back(), &QAction::triggered, this, command);
    };
    add({"keys.selectAll",
         QT_TRANSLATE_NOOP("Actions", "&All keys"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("Actions", "In the dope sheet Ctrl+A")},
        [c] { c->selectAll(); });
    add({"keys.selectNone",
         QT_TRANSLATE_NOOP("Actions", "&No key"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("Actions", "In the dope sheet Esc")},
        [c] { c->selectNone(); });
    add({"keys.selectColumn",
         QT_TRANSLATE_NOOP("Actions", "All at this &frame"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("Actions", "In the dope sheet K, or Alt+click on a key")},
        [c] { c->selectColumn(); });
    add({"keys.selectBefore",
         QT_TRANSLATE_NOOP("Actions", "All &up to this frame"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("Actions", "In the dope sheet [")},
        [c] { c->selectBefore(); });
    add({"keys.selectBehind",
         QT_TRANSLATE_NOOP("Actions", "All f&rom this frame on"),
         nullptr,
         {},
         QT_TRANSLATE_NOOP("Actions", "In the dope sheet ]")},
        [c] { c->selectBehind(); });
}

QMenu* KeyActions::insertMenu(QWidget* parent) const
{
    auto* menu = new QMenu(parent);
    menu->addAction(m_insert);
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
            action->setToolTip(tr("Where the easing shows its character"));
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
            action->setToolTip(tr("Where the handles of Bézier keys stand"));
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
    menu->addAction(m_insert);
    QMenu* inserts = add(new QMenu(menu), QCoreApplication::translate("keys", "Insert &only"));
    inserts->addActions(m_inserts);
    inserts->setToolTipsVisible(true);
    menu->addActions({m_removeHere, m_auto, m_previous, m_next});
    menu->addSeparator();
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
