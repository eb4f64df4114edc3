// Modifiers that turn what has grown: by its weight, and from side to side.
#include "core/recipe/edit_operations.h"

#include "core/generators/grammar/turtle.h"
#include "core/math/reproducible.h"
#include "core/math/stage_hash.h"
#include "core/params/node_params.h"
#include "core/skeleton/bend.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace ramure::edits {
namespace {

constexpr double gravity = 9.81;     ///< m/s²
constexpr double greenWood = 900.0;  ///< kg/m³, of living wood
constexpr double twigRadius = 0.005; ///< m; leaves grow on what is thinner
constexpr double thinnest = 0.0005;  ///< m; a thinner twig bends as one of this radius
constexpr int rounds = 8;            ///< the load is put on bit by bit
constexpr double mostTurn = 0.3;     ///< rad of one piece in one round

/// The weight above the start of each piece: kg, and kg times place.
struct Load
{
    std::vector<double> mass, own; ///< own: of the piece alone
    std::vector<glm::dvec3> moment;
};

Load loadOf(const EditTree& tree, const std::vector<Index>& order, const SagParams& sag)
{
    const std::size_t count = tree.pieces().size();
    Load load{std::vector<double>(count, 0.0), std::vector<double>(count, 0.0),
              std::vector<glm::dvec3>(count, glm::dvec3(0.0))};
    for (std::size_t k = order.size(); k-- > 0;) {
        const Index i = order[k];
        const EditPiece& piece = tree.piece(i);
        const double length = tree.length(i), a = piece.a0, b = piece.a1;
        double own = greenWood * std::numbers::pi / 3.0 * length * (a * a + a * b + b * b);
        if (0.5 * (a + b) < twigRadius && !piece.bare)
            own += sag.load * length;
        load.own[i] = own;
        load.mass[i] += own;
        load.moment[i] += own * 0.5 * (piece.p0 + piece.p1);
        if (piece.parent != noIndex) {
            load.mass[piece.parent] += load.mass[i];
            load.moment[piece.parent] += load.moment[i];
        }
    }
    return load;
}

/// The turn of a piece by what it carries: of a beam, curvature = torque / (E I).
glm::dvec3 turnBy(const EditTree& tree, Index i, const Load& load, const SagParams& sag)
{
    const EditPiece& piece = tree.piece(i);
    const double length = tree.length(i);
    if (length == 0.0 || load.mass[i] == 0.0)
        return glm::dvec3(0.0);
    const glm::dvec3 along = (piece.p1 - piece.p0) / length;
    const glm::dvec3 down(0.0, -gravity, 0.0);
    const glm::dvec3 atStart = glm::cross(load.moment[i] - load.mass[i] * piece.p0, down);
    const glm::dvec3 ownMoment = load.own[i] * 0.5 * (piece.p0 + piece.p1);
    const double above = load.mass[i] - load.own[i];
    const glm::dvec3 atEnd = glm::cross(load.moment[i] - ownMoment - above * piece.p1, down);
    glm::dvec3 torque = 0.5 * (atStart + atEnd);
    torque -= glm::dot(torque, along) * along; // a twist of the wood turns nothing
    const double radius = std::max(0.5 * (piece.a0 + piece.a1), thinnest);
    const double stiffness =
        sag.stiffness * 1e9 * 0.25 * std::numbers::pi * radius * radius * radius * radius;
    const glm::dvec3 turn = sag.amount / rounds * length / stiffness * torque;
    // Nothing turns past the vertical, however soft it is.
    const double angle = glm::length(turn);
    const double toEnd = maths::acos(std::clamp(sag.amount > 0.0 ? -along.y : along.y, -1.0, 1.0));
    const double most = std::min(mostTurn, 0.5 * toEnd);
    return angle > most ? most / angle * turn : turn;
}

/// A vector that changes smoothly along an axis: value noise in two octaves. 0 at its foot.
class Wander
{
public:
    explicit Wander(const Random& chance)
        : m_key(Random(chance).next())
    {
    }
    [[nodiscard]] glm::dvec3 at(double u) const
    {
        const double ramp = std::min(u, 1.0);
        return ramp * (octave(u, 1) + 0.5 * octave(2.0 * u, 2));
    }

private:
    [[nodiscard]] glm::dvec3 octave(double u, std::uint64_t which) const
    {
        const double whole = std::floor(u), t = u - whole, smooth = t * t * (3.0 - 2.0 * t);
        const auto cell = static_cast<std::uint64_t>(whole);
        return (1.0 - smooth) * corner(cell, which) + smooth * corner(cell + 1, which);
    }
    [[nodiscard]] glm::dvec3 corner(std::uint64_t cell, std::uint64_t which) const
    {
        Random chance(m_key, RandomStream::Steps, StageHash(which).add(cell).value());
        return {chance.range(-1.0, 1.0), chance.range(-1.0, 1.0), chance.range(-1.0, 1.0)};
    }

