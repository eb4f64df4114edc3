#include "widgets/panels/recipe/recipe_model.h"

#include "core/params/tree_edit_table.h"
#include "core/qt/document/commands.h"
#include "core/skeleton/axes.h"
#include "widgets/base/texts/branch_names.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/view/tools/limb_finder.h"
#include <QApplication>
#include <QLocale>
#include <QMimeData>
#include <QPalette>
#include <algorithm>
#include <numeric>

namespace ramure {
namespace {

const auto rowType = QStringLiteral("application/x-ramure-edit-row");
constexpr int leastOfGroup = 10;

QString percent(double share)
{
    return RecipeModel::tr("%1 %", "a share").arg(QLocale().toString(100.0 * share, 'f', 0));
}

} // namespace

QString editText(const TreeEdit& edit)
{
    const EditOperationInfo& info = infoOf(edit.operation);
    const QString name = coreText(info.label);
    if (edit.operation == EditOperation::Place)
        return RecipeModel::tr("%1 at %2", "an edit and its place")
            .arg(coreText(editOrgans()[std::size_t(edit.organ)].label), percent(edit.at));
    if (info.fields & editFactor && edit.operation != EditOperation::Graft &&
        edit.operation != EditOperation::Root)
        return RecipeModel::tr("%1 × %2", "an edit and its factor")
            .arg(name, QLocale().toString(edit.factor, 'f', 2));
    if (edit.operation == EditOperation::Cut)
        return RecipeModel::tr("%1 at %2", "an edit and its place").arg(name, percent(edit.at));
    if (edit.operation == EditOperation::Leaves)
        return edit.shown ? RecipeModel::tr("Leaves on") : RecipeModel::tr("Leaves off");
    return name;
}

QString sourceText(const NodeParams& params)
{
    return coreText(infoOf(params.generator.kind).first.label);
}

namespace {

const char* iconOf(const TreeEdit& edit)
{
    switch (infoOf(edit.operation).group) {
    case StepGroup::Source:
        return "tree";
    case StepGroup::Modifier:
        return "tool-settings";
    case StepGroup::Unknown:
        return "warning";
    case StepGroup::Hand:
        break;
    }
    return edit.operation == EditOperation::Frozen ? "lock" : "hand-bend";
}

/// Where a step without a limb acts.
QString whereText(const TreeEdit& edit)
{
    const StepParams& step = edit.values->step;
    const bool isSource = infoOf(edit.operation).group == StepGroup::Source;
    if (isSource && step.stand.way == StandWay::Ground)
        return RecipeModel::tr("on the ground");
    if (edit.operation == EditOperation::Frozen)
        return {};
    if (edit.operation == EditOperation::GrowOn)
        return RecipeModel::tr("the whole tree");
    const auto addresses = std::ranges::count(step.where, ',') + 1;
    if (step.where.starts_with("axes "))
        return RecipeModel::tr("%n chosen axis(es)", nullptr, static_cast<int>(addresses));
    return step.where.empty() ? RecipeModel::tr("everywhere") : QString::fromStdString(step.where);
}

} // namespace

RecipeModel::RecipeModel(Document* document, QObject* parent)
    : QAbstractItemModel(parent)
    , m_document(document)
{
    connect(document, &Document::changed, this, &RecipeModel::follow);
    update();
}

NodeId RecipeModel::treeMeant() const
{
    const Scene& scene = m_document->scene();
    const auto isTree = [](const Node* node) { return node && node->kind == NodeKind::Tree; };
    for (const NodeId id : {m_document->selection().activeNode(), m_document->selection().branchNode, m_tree})
        if (isTree(scene.find(id)))
            return id;
    const auto only = [&isTree](const Node& node) { return isTree(&node); };
    return std::ranges::count_if(scene.nodes(), only) == 1 ? std::ranges::find_if(scene.nodes(), only)->id
                                                           : noNode;
}

void RecipeModel::follow(const Change& change)
{
    if (change.has(changeReset | changeStructure | changeSelection | changeBranches | changeResults |
                   changeNodeState))
        update();
    if (change.has(changeReset | changeStructure | changeNodeState))
        emit listChanged(); // the tree may be called otherwise
}

void RecipeModel::update()
{
    const NodeId tree = treeMeant();
    const Node* node = m_document->scene().find(tree);
    const NodeResult* result = m_document->result(tree);
    auto report = result ? result->tree.edits : nullptr;
    static const std::vector<TreeEdit> none;
    const std::vector<TreeEdit>& edits = node ? node->params.edits : none;
    const bool sameTree = tree == m_tree;
    const bool sameSource = node && sourceText(node->params) == m_source;
    const double sourceSeconds = result ? result->tree.sourceSeconds : 0.0;
    if (sameTree && sameSource && edits == m_edits && report == m_report && sourceSeconds == m_sourceSeconds)
        return;
    const bool sameRows = sameTree && std::ranges::equal(edits, m_edits, {}, &TreeEdit::id, &TreeEdit::id);
    if (!sameRows)
        beginResetModel();
    m_tree = tree;
    m_source = node ? sourceText(node->params) : QString();
    m_edits = edits;
    m_report = std::move(report);
    m_sourceSeconds = sourceSeconds;
    updateLimbs();
    if (!sameRows) {
        fillGroups();
        endResetModel();
    } else if (rowCount() > 0) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
        for (const Group& group : m_groups)
            emit dataChanged(indexOf(group.first), indexOf(group.first + group.count - 1, Columns - 1));
    }
    emit listChanged();
}

