#include "widgets/view/render/crowd/mesh_copies.h"

#include "core/math/box.h"
#include "core/surface/foliage/foliage_texture.h"
#include "core/surface/foliage/place_foliage.h"
#include "widgets/view/render/crowd/far_shape.h"
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

namespace ramure {
namespace {

/// Steps of the golden section visit a row evenly from the first on; one that shares no divisor with the
/// row's length visits all of it.
std::size_t evenStep(std::size_t count)
{
    auto step = std::max<std::size_t>(1, static_cast<std::size_t>(double(count) * 0.6180339887498949));
    while (std::gcd(step, count) != 1)
        ++step;
    return step;
}

double radiusOf(const TriangleMesh& mesh)
{
    Box box;
    for (const glm::vec3& position : mesh.positions)
        box.add(glm::dvec3(position));
    return box.radius();
}

std::uint32_t packed(const glm::u8vec3& colour)
{
    return colour.r | std::uint32_t(colour.g) << 8 | std::uint32_t(colour.b) << 16;
}

/// Appends a mesh, split so that a colour belongs to a vertex: the number of a triangle among all copies need
/// not be known.
void append(MeshCopies& made, const TriangleMesh& mesh, LeafDetail coarsest = LeafDetail::All)
{
    const Index from = made.shape.faceCount();
    const bool coloured = mesh.colours.size() == mesh.triangles.size();
    TriangleMesh& shape = made.shape;
    const bool hasTexture = !mesh.uv.empty(), isSplit = !mesh.uvTriangles.empty();
    const bool isWood = mesh.radius.size() == mesh.positions.size();
    std::map<std::tuple<Index, Index, std::uint32_t>, Index> places; // vertex, coordinate, colour
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const glm::u8vec3 colour = coloured ? mesh.colours[f] : glm::u8vec3(255);
        glm::uvec3& triangle = shape.triangles.emplace_back();
        for (int corner = 0; corner < 3; ++corner) {
            const Index vertex = mesh.triangles[f][corner];
            const Index at = isSplit ? mesh.uvTriangles[f][corner] : vertex;
            const auto [place, isNew] = places.try_emplace({vertex, at, packed(colour)}, shape.vertexCount());
            triangle[corner] = place->second;
            if (!isNew)
                continue;
            shape.positions.push_back(mesh.positions[vertex]);
            shape.normals.push_back(mesh.normals[vertex]);
            if (hasTexture)
                shape.uv.push_back(mesh.uv[at]);
            if (isWood)
                shape.radius.push_back(mesh.radius[vertex]);
            made.colours.emplace_back(colour, 255);
        }
    }
    // A coarser one takes the place of all that are coarser still.
    for (std::size_t how = 0; how <= std::size_t(coarsest); ++how)
        made.detail[how] = {from, shape.faceCount() - from};
}

/// The coarsest of a shape: its mean colour, and texture coordinates of what lies nearest.
void appendFar(MeshCopies& made)
{
    TriangleMesh& shape = made.shape;
    const MeshCopies::Faces few = made.faces(LeafDetail::Few);
    TriangleMesh near;
    near.positions = shape.positions;
    near.triangles.assign(shape.triangles.begin() + few.from, shape.triangles.begin() + few.from + few.count);
    const TriangleMesh far = farShape(near);
    if (far.empty() || far.faceCount() >= few.count)
        return;
    glm::vec3 colour(0.0f);
    float area = 0.0f;
    for (const glm::uvec3& face : near.triangles) {
        const glm::vec3 a = near.positions[face[0]], b = near.positions[face[1]], c = near.positions[face[2]];
        const float share = glm::length(glm::cross(b - a, c - a));
        area += share;
        for (int corner = 0; corner < 3; ++corner)
            colour += share * glm::vec3(made.colours[face[corner]]) / 3.0f;
    }
    colour /= area; // of which a far shape has some
    const Index first = shape.vertexCount();
    for (std::size_t v = 0; v < far.positions.size(); ++v) {
        const glm::vec3 at = far.positions[v];
        const auto away = [&](const glm::uvec3& face) { return glm::distance(at, near.positions[face[0]]); };
        const glm::uvec3 nearest = *std::ranges::min_element(near.triangles, {}, away);
        shape.positions.push_back(at);
        shape.normals.push_back(far.normals[v]);
        if (!shape.uv.empty())
            shape.uv.push_back(glm::vec2(shape.uv[nearest[0]]));
        made.colours.emplace_back(glm::u8vec3(colour + 0.5f), 255);
    }
    made.detail[std::size_t(LeafDetail::Least)] = {shape.faceCount(), far.faceCount()};
    for (const glm::uvec3& face : far.triangles)
        shape.triangles.push_back(face + first);
}

void measure(MeshCopies& made)
{
    float largest = 0.0f;
    for (const MeshCopy& copy : made.copies)
        largest = std::max(largest, copy.size);
    made.reach = largest * float(2.0 * radiusOf(made.shape));
}

/// How much longer a shoot is than one of its leaves.
float shootOverLeaf(const LeafForm& form, double alpha)
{
    LeafForm single = form;
    single.perShoot = 1;
    return float(radiusOf(oneLeaf(form, alpha, FoliageModel::Fine)) /
                 radiusOf(oneLeaf(single, alpha, FoliageModel::Fine)));
}

std::vector<MeshCopy> spread(const std::vector<FoliageItem>& items, const std::vector<bool>& shown)
{
    std::vector<const FoliageItem*> kept;
    kept.reserve(items.size());
    for (const FoliageItem& item : items)
        if (shown.empty() || (item.branch < shown.size() && shown[item.branch]))
            kept.push_back(&item);
    std::vector<MeshCopy> copies(kept.size());
    const std::size_t step = evenStep(std::max<std::size_t>(1, kept.size()));
    for (std::size_t i = 0, piece = 0; i < copies.size(); ++i, piece = (piece + step) % copies.size()) {
        const FoliageItem& item = *kept[piece];
        const glm::quat turn(item.orientation);
        const glm::u8vec3 tone(glm::clamp(item.tone * item.tint, 0.0f, 1.0f) * 255.0f + 0.5f);
        copies[i] = {glm::vec3(item.position), item.size, glm::vec4(turn.x, turn.y, turn.z, turn.w),
                     item.branch, glm::u8vec4(tone, 255)};
    }
    return copies;
}

} // namespace

