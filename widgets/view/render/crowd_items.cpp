#include "widgets/view/render/crowd_items.h"

#include "core/pipeline/stage_hashes.h"
#include "widgets/view/render/scene_part_cache.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// A number that tells a block from all others that are alive.
double addressOf(const void* block)
{
    return double(reinterpret_cast<std::uintptr_t>(block));
}

/// Without what a similarity cannot hold.
ScatterPlace similarityOf(const glm::dmat4& matrix)
{
    const glm::dmat3 all(matrix);
    ScatterPlace out;
    out.position = glm::dvec3(matrix[3]);
    out.size = std::cbrt(std::abs(glm::determinant(all)));
    glm::dmat3 turn(1.0);
    turn[0] = glm::normalize(all[0]);
    turn[2] = glm::normalize(glm::cross(all[0], all[1]));
    turn[1] = glm::cross(turn[2], turn[0]);
    out.turn = glm::normalize(glm::quat_cast(turn));
    return out;
}

struct Prototype
{
    CrowdPrototype own;
    std::shared_ptr<const std::vector<MeshItem>> whole;
};

class PrototypeMaker
{
public:
    PrototypeMaker(ScenePartCache& cache, const CrowdSource& source)
        : m_cache(cache)
        , m_source(source)
    {
    }
    Prototype prototype(const Node& node)
    {
        Prototype made;
        const glm::dmat4 at = prototypeMatrix(node);
        std::vector<MeshItem> alone = m_source.alone(node, at);
        for (const MeshItem& item : alone) {
            made.own.box.add(item.box.transformed(item.world));
            made.own.wholeTriangles += item.copies ? std::int64_t(item.copies->copies.size()) *
                                                         item.copies->faces(LeafDetail::Few).count
                                                   : item.mesh.faceCount();
            made.own.crown = item.crown ? item.crown : made.own.crown;
        }
        if (made.own.box.empty() || std::abs(glm::determinant(glm::dmat3(at))) == 0.0)
            return {};
        made.own.local = similarityOf(at);
        const TreeResult* tree = node.kind == NodeKind::Tree ? m_source.resultOf(node.id) : nullptr;
        const auto forms =
            tree ? formsOf(node, *tree, made.own.box.transformed(glm::inverse(at))) : formsOf(alone);
        made.own.forms = *forms;
        m_numbers.push_back(addressOf(forms.get()));
        for (int i = 0; i < 16; ++i)
            m_numbers.push_back(at[i / 4][i % 4]);
        for (int i = 0; i < 6; ++i)
            m_numbers.push_back(i < 3 ? made.own.box.min[i] : made.own.box.max[i - 3]);
        m_numbers.push_back(addressOf(made.own.crown.get()));
        made.whole = std::make_shared<const std::vector<MeshItem>>(std::move(alone));
        return made;
    }
    /// Equal where all prototypes so far are the same.
    [[nodiscard]] const std::vector<double>& numbers() const { return m_numbers; }

private:
    std::shared_ptr<const CrowdForms> formsOf(const Node& node, const TreeResult& tree, const Box& box)
    {
        const auto stand = [&](ScenePart part, const auto& make) {
            const std::uint64_t bark = barkHash(node.params.bark);
            return m_cache.get<CrowdForms>(part, tree.simplified, tree.foliage,
                                           {double(bark >> 32U), double(bark & 0xFFFFFFFFU)}, make);
        };
        if (const auto found = m_source.view.crowdForms.find(node.id);
            found != m_source.view.crowdForms.end())
            return found->second;
        if (m_source.view.waitsForBark)
            if (auto made = stand(ScenePart::CrowdForms,
                                  [&] { return crowdForms(tree, node.params).value_or(CrowdForms()); });
                !made->empty())
                return made;
        return stand(ScenePart::StandIn, [&] { return standInForms(box, tree, node.params); });
    }
    std::shared_ptr<const CrowdForms> formsOf(const std::vector<MeshItem>& alone)
    {
        const auto key = alone.empty() ? nullptr : alone.front().mesh.key();
        std::vector<double> numbers;
        for (const MeshItem& item : alone) {
            numbers.push_back(addressOf(item.images.get()));
            for (int i = 0; i < 3; ++i)
                numbers.push_back(item.material.colour[i]);
        }
        return m_cache.get<CrowdForms>(ScenePart::CrowdForms, key, key, std::move(numbers),
                                       [&] { return plainForms(alone); });
    }

    ScenePartCache& m_cache;
    const CrowdSource& m_source;
    std::vector<double> m_numbers;
};

/// The edges of a box.
LineSet frameOf(const Box& box)
{
    LineSet frame;
    frame.box = box;
    for (int a = 0; a < 8; ++a)
        for (const int axis : {1, 2, 4})
            if ((a & axis) == 0) {
                LineSegment edge;
                edge.a = box.corner(a);
                edge.b = box.corner(a | axis);
                edge.colour = {255, 140, 20, 255};
                frame.segments.push_back(edge);
            }
    return frame;
}

} // namespace

void addCrowd(RenderScene& built, ScenePartCache& cache, ScatterMemory& memory, const CrowdSource& source)
{
    const auto places = memory.places(source.scene, source.scatter);
    if (!places || (*places)->empty())
        return;
    PrototypeMaker maker(cache, source);
    std::vector<CrowdPrototype> prototypes;
    CrowdItem item;
    for (const Node* node : prototypesOf(source.scene, source.scatter.id)) {
        Prototype made = maker.prototype(*node);
        prototypes.push_back(std::move(made.own));
        item.whole.push_back(std::move(made.whole));
    }
    item.crowd = cache.get<Crowd>(ScenePart::Crowd, *places, *places, maker.numbers(), [&] {
        auto made = Crowd::make(*places, prototypes);
        return made ? *made : *Crowd::make(nullptr, {});
    });
    if (item.crowd->box().empty())
        return;
    item.world = source.world;
    item.node = source.scatter.id;
    item.pickable = !source.scatter.locked;
    const auto& selected = source.view.selectedNodes;
    if (std::ranges::find(selected, item.node) != selected.end()) {
        LineItem frame;
        frame.lines = cache.get<LineSet>(ScenePart::CrowdFrame, item.crowd, item.crowd, {},
                                         [&] { return frameOf(item.crowd->box()); });
        frame.world = item.world;
        frame.node = item.node;
        frame.throughSurfaces = true;
        built.lines.push_back(std::move(frame));
    }
    built.crowds.push_back(std::move(item));
}

} // namespace ramure
