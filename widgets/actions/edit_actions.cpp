#include "widgets/actions/edit_actions.h"

#include "core/document/commands.h"
#include "core/params/presets.h"
#include "core/scene/arm_demo.h"
#include "widgets/actions/action_set.h"
#include "widgets/support/core_text.h"
#include "widgets/support/targets.h"
#include "widgets/theme/icons.h"
#include <QAbstractButton>
#include <QComboBox>
#include <QKeyEvent>
#include <QMenu>

namespace ramure {

EditActions::EditActions(Document* document, Chooser* chooser, ActionSet* set, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_chooser(chooser)
    , m_undo(set->add({"edit.undo", QT_TRANSLATE_NOOP("Actions", "&Undo"), "undo", QKeySequence::Undo}))
    , m_redo(set->add({"edit.redo", QT_TRANSLATE_NOOP("Actions", "&Redo"), "redo",
                       QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z)}))
    , m_newTree(set->add({"edit.newTree", QT_TRANSLATE_NOOP("Actions", "&New tree"), "new-tree",
                          QKeySequence(Qt::Key_Space),
                          QT_TRANSLATE_NOOP("Actions", "Grow another random tree from the same grammar")}))
    , m_addGroup(set->add({"edit.addGroup", QT_TRANSLATE_NOOP("Actions", "&Group"), "group", {}}))
    , m_addArm(set->add({"edit.addArm",
                         QT_TRANSLATE_NOOP("Actions", "&Arm"),
                         "group",
                         {},
                         QT_TRANSLATE_NOOP("Actions", "Add an articulated arm that reaches for targets")}))
    , m_addTerrain(set->add({"edit.addTerrain",
                             QT_TRANSLATE_NOOP("Actions", "&Terrain"),
                             "group",
                             {},
                             QT_TRANSLATE_NOOP("Actions", "Add a terrain that gives an arm targets")}))
    , m_duplicate(set->add({"edit.duplicate", QT_TRANSLATE_NOOP("Actions", "&Duplicate"), "duplicate",
                            QKeySequence(Qt::CTRL | Qt::Key_D)}))
    , m_rename(set->add(
          {"edit.rename", QT_TRANSLATE_NOOP("Actions", "Rena&me"), "rename", QKeySequence(Qt::Key_F2)}))
    , m_delete(
          set->add({"edit.delete", QT_TRANSLATE_NOOP("Actions", "De&lete"), "delete", QKeySequence::Delete}))
    , m_visible(set->add(
          {"edit.visible", QT_TRANSLATE_NOOP("Actions", "&Hide or show"), "eye", QKeySequence(Qt::Key_H)}))
    , m_locked(set->add({"edit.locked", QT_TRANSLATE_NOOP("Actions", "Loc&k or unlock"), "lock",
                         QKeySequence(Qt::CTRL | Qt::Key_L)}))
{
    QUndoStack* stack = document->undoStack();
    connect(m_undo, &QAction::triggered, stack, &QUndoStack::undo);
    connect(m_redo, &QAction::triggered, stack, &QUndoStack::redo);
    connect(stack, &QUndoStack::canUndoChanged, m_undo, &QAction::setEnabled);
    connect(stack, &QUndoStack::canRedoChanged, m_redo, &QAction::setEnabled);
    connect(stack, &QUndoStack::undoTextChanged, this, &EditActions::updateUndoTexts);
    connect(stack, &QUndoStack::redoTextChanged, this, &EditActions::updateUndoTexts);
    connect(m_newTree, &QAction::triggered, this, &EditActions::newTree);
    connect(m_addGroup, &QAction::triggered, this, &EditActions::addGroup);
    connect(m_addArm, &QAction::triggered, this, [this] { addArmDemo(0); });
    connect(m_addTerrain, &QAction::triggered, this, [this] { addArmDemo(1); });
    connect(m_duplicate, &QAction::triggered, this, &EditActions::duplicateSelected);
    connect(m_rename, &QAction::triggered, this, &EditActions::renameRequested);
    connect(m_delete, &QAction::triggered, this, &EditActions::removeSelected);
    connect(m_visible, &QAction::triggered, this, &EditActions::toggleVisible);
    connect(m_locked, &QAction::triggered, this, &EditActions::toggleLocked);
    connect(m_document, &Document::changed, this, &EditActions::follow);
    update();
    updateUndoTexts();
}

void EditActions::fillMenu(QMenu* menu)
{
    menu->addActions({m_undo, m_redo});
    menu->addSeparator();
    menu->addAction(m_newTree);
    m_addMenu = menu->addMenu(QString());
    for (const Preset& preset : presets()) {
        const QString name = QString::fromLatin1(preset.name);
        QAction* add = m_addMenu->addAction(icon("tree"), name);
        add->setObjectName(QStringLiteral("edit.add.") + name);
        connect(add, &QAction::triggered, this, [this, name] { addTree(name); });
    }
    m_addMenu->addSeparator();
    for (const EnumItem& item : findParam("primitive.shape")->items) {
        QAction* add = m_addMenu->addAction(icon("cube"), QString());
        add->setObjectName(QStringLiteral("edit.add.") + QLatin1String(item.name));
        connect(add, &QAction::triggered, this,
                [this, item] { addPrimitive(item.name, coreText(item.label)); });
        m_addPrimitives.emplace_back(add, item.label);
    }
    m_addMenu->addSeparator();
    m_addMenu->addActions({m_addArm, m_addTerrain, m_addGroup});
    menu->addSeparator();
    menu->addActions(nodeActions());
    retranslate();
}

QList<QAction*> EditActions::nodeActions() const
{
    return {m_duplicate, m_rename, m_visible, m_locked, m_delete};
}

void EditActions::retranslate()
{
    if (m_addMenu)
        m_addMenu->setTitle(tr("&Add to the scene"));
    for (const auto& [action, label] : m_addPrimitives)
        action->setText(coreText(label));
    updateUndoTexts();
}

void EditActions::follow(const Change& change)
{
    if (change.has(changeSelection | changeStructure | changeReset | changeNodeState))
        update();
}

void EditActions::update()
{
    const bool any = !selected().empty();
    for (QAction* action : {m_duplicate, m_delete, m_visible, m_locked})
        action->setEnabled(any);
    m_rename->setEnabled(selected().size() == 1);
    m_newTree->setEnabled(!targetTrees(*m_document).empty());
}

void EditActions::updateUndoTexts()
{
    const QUndoStack* stack = m_document->undoStack();
    m_undo->setEnabled(stack->canUndo());
    m_redo->setEnabled(stack->canRedo());
    const auto name = [](const QString& base, const QString& what) {
        return what.isEmpty() ? base : QStringLiteral("%1: %2").arg(base, what);
    };
    m_undo->setText(name(tr("&Undo"), stack->undoText()));
    m_redo->setText(name(tr("&Redo"), stack->redoText()));
}

void EditActions::report(const Error& error)
{
    m_chooser->report(Severity::Warning, errorText(error));
}

void EditActions::newTree()
{
    if (const auto done = edit::newTree(*m_document, targetTrees(*m_document)); !done)
        report(done.error());
}

void EditActions::addNode(Node node)
{
    // Beside the active node.
    const Scene& scene = m_document->scene();
    const Node* active = scene.find(m_document->selection().activeNode());
    const NodeId parent = active ? (active->kind == NodeKind::Group ? active->id : active->parent) : noNode;
    node.id = 1; // replaced by the document
    const int row = static_cast<int>(scene.children(parent).size());
    if (const auto done = edit::insertNodes(*m_document, {std::move(node)}, parent, row); !done)
        report(done.error());
}

void EditActions::addTree(const QString& preset)
{
    auto params = presetParams(preset.toStdString());
    if (!params)
        return report(params.error());
    Node node;
    node.kind = NodeKind::Tree;
    node.name = preset.toStdString();
    node.params = std::move(*params);
    addNode(std::move(node));
}

/// As in the demo: 0 the arm, 1 the terrain.
void EditActions::addArmDemo(std::size_t which)
{
    Node node = armDemo().nodes()[which];
    node.name = (which == 0 ? tr("Arm") : tr("Terrain")).toStdString();
    addNode(std::move(node));
}

void EditActions::addGroup()
{
    Node node;
    node.kind = NodeKind::Group;
    node.name = tr("Group").toStdString();
    addNode(std::move(node));
}

void EditActions::addPrimitive(const char* shape, const QString& label)
{
    Node node;
    node.kind = NodeKind::Primitive;
    node.name = label.toStdString();
    if (auto set = setParam(node.params, *findParam("primitive.shape"), EnumValue{shape}); !set)
        return report(set.error());
    addNode(std::move(node));
}

void EditActions::removeSelected()
{
    if (const auto done = edit::removeNodes(*m_document, selected()); !done)
        report(done.error());
}

void EditActions::duplicateSelected()
{
    if (const auto done = edit::duplicateNodes(*m_document, selected()); !done)
        report(done.error());
}

void EditActions::toggleVisible()
{
    const Node* active = m_document->scene().find(m_document->selection().activeNode());
    if (!active)
        return;
    if (const auto done = edit::setNodeVisible(*m_document, selected(), !active->visible); !done)
        report(done.error());
}

void EditActions::toggleLocked()
{
    const Node* active = m_document->scene().find(m_document->selection().activeNode());
    if (!active)
        return;
    if (const auto done = edit::setNodeLocked(*m_document, selected(), !active->locked); !done)
        report(done.error());
}

bool SpaceKeeper::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool needsSpace = qobject_cast<QAbstractButton*>(watched) || qobject_cast<QComboBox*>(watched);
        if (needsSpace && key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier) {
            event->accept();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace ramure