void RecipeModel::fillGroups()
{
    m_groups.clear();
    m_rows.clear();
    const auto isByHand = [this](int place) {
        return place >= 1 && place <= editCount() &&
               infoOf(editAt(place).operation).group == StepGroup::Hand &&
               editAt(place).operation != EditOperation::Frozen;
    };
    for (int place = 0; place < placeCount();) {
        int count = 0;
        while (isByHand(place + count))
            ++count;
        if (count >= leastOfGroup) {
            m_groups.push_back({place, count, static_cast<int>(m_rows.size())});
            m_rows.push_back(-static_cast<int>(m_groups.size()));
            place += count;
        } else {
            for (const int end = place + std::max(count, 1); place < end; ++place)
                m_rows.push_back(place);
        }
    }
}

bool RecipeModel::isGroup(const QModelIndex& index) const
{
    return index.isValid() && index.internalId() == 0 && m_rows[std::size_t(index.row())] < 0;
}

const RecipeModel::Group& RecipeModel::groupOf(const QModelIndex& index) const
{
    return m_groups[std::size_t(-1 - m_rows[std::size_t(index.row())])];
}

int RecipeModel::placeOf(const QModelIndex& index) const
{
    return index.internalId() == 0 ? m_rows[std::size_t(index.row())]
                                   : m_groups[index.internalId() - 1].first + index.row();
}

std::vector<int> RecipeModel::placesOf(const QModelIndex& index) const
{
    if (!index.isValid())
        return {};
    if (!isGroup(index))
        return {placeOf(index)};
    std::vector<int> places(std::size_t(groupOf(index).count));
    std::iota(places.begin(), places.end(), groupOf(index).first);
    return places;
}

QModelIndex RecipeModel::indexOf(int place, int column) const
{
    for (std::size_t g = 0; g < m_groups.size(); ++g)
        if (place >= m_groups[g].first && place < m_groups[g].first + m_groups[g].count)
            return createIndex(place - m_groups[g].first, column, quintptr(g + 1));
    const auto row = std::ranges::find(m_rows, place);
    return row == m_rows.end() ? QModelIndex()
                               : createIndex(static_cast<int>(row - m_rows.begin()), column, quintptr(0));
}

QModelIndex RecipeModel::index(int row, int column, const QModelIndex& parent) const
{
    if (row < 0 || row >= rowCount(parent) || column < 0 || column >= Columns)
        return {};
    return createIndex(row, column,
                       parent.isValid() ? quintptr(-m_rows[std::size_t(parent.row())]) : quintptr(0));
}

QModelIndex RecipeModel::parent(const QModelIndex& index) const
{
    return index.isValid() && index.internalId() > 0
               ? createIndex(m_groups[index.internalId() - 1].row, 0, quintptr(0))
               : QModelIndex();
}

void RecipeModel::updateLimbs()
{
    m_limbs.assign(m_edits.size(), QString());
    const NodeResult* result = m_document->result(m_tree);
    LimbFinder finder;
    if (m_edits.empty() || !result || !result->tree.simplified)
        return;
    const BranchRows rows(result->tree);
    const BranchNames names;
    for (int row = 1; row <= editCount(); ++row) {
        const auto branches = finder.limb(*m_document, m_tree, addressAt(row));
        if (!branches.empty())
            m_limbs[std::size_t(row - 1)] = names.axis(rows, rows.axisOf(branches.front()));
    }
}

std::uint64_t RecipeModel::idAt(int row) const
{
    return row == 0 ? sourceId : editAt(row).id;
}

std::vector<Index> RecipeModel::branchesAt(int row) const
{
    if (row == 0)
        return {};
    const EditOutcome* what = outcome(row);
    std::vector<std::uint64_t> addresses = what ? what->axes : std::vector<std::uint64_t>();
    if (addressAt(row) != 0 && addresses.empty())
        addresses.push_back(addressAt(row));
    return LimbFinder().axesAt(*m_document, m_tree, std::move(addresses));
}

