#include "core/qt/document/document.h"

#include "core/qt/document/document_command.h"
#include "core/scene/growth_spaces.h"
#include "core/scene/standing_ground.h"
#include "core/skeleton/edit_places.h"

#include <QSignalBlocker>
#include <algorithm>
#include <set>

namespace ramure {

Document::Document(QObject* parent)
    : QObject(parent)
    , m_history(m_scene)
{
    connect(m_history.stack(), &QUndoStack::cleanChanged, this, [this] {
        Change change;
        change.kinds = changeFile;
        tell(change, [] {});
    });
}

Document::~Document()
{
    disconnect(m_history.stack(), nullptr, this,
               nullptr); // it tells of its own end, when the rest of the document is gone
}

void Document::push(std::unique_ptr<DocumentCommand> command)
{
    m_history.push(std::move(command));
}

const NodeResult* Document::result(NodeId id) const
{
    const auto it = m_results.find(id);
    return it == m_results.end() ? nullptr : &it->second;
}

quint64 Document::shapeRevision(NodeId id) const
{
    const auto it = m_shapeRevisions.find(id);
    return it == m_shapeRevisions.end() ? 0 : it->second;
}

const Error* Document::problem(NodeId id) const
{
    const NodeResult* have = result(id);
    return have && have->error && have->revision >= shapeRevision(id) ? &*have->error : nullptr;
}

bool Document::isCurrent(NodeId id) const
{
    const NodeResult* have = result(id);
    return have && !have->draft && have->revision >= shapeRevision(id);
}

/// News that are no edit of the scene: the revision stays.
void Document::tell(const Change& change, const std::function<void()>& edit)
{
    Change news = change;
    news.revision = m_revision;
    emit aboutToBeChanged(news);
    edit();
    emit changed(news);
}

void Document::setFilePath(const QString& path)
{
    if (path == m_filePath)
        return;
    Change change;
    change.kinds = changeFile;
    tell(change, [&] { m_filePath = path; });
}

void Document::reset(Scene scene, const QString& path, std::string extras)
{
    m_history.drop();
    Change change;
    change.kinds = changeReset | changeStructure | changeSelection | changeFile;
    change.firstStale = Stage::Symbols;
    change.revision = ++m_revision;
    for (const Node& node : scene.nodes())
        change.nodes.push_back(node.id);
    emit aboutToBeChanged(change);
    m_scene = std::move(scene);
    linkGrowthSpaces(m_scene);
    m_selection = {};
    m_results.clear();
    m_shapeRevisions.clear();
    m_filePath = path;
    m_extras = std::move(extras);
    {
        const QSignalBlocker quiet(this); // the stack may become clean; one news is enough
        m_history.clear();
    }
    settle(change);
    emit changed(change);
}

Selection Document::valid(Selection selection) const
{
    std::vector<NodeId> nodes;
    for (const NodeId id : selection.nodes)
        if (m_scene.find(id) && std::find(nodes.begin(), nodes.end(), id) == nodes.end())
            nodes.push_back(id);
    selection.nodes = std::move(nodes);

    const NodeResult* have = result(selection.branchNode);
    const Index count = have && have->tree.simplified ? have->tree.simplified->skeleton.size() : 0;
    std::erase_if(selection.branches, [count](Index branch) { return branch >= count; });
    std::sort(selection.branches.begin(), selection.branches.end());
    selection.branches.erase(std::unique(selection.branches.begin(), selection.branches.end()),
                             selection.branches.end());
    if (selection.branches.empty())
        selection.branchNode = noNode;
    if (!std::binary_search(selection.branches.begin(), selection.branches.end(), selection.activeBranch))
        selection.activeBranch = selection.branches.empty() ? noIndex : selection.branches.back();
    return selection;
}

void Document::setSelection(Selection selection)
{
    selection = valid(std::move(selection));
    if (selection == m_selection)
        return;
    Change change;
    change.kinds = changeSelection;
    tell(change, [&] { m_selection = std::move(selection); });
}

/// The selected branches found again in another skeleton of the same tree.
Selection Document::followed(const TreeResult& before, const TreeResult& after) const
{
    Selection selection = m_selection;
    if (!before.skeleton || !after.skeleton || !before.simplified || !after.simplified ||
        before.simplified == after.simplified)
        return selection;
    const std::vector<Index> now = followBranches(*before.skeleton, *before.simplified, selection.branches,
                                                  *after.skeleton, *after.simplified);
    selection.branches.clear();
    selection.activeBranch = noIndex;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i] == noIndex)
            continue;
        selection.branches.push_back(now[i]);
        if (m_selection.branches[i] == m_selection.activeBranch)
            selection.activeBranch = now[i];
    }
    std::sort(selection.branches.begin(), selection.branches.end());
    return selection;
}

