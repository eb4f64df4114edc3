#include "widgets/actions/recipe_actions.h"

#include "core/params/tree_edit_table.h"
#include "core/presets/presets.h"
#include "core/qt/document/commands.h"
#include "core/qt/document/project/own_presets.h"
#include "widgets/actions/preset_menu.h"
#include "widgets/base/action_set.h"
#include "widgets/base/targets.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/view/tools/hand/hand_edit.h"
#include <QMenu>
#include <QStandardPaths>
#include <algorithm>

namespace ramure {
namespace {

QByteArray idOf(const EditOperationInfo& info)
{
    return QByteArray("recipe.add.") + info.key;
}

OwnPresets ownSteps()
{
    return OwnPresets(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                      QStringLiteral("/steps"));
}

} // namespace

RecipeActions::RecipeActions(Document* document, ActionSet* set, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_set(set)
    , m_menu(std::make_unique<QMenu>(tr("Add a &step")))
{
    const auto isThere = [this] { return !targetTrees(*m_document).empty(); };
    for (const EditOperationInfo& info : editOperations())
        if (info.group == StepGroup::Modifier || info.group == StepGroup::Source)
            set->add(this, {idOf(info), coreText(info.label), nullptr, noKeys, coreText(info.tip),
                            [this, operation = info.operation] { add(newStep(operation)); }, isThere});
    fillMenu();
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeSelection | changeStructure | changeReset))
            m_set->update(this);
    });
    m_set->update(this);
}

RecipeActions::~RecipeActions() = default;

void RecipeActions::fillMenu()
{
    m_menu->setToolTipsVisible(true);
    for (const auto& [group, title] :
         {std::pair{StepGroup::Modifier, tr("Modifiers")}, std::pair{StepGroup::Source, tr("Sources")}}) {
        m_menu->addSection(title);
        for (const EditOperationInfo& info : editOperations())
            if (info.group == group)
                m_menu->addAction(m_set->find(QString::fromLatin1(idOf(info))));
    }
    addPresets(m_menu->addMenu(tr("Source &like a preset")));
    m_own = m_menu->addMenu(tr("&My steps"));
    connect(m_menu.get(), &QMenu::aboutToShow, this, &RecipeActions::fillOwn);
}

void RecipeActions::fillOwn()
{
    m_own->clear();
    for (const QString& name : ownSteps().names())
        m_own->addAction(QString(name).replace(u'&', QStringLiteral("&&")), this,
                         [this, name] { addOwn(name); });
    m_own->setEnabled(!m_own->isEmpty());
}

void RecipeActions::save(NodeId tree, const std::vector<std::uint64_t>& steps)
{
    const Node* const from = m_document->scene().find(tree);
    if (!from || steps.empty())
        return;
    Node kept = *from;
    kept.params = NodeParams();
    kept.params.generator.kind = EditOperation::Draw;
    for (const TreeEdit& step : from->params.edits)
        if (std::ranges::count(steps, step.id) > 0)
            kept.params.edits.push_back(step);
    const TreeEdit& first = kept.params.edits.front();
    const QString name = ownSteps().freeName(first.name.empty() ? coreText(infoOf(first.operation).label)
                                                                : QString::fromStdString(first.name));
    const auto saved = ownSteps().save(name, kept);
    emit messageRaised(saved ? tr("Kept as “%1”: Add a step > My steps adds it to any tree").arg(name)
                             : errorText(saved.error()));
}

void RecipeActions::addOwn(const QString& name)
{
    const auto trees = targetTrees(*m_document);
    const auto kept = ownSteps().load(name);
    if (!kept)
        emit messageRaised(errorText(kept.error()));
    if (!kept || trees.empty())
        return;
    std::vector<TreeEdit> steps = kept->params.edits;
    for (TreeEdit& step : steps)
        step.id = 0; // another tree may have it twice
    const auto done = edit::putTreeEdits(*m_document, trees.front(), std::move(steps));
    if (!done)
        emit messageRaised(errorText(done.error()));
    else
        emit added(trees.front(), done->back());
}

void RecipeActions::addPresets(QMenu* menu)
{
    for (const Preset& preset : presets()) {
        auto* action = new QAction(icon("tree"), QString(), this);
        describePreset(preset, action);
        addPreset(menu, preset, action);
        const std::string name = preset.name;
        connect(action, &QAction::triggered, this, [this, name] {
            const auto params = presetParams(name);
            if (!params)
                return;
            const EditOperation first = params->generator.kind;
            add(newStep(first == EditOperation::Draw ? EditOperation::Grammar : first, *params));
        });
    }
    sortGroups(menu);
}

void RecipeActions::add(TreeEdit step)
{
    const auto trees = targetTrees(*m_document);
    if (trees.empty())
        return;
    const Selection& selection = m_document->selection();
    // What acts on all of the tree asks for no limb.
    const bool onLimb = std::ranges::count(stepParams(step.operation), findParam("step.where")) > 0 &&
                        selection.branchNode == trees.front() && selection.activeBranch != noIndex;
    const auto limb = onLimb ? LimbFinder().startOf(*m_document, trees.front(), selection.activeBranch)
                             : std::optional<LimbHit>();
    const auto done = limb ? putStepOn(*m_document, *limb, std::move(step))
                           : edit::putTreeEdits(*m_document, trees.front(), {std::move(step)});
    if (!done)
        emit messageRaised(errorText(done.error()));
    else
        emit added(trees.front(), done->front());
}

} // namespace ramure
