// What makes new axes, or puts limbs elsewhere.
#include "core/recipe/edit_operations.h"

#include "core/math/reproducible.h"
#include "core/math/stage_hash.h"
#include "core/recipe/scion.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure::edits {
namespace {

constexpr double lowestFork = 0.02;   ///< as a share: at the very foot it would be the parent's fork
constexpr double usualShare = 0.6;    ///< of the parent's radius, where a stroke says nothing
constexpr double usualTip = 0.2;      ///< of the radius at the foot
constexpr double shortestStep = 1e-6; ///< m

/// Points of a stroke in tree space, each apart from the one before.
std::vector<StrokePoint> placed(const std::vector<StrokePoint>& points, const glm::dvec3& origin,
                                const Frame& frame)
{
    std::vector<StrokePoint> out;
    for (const StrokePoint& point : points) {
        const glm::dvec3 at = origin + outOf(frame, point.position);
        if (out.empty() || glm::length(at - out.back().position) >= shortestStep)
            out.push_back({at, point.radius});
    }
    return out;
}

/// Radii that a stroke leaves open: as before, and, where it says none at all, ever thinner from \p first.
void fillRadii(std::vector<StrokePoint>& points, double first)
{
    const bool none = std::ranges::all_of(points, [](const StrokePoint& p) { return p.radius == 0.0; });
    const auto last = static_cast<double>(points.size() - 1);
    double before = first;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (none)
            points[i].radius = first * (1.0 - (1.0 - usualTip) * static_cast<double>(i) / last);
        else if (points[i].radius == 0.0)
            points[i].radius = before;
        before = points[i].radius;
    }
}

/// Of a limb's direction about the axis it stands on; 0 straight on, as Axis::azimuth.
double azimuthOf(const glm::dvec3& along)
{
    const double aside = along.x * along.x + along.y * along.y;
    return aside > 1e-18 * glm::dot(along, along) ? maths::atan2(along.y, along.x) : 0.0;
}

Scion scionOf(const EditTree& tree, std::uint64_t graft, Index axis)
{
    Scion scion{limbOf(tree, axis), {}, {}};
    const EditMarks marks = tree.marked(tree.axis(axis).first);
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after)
        if (const Index own = tree.piece(i).axis; marks[i] && tree.axis(own).first == i) {
            scion.addresses.push_back(graftedAddress(graft, tree.axis(own).address));
            scion.originals.push_back(own);
            for (Index k = i; k != noIndex; k = tree.piece(k).next)
                scion.pieces.push_back(k);
        }
    return scion;
}

Scion scionOf(const TreeEdit& edit)
{
    Scion scion{edit.limb, {}, {}};
    for (std::int64_t axis = 0; axis <= edit.limb.back().axis; ++axis) {
        scion.addresses.push_back(graftedAddress(edit.id, static_cast<std::uint64_t>(axis)));
        scion.originals.push_back(noIndex);
    }
    return scion;
}

/// m along its parent, where an axis stands.
double distanceOfFork(const EditTree& tree, Index axis)
{
    const Index below = tree.piece(tree.axis(axis).first).parent;
    double sum = 0.0;
    for (Index i = tree.axis(tree.piece(below).axis).first; i != noIndex; i = tree.piece(i).next) {
        sum += tree.length(i);
        if (i == below)
            break;
    }
    return sum;
}

/// What a piece of another tree brings.
void putOrgans(EditTree& tree, const LimbPiece& piece, Index made, double size, const Frame& frame)
{
    const double length = tree.length(made);
    for (const LimbOrgan& brought : piece.organs) {
        Organ organ;
        organ.branch = made;
        organ.kind = brought.organ == EditOrgan::Leaf ? OrganKind::Leaf : OrganKind::Fruit;
        organ.share = brought.share;
        organ.offset = size * outOf(frame, brought.offset);
        organ.axis = length > 0.0 ? (tree.piece(made).p1 - tree.piece(made).p0) / length : organ.axis;
        organ.heading = outOf(frame, brought.heading);
        organ.up = outOf(frame, brought.up);
        organ.size = brought.size > 0.0 ? size * brought.size : brought.size;
        tree.putOrgan(organ);
    }
}

/// The axes that spring from an axis, or, of noIndex, from the ground.
std::vector<Index> axesOn(const EditTree& tree, Index axis)
{
    std::vector<Index> axes;
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after) {
        const EditPiece& piece = tree.piece(i);
        const Index below = piece.parent == noIndex ? noIndex : tree.piece(piece.parent).axis;
        if (tree.axis(piece.axis).first == i && below == axis)
            axes.push_back(piece.axis);
    }
    return axes;
}

