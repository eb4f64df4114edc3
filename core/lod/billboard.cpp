#include "core/lod/billboard.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

namespace ramure {

ViewFrame viewFrame(const glm::dvec3& backward)
{
    const glm::dvec3 level(backward.z, 0.0, -backward.x);
    const double length = glm::length(level);
    ViewFrame frame;
    frame.backward = backward;
    frame.right = length > 1e-9 ? level / length : glm::dvec3(1.0, 0.0, 0.0);
    frame.up = glm::cross(frame.backward, frame.right);
    return frame;
}

glm::dvec2 hemiOctEncoded(const glm::dvec3& direction)
{
    const double up = std::max(direction.y, 0.0);
    const double sum = std::abs(direction.x) + std::abs(direction.z) + up;
    if (sum <= 0.0)
        return {0.0, 0.0};
    const double x = direction.x / sum, z = direction.z / sum;
    return {x + z, x - z};
}

glm::dvec3 hemiOctDecoded(const glm::dvec2& point)
{
    const double x = 0.5 * (point.x + point.y), z = 0.5 * (point.x - point.y);
    return glm::normalize(glm::dvec3(x, std::max(1.0 - std::abs(x) - std::abs(z), 0.0), z));
}

glm::dvec3 atlasDirection(AtlasCell cell, int views)
{
    const auto at = [views](int i) { return 2.0 * i / (views - 1) - 1.0; };
    return hemiOctDecoded({at(cell.column), at(cell.row)});
}

std::vector<AtlasCell> viewsAround(const glm::dvec3& direction, int views)
{
    constexpr double reach = 1.5;
    const glm::dvec2 at = (0.5 * hemiOctEncoded(direction) + 0.5) * double(views - 1);
    std::vector<AtlasCell> out;
    for (int row = 0; row < views; ++row)
        for (int column = 0; column < views; ++column)
            if (glm::distance(at, glm::dvec2(column, row)) < reach)
                out.push_back({column, row});
    return out;
}

std::vector<ViewFrame> cardFrames(int standing, bool lying)
{
    std::vector<ViewFrame> frames;
    for (int i = 0; i < standing; ++i) {
        const double angle = std::numbers::pi * i / standing;
        frames.push_back(viewFrame({maths::sin(angle), 0.0, maths::cos(angle)}));
    }
    if (lying)
        frames.push_back(viewFrame({0.0, 1.0, 0.0}));
    return frames;
}

namespace {

/// In rows, the highest first. \returns false: they do not fit.
bool place(std::vector<BillboardCard>& cards, std::span<const std::size_t> order, double pixelsPerMetre,
           int size, int gap)
{
    int x = 0, y = 0, rowHeight = 0;
    for (const std::size_t number : order) {
        const glm::dvec2 metres = cards[number].seen.size();
        const glm::dvec2 pixels = glm::dvec2(std::ceil(metres.x * pixelsPerMetre - 1e-6),
                                             std::ceil(metres.y * pixelsPerMetre - 1e-6));
        if (!(pixels.x + 2 * gap <= size && pixels.y + 2 * gap <= size))
            return false;
        PixelRect& rect = cards[number].picture;
        rect.width = std::max(static_cast<int>(pixels.x), 1);
        rect.height = std::max(static_cast<int>(pixels.y), 1);
        if (x + rect.width + 2 * gap > size) {
            x = 0;
            y += rowHeight;
            rowHeight = 0;
        }
        rect.x = x + gap;
        rect.y = y + gap;
        x += rect.width + 2 * gap;
        rowHeight = std::max(rowHeight, rect.height + 2 * gap);
        if (y + rowHeight > size)
            return false;
    }
    return true;
}

} // namespace

Expected<void> packCards(std::vector<BillboardCard>& cards, int size, int gap)
{
    double least = 1e300;
    for (const BillboardCard& card : cards) {
        const glm::dvec2 metres = card.seen.size();
        if (!(metres.x > 0.0 && metres.y > 0.0 && std::isfinite(metres.x) && std::isfinite(metres.y)))
            return fail(ErrorCode::Invalid, RAMURE_NOOP("a card shows nothing"));
        least = std::min({least, metres.x, metres.y});
    }
    if (size < 16)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a picture of cards has at least 16 pixels a side"));
    std::vector<std::size_t> order(cards.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(
        order, [&](std::size_t a, std::size_t b) { return cards[a].seen.size().y > cards[b].seen.size().y; });
    double low = 0.0, high = size / least; // pixels per metre
    for (int round = 0; round < 60; ++round) {
        const double middle = 0.5 * (low + high);
        (place(cards, order, middle, size, gap) ? low : high) = middle;
    }
    if (low <= 0.0 || !place(cards, order, low, size, gap))
        return fail(ErrorCode::Limit, RAMURE_NOOP("%1 cards do not fit into a picture of %2 pixels"),
                    {std::to_string(cards.size()), std::to_string(size)});
    for (BillboardCard& card : cards) {
        const glm::dvec2 middle = card.seen.centre();
        const glm::dvec2 half = 0.5 / low * glm::dvec2(card.picture.width, card.picture.height);
        card.seen = {middle - half, middle + half};
    }
    return {};
}

TriangleMesh cardMesh(std::span<const BillboardCard> cards, const glm::dvec3& middle, int size)
{
    TriangleMesh mesh;
    for (const BillboardCard& card : cards) {
        const auto first = static_cast<Index>(mesh.positions.size());
        for (const glm::ivec2 corner : {glm::ivec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
            const glm::dvec2 at(corner.x ? card.seen.high.x : card.seen.low.x,
                                corner.y ? card.seen.high.y : card.seen.low.y);
            mesh.positions.emplace_back(middle + at.x * card.frame.right + at.y * card.frame.up);
            mesh.normals.emplace_back(card.frame.backward);
            const PixelRect& rect = card.picture;
            mesh.uv.emplace_back(double(rect.x + corner.x * rect.width) / size,
                                 1.0 - double(rect.y + (1 - corner.y) * rect.height) / size);
        }
        mesh.triangles.emplace_back(first, first + 1, first + 2);
        mesh.triangles.emplace_back(first, first + 2, first + 3);
    }
    return mesh;
}

} // namespace ramure
