#include "widgets/panels/validation/kind_texts.h"

namespace ramure {

KindText KindTexts::edges(DefectKind kind)
{
    if (kind == DefectKind::BoundaryEdge)
        return {
            tr("Boundary edges"),
            tr("An edge with a face on one side only: the surface is open there, like the rim of a cup."),
            tr("A slicer cannot tell inside from outside. It leaves the hole open or fills it as it likes."),
            tr("One looks into the branch through the hole, and light and shadow leak through it.")};
    if (kind == DefectKind::NonManifoldEdge)
        return {tr("Non-manifold edges"),
                tr("Three faces or more meet in one edge, like the pages of a book in its spine."),
                tr("No solid body has such an edge: walls go missing or come out twice."),
                tr("Smoothing, subdividing and unwrapping go wrong around it; the shading shows a seam.")};
    return {tr("Inconsistent edges"), tr("Two neighbouring faces do not agree on which side is outside."),
            tr("Inside and outside change places: parts come out hollow or missing."),
            tr("One of the two faces shows its back. Programs that do not draw back faces show a hole there, "
               "others light it from the wrong side.")};
}

KindText KindTexts::vertices(DefectKind kind)
{
    if (kind == DefectKind::NonManifoldVertex)
        return {tr("Non-manifold vertices"),
                tr("Two parts of the surface touch in a single point, like the halves of an hourglass."),
                tr("A joint without thickness: it breaks, or the parts come out separate."),
                tr("Smooth normals mix both parts and leave a dark spot; physics and level-of-detail tools "
                   "may refuse "
                   "the mesh.")};
    if (kind == DefectKind::DuplicateVertex)
        return {tr("Duplicate vertices"), tr("Two vertices stand at exactly the same place."),
                tr("The surface looks closed and yet is slit there; programs that weld points may close it "
                   "wrongly."),
                tr("The shading may show a seam, and the surface tears open when it moves.")};
    return {tr("Isolated vertices"), tr("A vertex that no face uses."),
            tr("Nothing is printed there, but some programs refuse the file."),
            tr("It takes memory and may enlarge the box around the tree, so that the view frames it badly.")};
}

KindText KindTexts::faces(DefectKind kind)
{
    if (kind == DefectKind::DuplicateFace)
        return {tr("Duplicate faces"), tr("Two faces on the same three vertices."),
                tr("A wall without thickness. Slicers drop both faces, or only one and leave a hole."),
                tr("Both lie at the same depth and flicker.")};
    return {tr("Degenerate faces"),
            tr("A face without area: a vertex repeated, or its three vertices in line."),
            tr("It faces nowhere. Slicers remove it, which may leave a crack."),
            tr("It cannot be seen, costs time and has no normal: dark specks, and normal maps fail.")};
}

KindText KindTexts::of(SkeletonRepair kind)
{
    switch (kind) {
    case SkeletonRepair::ZeroLengthContracted:
        return {tr("Branches that do not show"),
                tr("A branch without length, or with all of it inside a thicker one, was passed over: its "
                   "children start at its parent's end. Nothing that could be seen is lost."),
                {},
                {}};
    case SkeletonRepair::RootStub:
        return {tr("Roots without length"),
                tr("A root without length was given a short stub, so that the branches have something to "
                   "stand on."),
                {},
                {}};
    case SkeletonRepair::RootsJoined:
        return {tr("Stems from one place"),
                tr("Stems that start within a radius of each other stand on one plate at the ground, so that "
                   "they "
                   "are one mesh. Two meshes there would run through each other."),
                {},
                {}};
    case SkeletonRepair::SiblingsMerged:
        return {tr("Siblings in one place"),
                tr("Two branches of one parent lie in the same place, so one tube serves both. Two tubes "
                   "there would "
                   "cross each other all along."),
                {},
                {}};
    case SkeletonRepair::SiblingChained:
        return {tr("Siblings inside a longer one"),
                tr("A branch leaves one of the same parent only at its end, or beyond: it starts there."),
                {},
                {}};
    case SkeletonRepair::RadiusClamped:
        return {
            tr("Radii too small"),
            tr("The radius was below the least one (Cross-sections, Least radius), or so small against the "
               "size of the tree that the tube's points would fall together. It was raised to the smallest "
               "that works; no printer makes it that thin."),
            {},
            {}};
    }
    return {};
}

KindText KindTexts::of(PairKind kind)
{
    if (kind == PairKind::Same)
        return {tr("Crossings within a branch"),
                tr("Triangles of one branch run through each other: its surface folds over where it bends "
                   "sharply or begins at a tight fork."),
                tr("A fold of a hair's breadth inside the wood: slicers that add up walls do not notice it."),
                tr("A small crease in the shading, and a false edge for tools that cut the mesh.")};
    if (kind == PairKind::Siblings)
        return {
            tr("Crossings between siblings"),
            tr("Two branches that start at one fork run through each other behind it: they stay close for "
               "longer than they are thick."),
            tr("Both are one body there. Most slicers join them; some leave a hollow where they overlap."),
            tr("The crease between them is hard, not a valley; leaves and bark may flicker in it.")};
    if (kind == PairKind::ParentChild)
        return {tr("Crossings of parent and child"),
                tr("A branch runs back into the one that it grows on: it turns by more than a right angle."),
                tr("The overlap lies inside the wood. Most slicers join the two."),
                tr("The bark of one comes out of the other without a seam between them.")};
    return {tr("Crossings far apart"),
            tr("Triangles of branches run through each other that do not meet in any fork."),
            tr("The branches are one body where they cross."),
            tr("They go through each other, and do so when the wind moves them.")};
}

KindText KindTexts::of(FindingKind kind)
{
    if (kind == FindingKind::Collision)
        return {
            tr("Branches that collide"),
            tr("Two branches far from each other in the tree run through each other. The mesh is correct: "
               "the tree grew so. “Move apart” turns the thinner branch away, as little as possible."),
            tr("They come out as one body, joined where they cross. Slicers that do not join overlapping "
               "walls "
               "leave a hollow there."),
            tr("Up close one sees a branch go through another; in the wind both move through each other.")};
    return {tr("Thinnest triangles"),
            tr("The triangles with the smallest angles. They are no defects: every mesh has some."),
            tr("They do no harm as long as they have an area."),
            tr("Long thin triangles shade in streaks, subdivide badly and slow down computations on the "
               "surface.")};
}

KindText KindTexts::clean()
{
    return {
        tr("What this means"),
        tr("The branches are one closed skin without holes or seams: every edge has exactly two faces, and "
           "all faces look outward. No triangle runs through another."),
        tr("The mesh is a solid body; a slicer takes it as it is."),
        tr("Smooth shading, subdividing, unwrapping and physics work without repair.")};
}

KindText KindTexts::crossed()
{
    return {
        tr("What this means"),
        tr("The surface has no holes or seams, but parts of it run through each other. Each such place is "
           "listed above."),
        tr("Most slicers join overlapping parts; some leave a hollow there."),
        tr("A hard crease where they meet, and false edges for tools that cut the mesh.")};
}

KindText KindTexts::cleanSolid()
{
    return {
        tr("What this means"),
        tr("The surface is closed, without holes or seams: every edge has exactly two faces, and all faces "
           "look outward. No triangle runs through another."),
        tr("The mesh is a solid body; a slicer takes it as it is."),
        tr("Smooth shading, subdividing, unwrapping and physics work without repair.")};
}

KindText KindTexts::cleanSurface()
{
    return {
        tr("What this means"),
        tr("A terrain or a plane has an edge by its nature, so its surface is open there. Nothing else is "
           "wrong with it: no other holes or seams, and all faces look to the same side."),
        tr("It encloses nothing. Give it a thickness before it goes to a slicer."),
        tr("Smooth shading, subdividing and physics work; from below one sees its back.")};
}

KindText KindTexts::ofCrossing(PairKind kind, const MeshAnalysis& analysis)
{
    if (analysis.crossings.kindsKnown)
        return of(kind);
    return {tr("Crossings"), tr("Triangles of the mesh run through each other."),
            tr("Most slicers join overlapping parts; some leave a hollow there."),
            tr("A hard crease where they meet, and false edges for tools that cut the mesh.")};
}

QString KindTexts::rich(const KindText& text)
{
    const auto paragraph = [](const QString& label, const QString& words) {
        if (words.isEmpty())
            return QString();
        const QString head =
            label.isEmpty() ? QString() : QStringLiteral("<i>%1</i> ").arg(label.toHtmlEscaped());
        return QStringLiteral("<p>%1%2</p>").arg(head, words.toHtmlEscaped());
    };
    return QStringLiteral("<p><b>%1</b></p>").arg(text.name.toHtmlEscaped()) + paragraph({}, text.meaning) +
           paragraph(tr("In a print:"), text.print) + paragraph(tr("In a game or a renderer:"), text.game);
}

KindText KindTexts::of(DefectKind kind)
{
    switch (kind) {
    case DefectKind::BoundaryEdge:
    case DefectKind::NonManifoldEdge:
    case DefectKind::InconsistentEdge:
        return edges(kind);
    case DefectKind::NonManifoldVertex:
    case DefectKind::DuplicateVertex:
    case DefectKind::IsolatedVertex:
        return vertices(kind);
    case DefectKind::DuplicateFace:
    case DefectKind::DegenerateFace:
        break;
    }
    return faces(kind);
}

} // namespace ramure
