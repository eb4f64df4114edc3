// Modifiers of radii.
#include "core/recipe/edit_operations.h"

#include "core/math/reproducible.h"
#include "core/params/node_params.h"
#include <algorithm>

namespace ramure::edits {
namespace {

/// By piece: metres of wood that stand on its start and on its end, and the foot below. What a branch
/// carries, leaves above all, goes by the length of its twigs (Shinozaki et al. 1964): so radii get smaller
/// along an axis, too.
struct Pipes
{
    std::vector<double> start, end;
    std::vector<Index> foot;
};

constexpr double tipLength = 0.02; ///< m of wood that a tip counts for

Pipes pipesOf(const EditTree& tree)
{
    const std::size_t count = tree.pieces().size();
    Pipes pipes{std::vector<double>(count, 0.0), std::vector<double>(count, 0.0),
                std::vector<Index>(count, noIndex)};
    std::vector<Index> order;
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after) {
        const Index parent = tree.piece(i).parent;
        pipes.foot[i] = parent == noIndex ? i : pipes.foot[parent];
        order.push_back(i);
    }
    for (std::size_t k = order.size(); k-- > 0;) {
        const Index i = order[k];
        pipes.end[i] = std::max(pipes.end[i], tipLength);
        pipes.start[i] = pipes.end[i] + tree.length(i);
        if (const Index parent = tree.piece(i).parent; parent != noIndex)
            pipes.end[parent] += pipes.start[i];
    }
    return pipes;
}

} // namespace

Expected<void> pipe(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const auto axes = axesMeant(tree, edit, target);
    RAMURE_TRY(axes);
    const PipeParams& pipe = edit.values->step.pipe;
    const Pipes pipes = pipesOf(tree);
    const auto rule = [&](double carried) { return maths::pow(carried, 1.0 / pipe.exponent); };
    std::vector<double> unit(tree.pieces().size(), pipe.tip / rule(tipLength)); // m, by foot
    for (Index i = tree.firstPiece(); i != noIndex && pipe.keepsFoot; i = tree.piece(i).after)
        if (pipes.foot[i] == i)
            unit[i] = tree.piece(i).a0 / rule(pipes.start[i]);
    for (Index i = tree.firstPiece(); i != noIndex; i = tree.piece(i).after) {
        EditPiece& piece = tree.piece(i);
        if (!(*axes)[piece.axis])
            continue;
        const double one = unit[pipes.foot[i]];
        piece.a0 += pipe.blend * (one * rule(pipes.start[i]) - piece.a0);
        piece.a1 += pipe.blend * (one * rule(pipes.end[i]) - piece.a1);
    }
    return {};
}

Expected<void> flare(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const auto axes = axesMeant(tree, edit, target);
    RAMURE_TRY(axes);
    const FlareParams& flare = edit.values->step.flare;
    constexpr int steps = 8;
    constexpr double reach = 3.0; // heights: a twentieth of the swelling is left there
    bool any = false;
    for (Index a = 0; a < axes->size(); ++a) {
        const Index first = tree.axis(a).first;
        if (!(*axes)[a] || tree.piece(first).parent != noIndex || tree.piece(first).loose)
            continue;
        const double whole = tree.axisLength(a);
        std::vector<AxisSpot> spots;
        for (int k = 1; k <= steps && whole > 0.0; ++k)
            if (const double s = reach * flare.height * k / steps; s < 0.98 * whole)
                spots.push_back(tree.spotOn(a, s / whole));
        tree.splitAt(spots);
        const auto swell = [&](double s) {
            return s > reach * flare.height ? 1.0 : 1.0 + flare.amount * maths::exp(-s / flare.height);
        };
        double s = 0.0;
        for (Index i = first; i != noIndex; i = tree.piece(i).next) {
            tree.piece(i).a0 *= swell(s);
            s += tree.length(i);
            tree.piece(i).a1 *= swell(s);
        }
        any = true;
    }
    return any ? Expected<void>()
               : fail(ErrorCode::Invalid, RAMURE_NOOP("only an axis on the ground has a root"));
}

} // namespace ramure::edits
