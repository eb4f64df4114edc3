// Sources behind the first: what a generator grows on axes of the tree, or beside it.
#include "core/recipe/edit_operations.h"

#include "core/generators/grammar/turtle.h"
#include "core/generators/sources.h"
#include "core/generators/variety.h"
#include "core/math/reproducible.h"
#include "core/math/stage_hash.h"
#include "core/recipe/scion.h"
#include <algorithm>
#include <numbers>
#include <optional>

namespace ramure::edits {
namespace {

constexpr double thickest = 0.9; ///< what grows on an axis, of the axis' radius there
constexpr double goldenAngle = std::numbers::pi * (3.0 - 2.2360679774997896);

/// A limb of what the generator has grown.
struct GrownLimb
{
    double share = 0.0;  ///< of the trunk, where it starts
    double radius = 0.0; ///< m, of the trunk there
    Scion scion;
};

/// One of the variants.
struct Grown
{
    double length = 0.0, radius = 0.0; ///< of its trunk
    std::vector<GrownLimb> limbs;      ///< on the trunk; or one, the whole
    std::size_t pieces = 0;
};

Scion scionOf(const EditTree& tree, Index axis)
{
    Scion scion{limbOf(tree, axis), {}, {}};
    const EditMarks marks = tree.marked(tree.axis(axis).first);
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after)
        if (const Index own = tree.piece(i).axis; marks[i] && tree.axis(own).first == i) {
            scion.addresses.push_back(tree.axis(own).address);
            scion.originals.push_back(noIndex);
        }
    return scion;
}

Expected<Grown> grownOf(const EditTree& tree, const TreeEdit& edit, std::int64_t variant)
{
    NodeParams params = *edit.values;
    constexpr std::uint64_t seeds = 1ull << 53; // that the parameter can have
    params.grammar.seed = static_cast<std::int64_t>(
        StageHash(tree.seed()).add(edit.id).add(params.step.seed).add(variant).value() % seeds);
    const Progress progress{tree.progress().stop, {}};
    const auto symbols = growSymbols(params, progress);
    RAMURE_TRY(symbols);
    const auto skeleton = growSkeleton(*symbols, params, progress);
    RAMURE_TRY(skeleton);
    const TreeAxes axes = ramure::axesOf(*skeleton);
    const EditTree grown(*skeleton, axes);
    const auto longest = std::ranges::max_element(
        axes.axes, {}, [](const Axis& axis) { return axis.parent == noIndex ? axis.length : -1.0; });
    if (longest == axes.axes.end() || !(longest->length > 0.0))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("nothing grows that has a length"));
    const auto trunk = static_cast<Index>(longest - axes.axes.begin());
    Grown out{longest->length, longest->radius, {}};
    if (params.step.stand.way != StandWay::Limbs)
        out.limbs.push_back({0.0, longest->radius, scionOf(grown, trunk)});
    for (Index a = 0; a < axes.axes.size() && params.step.stand.way == StandWay::Limbs; ++a)
        if (const Axis& axis = axes.axes[a]; axis.parent == trunk)
            out.limbs.push_back(
                {axis.share, grown.radiusAt(grown.spotOn(trunk, axis.share)), scionOf(grown, a)});
    for (const GrownLimb& limb : out.limbs)
        out.pieces += limb.scion.limb.size();
    return out;
}

/// One thing that is to grow.
struct Planned
{
    const GrownLimb* limb;
    AxisSpot spot;
    Index axis;
    double roll, tilt; ///< rad
    ScionSize size;
    std::uint64_t rank; ///< among those on its axis
};

class Planter
{
public:
    Planter(EditTree& tree, const TreeEdit& edit)
        : m_tree(tree)
        , m_edit(edit)
        , m_stand(edit.values->step.stand)
        , m_variants(variesByChance(*edit.values) ? m_stand.variants : 1)
        , m_grown(static_cast<std::size_t>(m_variants))
    {
    }

