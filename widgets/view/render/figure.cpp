#include "widgets/view/render/figure.h"

#include "core/math/angle.h"
#include "core/surface/mesh/normals.h"
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace ramure {
namespace {

/// A part of the body: two spheres and what lies between them. m.
struct Part
{
    glm::dvec3 from, to;
    double fromRadius, toRadius;
};

// Of the left and the middle; parts beside the middle have a mirror image. Shares of the height are those
// that artists draw by: the head is an eighth, the hips lie at a half.
constexpr std::array parts{
    Part{{0.0, 1.665, 0.02}, {0.0, 1.71, 0.01}, 0.080, 0.090},    // head
    Part{{0.0, 1.50, -0.01}, {0.0, 1.60, 0.01}, 0.055, 0.050},    // neck
    Part{{0.0, 1.28, 0.0}, {0.0, 1.42, -0.01}, 0.135, 0.115},     // chest
    Part{{0.0, 0.98, 0.0}, {0.0, 1.25, 0.0}, 0.130, 0.120},       // waist
    Part{{0.08, 1.40, -0.01}, {0.19, 1.41, -0.02}, 0.080, 0.060}, // shoulder
    Part{{0.20, 1.40, -0.02}, {0.25, 1.12, -0.03}, 0.052, 0.042}, // upper arm
    Part{{0.25, 1.12, -0.03}, {0.27, 0.87, 0.04}, 0.042, 0.030},  // forearm
    Part{{0.27, 0.85, 0.04}, {0.27, 0.76, 0.06}, 0.035, 0.028},   // hand
    Part{{0.09, 0.93, 0.0}, {0.10, 0.52, 0.01}, 0.095, 0.060},    // thigh
    Part{{0.10, 0.52, 0.01}, {0.11, 0.12, -0.02}, 0.058, 0.040},  // shin
    Part{{0.11, 0.040, -0.03}, {0.12, 0.030, 0.15}, 0.045, 0.035} // foot
};
constexpr glm::u8vec3 figureColour{118, 122, 128};
constexpr int sides = 14, capRings = 4;

void addPart(TriangleMesh& mesh, const Part& part)
{
    const glm::dvec3 way = glm::normalize(part.to - part.from);
    const glm::dvec3 other = std::abs(way.y) < 0.8 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 x = glm::normalize(glm::cross(other, way)), z = glm::cross(x, way);
    const auto first = static_cast<Index>(mesh.positions.size());
    for (int ring = 0; ring < 2 * capRings; ++ring) { // half a sphere at each end
        const bool lower = ring < capRings;
        const double angle = lower ? -0.5 * pi + 0.5 * pi * (ring + 0.5) / (capRings - 0.5)
                                   : 0.5 * pi * (ring - capRings) / (capRings - 0.5);
        const double radius = lower ? part.fromRadius : part.toRadius;
        const glm::dvec3 centre = (lower ? part.from : part.to) + radius * std::sin(angle) * way;
        for (int k = 0; k < sides; ++k) {
            const double around = 2.0 * pi * k / sides;
            mesh.positions.emplace_back(centre + radius * std::cos(angle) *
                                                     (std::cos(around) * x + std::sin(around) * z));
        }
    }
    for (Index ring = 0; ring + 1 < 2 * capRings; ++ring)
        for (Index k = 0; k < sides; ++k) {
            const Index a = first + ring * sides + k, b = first + ring * sides + (k + 1) % sides;
            mesh.triangles.emplace_back(a, a + sides, b);
            mesh.triangles.emplace_back(b, a + sides, b + sides);
        }
    for (const bool lower : {true, false}) { // the small holes at the poles
        const Index ring = lower ? first : first + (2 * capRings - 1) * sides;
        for (Index k = 1; k + 1 < sides; ++k) {
            const Index a = ring + k, b = ring + k + 1;
            mesh.triangles.emplace_back(ring, lower ? a : b, lower ? b : a);
        }
    }
}

} // namespace

TriangleMesh figureMesh()
{
    TriangleMesh mesh;
    for (const Part& part : parts) {
        addPart(mesh, part);
        if (part.from.x == 0.0)
            continue;
        Part mirrored = part;
        mirrored.from.x = -part.from.x;
        mirrored.to.x = -part.to.x;
        addPart(mesh, mirrored);
    }
    for (glm::vec3& p : mesh.positions)
        p.y = std::max(p.y, 0.0F); // soles are flat
    computeNormals(mesh);
    return mesh;
}

void addFigure(RenderScene& scene, const std::optional<FigureTree>& tree)
{
    static const auto mesh = std::make_shared<const TriangleMesh>(figureMesh());
    static const Box box = meshBox(*mesh);
    constexpr double step = 0.9; // m
    glm::dvec3 place(0.0);
    if (tree) {
        const double scale = glm::length(glm::dvec3(tree->world[0]));
        place = glm::dvec3(tree->world * glm::dvec4(tree->foot, 1.0));
        place.x += scale * tree->radius + step;
        if (tree->ground) {
            const glm::dvec3 own(glm::inverse(tree->world) * glm::dvec4(place, 1.0));
            place.y -= scale * tree->ground->above(own);
        }
    } else if (!scene.box.empty()) {
        place = 0.5 * (scene.box.min + scene.box.max);
        place.x += 0.5 * (scene.box.max.x - scene.box.min.x) + step;
        place.y = scene.box.min.y;
    } else {
        place.x = step;
    }
    MeshItem item;
    item.mesh = mesh;
    item.box = box;
    item.material.colour = figureColour;
    item.world = glm::translate(glm::dmat4(1.0), place);
    item.isMark = true;
    item.pickable = item.framed = false;
    scene.meshes.push_back(std::move(item));
}

} // namespace ramure
