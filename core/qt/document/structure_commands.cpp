// Nodes that come, go and move.
#include "core/evaluate/evaluator.h"
#include "core/qt/document/document_command.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <map>
#include <set>

namespace ramure {

namespace {

/// A subtree and where it stands; \p nodes is empty while it is in the scene.
struct Block
{
    std::vector<NodeId> ids; ///< depth-first, the first is the top
    NodeId parent = noNode;
    int row = 0;
    std::vector<Node> nodes;
};

/// Puts subtrees in or takes them out. Inserting and removing are each other's undo.
class StructureCommand final : public DocumentCommand
{
public:
    /// \p blocks in an order in which each can be put in at its row, at least one.
    StructureCommand(Document& document, std::vector<Block> blocks, const QString& text)
        : DocumentCommand(document, 0, text)
        , m_blocks(std::move(blocks))
        , m_inside(m_blocks.front().nodes.empty())
    {
    }
    void swap() override
    {
        document().applyChange(describe(), [this](Scene& scene) {
            if (m_inside)
                for (auto block = m_blocks.rbegin(); block != m_blocks.rend(); ++block)
                    block->nodes = scene.remove(block->ids.front());
            else
                for (Block& block : m_blocks)
                    scene.insert(std::exchange(block.nodes, {}), block.parent, block.row);
        });
        m_inside = !m_inside;
    }
    void countMemory(MemoryCount& memory) const override
    {
        memory.add(sizeof(*this));
        for (const Block& block : m_blocks) {
            memory.add(sizeof(Block) + block.ids.size() * sizeof(NodeId));
            for (const Node& node : block.nodes)
                memory.add(node);
        }
    }

private:
    [[nodiscard]] Change describe() const
    {
        Change change;
        change.kinds = changeStructure;
        for (const Block& block : m_blocks)
            change.nodes.insert(change.nodes.end(), block.ids.begin(), block.ids.end());
        const Selection& selection = document().selection();
        const auto goes = [&](NodeId id) {
            return std::find(change.nodes.begin(), change.nodes.end(), id) != change.nodes.end();
        };
        if (m_inside &&
            (goes(selection.branchNode) || std::any_of(selection.nodes.begin(), selection.nodes.end(), goes)))
            change.kinds |= changeSelection;
        return change;
    }

    std::vector<Block> m_blocks;
    bool m_inside;
};

class MoveCommand final : public DocumentCommand
{
public:
    struct Place
    {
        NodeId parent;
        int row;
        PlacementParams placement;
        bool operator==(const Place&) const = default;
    };

    MoveCommand(Document& document, NodeId node, const Place& place)
        : DocumentCommand(document, 0, DocumentCommand::tr("Move"))
        , m_node(node)
        , m_place(place)
    {
    }
    static Place placeOf(const Scene& scene, NodeId node)
    {
        const Node& present = *scene.find(node);
        return {present.parent, scene.row(node), present.params.tree};
    }
    void swap() override
    {
        document().applyChange(describe(), [this](Scene& scene) {
            const Place before = placeOf(scene, m_node);
            scene.move(m_node, m_place.parent, m_place.row);
            scene.find(m_node)->params.tree = m_place.placement;
            m_place = before;
        });
    }
    void countMemory(MemoryCount& memory) const override { memory.add(sizeof(*this)); }

private:
    [[nodiscard]] Change describe() const
    {
        Change change;
        change.kinds = changeStructure;
        for (const Node& node : document().scene().subtree(m_node))
            change.nodes.push_back(node.id);
        const NodeParams& params = document().scene().find(m_node)->params;
        if (params.tree == m_place.placement)
            return change;
        change.kinds |= changeParams;
        NodeParams moved = params;
        moved.tree = m_place.placement;
        for (const ParamDef& def : paramTable())
            if (def.get(params) != def.get(moved))
                change.params.push_back(paramId(def));
        return change;
    }

