#include "widgets/view/render/mesh_copies.h"

#include "core/surface/foliage/foliage_texture.h"
#include <algorithm>
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

std::uint32_t packed(const glm::u8vec3& colour)
{
    return colour.r | std::uint32_t(colour.g) << 8 | std::uint32_t(colour.b) << 16;
}

/// Appends a mesh, split so that a colour belongs to a vertex: the number of a triangle among all copies need
/// not be known.
void append(MeshCopies& made, const TriangleMesh& mesh)
{
    const bool coloured = mesh.colours.size() == mesh.triangles.size();
    TriangleMesh& shape = made.shape;
    const bool hasTexture = !mesh.uv.empty(), isSplit = !mesh.uvTriangles.empty();
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
            made.colours.emplace_back(colour, 255);
        }
    }
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

MeshCopies leafCopies(const Foliage& foliage, double alpha, FoliageModel model,
                      const std::vector<bool>& shown)
{
    MeshCopies made;
    made.copies = spread(foliage.leaves, shown);
    TriangleMesh leaf = oneLeaf(foliage.form, alpha, model);
    if (model == FoliageModel::Fine && leaf.uv.empty()) // those of plants have their own
        addLeafTexture(leaf, foliage.form);
    append(made, leaf);
    made.faces = made.lightFaces = made.shape.faceCount();
    if (foliage.form.shape == LeafShape::Faithful || model == FoliageModel::Rough)
        return made;
    LeafForm simple = foliage.form;
    simple.detail = 1;
    append(made, oneLeaf(simple, alpha, model));
    made.lightFaces = made.shape.faceCount() - made.faces;
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
    made.faces = made.lightFaces = made.shape.faceCount();
    return made;
}

} // namespace ramure