void Document::setResult(NodeId id, NodeResult result)
{
    if (!m_scene.find(id))
        return;
    Selection selection = m_selection;
    if (selection.branchNode == id)
        if (const NodeResult* before = this->result(id))
            selection = followed(before->tree, result.tree);
    Change change;
    change.kinds = changeResults;
    if (selection != m_selection)
        change.kinds |= changeSelection;
    change.nodes = {id};
    tell(change, [&] {
        m_results[id] = std::move(result);
        m_selection = valid(std::move(selection));
    });
}

/// After an edit: what it made stale, and what went with removed nodes.
void Document::settle(const Change& change)
{
    const bool reshapes = change.has(changeParams | changeBranches) && change.firstStale < Stage::Placement;
    for (const NodeId id : change.nodes)
        if (reshapes || (change.has(changeStructure) && !m_shapeRevisions.contains(id)))
            m_shapeRevisions[id] = change.revision;
    if (change.has(changeStructure))
        dropGone();
}

/// Trees that fill solids or grow around them grow anew where these have changed, and stand on what is below
/// them: part of the change itself, and undone with it. Only hashes are compared here; whoever grows a tree
/// works out what it grows around.
void Document::followSolids(const Change& edit)
{
    const auto isTree = [this](NodeId id) {
        const Node* node = m_scene.find(id);
        return node && node->kind == NodeKind::Tree;
    };
    const auto mayConcernOthers = [](ParamId id) {
        const Stage stage = paramTable()[id].stage;
        return stage == Stage::Symbols || stage == Stage::Placement;
    };
    // Steps, shape, leaves and bark of a tree concern no other one.
    const bool concernsOthers = edit.has(changeStructure) || !std::ranges::all_of(edit.nodes, isTree) ||
                                (edit.params.empty() && !edit.has(changeBranches)) ||
                                std::ranges::any_of(edit.params, mayConcernOthers);
    const std::span<const NodeId> only = concernsOthers ? std::span<const NodeId>() : edit.nodes;
    const auto take = [this](auto&& stale, Stage firstStale, auto&& give) {
        if (stale.empty())
            return;
        Change change;
        change.kinds = changeParams;
        change.firstStale = firstStale;
        change.revision = m_revision;
        for (const auto& [id, value] : stale)
            change.nodes.push_back(id);
        emit aboutToBeChanged(change);
        for (const auto& [id, value] : stale)
            give(m_scene.find(id)->params, value);
        settle(change);
        emit changed(change);
    };
    take(staleGrowthSpaces(m_scene, only), Stage::Skeleton, setGrowthSpace);
    // The ground under a trunk may depend on the solids that the tree fills.
    take(staleGrounds(m_scene, only), Stage::Mesh,
         [](NodeParams& params, const StandingGround& ground) { params.ground = ground; });
}

void Document::dropGone()
{
    std::set<NodeId> present;
    for (const Node& node : m_scene.nodes())
        present.insert(node.id);
    const auto gone = [&present](const auto& entry) { return !present.contains(entry.first); };
    std::erase_if(m_results, gone);
    std::erase_if(m_shapeRevisions, gone);
    m_selection = valid(std::move(m_selection));
}

} // namespace ramure

#include "moc_document.cpp"