/// How many axes stand on each.
std::vector<Index> carriedBy(const EditTree& tree)
{
    std::vector<Index> counts(tree.axisCount(), 0);
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after)
        if (const Index below = tree.piece(i).parent;
            below != noIndex && tree.piece(below).axis != tree.piece(i).axis)
            ++counts[tree.piece(below).axis];
    return counts;
}

/// Which axis a new one is to look like: one beside it, else any of its order, that carries something. Of
/// several the one that stands nearest, is most like it in length and is as dense as the others are together.
/// noIndex: none carries anything.
Index modelFor(const EditTree& tree, Index axis, Index parent, double share)
{
    constexpr double farAway = 0.01; // what another limb's counts for
    const std::vector<Index> carries = carriedBy(tree);
    std::vector<Index> models;
    double carried = 0.0, along = 0.0;
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after) {
        const Index other = tree.piece(i).axis;
        if (tree.axis(other).first != i || other == axis || carries[other] == 0 ||
            tree.piece(i).level != tree.piece(tree.axis(axis).first).level)
            continue;
        models.push_back(other);
        carried += carries[other];
        along += tree.axisLength(other);
    }
    const double length = tree.axisLength(axis), whole = parent == noIndex ? 0.0 : tree.axisLength(parent);
    Index best = noIndex;
    double bestWorth = 0.0;
    for (const Index other : models) {
        const Index foot = tree.piece(tree.axis(other).first).parent;
        const Index below = foot == noIndex ? noIndex : tree.piece(foot).axis;
        const double own = tree.axisLength(other);
        // A limb that falls stands on nothing, whatever its order.
        const bool isBeside = below == parent;
        const double away =
            isBeside && whole > 0.0 ? std::abs(distanceOfFork(tree, other) / whole - share) : 0.0;
        const double dense = std::min(1.0, carries[other] * along / (own * carried));
        const double worth = dense * std::min(own, length) / std::max(own, length) *
                             (isBeside ? 1.0 / (1.0 + 4.0 * away) : farAway);
        if (worth > bestWorth) {
            bestWorth = worth;
            best = other;
        }
    }
    return best;
}

/// Is no stouter for its length than its model, and ends as thin, so that it has leaves to its tip.
void thinAs(EditTree& tree, Index model, Index axis)
{
    const double length = tree.axisLength(axis), tip = tree.piece(tree.tipOf(model)).a1;
    const double stout = tree.piece(tree.axis(model).first).a0 * length / tree.axisLength(model);
    const double foot = std::max(tip, std::min(stout, tree.piece(tree.axis(axis).first).a0));
    double from = 0.0;
    for (Index i = tree.axis(axis).first; i != noIndex; i = tree.piece(i).next) {
        const double to = from + tree.length(i);
        EditPiece& piece = tree.piece(i);
        piece.a0 = std::min(piece.a0, std::lerp(foot, tip, from / length));
        piece.a1 = std::min(piece.a1, std::lerp(foot, tip, to / length));
        from = to;
    }
}

/// What grows on one axis grows on another at the same distances from the tip and as large, so that both are
/// equally dense; where the other is longer, it grows there again further down. Nothing becomes thicker than
/// what it stands on.
void growAs(EditTree& tree, const TreeEdit& edit, Index model, Index axis)
{
    constexpr double thickest = 0.9; // of the radius below
    const double whole = tree.axisLength(model), length = tree.axisLength(axis);
    std::vector<std::pair<Index, double>> limbs; // m from the tip
    for (const Index limb : axesOn(tree, model))
        limbs.emplace_back(limb, whole - distanceOfFork(tree, limb));
    for (std::uint64_t round = 0; static_cast<double>(round) * whole < length; ++round)
        for (const auto& [limb, fromTip] : limbs) {
            const double share = 1.0 - (fromTip + static_cast<double>(round) * whole) / length;
            if (share <= lowestFork)
                continue;
            const std::uint64_t graft = round == 0 ? edit.id : StageHash(edit.id).add(round).value();
            const Scion scion = scionOf(tree, graft, limb);
            const Index below = tree.splitAt(forkSpot(tree, axis, share));
            const double radius = tree.piece(tree.axis(limb).first).a0;
            const double size = radius > 0.0 ? std::min(1.0, thickest * tree.piece(below).a1 / radius) : 1.0;
            growLimb(tree, scion, edit.id, {size, size}, below, turnedSeat(tree, below, 0.0));
        }
}

