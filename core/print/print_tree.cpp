#include "core/print/print_tree.h"

#include "core/math/reproducible.h"
#include "core/params/source_facts.h"
#include "core/print/leaf_sheets.h"
#include "core/print/print_skeleton.h"
#include "core/print/thinned_mesh.h"
#include "core/print/united_surface.h"
#include "core/surface/check/self_intersections.h"
#include "core/surface/mesh/normals.h"
#include "core/surface/mesher/build_branch_mesh.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace ramure {
namespace {

constexpr int sides = 16; ///< of the tubes that are united; the grid is coarser than their faces
constexpr int discSides = 96;
constexpr double voxelsAcross = 6.0, leastVoxelsAcross = 3.5; ///< of the thinnest twig
constexpr double mostVoxels = 0.8e6;     ///< on the surface: more than twice as many triangles
constexpr double mostLeafVoxels = 0.2e6; ///< of these on leaves
constexpr int mostHeightRounds = 4;
constexpr double heightSlack = 0.002;
constexpr int mostThinnings = 2; ///< after the second, crossings are the grid's own
constexpr int mostUnions = 3;

/// Flat sides lie inside of the tube that they stand for, and so do those of the grid.
double widening(double thinnest, double voxel)
{
    const double inner = maths::cos(std::numbers::pi / sides);
    return 1.02 * thinnest / inner + 0.7 * voxel * voxel / thinnest;
}

double areaOf(const TriangleMesh& mesh)
{
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

/// A closed cylinder about the vertical.
void addCylinder(TriangleMesh& mesh, const glm::dvec3& middle, double radius, double low, double high)
{
    const Index first = mesh.vertexCount();
    for (const double y : {low, high})
        for (int k = 0; k < discSides; ++k) {
            const auto at = maths::sincos(2.0 * std::numbers::pi * k / discSides);
            mesh.positions.emplace_back(middle.x + radius * at.cos, y, middle.z + radius * at.sin);
        }
    mesh.positions.emplace_back(middle.x, low, middle.z);
    mesh.positions.emplace_back(middle.x, high, middle.z);
    const Index bottom = first + 2 * discSides, top = bottom + 1;
    for (Index k = 0; k < discSides; ++k) {
        const Index a = first + k, b = first + (k + 1) % discSides;
        mesh.triangles.emplace_back(a, b, bottom);
        mesh.triangles.emplace_back(b + discSides, a + discSides, top);
        mesh.triangles.emplace_back(a, b + discSides, b);
        mesh.triangles.emplace_back(a, a + discSides, b + discSides);
    }
}

/// A sheet without area: it becomes a ball.
void addBead(TriangleMesh& sheets, const glm::vec3& at)
{
    const Index first = sheets.vertexCount();
    sheets.positions.insert(sheets.positions.end(), 3, at);
    sheets.triangles.emplace_back(first, first + 1, first + 2);
}

/// Where a tube turns sharply it is pinched: a bead as thick as the twig goes there.
Expected<void> addBeads(TriangleMesh& sheets, const TriangleMesh& tubes, double thinnest,
                        const Progress& progress)
{
    constexpr double pinched = 0.96;
    const double below = pinched * thinnest * maths::cos(std::numbers::pi / sides);
    const auto places = thinPlaces(std::make_shared<const TriangleMesh>(tubes), below, 0.25 * thinnest,
                                   Progress{progress.stop, {}});
    RAMURE_TRY(places);
    for (const glm::dvec3& at : *places)
        addBead(sheets, glm::vec3(at));
    return {};
}

/// Mass over a point of the ground, as far as the skeleton knows it.
glm::dvec2 balanceOf(const Skeleton& skeleton)
{
    glm::dvec2 moment(0.0);
    double mass = 0.0;
    for (Index i = 0; i < skeleton.size(); ++i) {
        const double radius = 0.5 * (skeleton.a0[i] + skeleton.a1[i]);
        const double own = radius * radius * skeleton.length(i);
        const glm::dvec3 middle = 0.5 * (skeleton.p0[i] + skeleton.p1[i]);
        moment += own * glm::dvec2(middle.x, middle.z);
        mass += own;
    }
    return mass > 0.0 ? moment / mass : moment;
}

/// What the tree stands on: a disc under all roots and the weight, or, cut flat, the foot of each root.
void addFoot(TriangleMesh& mesh, const Skeleton& skeleton, const PrintOptions& options)
{
    const double thickness = std::max(0.002, 1.2 * options.smallestDiameter());
    double radius = 0.0;
    for (Index i = 0; i < skeleton.size(); ++i) {
        if (skeleton.parent[i] != noIndex)
            continue;
        const glm::dvec3& foot = skeleton.p0[i];
        radius = std::max(radius, glm::length(glm::dvec2(foot.x, foot.z)) + 2.0 * skeleton.a0[i]);
        if (!options.hasFootDisc)
            addCylinder(mesh, foot, skeleton.a0[i], -thickness, foot.y + 0.3 * skeleton.a0[i]);
    }
    if (!options.hasFootDisc)
        return;
    radius = std::max({radius, 0.12 * options.height, 1.4 * glm::length(balanceOf(skeleton))});
    addCylinder(mesh, glm::dvec3(0.0), radius, -thickness, thickness);
}

Expected<TriangleMesh> tubesOf(const Skeleton& skeleton, const NodeParams& params, const Progress& progress)
{
    BranchMeshOptions options{params.sections, params.mesh, false};
    options.targetTriangles = 0;
    options.roots = 0;             // it stands on a foot of its own
    options.clampOvershoot = true; // where a curve runs back into itself, its tube is pinched
    options.radialDivisions = sides;
    options.lengthDivisions = std::max<std::int64_t>(options.lengthDivisions, 4);
    auto made = buildBranchMesh(skeleton, options, progress);
    RAMURE_TRY(made);
    return std::move(made->mesh);
}

/// What is printed, and the foliage that it carries, if any.
struct Source
{
    const Skeleton& tree;
    const NodeParams& params;
    const PrintOptions& options;
    const Foliage* foliage;
};

struct Prepared
{
    PrintSkeleton print;
    TriangleMesh tubes;
    LeafSheets leaves;
};

double topOf(const TriangleMesh& mesh)
{
    double top = 0.0;
    for (const glm::vec3& p : mesh.positions)
        top = std::max(top, double(p.y));
    return top;
}

/// The mesh may rise above the skeleton's ends, and leaves do: the scale follows until the top is where it is
/// wanted. \param thinnest m, of the tubes and the shells.
Expected<Prepared> prepared(const Source& of, double thinnest, double& wanted, const Progress& progress)
{
    const double height = of.options.height, coarsest = of.options.smallestDiameter() / leastVoxelsAcross;
    for (int round = 1;; ++round) {
        auto print = printSkeleton(of.tree, wanted, thinnest);
        RAMURE_TRY(print);
        auto tubes = tubesOf(print->skeleton, of.params, Progress{progress.stop, {}});
        RAMURE_TRY(tubes);
        progress.report(double(round) / mostHeightRounds);
        LeafSheets leaves;
        if (of.foliage)
            leaves = leafSheets(*of.foliage, of.tree, *print, trunkRadius(of.params),
                                {thinnest, mostLeafVoxels * coarsest * coarsest});
        const double leafTop = leaves.mesh.empty() ? 0.0 : topOf(leaves.mesh) + 0.5 * thinnest;
        const double off = std::max(topOf(*tubes), leafTop) / height - 1.0;
        if (std::abs(off) < heightSlack || round == mostHeightRounds)
            return Prepared{std::move(*print), std::move(*tubes), std::move(leaves)};
        wanted = std::clamp(wanted / (1.0 + off), 0.5 * height, 2.0 * height);
    }
}

using Places = std::vector<glm::vec3>;

/// Marks the vertices near what runs through each other. \returns where that is
Expected<Places> markCrossings(std::vector<bool>& isKept, const TriangleMesh& fine, const TriangleMesh& thin,
                               double reach, const Progress& progress)
{
    const auto crossings = findSelfIntersections(thin, {}, 0, Progress{progress.stop, {}});
    RAMURE_TRY(crossings);
    Places places;
    std::vector<std::pair<glm::vec3, glm::vec3>> boxes;
    for (const FacePair& pair : crossings->pairs)
        for (const Index face : {pair.first, pair.second}) {
            const glm::uvec3& t = thin.triangles[face];
            const glm::vec3 &a = thin.positions[t.x], &b = thin.positions[t.y], &c = thin.positions[t.z];
            const auto margin = static_cast<float>(reach);
            boxes.emplace_back(glm::min(a, glm::min(b, c)) - margin, glm::max(a, glm::max(b, c)) + margin);
            places.push_back((a + b + c) / 3.0F);
        }
    isKept.resize(fine.positions.size(), false);
    for (std::size_t v = 0; v < fine.positions.size(); ++v)
        for (const auto& [low, high] : boxes)
            if (glm::all(glm::lessThanEqual(low, fine.positions[v])) &&
                glm::all(glm::lessThanEqual(fine.positions[v], high))) {
                isKept[v] = true;
                break;
            }
    return places;
}

/// Thins a mesh until nothing runs through itself: where something would, all vertices around stay.
/// \param crossings what is left of them in the end, where that does not help
Expected<TriangleMesh> thinnedApart(const TriangleMesh& fine, ThinningOptions options, Places& crossings,
                                    const Progress& progress)
{
    double reach = 4.0 * options.grain;
    for (int round = 0; round < mostThinnings; ++round, reach *= 2.0) {
        auto thin = thinnedMesh(fine, options,
                                progress.part(double(round) / mostThinnings, (round + 1.0) / mostThinnings));
        if (!thin)
            return thin;
        auto found = markCrossings(options.isKept, fine, *thin, reach, progress);
        RAMURE_TRY(found);
        crossings = std::move(*found);
        if (crossings.empty())
            return thin;
    }
    return fail(ErrorCode::Invalid,
                RAMURE_NOOP("the branches could not be united into one surface: try another height"));
}

/// Fewer triangles, none of which run through each other. What costs nothing goes first, most of all there
/// is; the rest is quick, however often it has to be done.
Expected<TriangleMesh> thinnedWithoutCrossings(const TriangleMesh& fine, const ThinningOptions& options,
                                               Places& crossings, const Progress& progress)
{
    ThinningOptions lossless = options;
    lossless.mostTriangles = 0;
    auto light = thinnedApart(fine, lossless, crossings, progress.part(0.0, 0.7));
    if (!light || light->triangles.size() <= options.mostTriangles)
        return light;
    ThinningOptions rest = options;
    rest.isThin = true;
    return thinnedApart(*light, rest, crossings, progress.part(0.7, 1.0));
}

struct Joined
{
    TriangleMesh mesh;
    Index loose = 0;
};

/// One surface of all, thinned out. A grid may see two surfaces cross where they nearly touch: a bead joins
/// them there, and all is done again.
Expected<Joined> joined(const TriangleMesh& tubes, UnionOptions joining, const ThinningOptions& thinning,
                        const Progress& progress)
{
    for (int attempt = 1;; ++attempt) {
        auto united = unitedSurface(tubes, joining, progress.part(0.0, 0.45));
        RAMURE_TRY(united);
        Places crossings;
        auto thin = thinnedWithoutCrossings(united->mesh, thinning, crossings, progress.part(0.45, 1.0));
        if (thin)
            return Joined{std::move(*thin), united->loose};
        if (crossings.empty() || attempt == mostUnions)
            return fail(std::move(thin.error()));
        for (const glm::vec3& at : crossings)
            addBead(joining.sheets, at);
    }
}

} // namespace

Expected<PrintedTree> printTree(const Skeleton& tree, const NodeParams& params, const PrintOptions& options,
                                const Progress& progress, const Foliage* foliage)
{
    RAMURE_TRY(checkPrint(options));
    const double diameter = options.smallestDiameter(), finest = diameter / voxelsAcross;
    const Source source{tree, params, options, options.leaves == PrintLeaves::Off ? nullptr : foliage};
    double wanted = options.height;
    auto ready = prepared(source, widening(diameter, finest), wanted, progress.part(0.0, 0.05));
    RAMURE_TRY(ready);
    const double voxel =
        std::clamp(std::sqrt((areaOf(ready->tubes) + 2.5 * areaOf(ready->leaves.mesh)) / mostVoxels), finest,
                   diameter / leastVoxelsAcross);
    const double thinnest = widening(diameter, voxel); // a coarser grid takes more of a twig
    if (voxel > finest)
        ready = prepared(source, thinnest, wanted, progress.part(0.05, 0.1));
    RAMURE_TRY(ready);
    UnionOptions joining{voxel, true};
    joining.notches = notchBalls(ready->print.skeleton);
    joining.sheets = std::move(ready->leaves.mesh);
    joining.thickness = thinnest;
    RAMURE_TRY(addBeads(joining.sheets, ready->tubes, thinnest, progress));
    addFoot(ready->tubes, ready->print.skeleton, options);
    ThinningOptions thinning;
    thinning.grain = voxel;
    thinning.mostTriangles = options.mostTriangles;
    if (params.mesh.targetTriangles > 0)
        thinning.mostTriangles =
            static_cast<Index>(std::min<std::int64_t>(thinning.mostTriangles, params.mesh.targetTriangles));
    auto made = joined(ready->tubes, std::move(joining), thinning, progress.part(0.1, 0.85));
    RAMURE_TRY(made);
    computeNormals(made->mesh);
    PrintedTree out;
    out.mesh = std::make_shared<const TriangleMesh>(std::move(made->mesh));
    out.scale = ready->print.scale;
    out.thickened = ready->print.thickened;
    out.cut = ready->print.cut;
    out.loose = made->loose;
    out.leaves = ready->leaves.leaves;
    out.leavesLeftOut = ready->leaves.leftOut;
    auto report = printReport(out.mesh, 0.5 * diameter, progress.part(0.85, 1.0));
    RAMURE_TRY(report);
    out.report = *report;
    return out;
}

} // namespace ramure
