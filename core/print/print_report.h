/// \file
/// What is to be known about a mesh before it is printed.
#pragma once

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/surface/mesh/triangle_mesh.h"
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

namespace ramure {

/// Lengths in m, in the space of the mesh, which has Y up and stands on y = 0.
struct PrintReport
{
    glm::dvec3 low{0.0}, high{0.0}; ///< bounding box
    double volume = 0.0;            ///< m³
    double thinnest = 0.0;          ///< from one wall through the material to the other
    glm::dvec3 thinnestAt{0.0};     ///< the middle of that way
    double overhang = 0.0;          ///< m², faces that look down by more than 45°, the foot aside
    glm::dvec3 centreOfMass{0.0};
    double footArea = 0.0; ///< m², of the convex hull of what touches the ground
    double balance =
        0.0; ///< how far the centre of mass is inside of that hull's border; below 0: it falls over
    Index triangles = 0, pieces = 0;
    std::uint64_t crossings = 0; ///< pairs of triangles that run through each other
    bool isClosed = false;       ///< one closed, outward 2-manifold a piece

    [[nodiscard]] glm::dvec3 size() const { return high - low; }
    [[nodiscard]] bool standsUp() const { return balance > 0.0; }
};

/// It looks down by more than 45° and is no part of the flat foot. \pre the index is one of the mesh's
bool isOverhang(const TriangleMesh& mesh, Index face);

/// \param around m: the thickness of a place is the largest so near to it; else every sharp edge would be the
/// thinnest of all. Errors: Invalid (indices out of range), Cancelled.
Expected<PrintReport> printReport(const std::shared_ptr<const TriangleMesh>& mesh, double around,
                                  const Progress& progress = {});

/// The middles of all walls thinner than \p below, m, one at most in each cube of the side \p around.
/// Surfaces may cross. Error: Cancelled.
Expected<std::vector<glm::dvec3>> thinPlaces(const std::shared_ptr<const TriangleMesh>& mesh, double below,
                                             double around, const Progress& progress = {});

/// Corners of the convex hull, counter-clockwise; fewer than three where there is no area.
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points);

} // namespace ramure
