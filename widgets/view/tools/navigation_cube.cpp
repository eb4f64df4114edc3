#include "widgets/view/tools/navigation_cube.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <algorithm>
#include <array>

namespace ramure {
namespace {

constexpr double cubeRoom = 92.0; ///< of the square that holds the cube, logical pixels
constexpr double inset = 12.0;    ///< to the picture's edge
constexpr double halfEdge = 27.0; ///< half an edge of the cube

struct CubeSide
{
    AxisView view;
    glm::dvec3 normal;
    glm::dvec3 right; ///< of its label
    glm::dvec3 up;
};

constexpr std::array<CubeSide, 6> cubeSides{{
    {AxisView::Front, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
    {AxisView::Back, {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
    {AxisView::Right, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
    {AxisView::Left, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    {AxisView::Top, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
    {AxisView::Bottom, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
}};

/// Orthographic: the cube looks the same wherever it sits.
QPointF onScreen(const Camera& camera, QPointF centre, const glm::dvec3& point)
{
    return centre +
           QPointF(halfEdge * glm::dot(point, camera.right()), -halfEdge * glm::dot(point, camera.up()));
}

bool isVisible(const Camera& camera, const CubeSide& of)
{
    return glm::dot(of.normal, camera.backward()) > 0.02;
}

QPolygonF outline(const Camera& camera, QPointF centre, const CubeSide& of)
{
    QPolygonF polygon;
    for (const auto& [x, y] : {std::pair(-1, 1), std::pair(1, 1), std::pair(1, -1), std::pair(-1, -1)})
        polygon << onScreen(camera, centre, of.normal + double(x) * of.right + double(y) * of.up);
    return polygon;
}

/// So that a long label keeps off the edges.
QFont labelFont(QFont font, const QString& label)
{
    constexpr int usual = 17;
    constexpr double room = 50.0; // of the 64 units of a side
    font.setPixelSize(usual);
    font.setWeight(QFont::DemiBold);
    const double width = QFontMetricsF(font).horizontalAdvance(label);
    font.setPixelSize(int(usual * std::min(room / width, 1.0)));
    return font;
}

} // namespace

QRectF NavigationCube::place(QSize picture)
{
    return {picture.width() - cubeRoom - inset, inset, cubeRoom, cubeRoom};
}

std::optional<AxisView> NavigationCube::sideAt(const Camera& camera, QSize picture, QPointF point)
{
    const QPointF centre = place(picture).center();
    for (const CubeSide& of : cubeSides) {
        if (isVisible(camera, of) && outline(camera, centre, of).containsPoint(point, Qt::OddEvenFill))
            return of.view;
    }
    return std::nullopt;
}

void NavigationCube::paint(QPainter& painter, const Camera& camera, QSize picture,
                           std::optional<AxisView> hovered)
{
    const std::array<QString, 6> labels{tr("Front"), tr("Back"), tr("Right"),
                                        tr("Left"),  tr("Top"),  tr("Bottom")};
    const QPointF centre = place(picture).center();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < cubeSides.size(); ++i) {
        const CubeSide& of = cubeSides[i];
        if (!isVisible(camera, of))
            continue;
        const QPolygonF polygon = outline(camera, centre, of);
        const double light = 0.80 + 0.20 * glm::dot(of.normal, glm::normalize(glm::dvec3(0.3, 0.9, 0.45)));
        const bool bright = hovered == of.view;
        painter.setPen(QPen(QColor(40, 48, 56, 190), 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(
            bright ? QColor(255, 176, 66, 240)
                   : QColor::fromRgbF(float(0.93 * light), float(0.95 * light), float(0.97 * light), 0.90f));
        painter.drawPolygon(polygon);
        // The label lies on the side: its square of 64 units is mapped onto the polygon.
        QTransform onSide;
        if (!QTransform::quadToQuad(QPolygonF({{0, 0}, {64, 0}, {64, 64}, {0, 64}}), polygon, onSide))
            continue;
        painter.save();
        painter.setTransform(onSide, true);
        painter.setFont(labelFont(painter.font(), labels[i]));
        painter.setPen(QColor(30, 36, 42));
        painter.drawText(QRectF(0, 0, 64, 64), Qt::AlignCenter, labels[i]);
        painter.restore();
    }
    // The three axes leave the corner of smallest coordinates; hidden ones are covered by the cube's drawing
    // order.
    const std::array<std::pair<glm::dvec3, QColor>, 3> axes{{{{1, 0, 0}, QColor(214, 56, 48)},
                                                             {{0, 1, 0}, QColor(64, 152, 48)},
                                                             {{0, 0, 1}, QColor(48, 96, 214)}}};
    for (const auto& [axis, colour] : axes) {
        const glm::dvec3 corner(-1.0);
        painter.setPen(QPen(colour, 2.6, Qt::SolidLine, Qt::RoundCap));
        const bool inFront = glm::dot(axis - glm::dvec3(1.0), camera.backward()) > -0.4;
        if (inFront || camera.pitchRad < 0.0)
            painter.drawLine(onScreen(camera, centre, corner), onScreen(camera, centre, corner + 2.0 * axis));
    }
    painter.restore();
}

} // namespace ramure