/// What grows on a limb, as its branches stand now.
void takeOrgans(const EditTree& tree, const Frame& frame, const std::unordered_map<Index, std::int64_t>& at,
                std::vector<LimbPiece>& limb)
{
    for (const EditOrganSeat& organ : tree.organs()) {
        const auto found = at.find(organ.branch);
        const EditPiece& piece = tree.piece(organ.branch);
        if (found == at.end() || (piece.bare && !organ.stays) || isMark(organ.kind))
            continue;
        const double length = tree.length(organ.branch);
        const bool turns = length > 0.0 && glm::dot(organ.axis, organ.axis) > 0.0;
        const glm::dquat turn = turns ? rotationBetween(organ.axis, (piece.p1 - piece.p0) / length)
                                      : glm::dquat(1.0, 0.0, 0.0, 0.0);
        LimbOrgan& taken = limb[static_cast<std::size_t>(found->second)].organs.emplace_back();
        taken.organ = organ.kind == OrganKind::Leaf ? EditOrgan::Leaf : EditOrgan::Fruit;
        taken.share = organ.share;
        taken.size = organ.size;
        taken.offset = into(frame, turn * organ.offset);
        taken.heading = into(frame, turn * organ.heading);
        taken.up = into(frame, turn * organ.up);
    }
}

} // namespace

Seat turnedSeat(const EditTree& tree, Index below, double byRad)
{
    return {tree.piece(below).p1, rolled(tree.frameAfter(below), byRad)};
}

void growLimb(EditTree& tree, const Scion& scion, std::uint64_t maker, const ScionSize& size, Index below,
              const Seat& seat)
{
    const std::vector<LimbPiece>& limb = scion.limb;
    std::vector<Index> axisOf, made(limb.size());
    const Index level = below == noIndex ? 0 : tree.piece(below).level + 1;
    std::vector<Index> levels(limb.size());
    for (std::size_t i = 0; i < limb.size(); ++i) {
        const LimbPiece& piece = limb[i];
        const auto axis = static_cast<std::size_t>(piece.axis);
        const bool starts = axis == axisOf.size();
        if (starts)
            axisOf.push_back(tree.addAxis(scion.addresses[axis], maker, scion.originals[axis]));
        const auto parent = static_cast<std::size_t>(std::max<std::int64_t>(piece.parent, 0));
        levels[i] = i == 0 ? level : levels[parent] + (starts ? 1 : 0);
        made[i] = tree.extend(axisOf[axis], i == 0 ? below : made[parent], seat.foot,
                              seat.foot + outOf(seat.frame, size.length * piece.p1),
                              size.thickness * piece.a0, size.thickness * piece.a1, levels[i]);
        tree.piece(made[i]).bare = piece.bare;
        tree.piece(made[i]).sawn = piece.sawn;
        if (scion.pieces.empty())
            putOrgans(tree, piece, made[i], size.length, seat.frame);
        else
            tree.copyOrgans(scion.pieces[i], made[i], size.length);
    }
}

AxisSpot forkSpot(const EditTree& tree, Index axis, double share)
{
    return tree.spotOn(axis, std::max(share, lowestFork));
}

std::uint64_t graftedAddress(std::uint64_t graft, std::uint64_t original)
{
    return StageHash(graft).add(original).value();
}

std::vector<LimbPiece> limbOf(const EditTree& tree, Index axis)
{
    const Frame frame = tree.frameBelow(axis);
    const Index first = tree.axis(axis).first;
    const glm::dvec3 foot = tree.piece(first).p0;
    const EditMarks marks = tree.marked(first);
    // Axis by axis, parents first.
    std::vector<Index> starts;
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after)
        if (marks[i] && tree.axis(tree.piece(i).axis).first == i)
            starts.push_back(i);
    std::vector<LimbPiece> limb;
    std::unordered_map<Index, std::int64_t> at;
    for (std::size_t a = 0; a < starts.size(); ++a)
        for (Index i = starts[a]; i != noIndex; i = tree.piece(i).next) {
            const EditPiece& piece = tree.piece(i);
            at[i] = static_cast<std::int64_t>(limb.size());
            limb.push_back({i == first ? -1 : at.at(piece.parent), into(frame, piece.p0 - foot),
                            into(frame, piece.p1 - foot), piece.a0, piece.a1, static_cast<std::int64_t>(a),
                            piece.sawn && piece.next == noIndex, piece.bare});
        }
    takeOrgans(tree, frame, at, limb);
    return limb;
}

