/// \file
/// A tree under a hand: the tools of the view with a small tree that is grown in the background.
#pragma once

#include "core/presets/presets.h"
#include "core/qt/session/jobs/recompute.h"
#include "tests/support/suite.h"
#include "tests/support/tool_bench.h"

namespace ramure::test {

struct HandBench : ToolBench
{
    static constexpr int patienceMs = patience(20'000);
    Recompute recompute{&document};

    explicit HandBench(HandTool tool, int trees = 1, const char* preset = "TinyTree")
    {
        recompute.setRest(0);
        std::vector<Node> nodes;
        for (int i = 0; i < trees; ++i) {
            Node node;
            node.id = NodeId(i + 1);
            node.kind = NodeKind::Tree;
            node.name = "tree " + std::to_string(i + 1);
            node.params = presetParams(preset).value_or(NodeParams{});
            node.params.tree.translation.x = 4.0 * i;
            nodes.push_back(std::move(node));
        }
        open(Scene::fromNodes(nodes).value_or(Scene()));
        grow();
        hand.setTool(tool);
    }
    /// The document of now is grown, and shown where nobody moves the camera.
    void grow()
    {
        if (!recompute.waitForFull(patienceMs))
            qWarning("no result");
        const Camera before = camera;
        const bool first = scene->meshes.empty() && scene->lines.empty();
        show();
        if (!first)
            camera = before;
        tools.sceneReady();
    }
    [[nodiscard]] const Skeleton& skeleton(NodeId id = 1) const
    {
        return document.result(id)->tree.simplified->skeleton;
    }
    [[nodiscard]] const std::vector<TreeEdit>& edits(NodeId id = 1) const
    {
        return document.scene().find(id)->params.edits;
    }
    /// What is seen of a branch there. \param share of its length
    [[nodiscard]] QPointF on(Index branch, double share = 0.6, NodeId id = 1) const
    {
        const glm::dvec3 at = glm::mix(skeleton(id).p0[branch], skeleton(id).p1[branch], share);
        return pixelOf(at + document.scene().find(id)->params.tree.translation);
    }
    /// A branch without children that is seen, hit where on() says, and is of that order at least: not of the
    /// trunk.
    [[nodiscard]] Index twig(NodeId id = 1, Index order = 1)
    {
        LimbFinder finder;
        const TreeAxes& axes = *finder.axes(document, id);
        const ChildLists children = childLists(skeleton(id));
        for (Index b = skeleton(id).size(); b-- > 0;) {
            const QPointF at = on(b, 0.6, id);
            const auto hit = latestPickScene()->pick(view(), {at.x(), at.y()});
            const auto limb = finder.startOf(document, id, b);
            if (limb && axes.axes[limb->axis].order >= order && children.count(b) == 0 && hit &&
                hit->node == id && hit->branch == b)
                return b;
        }
        return noIndex;
    }
    [[nodiscard]] LimbHit limb(Index branch, NodeId id = 1)
    {
        return LimbFinder().startOf(document, id, branch).value_or(LimbHit());
    }
    [[nodiscard]] std::vector<Index> all(NodeId id = 1) const
    {
        std::vector<Index> branches(skeleton(id).size());
        for (Index b = 0; b < branches.size(); ++b)
            branches[b] = b;
        return branches;
    }
    void select(NodeId id, std::vector<Index> branches)
    {
        Selection selection;
        selection.nodes = {id};
        selection.branchNode = id;
        selection.activeBranch = branches.back();
        selection.branches = std::move(branches);
        document.setSelection(selection);
    }
    void click(QPointF at, Qt::KeyboardModifiers held = {})
    {
        press(at, Qt::LeftButton, held);
        release(at, Qt::LeftButton, held);
    }
};

} // namespace ramure::test
