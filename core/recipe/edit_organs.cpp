// What puts leaves, fruit and flowers where the hand wants them.
#include "core/recipe/edit_operations.h"

#include "core/math/reproducible.h"
#include <glm/geometric.hpp>

namespace ramure::edits {

Expected<void> place(EditTree& tree, const TreeEdit& edit, Index target, Index /*other*/)
{
    const AxisSpot spot = forkSpot(tree, target, edit.at);
    const EditPiece& piece = tree.piece(spot.piece);
    const double length = tree.length(spot.piece);
    if (length == 0.0)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the axis has no length"));
    const Frame frame = tree.frameAfter(spot.piece);
    const auto [sine, cosine] = maths::sincos(edit.azimuthRad);
    Organ organ;
    organ.branch = spot.piece;
    organ.kind = edit.organ == EditOrgan::Leaf ? OrganKind::Leaf : OrganKind::Fruit;
    organ.share = spot.t;
    organ.axis = (piece.p1 - piece.p0) / length;
    organ.up = cosine * frame.normal + sine * frame.binormal;
    organ.size = -edit.factor;
    tree.putOrgan(organ);
    return {};
}

} // namespace ramure::edits
