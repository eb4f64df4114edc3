// Radii, and another way for an axis.
#include "core/recipe/edit_operations.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ramure::edits {
namespace {

/// A line of points by their distance from the first.
class Polyline
{
public:
    Polyline(const glm::dvec3& foot, const Frame& frame, const std::vector<StrokePoint>& points)
    {
        add(foot);
        for (const StrokePoint& point : points)
            add(foot + outOf(frame, point.position));
    }

    [[nodiscard]] double length() const { return m_along.back(); }
    /// Of the points between the ends, as shares.
    [[nodiscard]] std::vector<double> shares() const
    {
        std::vector<double> shares;
        for (std::size_t i = 1; i + 1 < m_along.size(); ++i)
            shares.push_back(m_along[i] / length());
        return shares;
    }
    [[nodiscard]] glm::dvec3 at(double share) const
    {
        const double wanted = share * length();
        const auto above = std::ranges::lower_bound(m_along, wanted);
        if (above == m_along.begin())
            return m_points.front();
        if (above == m_along.end())
            return m_points.back();
        const auto i = static_cast<std::size_t>(above - m_along.begin());
        const double t = (wanted - m_along[i - 1]) / (m_along[i] - m_along[i - 1]);
        return m_points[i - 1] + t * (m_points[i] - m_points[i - 1]);
    }

private:
    /// Points upon each other are one.
    void add(const glm::dvec3& point)
    {
        const double step = m_points.empty() ? 1.0 : glm::length(point - m_points.back());
        if (step < 1e-6)
            return;
        m_along.push_back(m_points.empty() ? 0.0 : m_along.back() + step);
        m_points.push_back(point);
    }

    std::vector<glm::dvec3> m_points;
    std::vector<double> m_along;
};

} // namespace

Expected<void> thickness(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const EditMarks limb = edit.below ? tree.marked(tree.axis(target).first) : EditMarks();
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after)
        if (edit.below ? limb[i] : tree.piece(i).axis == target) {
            tree.piece(i).a0 *= edit.factor;
            tree.piece(i).a1 *= edit.factor;
        }
    return {};
}

Expected<void> taper(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const double whole = tree.axisLength(target);
    if (whole == 0.0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the axis has no length"));
    double start = 0.0;
    for (Index i = tree.axis(target).first; i != noIndex; i = tree.piece(i).next) {
        const double end = start + tree.length(i);
        tree.piece(i).a0 *= 1.0 + (edit.factor - 1.0) * start / whole;
        tree.piece(i).a1 *= 1.0 + (edit.factor - 1.0) * end / whole;
        start = end;
    }
    return {};
}

Expected<void> redraw(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const Frame frame = tree.frameBelow(target);
    const glm::dvec3 foot = tree.piece(tree.axis(target).first).p0;
    const Polyline way(foot, frame, edit.points);
    if (!(way.length() > 0.0) || tree.axisLength(target) == 0.0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the stroke goes nowhere"));
    for (const double share : way.shares())
        tree.splitAt(target, share);
    std::vector<double> share(tree.pieces().size(), -1.0); // where the axis' pieces end
    const double whole = tree.axisLength(target);
    double end = 0.0;
    for (Index i = tree.axis(target).first; i != noIndex; i = tree.piece(i).next) {
        end += tree.length(i);
        share[i] = tree.piece(i).next == noIndex ? 1.0 : end / whole;
    }
    tree.carry([&](Index i, glm::dquat& turn, glm::dvec3& along) {
        if (share[i] < 0.0)
            return false;
        const EditPiece& piece = tree.piece(i);
        const bool isFirst = i == tree.axis(target).first;
        const glm::dvec3 before = piece.p1 - piece.p0; // its start is moved behind this
        const glm::dvec3 start = isFirst ? piece.p0 : tree.piece(piece.parent).p1;
        along = way.at(share[i]) - start;
        const double was = glm::length(before), is = glm::length(along);
        if (was > 0.0 && is > 0.0)
            turn = rotationBetween(before / was, along / is);
        return true;
    });
    return {};
}

} // namespace ramure::edits