    NodeId m_node;
    Place m_place;
};

std::vector<NodeId> idsOf(const std::vector<Node>& nodes)
{
    std::vector<NodeId> ids;
    ids.reserve(nodes.size());
    for (const Node& node : nodes)
        ids.push_back(node.id);
    return ids;
}

/// Those of \p ids that are below no other of them, in the scene's order: depth-first, so that a node comes
/// after its parent.
std::vector<NodeId> topsOf(const Scene& scene, const std::vector<NodeId>& ids)
{
    const std::set<NodeId> asked(ids.begin(), ids.end());
    std::set<NodeId> covered;
    std::vector<NodeId> tops;
    for (const Node& node : scene.nodes()) {
        const bool below = covered.contains(node.parent);
        if (!below && asked.contains(node.id))
            tops.push_back(node.id);
        if (below || asked.contains(node.id))
            covered.insert(node.id);
    }
    return tops;
}

/// New ids for all; parents within the list follow.
void renumber(Document& document, std::vector<Node>& nodes)
{
    std::map<NodeId, NodeId> renamed;
    for (Node& node : nodes) {
        const NodeId id = document.newNodeId();
        renamed[node.id] = id;
        node.id = id;
        if (const auto parent = renamed.find(node.parent); parent != renamed.end())
            node.parent = parent->second;
    }
}

/// Names for copies: "Oak" becomes "Oak 2", "Oak 2" the first of "Oak 3", "Oak 4" ... that is free.
class CopyNames
{
public:
    explicit CopyNames(const Scene& scene)
    {
        for (const Node& node : scene.nodes())
            m_taken.insert(node.name);
    }
    std::string next(const std::string& name)
    {
        const std::size_t last = name.find_last_not_of("0123456789");
        const bool numbered = last != std::string::npos && last + 1 < name.size() && name[last] == ' ';
        const std::string stem = numbered ? name.substr(0, last) : name;
        int& number = m_numbers.try_emplace(stem, 1).first->second;
        std::string candidate;
        do
            candidate = std::string(stem).append(" ").append(std::to_string(++number));
        while (!m_taken.insert(candidate).second);
        return candidate;
    }

private:
    std::set<std::string> m_taken;
    std::map<std::string, int> m_numbers; ///< per stem, the last one given
};

/// A subtree that may be inserted: a tree of nodes with allowed parameters.
Expected<void> checkSubtree(std::vector<Node> nodes)
{
    for (const Node& node : nodes)
        if (const auto good = checkParams(node.params); !good)
            return good;
    Scene scratch;
    return scratch.insert(std::move(nodes), noNode, 0);
}

/// noNode, or a node that may be changed.
Expected<void> checkParent(const Scene& scene, NodeId parent)
{
    return parent == noNode ? Expected<void>{} : checkEditable(scene, parent);
}

void selectNodes(Document& document, const std::vector<NodeId>& nodes)
{
    Selection selection;
    selection.nodes = nodes;
    document.setSelection(std::move(selection));
}

/// The placement that keeps \p node where it is in the world at a time when it is put below \p parent. Its
/// track stands between the parent and the placement.
Expected<PlacementParams> keptPlacement(const Scene& scene, const Node& node, NodeId parent, double seconds)
{
    const glm::dmat4 track = transformAt(node.animation, ChannelPart::GlobalTranslation, seconds);
    const EvaluatedScene now(scene, seconds);
    const glm::dmat4 from = now.transforms(node.parent).world * track;
    const glm::dmat4 into = now.transforms(parent).world * track;
    if (from == into)
        return node.params.tree;
    if (glm::determinant(glm::dmat3(into)) == 0.0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the new parent is flat: a scale is zero"));
    const auto placement =
        decomposePlacement(glm::affineInverse(into) * from * placementMatrix(node.params.tree));
    if (!placement)
        return placement;
    NodeParams moved = node.params;
    moved.tree = *placement;
    const auto allowed = checkParams(moved);
    return allowed ? placement : fail(allowed.error());
}

} // namespace

Expected<NodeId> edit::insertNodes(Document& document, std::vector<Node> subtree, NodeId parent, int row)
{
    RAMURE_TRY(checkParent(document.scene(), parent));
    RAMURE_TRY(checkSubtree(subtree));
    renumber(document, subtree);
    const NodeId top = subtree.front().id;
    Block block{idsOf(subtree), parent, row, {}};
    block.nodes = std::move(subtree);
    const QString text = DocumentCommand::tr("Add %1").arg(QString::fromStdString(block.nodes.front().name));
    std::vector<Block> blocks;
    blocks.push_back(std::move(block));
    document.push(std::make_unique<StructureCommand>(document, std::move(blocks), text));
    selectNodes(document, {top});
    return top;
}

Expected<void> edit::removeNodes(Document& document, const std::vector<NodeId>& nodes)
{
    const Scene& scene = document.scene();
    const auto ids = editable(scene, nodes);
    RAMURE_TRY(ids);
    std::vector<Block> blocks;
    for (const NodeId top : topsOf(scene, *ids)) {
        const std::vector<Node> below = scene.subtree(top);
        const auto locked =
            std::find_if(below.begin(), below.end(), [](const Node& node) { return node.locked; });
        if (locked != below.end())
            return checkEditable(scene, locked->id);
        blocks.push_back({idsOf(below), below.front().parent, scene.row(top), {}});
    }
    if (blocks.empty())
        return {};
    const QString text = DocumentCommand::tr("Delete %n node(s)", nullptr, static_cast<int>(blocks.size()));
    document.push(std::make_unique<StructureCommand>(document, std::move(blocks), text));
    return {};
}

Expected<std::vector<NodeId>> edit::duplicateNodes(Document& document, const std::vector<NodeId>& nodes)
{
    const Scene& scene = document.scene();
    for (const NodeId id : nodes)
        if (!scene.find(id))
            return unknownNode(id);
    std::vector<Block> blocks;
    std::vector<NodeId> tops;
    CopyNames names(scene);
    std::map<NodeId, int> copiesBelow; // each copy moves the later siblings of its original down by one
    for (const NodeId original : topsOf(scene, nodes)) {
        std::vector<Node> copy = scene.subtree(original);
        const NodeId parent = copy.front().parent;
        RAMURE_TRY(checkParent(scene, parent));
        renumber(document, copy);
        copy.front().name = names.next(copy.front().name);
        tops.push_back(copy.front().id);
        Block block{idsOf(copy), parent, scene.row(original) + ++copiesBelow[parent], {}};
        block.nodes = std::move(copy);
        blocks.push_back(std::move(block));
    }
    if (blocks.empty())
        return tops;
    const QString text =
        DocumentCommand::tr("Duplicate %n node(s)", nullptr, static_cast<int>(blocks.size()));
    document.push(std::make_unique<StructureCommand>(document, std::move(blocks), text));
    selectNodes(document, tops);
    return tops;
}

Expected<void> edit::moveNode(Document& document, NodeId node, NodeId newParent, int row, bool keepWorld,
                              double timeSeconds)
{
    const Scene& scene = document.scene();
    for (const auto& allowed : {checkEditable(scene, node), checkParent(scene, newParent)})
        if (!allowed)
            return allowed;
    Scene trial = scene; // says whether it may, and at which row it ends up
    if (const auto moved = trial.move(node, newParent, row); !moved)
        return moved;
    MoveCommand::Place place = MoveCommand::placeOf(trial, node);
    if (keepWorld) {
        const auto kept = keptPlacement(scene, *scene.find(node), newParent, timeSeconds);
        RAMURE_TRY(kept);
        place.placement = *kept;
    }
    if (place != MoveCommand::placeOf(scene, node))
        document.push(std::make_unique<MoveCommand>(document, node, place));
    return {};
}

} // namespace ramure