int RecipeModel::rowOf(std::uint64_t id) const
{
    for (int row = 0; row < placeCount(); ++row)
        if (idAt(row) == id)
            return row;
    return -1;
}

const EditOutcome* RecipeModel::outcome(int row) const
{
    if (!m_report || row == 0)
        return nullptr;
    const auto found = std::ranges::find(*m_report, idAt(row), &EditOutcome::id);
    return found == m_report->end() ? nullptr : &*found;
}

bool RecipeModel::isLost(int row) const
{
    const EditOutcome* what = outcome(row);
    return what && (what->state == EditState::Unplaced || what->state == EditState::Idle);
}

bool RecipeModel::isFrozen(int row) const
{
    return row < static_cast<int>(stepsFrozen(m_edits));
}

std::uint64_t RecipeModel::addressAt(int row) const
{
    const TreeEdit& edit = editAt(row);
    if (edit.operation == EditOperation::Draw)
        return edit.id; // what it made
    const EditOutcome* what = outcome(row);
    return what ? what->address : edit.target.address;
}

int RecipeModel::placeCount() const
{
    const std::size_t first = m_tree == noNode ? 0 : 1;
    return static_cast<int>(first + m_edits.size());
}

int RecipeModel::rowCount(const QModelIndex& parent) const
{
    if (parent.isValid())
        return isGroup(parent) && parent.column() == Name ? groupOf(parent).count : 0;
    return static_cast<int>(m_rows.size());
}

int RecipeModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() && !isGroup(parent) ? 0 : Columns;
}

QVariant RecipeModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (isGroup(index))
        return groupData(groupOf(index), index.column(), role);
    const int place = placeOf(index);
    return place == 0 ? sourceData(index.column(), role) : stepData(place, index.column(), role);
}

QVariant RecipeModel::groupData(const Group& group, int column, int role) const
{
    const auto first = m_edits.begin() + (group.first - 1);
    const auto on =
        std::count_if(first, first + group.count, [](const TreeEdit& edit) { return edit.enabled; });
    double seconds = 0.0;
    for (int place = group.first; place < group.first + group.count; ++place)
        if (const EditOutcome* what = outcome(place))
            seconds += what->seconds;
    switch (role) {
    case Qt::DisplayRole:
        return column == Name   ? tr("%n hand edit(s)", nullptr, group.count)
               : column == Time ? timeText(seconds)
                                : QString();
    case Qt::CheckStateRole:
        return column != Name ? QVariant()
                              : QVariant(on == 0             ? Qt::Unchecked
                                         : on == group.count ? Qt::Checked
                                                             : Qt::PartiallyChecked);
    case Qt::DecorationRole:
        return column == Name ? QVariant(icon("hand-bend")) : QVariant();
    case Qt::TextAlignmentRole:
        return column == Time ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
    case Qt::ToolTipRole:
        return tr("Consecutive hand edits. A change of this row changes all of them.");
    default:
        return {};
    }
}

QVariant RecipeModel::stepData(int place, int column, int role) const
{
    const TreeEdit& edit = editAt(place);
    const QString& limb = m_limbs[std::size_t(place - 1)];
    const bool isByHand =
        infoOf(edit.operation).group == StepGroup::Hand && edit.operation != EditOperation::Frozen;
    const bool lost = edit.enabled && isLost(place);
    const bool said = !lost && outcome(place) && !outcome(place)->why.plain().empty();
    const bool waits = outcome(place) && outcome(place)->state == EditState::Waits;
    switch (role) {
    case Qt::DisplayRole:
        if (column == Name)
            return edit.name.empty() ? editText(edit) : QString::fromStdString(edit.name);
        if (column == Time)
            return outcome(place) ? timeText(outcome(place)->seconds) : QString();
        if (edit.year > 0.0 && !lost)
            return tr("in year %1", "an edit of a growing tree").arg(QLocale().toString(edit.year, 'f', 0));
        return lost && isByHand              ? tr("no place at present")
               : limb.isEmpty() && !isByHand ? whereText(edit)
                                             : limb;
    case Qt::EditRole:
        return edit.name.empty() ? coreText(infoOf(edit.operation).label) : QString::fromStdString(edit.name);
    case Qt::CheckStateRole:
        return column == Name ? QVariant(edit.enabled ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::DecorationRole:
        return column == Name                     ? QVariant(icon(iconOf(edit)))
               : (lost || said) && column == Limb ? QVariant(icon("warning"))
                                                  : QVariant();
    case Qt::TextAlignmentRole:
        return column == Time ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
    case Qt::ForegroundRole:
        return edit.enabled && !lost && !waits && !isFrozen(place)
                   ? QVariant()
                   : QApplication::palette().brush(QPalette::PlaceholderText);
    case Qt::ToolTipRole:
        if (lost)
            return isByHand ? tr("It is kept, and acts again as soon as there is such a limb: %1")
                                  .arg(errorText(outcome(place)->why))
                            : tr("It changes nothing now: %1").arg(errorText(outcome(place)->why));
        if (isFrozen(place))
            return tr("It does not run, because a step below holds its result");
        if (waits)
            return tr("The tree is younger: it acts from the year %1 on").arg(edit.year);
        if (said)
            return errorText(outcome(place)->why);
        if (*infoOf(edit.operation).tip != '\0')
            return coreText(infoOf(edit.operation).tip);
        return edit.name.empty() ? limb : editText(edit);
    default:
        return {};
    }
}

QVariant RecipeModel::sourceData(int column, int role) const
{
    if (role == Qt::DisplayRole)
        return column == Name ? m_source : column == Limb ? tr("on the ground") : timeText(m_sourceSeconds);
    if (role == Qt::TextAlignmentRole && column == Time)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::DecorationRole && column == Name)
        return icon("tree");
    if (role == Qt::ForegroundRole && isFrozen(0))
        return QApplication::palette().brush(QPalette::PlaceholderText);
    if (role == Qt::ToolTipRole)
        return tr("The recipe's first source: its values are the tree's parameters");
    return {};
}

