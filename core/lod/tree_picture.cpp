#include "core/lod/tree_picture.h"

#include "core/math/box.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ramure {
namespace {

constexpr int packedSize = 1024; ///< cards are packed for a picture of so many pixels a side

/// Calls \p take for every vertex that is seen.
template <class Take> void forEachPlace(const std::vector<ShownSurface>& surfaces, const Take& take)
{
    for (const ShownSurface& surface : surfaces) {
        for (const FoliageItem& item : surface.copies)
            for (const glm::vec3& at : surface.mesh->positions)
                take(item.position + item.orientation * (double(item.size) * glm::dvec3(at)));
        for (const glm::vec3& at : surface.mesh->positions)
            if (surface.copies.empty())
                take(glm::dvec3(at));
    }
}

/// How far leaves are from the trunk at each height.
class CrownWidths
{
public:
    CrownWidths(const std::vector<ShownSurface>& surfaces, const glm::dvec3& foot, const Box& box)
        : m_foot(foot)
        , m_low(box.min.y)
        , m_height(std::max(box.size().y, 1e-9))
    {
        for (const ShownSurface& surface : surfaces)
            for (const FoliageItem& leaf : surface.copies) {
                const glm::dvec3 away = leaf.position - foot;
                double& width = m_widths[slice(leaf.position.y)];
                width = std::max(width, glm::length(glm::dvec2(away.x, away.z)));
            }
    }
    /// Is a place so near to a card that faces \p backward that the card shows it? Where no leaves are, all
    /// is.
    [[nodiscard]] bool isNear(const glm::dvec3& place, const glm::dvec3& backward) const
    {
        const double width = m_widths[slice(place.y)];
        return width <= 0.0 || std::abs(glm::dot(place - m_foot, backward)) <= nearShare * width;
    }

private:
    /// Of the crown's width to either side. A third would show every leaf of a cylinder once; the pieces that
    /// are seen at an angle are narrower than the crown.
    static constexpr double nearShare = 0.42;
    static constexpr std::size_t slices = 24;
    [[nodiscard]] std::size_t slice(double y) const
    {
        return std::size_t(std::clamp((y - m_low) / m_height, 0.0, 0.999) * double(slices));
    }

    glm::dvec3 m_foot;
    double m_low, m_height;
    std::array<double, slices> m_widths{};
};

/// The triangles that are near to a card.
TriangleMesh nearTo(const ViewFrame& frame, TriangleMesh mesh, const CrownWidths& crown)
{
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!crown.isNear(glm::dvec3(mesh.positions[mesh.triangles[t].x]), frame.backward))
            continue;
        if (!mesh.uvTriangles.empty())
            mesh.uvTriangles[kept] = mesh.uvTriangles[t];
        if (!mesh.colours.empty())
            mesh.colours[kept] = mesh.colours[t];
        mesh.triangles[kept++] = mesh.triangles[t];
    }
    mesh.triangles.resize(kept);
    mesh.uvTriangles.resize(std::min(kept, mesh.uvTriangles.size()));
    mesh.colours.resize(std::min(kept, mesh.colours.size()));
    return mesh;
}

std::vector<ShownSurface> nearTo(const ViewFrame& frame, const std::vector<ShownSurface>& surfaces,
                                 const CrownWidths& crown)
{
    std::vector<ShownSurface> out;
    for (const ShownSurface& surface : surfaces) {
        ShownSurface near = surface;
        if (surface.copies.empty())
            near.mesh = std::make_shared<const TriangleMesh>(nearTo(frame, *surface.mesh, crown));
        std::erase_if(near.copies,
                      [&](const FoliageItem& leaf) { return !crown.isNear(leaf.position, frame.backward); });
        if (!near.mesh->empty() && near.copies.empty() == surface.copies.empty())
            out.push_back(std::move(near));
    }
    return out;
}

} // namespace

Expected<TreePicture> treePicture(const std::vector<ShownSurface>& surfaces, const glm::dvec3& foot)
{
    Box box;
    forEachPlace(surfaces, [&](const glm::dvec3& at) { box.add(at); });
    if (box.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a tree of nothing has no billboard"));
    const glm::dvec3 centre(foot.x, box.centre().y, foot.z);
    std::vector<BillboardCard> cards;
    for (const ViewFrame& frame : cardFrames(billboardCards, false)) {
        constexpr double most = std::numeric_limits<double>::infinity();
        cards.push_back({frame, {glm::dvec2(most), glm::dvec2(-most)}, {}});
    }
    forEachPlace(surfaces, [&](const glm::dvec3& at) {
        const glm::dvec3 away = at - centre;
        for (BillboardCard& card : cards) {
            const glm::dvec2 seen(glm::dot(away, card.frame.right), glm::dot(away, card.frame.up));
            card.seen = {glm::min(card.seen.low, seen), glm::max(card.seen.high, seen)};
        }
    });
    for (BillboardCard& card : cards) // a trunk without width is seen nevertheless
        card.seen.high = glm::max(card.seen.high, card.seen.low + 1e-6);
    RAMURE_TRY(packCards(cards, packedSize, int(cardGutter)));
    const CrownWidths crown(surfaces, foot, box);
    auto atlas = std::make_shared<CardAtlas>();
    atlas->name = "billboard";
    TriangleMesh mesh;
    for (const BillboardCard& card : cards) {
        const glm::dvec2 middle = card.seen.centre();
        const std::vector<ShownSurface> near = nearTo(card.frame, surfaces, crown);
        const std::size_t from = atlas->surfaces.size();
        atlas->surfaces.insert(atlas->surfaces.end(), near.begin(), near.end());
        ShownCard shown{from, from + near.size(), card.frame,
                        centre + middle.x * card.frame.right + middle.y * card.frame.up,
                        0.5 * card.seen.size()};
        const PixelRect& place = card.picture;
        shown.low = glm::vec2(place.x, packedSize - place.y - place.height) / float(packedSize);
        shown.high = shown.low + glm::vec2(place.width, place.height) / float(packedSize);
        atlas->cards.push_back(shown);
        const TriangleMesh own = meshOf(shown);
        for (const glm::uvec3& face : own.triangles)
            mesh.triangles.push_back(face + mesh.vertexCount());
        mesh.positions.insert(mesh.positions.end(), own.positions.begin(), own.positions.end());
        mesh.normals.insert(mesh.normals.end(), own.normals.begin(), own.normals.end());
        mesh.uv.insert(mesh.uv.end(), own.uv.begin(), own.uv.end());
    }
    atlas->hash = hashOf(*atlas);
    return TreePicture{std::move(atlas), std::move(mesh)};
}

} // namespace ramure
