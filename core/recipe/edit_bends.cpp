// What turns and moves pieces without making or taking any.
#include "core/recipe/edit_operations.h"

#include "core/math/reproducible.h"
#include "core/skeleton/bend.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure::edits {
namespace {

constexpr double finestTurn = 0.15; ///< rad, of a curl from one piece to the next
constexpr double finestBow = 0.08;  ///< likewise of a bend: its middle turns half as much again
constexpr int mostTurns = 48;

/// Of where an axis' piece ends, as a share of its length; the same order as its pieces.
struct AxisShares
{
    std::vector<Index> pieces;
    std::vector<double> from, to;
};

AxisShares sharesOf(const EditTree& tree, Index axis)
{
    AxisShares shares;
    const double whole = tree.axisLength(axis);
    double start = 0.0;
    for (Index i = tree.axis(axis).first; i != noIndex; i = tree.piece(i).next) {
        const double end = start + tree.length(i);
        shares.pieces.push_back(i);
        shares.from.push_back(whole > 0.0 ? start / whole : 0.0);
        shares.to.push_back(whole > 0.0 ? end / whole : 1.0);
        start = end;
    }
    return shares;
}

/// The first piece that a turn at a share of the axis takes along.
Index pieceAbove(EditTree& tree, Index axis, double share)
{
    const Index first = tree.axis(axis).first;
    const AxisSpot spot = tree.spotOn(axis, share);
    if (spot.piece == first && spot.t < 1.0 && spot.t * tree.length(first) < 1e-3 * tree.axisLength(axis))
        return first;
    return tree.piece(tree.splitAt(spot)).next;
}

/// What a brush does to directions.
template <class Wanted>
Expected<void> brush(EditTree& tree, const TreeEdit& edit, Index target, Wanted&& wanted)
{
    const EditMarks limb = target == noIndex ? EditMarks() : tree.marked(tree.axis(target).first);
    const double strength = std::abs(edit.strength);
    bool any = false;
    tree.carry([&](Index i, glm::dquat& turn, glm::dvec3& along) {
        const EditPiece& piece = tree.piece(i);
        const glm::dvec3 start = piece.parent == noIndex ? piece.p0 : tree.piece(piece.parent).p1;
        const double length = glm::length(along);
        const glm::dvec3 away = start + 0.5 * along - edit.centre;
        const double far = glm::dot(away, away) / (edit.radius * edit.radius);
        if (far >= 1.0 || length == 0.0 || (!limb.empty() && !limb[i]))
            return false;
        const glm::dvec3 to = wanted(start + 0.5 * along);
        const double size = glm::length(to);
        if (size < 1e-9 * edit.radius)
            return false;
        // Many short pieces turn no more than a few long ones.
        const double own = std::min(1.0, 4.0 * length / edit.radius);
        const double weight = own * strength * (1.0 - far) * (1.0 - far);
        const glm::dvec3 rotation = bendVector(rotationBetween(along / length, to / size));
        const glm::dquat part = bendRotation(weight * rotation);
        turn = glm::normalize(part * turn);
        along = part * along;
        any = true;
        return true;
    });
    return any ? Expected<void>() : fail(ErrorCode::Invalid, RAMURE_NOOP("no branch is within reach"));
}

/// Turns an axis bit by bit between two shares of its length: long pieces are split, so that it becomes a
/// curve however few it had. \param finest rad from one piece to the next, on average
/// \param done share of the turn that is made at a share of the way, from 0 to 1
template <class Done> void bow(EditTree& tree, const TreeEdit& edit, Index target, double finest, Done&& done)
{
    const glm::dvec3 whole = outOf(tree.frameBelow(target), edit.rotation);
    const int turns = static_cast<int>(
        std::clamp(std::ceil(glm::length(whole) / finest), 2.0, static_cast<double>(mostTurns)));
    for (int k = 0; k <= turns; ++k)
        if (const double share = edit.from + (edit.to - edit.from) * k / turns; share > 1e-3)
            tree.splitAt(target, share);
    const AxisShares shares = sharesOf(tree, target);
    std::vector<double> part(tree.pieces().size(), -1.0);
    double before = 0.0;
    for (std::size_t k = 0; k < shares.pieces.size(); ++k) {
        const double middle = 0.5 * (shares.from[k] + shares.to[k]);
        const double now = done(std::clamp((middle - edit.from) / (edit.to - edit.from), 0.0, 1.0));
        part[shares.pieces[k]] = now - before;
        before = now;
    }
    tree.carry([&](Index i, glm::dquat& turn, glm::dvec3& along) {
        if (!(part[i] > 0.0))
            return false;
        const glm::dquat rotation = bendRotation(part[i] * whole);
        turn = glm::normalize(rotation * turn);
        along = rotation * along;
        return true;
    });
}

} // namespace