/// Empty where it took no time that anybody would notice.
QString RecipeModel::timeText(double seconds)
{
    constexpr double least = 0.5e-3;
    if (seconds < least)
        return {};
    return seconds < 1.0 ? tr("%1 ms").arg(QLocale().toString(1e3 * seconds, 'f', 0))
                         : tr("%1 s").arg(QLocale().toString(seconds, 'f', 1));
}

QVariant RecipeModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    return section == Name ? tr("Step") : section == Limb ? tr("Where") : tr("Time");
}

bool RecipeModel::report(const Expected<void>& done)
{
    if (!done)
        emit refused(errorText(done.error()));
    return done.has_value();
}

bool RecipeModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    std::vector<std::uint64_t> ids;
    for (const int place : placesOf(index))
        if (place > 0)
            ids.push_back(idAt(place));
    if (ids.empty())
        return false;
    if (role == Qt::CheckStateRole)
        return report(edit::setTreeEditsEnabled(*m_document, m_tree, ids, value.toInt() == int(Qt::Checked)));
    if (role != Qt::EditRole || isGroup(index) || value == data(index, Qt::EditRole))
        return false;
    return report(edit::renameTreeEdit(*m_document, m_tree, ids.front(), value.toString().trimmed()));
}

Qt::ItemFlags RecipeModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::ItemIsDropEnabled;
    const int place = placesOf(index).front();
    if (isGroup(index) || place == 0)
        return Qt::ItemIsEnabled | Qt::ItemIsSelectable |
               (isGroup(index) && index.column() == Name ? Qt::ItemIsUserCheckable : Qt::NoItemFlags);
    const Qt::ItemFlags all = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled;
    return index.column() == Name ? all | Qt::ItemIsUserCheckable | Qt::ItemIsEditable : all;
}

QStringList RecipeModel::mimeTypes() const
{
    return {rowType};
}

QMimeData* RecipeModel::mimeData(const QModelIndexList& indexes) const
{
    if (indexes.empty())
        return nullptr;
    auto* data = new QMimeData;
    data->setData(rowType, QByteArray::number(placesOf(indexes.front()).front()));
    return data;
}

/// The row is moved by a command; false: the view has nothing to take away.
bool RecipeModel::dropMimeData(const QMimeData* data, Qt::DropAction, int row, int, const QModelIndex& parent)
{
    bool good = false;
    const int from = data->data(rowType).toInt(&good);
    if (!good || from < 1 || from > editCount())
        return false;
    const QModelIndex before = row >= 0 ? index(row, Name, parent) : parent;
    const auto above = before.isValid() ? placesOf(before) : std::vector<int>();
    const auto group = parent.isValid() ? placesOf(parent) : std::vector<int>();
    // Below the last row of a group, or of the list.
    int to = !above.empty() ? above.front() : !group.empty() ? group.back() + 1 : placeCount();
    to = std::clamp(to, 1, editCount() + 1);
    to -= to > from ? 1 : 0;
    if (to != from)
        report(edit::moveTreeEdit(*m_document, m_tree, idAt(from), to - 1));
    return false;
}

} // namespace ramure
