// The modifier that lets limbs die.
#include "core/recipe/edit_operations.h"

#include "core/params/node_params.h"
#include <algorithm>

namespace ramure::edits {
namespace {

/// Where axes start on their parents, as shares of the parents' lengths.
std::vector<double> sharesOfForks(const EditTree& tree)
{
    std::vector<double> end(tree.pieces().size(), 0.0), length(tree.axisCount(), 0.0);
    for (Index a = 0; a < tree.axisCount(); ++a)
        for (Index i = tree.isGone(a) ? noIndex : tree.axis(a).first; i != noIndex; i = tree.piece(i).next)
            end[i] = length[a] += tree.length(i);
    std::vector<double> shares(tree.axisCount(), 0.0);
    for (Index a = 0; a < tree.axisCount(); ++a)
        if (const Index below = tree.piece(tree.axis(a).first).parent; below != noIndex && !tree.isGone(a)) {
            const double whole = length[tree.piece(below).axis];
            shares[a] = whole > 0.0 ? end[below] / whole : 0.0;
        }
    return shares;
}

/// The limbs that have died, without those on other dead ones.
std::vector<Index> deadLimbs(const EditTree& tree, const TreeEdit& edit, const std::vector<bool>& axes)
{
    const DeadWoodParams& dead = edit.values->step.deadWood;
    const std::vector<double> shares = sharesOfForks(tree);
    std::vector<Index> limbs;
    EditMarks marks(tree.pieces().size(), false);
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after) {
        const EditPiece& piece = tree.piece(i);
        marks[i] = piece.parent != noIndex && marks[piece.parent];
        const bool starts = tree.axis(piece.axis).first == i;
        if (!starts || marks[i] || !axes[piece.axis] || piece.loose)
            continue;
        const double weight = 1.0 + dead.low * (1.0 - 2.0 * shares[piece.axis]);
        marks[i] = chanceOf(tree, edit, piece.axis).unit() < dead.share * weight;
        if (marks[i])
            limbs.push_back(piece.axis);
    }
    return limbs;
}

/// Where an axis breaks, as a share of its length.
double brokenAt(double length, Random& chance)
{
    constexpr double spread = 0.35; // to either side
    const double free = std::min(spread, std::min(length, 1.0 - length));
    return length + chance.range(-free, free);
}

} // namespace

Expected<void> deadWood(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const auto axes = axesMeant(tree, edit, target);
    RAMURE_TRY(axes);
    const DeadWoodParams& dead = edit.values->step.deadWood;
    const std::vector<Index> limbs = deadLimbs(tree, edit, *axes);
    std::vector<Index> feet, starts; // of limbs, of what is gone
    std::vector<AxisSpot> breaks;
    for (const Index limb : limbs) {
        feet.push_back(tree.axis(limb).first);
        Random chance = chanceOf(tree, edit, limb);
        chance.next(); // which has let it die
        if (const double share = brokenAt(dead.length, chance); share < 1.0)
            breaks.push_back(tree.spotOn(limb, share));
    }
    for (const Index below : tree.splitAt(breaks))
        if (const Index above = tree.piece(below).next; above != noIndex) {
            starts.push_back(above);
            tree.piece(below).sawn = true;
        }
    const EditMarks all = tree.markedFrom(feet);
    tree.setBare(all);
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after) {
        const EditPiece& piece = tree.piece(i);
        const bool isTwig =
            all[i] && tree.axis(piece.axis).first == i && piece.parent != noIndex && all[piece.parent];
        if (isTwig && chanceOf(tree, edit, piece.axis).unit() < dead.twigs)
            starts.push_back(i);
    }
    const EditMarks gone = tree.markedFrom(starts);
    if (std::ranges::count(gone, true) >= static_cast<std::ptrdiff_t>(tree.size()))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("nothing of the tree would be left"));
    tree.remove(gone);
    return {};
}

} // namespace ramure::edits
