// What takes something away.
#include "core/generators/shape_test.h"
#include "core/recipe/edit_operations.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ramure::edits {
namespace {

/// Stubs that are shorter than so many radii go too.
constexpr double shortestStub = 0.5;

tl::unexpected<Error> nothingLeft()
{
    return fail(ErrorCode::Invalid, RAMURE_NOOP("nothing of the tree would be left"));
}

Expected<void> takeAway(EditTree& tree, const EditMarks& marks)
{
    if (std::ranges::count(marks, true) >= static_cast<std::ptrdiff_t>(tree.size()))
        return nothingLeft();
    tree.remove(marks);
    return {};
}

/// Whether the sphere of a brush reaches a piece.
bool touches(const TreeEdit& edit, const EditPiece& piece)
{
    const glm::dvec3 way = piece.p1 - piece.p0;
    const double squared = glm::dot(way, way);
    const double t =
        squared > 0.0 ? std::clamp(glm::dot(edit.centre - piece.p0, way) / squared, 0.0, 1.0) : 0.0;
    const glm::dvec3 away = edit.centre - piece.p0 - t * way;
    return glm::dot(away, away) <= edit.radius * edit.radius;
}

/// Where a piece leaves a shape. \pre it starts inside and ends outside
double leavesAt(const ShapeTest& shape, const EditPiece& piece)
{
    double in = 0.0, out = 1.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (in + out);
        (shape.contains(piece.p0 + middle * (piece.p1 - piece.p0)) ? in : out) = middle;
    }
    return in;
}

/// What a shape leaves of a tree.
class Pruner
{
public:
    Pruner(const EditTree& tree, const ShapeTest& shape, const EditMarks& limb)
        : m_tree(tree)
        , m_shape(shape)
        , m_limb(limb)
        , m_gone(tree.pieces().size(), false)
        , m_entered(tree.pieces().size(), false)
    {
    }

    void run()
    {
        for (Index i = m_tree.firstPiece(); i != noIndex; i = m_tree.piece(i).after) {
            const Index parent = m_tree.piece(i).parent;
            m_loose[i] = m_tree.piece(i).loose || (parent != noIndex && m_loose[parent]);
            if (m_loose[i])
                continue;
            if (parent != noIndex && (m_gone[parent] || m_ends[parent]))
                m_gone[i] = true;
            else if (m_limb.empty() || m_limb[i])
                look(i);
        }
    }

    [[nodiscard]] const EditMarks& gone() const { return m_gone; }
    /// Pieces that end earlier, and where.
    [[nodiscard]] const std::vector<std::pair<Index, double>>& cuts() const { return m_cuts; }

private:
    void look(Index i)
    {
        const EditPiece& piece = m_tree.piece(i);
        const bool starts = m_shape.contains(piece.p0), ends = m_shape.contains(piece.p1);
        // A trunk may come from outside: it is cut where it leaves the shape again.
        const bool isStem = isOnGround(piece.axis);
        const bool entered = starts || (piece.parent != noIndex && m_entered[piece.parent]);
        m_entered[i] = isStem && (entered || ends);
        if (!starts && (!isStem || (entered && !ends))) {
            m_gone[i] = true;
            return;
        }
        if (ends || !starts)
            return;
        const double t = leavesAt(m_shape, piece);
        if (t * m_tree.length(i) < shortestStub * piece.a0 && !(isStem && piece.parent == noIndex)) {
            m_gone[i] = true;
            return;
        }
        m_ends[i] = true;
        m_cuts.emplace_back(i, t);
    }
    [[nodiscard]] bool isOnGround(Index axis) const
    {
        return m_tree.piece(m_tree.axis(axis).first).parent == noIndex;
    }

    const EditTree& m_tree;
    const ShapeTest& m_shape;
    const EditMarks& m_limb;
    EditMarks m_gone, m_entered;
    EditMarks m_ends = EditMarks(m_gone.size(), false);
    EditMarks m_loose = EditMarks(m_gone.size(), false); ///< cut off before: nothing there stands out
    std::vector<std::pair<Index, double>> m_cuts;
};

} // namespace

Expected<void> cut(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const Index first = tree.axis(target).first;
    const AxisSpot spot = tree.spotOn(target, edit.at);
    const bool atFoot = spot.piece == first && spot.t * tree.length(first) < 1e-3 * tree.axisLength(target);
    if (atFoot && !edit.falls)
        return takeAway(tree, tree.marked(first));
    if (atFoot && tree.piece(first).loose)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the limb has been cut off already"));
    if (!atFoot && spot.t >= 1.0 && tree.piece(spot.piece).next == noIndex)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("there is nothing above the cut"));
    const Index below = atFoot ? noIndex : tree.splitAt(spot);
    const Index above = atFoot ? first : tree.piece(below).next;
    if (edit.falls)
        tree.loosen(above, graftedAddress(edit.id, tree.axis(target).address), edit.seconds);
    else
        tree.remove(tree.marked(above));
    if (below != noIndex)
        tree.piece(below).sawn = true;
    return {};
}

Expected<void> remove(EditTree& tree, const TreeEdit& /*edit*/, Index target, Index /*other*/)
{
    return takeAway(tree, tree.marked(tree.axis(target).first));
}

Expected<void> keep(EditTree& tree, const TreeEdit& /*edit*/, Index target, Index /*other*/)
{
    const Index first = tree.axis(target).first;
    EditMarks kept = tree.marked(first);
    for (Index i = first; i != noIndex; i = tree.piece(i).parent)
        kept[i] = true;
    EditMarks others(kept.size(), false);
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after)
        others[i] = !kept[i];
    if (std::ranges::count(others, true) == 0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("there is nothing else"));
    tree.remove(others);
    return {};
}

Expected<void> prune(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const EditMarks limb = target == noIndex ? EditMarks() : tree.marked(tree.axis(target).first);
    const ShapeTest shape(edit.shape);
    if (auto ok = shape.check(); !ok)
        return ok;
    Pruner pruner(tree, shape, limb);
    pruner.run();
    const auto gone = std::ranges::count(pruner.gone(), true);
    if (gone == 0 && pruner.cuts().empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("nothing stands out of the shape"));
    if (gone >= static_cast<std::ptrdiff_t>(tree.size()))
        return nothingLeft();
    for (const auto& [i, t] : pruner.cuts())
        tree.shorten(i, t);
    tree.remove(pruner.gone());
    return {};
}

/// Of a limb; without one, of what a brush touches.
Expected<void> leaves(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const EditMarks limb = target == noIndex ? EditMarks() : tree.marked(tree.axis(target).first);
    bool any = target != noIndex;
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after) {
        const EditPiece& piece = tree.piece(i);
        if (limb.empty() ? piece.bare == !edit.shown || !touches(edit, piece) : !limb[i])
            continue;
        tree.setBare(i, !edit.shown);
        any = true;
    }
    return any ? Expected<void>() : fail(ErrorCode::Invalid, RAMURE_NOOP("no leaves there would come or go"));
}

} // namespace ramure::edits