    std::uint64_t m_key;
};

/// m from one turn to the next: short axes have some, too.
double spacingOf(const EditTree& tree, Index axis, const GnarlParams& gnarl)
{
    constexpr double fewest = 2.0; // turns
    const double wanted = gnarl.length * 2.0 * tree.piece(tree.axis(axis).first).a0;
    return std::min(wanted, tree.axisLength(axis) / fewest);
}

constexpr double finest = 0.004; ///< m; thinner wood turns where its pieces end

/// Where wood must be split so that it can turn, piece by piece.
std::vector<AxisSpot> turningPlaces(const EditTree& tree, const std::vector<bool>& axes,
                                    const std::vector<double>& spacing)
{
    constexpr double parts = 3.0; // of one turn
    constexpr double most = 24.0; // of one piece
    std::vector<AxisSpot> spots;
    for (Index i = 0; i < tree.pieces().size(); ++i) {
        const EditPiece& piece = tree.piece(i);
        if (piece.gone || !axes[piece.axis] || piece.a0 < finest || !(spacing[piece.axis] > 0.0))
            continue;
        const double count = std::clamp(std::floor(parts * tree.length(i) / spacing[piece.axis]), 1.0, most);
        for (double k = 1.0; k < count; ++k)
            spots.push_back({i, k / count});
    }
    return spots;
}

} // namespace

Expected<void> sag(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const auto axes = axesMeant(tree, edit, target);
    RAMURE_TRY(axes);
    const SagParams& sag = edit.values->step.sag;
    std::vector<Index> order;
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after)
        order.push_back(i);
    for (int round = 0; round < rounds && !tree.cancelled(); ++round) {
        const Load load = loadOf(tree, order, sag);
        std::vector<glm::dvec3> turns(tree.pieces().size(), glm::dvec3(0.0));
        for (const Index i : order)
            if ((*axes)[tree.piece(i).axis] && !tree.piece(i).loose)
                turns[i] = turnBy(tree, i, load, sag);
        tree.carry([&](Index i, glm::dquat& turn, glm::dvec3& along) {
            if (turns[i] == glm::dvec3(0.0))
                return false;
            const glm::dquat own = bendRotation(turns[i]);
            turn = glm::normalize(own * turn);
            along = own * along;
            return true;
        });
    }
    return {};
}

Expected<void> gnarl(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const auto axes = axesMeant(tree, edit, target);
    RAMURE_TRY(axes);
    const GnarlParams& gnarl = edit.values->step.gnarl;
    std::vector<double> spacing(tree.axisCount(), 0.0);
    for (Index a = 0; a < tree.axisCount(); ++a)
        if ((*axes)[a])
            spacing[a] = spacingOf(tree, a, gnarl);
    const std::vector<AxisSpot> spots = turningPlaces(tree, *axes, spacing);
    if (tree.size() + spots.size() > maxBranches)
        return fail(ErrorCode::Limit, RAMURE_NOOP("the step would make more branches than there may be"));
    tree.splitAt(spots);
    std::vector<glm::dvec3> wander(tree.pieces().size(), glm::dvec3(0.0));
    for (Index a = 0; a < tree.axisCount(); ++a) {
        if (!(spacing[a] > 0.0))
            continue;
        const Index first = tree.axis(a).first;
        const double angle = gnarl.angle * maths::pow(gnarl.byOrder, tree.piece(first).level);
        const Wander noise(chanceOf(tree, edit, a));
        double s = 0.0;
        for (Index i = first; i != noIndex; i = tree.piece(i).next) {
            s += tree.length(i);
            wander[i] = angle * noise.at(s / spacing[a]);
        }
    }
    tree.carry([&](Index i, glm::dquat& turn, glm::dvec3& along) {
        const EditPiece& piece = tree.piece(i);
        if (!(spacing[piece.axis] > 0.0))
            return false;
        // What the axis has turned by so far is handed on: only the rest is its own.
        const bool goesOn = piece.parent != noIndex && tree.piece(piece.parent).axis == piece.axis;
        const glm::dquat before =
            goesOn ? bendRotation(wander[piece.parent]) : glm::dquat(1.0, 0.0, 0.0, 0.0);
        const glm::dquat own = bendRotation(wander[i]) * glm::conjugate(before);
        turn = glm::normalize(own * turn);
        along = own * along;
        return true;
    });
    return {};
}

} // namespace ramure::edits
