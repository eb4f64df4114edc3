#include "widgets/actions/edit_actions.h"

#include "core/generators/variety.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/project/own_presets.h"
#include "core/qt/document/scatter_commands.h"
#include "core/qt/session/jobs/planting.h"
#include "core/scene/kinds/node_kinds.h"
#include "widgets/actions/deleted_selection.h"
#include "widgets/actions/preset_menu.h"
#include "widgets/base/action_set.h"
#include "widgets/base/targets.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/texts/node_words.h"
#include "widgets/base/texts/preset_title.h"
#include "widgets/base/theme/icons.h"
#include "widgets/view/render/camera_items.h"
#include "widgets/view/tools/hand/hand_edit.h"
#include <QAbstractButton>
#include <QComboBox>
#include <QKeyEvent>
#include <QMenu>
#include <algorithm>

namespace ramure {

EditActions::EditActions(Document* document, Chooser* chooser, ActionSet* set, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_chooser(chooser)
    , m_set(set)
    , m_deleted(new DeletedSelection(document, this))
{
    addRows();
    for (const NodeKindRow* row : nodeKinds())
        if (*row->addId != '\0')
            m_addKinds += set->add(this, {row->addId, coreText(row->addText), row->icon, noKeys,
                                          coreText(row->addTip), [this, row] { addKind(*row); }});
    connect(document->undoStack(), &QUndoStack::indexChanged, this, &EditActions::updateUndoTexts);
    connect(document, &Document::changed, this, &EditActions::follow);
    update();
    updateUndoTexts();
}

void EditActions::addRows()
{
    const auto any = [this] { return !selected().empty(); };
    const auto oneTree = [this] { return targetTrees(*m_document).size() == 1; };
    m_set->add(
        this,
        {{"edit.undo", Actions::tr("&Undo"), "undo", QKeySequence::Undo, QString(),
          [this] { m_document->undo(); }},
         {"edit.redo", Actions::tr("&Redo"), "redo", Qt::CTRL | Qt::SHIFT | Qt::Key_Z, QString(),
          [this] { m_document->redo(); }},
         {"edit.newTree", Actions::tr("&New tree"), "new-tree", Qt::Key_Space,
          Actions::tr("Grow another tree from the same rules and numbers, with another seed"),
          [this] { newTree(); }, [this] { return canVary(); }},
         {"edit.duplicate", Actions::tr("&Duplicate"), "duplicate", Qt::CTRL | Qt::Key_D,
          Actions::tr("Copy with everything below; the copy follows the mouse: a click puts it down, Esc "
                      "leaves it in place"),
          [this] { duplicateSelected(); }, any},
         {"edit.rename", Actions::tr("Rena&me"), "rename", Qt::Key_F2, QString(),
          [this] { emit renameRequested(); }, [this] { return selected().size() == 1; }},
         {"edit.delete", Actions::tr("De&lete"), "delete", QKeySequence::Delete, QString(),
          [this] { removeSelected(); },
          [this, any] { return any() || !m_document->selection().branches.empty(); }},
         {"edit.straighten", Actions::tr("Strai&ghten branches"), nullptr, noKeys,
          Actions::tr("Take back how the selected branches were bent"), [this] { straightenSelected(); },
          [this] { return !selectedBends().empty(); }},
         {"edit.moreLikeThis", Actions::tr("M&ore like this…"), nullptr, noKeys,
          Actions::tr("Nine trees of the same numbers that chance grew otherwise, to choose from"),
          [this] { emit moreRequested(targetTrees(*m_document).front()); }, oneTree},
         {"edit.variations", Actions::tr("&Variations…"), nullptr, noKeys,
          Actions::tr("Many trees from this one, by seeds and ranges of parameters: look at them, star the "
                      "good ones, write a table for a batch"),
          [this] { emit variationsRequested(targetTrees(*m_document).front()); }, oneTree},
         {"edit.visible", Actions::tr("&Hide or show"), "eye", Qt::Key_H, QString(),
          [this] { toggleVisible(); }, any},
         {"edit.locked", Actions::tr("Loc&k or unlock"), "lock", Qt::CTRL | Qt::Key_L, QString(),
          [this] { toggleLocked(); }, any}});
}

void EditActions::fillMenu(QMenu* menu)
{
    m_set->fill(menu, {"edit.undo", "edit.redo", nullptr, "edit.newTree"});
    m_addMenu = menu->addMenu(tr("&Add to the scene"));
    for (const Preset& preset : presets()) {
        const QString name = QString::fromLatin1(preset.name);
        auto* add = new QAction(icon("tree"), QString(), this);
        describePreset(preset, add);
        addPreset(m_addMenu, preset, add);
        add->setObjectName(QStringLiteral("edit.add.") + name);
        connect(add, &QAction::triggered, this, [this, name] { addTree(name); });
    }
    sortGroups(m_addMenu);
    m_addMenu->addSeparator();
    for (const EnumItem& item : findParam("primitive.shape")->items) {
        QAction* add = m_addMenu->addAction(icon("cube"), coreText(item.label));
        add->setObjectName(QStringLiteral("edit.add.") + QLatin1String(item.name));
        connect(add, &QAction::triggered, this,
                [this, item] { addPrimitive(item.name, coreText(item.label)); });
    }
    m_addMenu->addSeparator();
    m_addMenu->addActions(m_addKinds);
    menu->addSeparator();
    menu->addActions(nodeActions());
    m_set->fill(menu, {"edit.straighten"});
}

QList<QAction*> EditActions::nodeActions() const
{
    return m_set->find({"edit.moreLikeThis", "edit.variations", "edit.duplicate", "edit.rename",
                        "edit.visible", "edit.locked", "edit.delete"});
}

QList<QAction*> EditActions::copyActions(NodeId scatter, std::uint32_t key, QObject* parent)
{
    const auto add = [&](const char* name, const QString& text, const QString& tip, auto&& act) {
        auto* action = new QAction(text, parent);
        action->setObjectName(QLatin1String(name));
        action->setToolTip(tip);
        action->setStatusTip(tip);
        connect(action, &QAction::triggered, this, [this, act] { reportFailure(act()); });
        return action;
    };
    return {add("edit.makeReal", tr("Make it a &tree of its own"),
                tr("This copy becomes a node beside the scatter, at the same place"),
                [this, scatter, key] { return edit::makeReal(*m_document, scatter, key); }),
            add("edit.removeCopy", tr("Take this &copy away"),
                tr("The scatter leaves this copy out; its place stays empty"),
                [this, scatter, key] { return edit::removeCopies(*m_document, scatter, {key}); })};
}

void EditActions::follow(const Change& change)
{
    m_set->find("edit.undo")->setEnabled(m_document->history().canUndo()); // also what a hand is doing now
    const bool isVaried = change.has(changeParams) && change.firstStale <= Stage::Skeleton;
    if (isVaried || change.has(changeSelection | changeStructure | changeReset | changeNodeState |
                               changeBranches | changeResults))
        update();
}

bool EditActions::canVary() const
{
    return std::ranges::any_of(targetTrees(*m_document), [this](NodeId id) {
        return variesByChance(m_document->scene().find(id)->params);
    });
}

void EditActions::update()
{
    m_set->update(this);
    m_set->setTip(m_set->find("edit.newTree"),
                  targetTrees(*m_document).empty() || canVary()
                      ? QString()
                      : tr("New tree: nothing can vary. No rule has chances, and the variation of "
                           "angles, lengths and radii is 0 %"));
    updateTexts();
}

/// A click on a branch selects its tree, too: what would act on the tree says so.
void EditActions::updateTexts()
{
    const Scene& scene = m_document->scene();
    const Selection& selection = m_document->selection();
    const Node* active = scene.find(selection.activeNode());
    const QString what = nodeWords(scene, selection.nodes);
    const auto say = [this, &what](const char* id, const QString& text) {
        m_set->setText(m_set->find(id), what.isEmpty() || text.isEmpty() ? QString() : text.arg(what));
    };
    say("edit.duplicate", tr("&Duplicate %1"));
    say("edit.rename", selection.nodes.size() == 1 ? tr("Rena&me %1") : QString());
    say("edit.visible", active && !active->visible ? tr("S&how %1") : tr("&Hide %1"));
    say("edit.locked", active && active->locked ? tr("Unloc&k %1") : tr("Loc&k %1"));
    if (!selection.branches.empty())
        m_set->setText(m_set->find("edit.delete"), tr("De&lete %Ln branch(es)", nullptr, goingBranches()));
    else
        say("edit.delete", tr("De&lete %1"));
    emit targetNamed(what);
}

/// How many branches go with those that are selected: all that grows on them, too.
int EditActions::goingBranches() const
{
    const Selection& selection = m_document->selection();
    const NodeResult* result = m_document->result(selection.branchNode);
    if (!result || !result->tree.simplified)
        return int(selection.branches.size());
    const std::vector<Index>& parent = result->tree.simplified->skeleton.parent;
    std::vector<bool> goes(parent.size(), false);
    for (const Index branch : selection.branches)
        goes[branch] = true;
    for (std::size_t b = 0; b < parent.size(); ++b)
        goes[b] = goes[b] || (parent[b] != noIndex && goes[parent[b]]);
    return int(std::ranges::count(goes, true));
}

void EditActions::updateUndoTexts()
{
    const QUndoStack* stack = m_document->undoStack();
    QAction *undo = m_set->find("edit.undo"), *redo = m_set->find("edit.redo");
    undo->setEnabled(m_document->history().canUndo());
    redo->setEnabled(stack->canRedo());
    const auto name = [](const QString& base, const QString& what) {
        return what.isEmpty() ? base : QStringLiteral("%1: %2").arg(base, what);
    };
    m_set->setText(undo, name(tr("&Undo"), stack->undoText()));
    m_set->setText(redo, name(tr("&Redo"), stack->redoText()));
}

void EditActions::report(const Error& error)
{
    m_chooser->report(Severity::Warning, errorText(error));
}

void EditActions::newTree()
{
    const auto grown = edit::newTree(*m_document, targetTrees(*m_document));
    reportFailure(grown);
    if (grown) { // a branch of the same address is another one
        Selection selection = m_document->selection();
        selection.branches.clear();
        m_document->setSelection(std::move(selection));
    }
}

/// Beside the active node.
NodeId EditActions::parentOfNew() const
{
    const Node* active = m_document->scene().find(m_document->selection().activeNode());
    return active ? (active->kind == NodeKind::Group ? active->id : active->parent) : noNode;
}

/// Of what is selected.
std::vector<NodeId> EditActions::whatCanBeCopied() const
{
    std::vector<NodeId> nodes = selected();
    std::erase_if(nodes, [this](NodeId id) {
        const Node* node = m_document->scene().find(id);
        return !node || !(node->kind == NodeKind::Tree || isShape(node->kind)) ||
               node->kind == NodeKind::Terrain;
    });
    return nodes;
}

/// What has a shape stands where there is room; a terrain is the ground of all that is there.
void EditActions::addNode(Node node)
{
    const NodeId parent = parentOfNew();
    if (isShape(node.kind) && node.kind != NodeKind::Terrain)
        return reportFailure(edit::plantNode(*m_document, std::move(node), parent));
    node.id = 1; // replaced by the document
    const int row = static_cast<int>(m_document->scene().children(parent).size());
    reportFailure(edit::insertNodes(*m_document, {std::move(node)}, parent, row));
}

void EditActions::addTree(const QString& preset, const std::optional<glm::dvec3>& place)
{
    reportFailure(namedTree(preset).and_then([&](Node&& tree) {
        giveTitle(tree);
        return edit::plantNode(*m_document, std::move(tree), parentOfNew(), place);
    }));
}

bool EditActions::canBecome(NodeId tree) const
{
    const Node* node = m_document->scene().find(tree);
    return node && node->kind == NodeKind::Tree && !m_document->scene().isLocked(tree);
}

void EditActions::makeLike(NodeId tree, const QString& preset)
{
    reportFailure(namedTree(preset).and_then([&](const Node& like) {
        const QString name = presetTitle(QString::fromStdString(like.name));
        return edit::makeTreesLike(*m_document, {tree}, like,
                                   tr("Make it %1", "undo step; the name of a preset").arg(name));
    }));
}

void EditActions::addKind(const NodeKindRow& row)
{
    Node node;
    node.kind = row.kind;
    node.name = coreText(row.label).toStdString();
    if (row.begin)
        row.begin(node.params);
    if (row.kind == NodeKind::Scatter)
        return reportFailure(edit::addScatter(*m_document, std::move(node), whatCanBeCopied()));
    if (row.kind == NodeKind::Camera && m_eye) {
        const Camera eye = m_eye();
        const glm::dmat4 above = worldMatrix(m_document->scene(), parentOfNew());
        if (const auto place = decomposePlacement(glm::inverse(above) * standingOf(eye))) {
            node.params.tree.translation = place->translation;
            node.params.tree.rotation = place->rotation;
        }
        node.params.camera.angleRad = eye.fovRad;
        node.params.camera.focus = eye.distance;
    }
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
    const Selection before = m_document->selection();
    if (before.branches.empty()) {
        if (auto done = edit::removeNodes(*m_document, selected()); !done)
            return report(done.error());
    } else {
        if (auto done = removeLimbs(*m_document, LimbFinder().selected(*m_document), false); !done)
            return emit messageRaised(errorText(done.error()));
        m_document->setSelection({}); // else the same key would take the whole tree next
    }
    m_deleted->remember(before);
}

void EditActions::duplicateSelected()
{
    const auto copies = edit::duplicateNodes(*m_document, selected());
    if (!copies)
        report(copies.error());
    else if (!copies->empty())
        emit duplicated();
}

/// Bends of the selected branches: those that begin on one of them.
std::vector<std::uint64_t> EditActions::selectedBends() const
{
    constexpr double sameSpot = 1e-3; // of the limb's length
    const Selection& selection = m_document->selection();
    const Node* node = m_document->scene().find(selection.branchNode);
    const NodeResult* result = m_document->result(selection.branchNode);
    const auto isBend = [](const TreeEdit& step) { return step.operation == EditOperation::Bend; };
    if (!node || !result || !result->tree.edits || std::ranges::none_of(node->params.edits, isBend))
        return {};
    const std::vector<LimbSpan> spans = LimbFinder().spans(*m_document, node->id);
    std::map<std::uint64_t, double> lengths;
    for (const LimbSpan& span : spans)
        lengths[span.address] = std::max(lengths[span.address], span.to);
    std::vector<std::uint64_t> bends;
    for (const TreeEdit& step : node->params.edits) {
        const auto what = std::ranges::find(*result->tree.edits, step.id, &EditOutcome::id);
        if (!isBend(step) || what == result->tree.edits->end())
            continue;
        const double at = (step.from + sameSpot) * lengths[what->address];
        if (std::ranges::any_of(selection.branches, [&](Index branch) {
                return branch < spans.size() && spans[branch].address == what->address &&
                       spans[branch].from <= at && at < spans[branch].to;
            }))
            bends.push_back(step.id);
    }
    return bends;
}

void EditActions::straightenSelected()
{
    reportFailure(edit::removeTreeEdits(*m_document, m_document->selection().branchNode, selectedBends()));
}

void EditActions::toggleVisible()
{
    const Node* active = m_document->scene().find(m_document->selection().activeNode());
    if (!active)
        return;
    reportFailure(edit::setNodeVisible(*m_document, selected(), !active->visible));
}

void EditActions::toggleLocked()
{
    const Node* active = m_document->scene().find(m_document->selection().activeNode());
    if (!active)
        return;
    reportFailure(edit::setNodeLocked(*m_document, selected(), !active->locked));
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