    Expected<void> plan(const std::vector<bool>& axes)
    {
        for (const Index a : m_tree.axesInOrder()) {
            if (!axes[a])
                continue;
            if (m_tree.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            Random chance = chanceOf(m_tree, m_edit, a);
            const auto grown = variant(chance.below(static_cast<std::uint32_t>(m_variants)));
            RAMURE_TRY(grown);
            const double whole = m_tree.axisLength(a);
            if (!(whole > 0.0))
                continue;
            if (m_stand.way == StandWay::Limbs)
                planLimbs(**grown, a, whole, chance);
            else if (m_stand.way == StandWay::Along)
                planAlong(**grown, a, whole, chance);
            else
                planTip(**grown, a, whole, chance);
            if (m_tree.size() + m_pieces > maxBranches)
                return fail(ErrorCode::Limit,
                            RAMURE_NOOP("the step would make more branches than there may be"));
        }
        return m_plans.empty() ? fail(ErrorCode::Invalid, RAMURE_NOOP("nothing grows there"))
                               : Expected<void>();
    }

    void grow()
    {
        std::vector<AxisSpot> spots;
        for (const Planned& plan : m_plans)
            spots.push_back(plan.spot);
        const std::vector<Index> ends = m_tree.splitAt(spots);
        for (std::size_t k = 0; k < m_plans.size(); ++k) {
            const Planned& plan = m_plans[k];
            Seat seat = turnedSeat(m_tree, ends[k], plan.roll);
            seat.frame = tilted(seat.frame, plan.tilt);
            put(plan, ends[k], seat, m_tree.axis(plan.axis).address);
        }
    }

    Expected<void> growOnGround()
    {
        const auto grown = variant(0);
        RAMURE_TRY(grown);
        if (m_tree.size() + (*grown)->pieces > maxBranches)
            return fail(ErrorCode::Limit, RAMURE_NOOP("the step would make more branches than there may be"));
        const Index first = m_tree.firstPiece();
        const glm::dvec3 foot = first == noIndex ? glm::dvec3(0.0) : m_tree.piece(first).p0;
        const Planned plan{&(*grown)->limbs.front(), {}, noIndex, 0.0, 0.0, {m_stand.size, m_stand.size}, 0};
        put(plan, noIndex, {foot + m_stand.offset, Frame()}, noAxisAddress);
        return {};
    }

private:
    Expected<const Grown*> variant(std::uint32_t which)
    {
        std::optional<Grown>& kept = m_grown[which];
        if (!kept) {
            auto made = grownOf(m_tree, m_edit, which);
            RAMURE_TRY(made);
            kept = std::move(*made);
        }
        return &*kept;
    }

    void add(Planned plan, double lengthFactor, double thicknessFactor)
    {
        const double here = m_tree.radiusAt(plan.spot);
        const double foot = plan.limb->scion.limb.front().a0;
        const double most = foot > 0.0 ? thickest * here / foot : thicknessFactor;
        plan.size = {lengthFactor, std::min(thicknessFactor, most)};
        m_plans.push_back(plan);
        m_pieces += plan.limb->scion.limb.size() + 1;
    }
    void planLimbs(const Grown& grown, Index axis, double whole, Random& chance)
    {
        const double roll = chance.range(-std::numbers::pi, std::numbers::pi);
        const double size = m_stand.size * whole / grown.length;
        std::uint64_t rank = 0;
        for (const GrownLimb& limb : grown.limbs) { // as they start along the trunk
            ++rank;
            if (limb.share < m_stand.from || limb.share > m_stand.to)
                continue;
            const AxisSpot spot = forkSpot(m_tree, axis, limb.share);
            const double thickness = limb.radius > 0.0 ? m_tree.radiusAt(spot) / limb.radius : size;
            add({&limb, spot, axis, roll, 0.0, {}, rank}, size, thickness);
        }
    }
    void planAlong(const Grown& grown, Index axis, double whole, Random& chance)
    {
        constexpr double jitter = 0.3; // of the way to the next
        const double phase = chance.range(-std::numbers::pi, std::numbers::pi);
        for (std::int64_t k = 0; k < m_stand.count; ++k) {
            const double at = (static_cast<double>(k) + 0.5 + chance.range(-jitter, jitter)) /
                              static_cast<double>(m_stand.count);
            const double share = m_stand.from + (m_stand.to - m_stand.from) * at;
            const double size = m_stand.size * whole / grown.length * chance.range(0.85, 1.15);
            add({&grown.limbs.front(),
                 forkSpot(m_tree, axis, share),
                 axis,
                 phase + goldenAngle * static_cast<double>(k),
                 m_stand.angle,
                 {},
                 std::uint64_t(k)},
                size, size);
        }
    }
    void planTip(const Grown& grown, Index axis, double whole, Random& chance)
    {
        const Index tip = m_tree.tipOf(axis);
        EditPiece& piece = m_tree.piece(tip);
        // The axis goes on: its end is as thick as what stands on it.
        piece.a1 = std::max(piece.a1, 0.5 * piece.a0);
        piece.sawn = false;
        const double size = m_stand.size * whole / grown.length;
        const double foot = grown.limbs.front().scion.limb.front().a0;
        add({&grown.limbs.front(),
             {tip, 1.0},
             axis,
             chance.range(-std::numbers::pi, std::numbers::pi),
             0.0,
             {},
             0},
            size, foot > 0.0 ? piece.a1 / foot : size);
    }

    static Frame tilted(const Frame& frame, double angle)
    {
        if (angle == 0.0)
            return frame;
        const auto [sine, cosine] = maths::sincos(angle);
        return {cosine * frame.tangent + sine * frame.normal, cosine * frame.normal - sine * frame.tangent,
                frame.binormal};
    }
    /// Addresses come from the parent's, the step's id and the rank: whatever happens below or beside.
    void put(const Planned& plan, Index below, const Seat& seat, std::uint64_t parent)
    {
        Scion named = plan.limb->scion;
        for (std::uint64_t& address : named.addresses)
            address = StageHash(m_edit.id).add(parent).add(plan.rank).add(address).value();
        growLimb(m_tree, named, m_edit.id, plan.size, below, seat);
    }

    EditTree& m_tree;
    const TreeEdit& m_edit;
    const StandParams& m_stand;
    std::int64_t m_variants;
    std::vector<std::optional<Grown>> m_grown;
    std::vector<Planned> m_plans;
    std::size_t m_pieces = 0;
};

} // namespace

Expected<void> source(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    Planter planter(tree, edit);
    if (edit.values->step.stand.way == StandWay::Ground)
        return planter.growOnGround();
    const auto axes = axesMeant(tree, edit, target);
    RAMURE_TRY(axes);
    if (auto planned = planter.plan(*axes); !planned)
        return planned;
    planter.grow();
    return {};
}

} // namespace ramure::edits
