#include "widgets/view/render/item_wind.h"

#include "core/math/reproducible.h"

namespace ramure {
namespace {

std::vector<glm::vec4> texelsOf(const WindElements& from)
{
    std::vector<glm::vec4> out;
    out.reserve(2 * from.elements.size());
    for (const WindElement& element : from.elements) {
        out.emplace_back(glm::vec3(element.pivot), float(element.parent));
        out.emplace_back(glm::vec3(element.axis), float(element.extent));
    }
    return out;
}

float phaseOf(const WindTree& tree, Index branch)
{
    return static_cast<float>(tree.stems[tree.stemOf[branch]].phase);
}

Index stemElement(const TreeWind& wind, Index branch)
{
    return wind.elements.ofStem.empty() ? 0 : wind.elements.ofStem[wind.tree.stemOf[branch]];
}

} // namespace

TreeWind treeWind(WindProfile profile, double directionRad, const Skeleton& grown,
                  const SimplifiedSkeleton& simplified, const TriangleMesh* leaves, const Foliage* foliage)
{
    const maths::SinCos direction = maths::sincos(directionRad);
    TreeWind out;
    out.profile = profile;
    out.direction = glm::vec2(direction.cos, -direction.sin);
    out.tree = windTree(grown, simplified);
    out.base = static_cast<float>(out.tree.base);
    out.lean = static_cast<float>(out.tree.height > 0.0 ? trunkSway / out.tree.height : 0.0);
    out.bendScale = static_cast<float>(windSettings(out.tree, {}).bendScale);
    if (profile != WindProfile::PivotPainter)
        return out;
    auto elements = leaves && foliage ? windElements(out.tree, windLeaves(*leaves, foliage->leaves))
                                      : windElements(out.tree, {});
    if (!elements) {
        out.profile = WindProfile::None;
        return out;
    }
    out.elements = std::move(*elements);
    out.texels = texelsOf(out.elements);
    return out;
}

ItemWind windOfMesh(const std::shared_ptr<const TreeWind>& tree, const TriangleMesh& mesh)
{
    ItemWind out;
    out.tree = tree;
    out.places.reserve(mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Index branch = mesh.branch[v];
        const double sway = tree->tree.sway(branch, glm::dvec3(mesh.positions[v]));
        out.places.emplace_back(phaseOf(tree->tree, branch), sway, stemElement(*tree, branch));
    }
    return out;
}

ItemWind windOfFruit(const std::shared_ptr<const TreeWind>& tree, const MeshCopies& copies)
{
    ItemWind out;
    out.tree = tree;
    out.places.reserve(copies.copies.size());
    for (const MeshCopy& copy : copies.copies)
        out.places.emplace_back(phaseOf(tree->tree, copy.branch),
                                tree->tree.sway(copy.branch, glm::dvec3(copy.position)),
                                stemElement(*tree, copy.branch));
    return out;
}

ItemWind windOfLeaves(const std::shared_ptr<const TreeWind>& tree, const MeshCopies& copies,
                      std::span<const FoliageItem> items, const std::vector<bool>& shown)
{
    ItemWind out = windOfFruit(tree, copies);
    out.flutter = static_cast<float>(leafFlutter);
    if (tree->elements.ofLeaf.empty())
        return out;
    std::vector<Index> pieces;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (shown.empty() || (items[i].branch < shown.size() && shown[items[i].branch]))
            pieces.push_back(tree->elements.ofLeaf[i]);
    for (std::size_t copy = 0; copy < out.places.size(); ++copy)
        out.places[copy].z = static_cast<float>(pieces[copies.pieceOf(copy)]);
    return out;
}

} // namespace ramure