Expected<void> draw(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const AxisSpot spot = target == noIndex ? AxisSpot() : forkSpot(tree, target, edit.at);
    const Frame frame = target == noIndex ? Frame() : tree.frameAfter(spot.piece);
    const glm::dvec3 origin = target == noIndex ? glm::dvec3(0.0) : tree.pointAt(spot);
    std::vector<StrokePoint> points = placed(edit.points, origin, frame);
    const bool startsHere = target == noIndex || glm::length(points.front().position - origin) < shortestStep;
    if (!startsHere)
        points.insert(points.begin(), StrokePoint{origin, points.front().radius});
    if (points.size() < 2)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the stroke goes nowhere"));
    const double length = glm::length(points.back().position - points.front().position);
    fillRadii(points, target == noIndex ? 0.05 * length : usualShare * tree.radiusAt(spot));
    Index below = target == noIndex ? noIndex : tree.splitAt(spot);
    const Index level = target == noIndex ? 0 : tree.piece(below).level + 1;
    const Index axis = tree.addAxis(edit.id);
    for (std::size_t i = 1; i < points.size(); ++i)
        below = tree.extend(axis, below, points[i - 1].position, points[i].position, points[i - 1].radius,
                            points[i].radius, level);
    if (!edit.below)
        return {};
    if (const Index model = modelFor(tree, axis, target, edit.at); model != noIndex) {
        if (std::ranges::all_of(edit.points, [](const StrokePoint& p) { return p.radius == 0.0; }))
            thinAs(tree, model, axis);
        growAs(tree, edit, model, axis);
    }
    return {};
}

Expected<void> extend(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    Index below = tree.tipOf(target);
    const EditPiece tip = tree.piece(below);
    std::vector<StrokePoint> points = placed(edit.points, tip.p1, tree.frameAfter(below));
    if (glm::length(points.front().position - tip.p1) < shortestStep)
        points.erase(points.begin());
    if (points.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the stroke goes nowhere"));
    points.insert(points.begin(), StrokePoint{tip.p1, tip.a1});
    fillRadii(points, tip.a1);
    for (std::size_t i = 1; i < points.size(); ++i)
        below = tree.extend(target, below, {}, points[i].position, points[i - 1].radius, points[i].radius,
                            tip.level);
    return {};
}

Expected<void> graft(EditTree& tree, const TreeEdit& edit, Index target, Index other)
{
    const bool isOwn = edit.limb.empty();
    if (isOwn && tree.isOn(tree.axis(target).first, tree.axis(other).first))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a limb cannot be grafted into itself"));
    const Scion scion = isOwn ? scionOf(tree, edit.id, other) : scionOf(edit);
    const std::vector<LimbPiece>& limb = scion.limb;
    if (std::ranges::all_of(limb, [](const LimbPiece& piece) { return piece.p0 == piece.p1; }))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the axis has no length"));
    const Index below = tree.splitAt(forkSpot(tree, target, edit.at));
    const double was = azimuthOf(limb.front().p1 - limb.front().p0);
    growLimb(tree, scion, edit.id, {edit.factor, edit.factor}, below,
             turnedSeat(tree, below, edit.azimuthRad - was));
    return {};
}

Expected<void> move(EditTree& tree, const TreeEdit& edit, Index target, Index other)
{
    const Index first = tree.axis(target).first;
    const Index parentPiece = tree.piece(first).parent;
    if (parentPiece == noIndex)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("an axis on the ground has no place on a parent"));
    const Index parent = other != noIndex ? other : tree.piece(parentPiece).axis;
    if (tree.isOn(tree.axis(parent).first, first))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a limb cannot be put on itself"));
    const Frame frame = tree.frameBelow(target);
    const glm::dvec3 foot = tree.piece(first).p0;
    const double was = azimuthOf(into(frame, tree.piece(first).p1 - foot));
    const Index below = tree.splitAt(forkSpot(tree, parent, edit.at));
    const Seat seat = turnedSeat(tree, below, edit.azimuthRad - was);
    const EditMarks limb = tree.marked(first);
    const Index levelBefore = tree.piece(first).level, level = tree.piece(below).level + 1;
    tree.hang(target, below);
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after)
        if (limb[i]) {
            EditPiece& piece = tree.piece(i);
            piece.p0 = piece.parent == below ? seat.foot : tree.piece(piece.parent).p1;
            piece.p1 = seat.foot + outOf(seat.frame, into(frame, piece.p1 - foot));
            piece.level = piece.level - levelBefore + level;
        }
    return {};
}

} // namespace ramure::edits