std::size_t MeshCopies::pieceOf(std::size_t copy) const
{
    return copy * evenStep(copies.size()) % copies.size();
}

Box boxAround(const std::vector<FoliageItem>& items, const TriangleMesh& one)
{
    float reach = 0.0F;
    for (const glm::vec3& corner : one.positions)
        reach = std::max(reach, glm::length(corner));
    glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
    for (const FoliageItem& item : items) {
        const glm::vec3 centre(item.position);
        const float far = 1.001F * item.size * reach;
        if (glm::all(glm::greaterThan(centre - far, low)) && glm::all(glm::lessThan(centre + far, high)))
            continue; // within
        const glm::mat3 turn(glm::mat3_cast(item.orientation));
        for (const glm::vec3& corner : one.positions) {
            const glm::vec3 p = centre + turn * (item.size * corner);
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    }
    return items.empty() || one.positions.empty() ? Box() : Box{glm::dvec3(low), glm::dvec3(high)};
}

MeshCopies leafCopies(const Foliage& foliage, double alpha, FoliageModel model,
                      const std::vector<bool>& shown)
{
    MeshCopies made;
    made.copies = spread(foliage.leaves, shown);
    TriangleMesh leaf = oneLeaf(foliage.form, alpha, model);
    if (model == FoliageModel::Fine && leaf.uv.empty()) // those of plants have their own
        addLeafTexture(leaf, foliage.form);
    append(made, leaf);
    if (foliage.form.shape != LeafShape::Faithful && model != FoliageModel::Rough) {
        LeafForm simple = foliage.form;
        simple.detail = 1;
        const TriangleMesh few = oneLeaf(simple, alpha, model);
        append(made, simple.perShoot > 1 ? few : widened(few, leaf), LeafDetail::Few);
        if (simple.perShoot > 1) // one for each leaf: a shoot is no leaf from any distance
            append(made, oneLeaf(simple, alpha, FoliageModel::Rhomb), LeafDetail::Least);
        else
            appendFar(made);
    }
    measure(made);
    if (foliage.form.perShoot > 1) // what is seen of a shoot are its leaves
        made.reach /= shootOverLeaf(foliage.form, alpha);
    return made;
}

MeshCopies shapeOf(const TriangleMesh& mesh)
{
    MeshCopies made;
    append(made, mesh);
    return made;
}

MeshCopies appleCopies(const Foliage& foliage, double alpha, FoliageModel model,
                       const std::vector<bool>& shown)
{
    MeshCopies made;
    made.copies = spread(foliage.apples, shown);
    TriangleMesh apple = oneApple(foliage.fruit, alpha, model);
    if (model == FoliageModel::Fine)
        addAppleTexture(apple, foliage.fruit);
    append(made, apple);
    appendFar(made);
    measure(made);
    return made;
}

} // namespace ramure
