/// \file
/// The small cube in the corner of the viewport that shows where the axes point; a click on a side looks from
/// there.
#pragma once

#include "widgets/view/render/camera.h"
#include <QCoreApplication>
#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <optional>

namespace ramure {

class NavigationCube
{
    Q_DECLARE_TR_FUNCTIONS(ramure::NavigationCube)
public:
    /// Where the cube lies in a picture of this size, logical pixels.
    [[nodiscard]] static QRectF place(QSize picture);
    /// The visible side under a point of the picture.
    [[nodiscard]] static std::optional<AxisView> sideAt(const Camera& camera, QSize picture, QPointF point);
    /// \param hovered the side to show brighter.
    static void paint(QPainter& painter, const Camera& camera, QSize picture,
                      std::optional<AxisView> hovered);
};

} // namespace ramure