Expected<void> bend(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    if (edit.to > edit.from) { // curved nowhere at once: neither where it begins nor where it ends
        bow(tree, edit, target, finestBow, [](double t) { return t * t * (3.0 - 2.0 * t); });
        return {};
    }
    const AxisSpot spot = tree.spotOn(target, edit.from);
    if (spot.t >= 1.0 && tree.piece(spot.piece).next == noIndex)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("there is nothing above the bend"));
    const Frame frame = tree.frameBelow(target);
    const glm::dquat rotation = bendRotation(outOf(frame, edit.rotation));
    const Index first = pieceAbove(tree, target, edit.from);
    tree.carry([&](Index i, glm::dquat& turn, glm::dvec3& along) {
        if (i != first)
            return false;
        turn = rotation;
        along = rotation * along;
        return true;
    });
    return {};
}

Expected<void> curl(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    if (edit.to <= edit.from)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a curl must end above its start"));
    bow(tree, edit, target, finestTurn, [](double share) { return share; });
    return {};
}

Expected<void> twist(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const AxisShares shares = sharesOf(tree, target);
    std::vector<double> share(tree.pieces().size(), -1.0);
    for (std::size_t k = 0; k < shares.pieces.size(); ++k)
        share[shares.pieces[k]] = shares.to[k];
    bool any = false;
    tree.carry([&](Index i, glm::dquat& turn, glm::dvec3& along) {
        const EditPiece& piece = tree.piece(i);
        if (piece.parent == noIndex || piece.axis == target || share[piece.parent] < 0.0)
            return false;
        const EditPiece& below = tree.piece(piece.parent);
        const double length = tree.length(piece.parent);
        if (length == 0.0)
            return false;
        const glm::dquat part =
            maths::angleAxis(edit.angleRad * share[piece.parent], (below.p1 - below.p0) / length);
        turn = glm::normalize(part * turn);
        along = part * along;
        return any = true;
    });
    return any ? Expected<void>() : fail(ErrorCode::Invalid, RAMURE_NOOP("nothing grows on this axis"));
}

Expected<void> roll(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const Index first = pieceAbove(tree, target, edit.from);
    if (first == noIndex)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("there is nothing above the roll"));
    tree.piece(first).roll += edit.angleRad;
    return {};
}

Expected<void> length(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const EditMarks limb = edit.below ? tree.marked(tree.axis(target).first) : EditMarks();
    tree.carry([&](Index i, glm::dquat& /*turn*/, glm::dvec3& along) {
        if (edit.below ? !limb[i] : tree.piece(i).axis != target)
            return false;
        along *= edit.factor;
        return true;
    });
    return {};
}

Expected<void> attract(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const double sign = edit.strength < 0.0 ? -1.0 : 1.0;
    return brush(tree, edit, target, [&](const glm::dvec3& at) { return sign * (edit.centre - at); });
}

Expected<void> comb(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const double sign = edit.strength < 0.0 ? -1.0 : 1.0;
    const glm::dvec3 way = sign * edit.radius / glm::length(edit.direction) * edit.direction;
    return brush(tree, edit, target, [&](const glm::dvec3& /*at*/) { return way; });
}

Expected<void> root(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    constexpr double flareTop = 0.15; ///< of the axis' length
    constexpr int flareSteps = 4;
    const Index first = tree.axis(target).first;
    if (tree.piece(first).parent != noIndex || tree.piece(first).loose)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("only an axis on the ground has a root"));
    const EditMarks limb = tree.marked(first);
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after)
        if (limb[i] && edit.offset != glm::dvec3(0.0)) {
            tree.piece(i).p0 += edit.offset;
            tree.piece(i).p1 += edit.offset;
        }
    if (edit.factor == 1.0)
        return {};
    for (int k = 1; k <= flareSteps; ++k)
        tree.splitAt(target, flareTop * k / flareSteps);
    const AxisShares shares = sharesOf(tree, target);
    const auto flare = [&](double share) {
        const double low = std::max(0.0, 1.0 - share / flareTop);
        return 1.0 + (edit.factor - 1.0) * low * low;
    };
    for (std::size_t k = 0; k < shares.pieces.size(); ++k) {
        tree.piece(shares.pieces[k]).a0 *= flare(shares.from[k]);
        tree.piece(shares.pieces[k]).a1 *= flare(shares.to[k]);
    }
    return {};
}

} // namespace ramure::edits
