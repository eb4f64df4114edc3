#include "widgets/view/render/passes/billboard_baker.h"

#include "widgets/view/render/render_scene.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr int mostSamples = 2;          ///< of a pixel, each way
constexpr int mostBakedSide = 4096;     ///< of what is drawn at once, where samples are to be had for less
constexpr int probeSide = 512;          ///< pixels of the picture that finds out what a card shows
constexpr int cardGap = 4, viewGap = 2; ///< pixels

Camera cameraOf(const ViewFrame& frame, const glm::dvec3& target, double height)
{
    Camera camera;
    camera.orthographic = true;
    camera.target = target;
    camera.fovRad = 2.0 * std::atan(0.5); // as high as it is far
    camera.distance = height;
    camera.pitchRad = std::asin(std::clamp(frame.backward.y, -1.0, 1.0));
    camera.yawRad = std::atan2(frame.backward.x, frame.backward.z);
    return camera;
}

BillboardPicture pictureOf(const SurfacePictures& drawn)
{
    BillboardPicture out(drawn.colour.width(), drawn.colour.height());
    const auto copy = [](const QImage& image, std::vector<glm::u8vec4>& to) {
        std::size_t i = 0;
        for (int y = 0; y < image.height(); ++y) {
            const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
            for (int x = 0; x < image.width(); ++x)
                to[i++] = {qRed(row[x]), qGreen(row[x]), qBlue(row[x]), qAlpha(row[x])};
        }
    };
    copy(drawn.colour, out.colour);
    copy(drawn.normal, out.normal);
    return out;
}

Error nothingSeen()
{
    return {ErrorCode::Invalid,
            RAMURE_NOOP("nothing is visible: there is nothing to make a billboard of"),
            {},
            {},
            {}};
}

/// What a card shows, with half a pixel's doubt about it.
Expected<PlaneRect> seenBy(const DrawSurfaces& draw, const ViewFrame& frame, const SceneBall& ball)
{
    const double radius = ball.radius * (1.0 + 4.0 / probeSide);
    const auto drawn =
        draw(cameraOf(frame, ball.middle, 2.0 * radius), QSize(probeSide, probeSide), ball.radius, false);
    RAMURE_TRY(drawn);
    const PixelRect covered = coveredRect(pictureOf(*drawn));
    if (covered.width == 0)
        return fail(nothingSeen());
    const double pixel = 2.0 * radius / probeSide;
    return PlaneRect{{(covered.x - 1) * pixel - radius, radius - (covered.y + covered.height + 1) * pixel},
                     {(covered.x + covered.width + 1) * pixel - radius, radius - (covered.y - 1) * pixel}};
}

} // namespace

SceneBall ballOf(const RenderScene& scene)
{
    const std::vector<glm::dvec3> points = scene.framePoints();
    Box box;
    for (const glm::dvec3& point : points)
        box.add(point);
    SceneBall ball;
    if (box.empty())
        return ball;
    ball.middle = box.centre();
    for (const glm::dvec3& point : points)
        ball.radius = std::max(ball.radius, glm::distance(point, ball.middle));
    ball.radius *= 1.01; // the points are some of all
    return ball;
}

Expected<BillboardPicture> bakeView(const DrawSurfaces& draw, const ViewFrame& frame,
                                    const glm::dvec3& middle, const PlaneRect& seen, QSize size, double reach,
                                    bool sparing)
{
    const int each = std::clamp(mostBakedSide / std::max(size.width(), size.height()), 1, mostSamples);
    const glm::dvec2 at = seen.centre();
    const auto drawn = draw(cameraOf(frame, middle + at.x * frame.right + at.y * frame.up, seen.size().y),
                            size * each, reach, sparing);
    RAMURE_TRY(drawn);
    return shrunk(pictureOf(*drawn), each);
}

Expected<BillboardAtlas> bakeAtlas(const DrawSurfaces& draw, const SceneBall& ball, int size, int views,
                                   const Progress& progress)
{
    if (!(ball.radius > 0.0))
        return fail(nothingSeen());
    const int side = size / views;
    BillboardAtlas out{BillboardPicture(size, size), views, ball.middle,
                       ball.radius * side / std::max(side - 2 * viewGap, 1)};
    const PlaneRect seen{glm::dvec2(-out.radius), glm::dvec2(out.radius)};
    for (int i = 0; i < views * views; ++i) {
        const AtlasCell cell{i % views, i / views};
        const auto view = bakeView(draw, viewFrame(atlasDirection(cell, views)), out.middle, seen,
                                   QSize(side, side), out.radius, true);
        RAMURE_TRY(view);
        const PixelRect place{cell.column * side, cell.row * side, side, side};
        paste(out.picture, *view, place.x, place.y);
        bleed(out.picture, place);
        progress.report(double(i + 1) / (views * views));
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    }
    return out;
}

Expected<BillboardCards> bakeCards(const DrawSurfaces& draw, const SceneBall& ball, int size, int standing,
                                   bool lying, const Progress& progress)
{
    if (!(ball.radius > 0.0))
        return fail(nothingSeen());
    BillboardCards out;
    out.picture = BillboardPicture(size, size);
    for (const ViewFrame& frame : cardFrames(standing, lying)) {
        const auto seen = seenBy(draw, frame, ball);
        RAMURE_TRY(seen);
        out.cards.push_back({frame, *seen, {}});
    }
    RAMURE_TRY(packCards(out.cards, size, cardGap));
    for (std::size_t i = 0; i < out.cards.size(); ++i) {
        const BillboardCard& card = out.cards[i];
        const PixelRect& place = card.picture;
        auto view = bakeView(draw, card.frame, ball.middle, card.seen, QSize(place.width, place.height),
                             ball.radius, true);
        RAMURE_TRY(view);
        turnNormals(*view, {0, 0, view->width, view->height}, card.frame);
        paste(out.picture, *view, place.x, place.y);
        progress.report(double(i + 1) / double(out.cards.size()));
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
    }
    bleed(out.picture, {0, 0, size, size});
    out.mesh = cardMesh(out.cards, ball.middle, size);
    return out;
}

} // namespace ramure
