#include "widgets/panels/validation/status_badge.h"

#include "widgets/base/theme/theme.h"
#include <QPainter>
#include <QPainterPath>

namespace ramure {
namespace {

constexpr int side = 28;

/// The sign in a square of 1 by 1.
QPainterPath signOf(StatusBadge::Status status)
{
    QPainterPath path;
    switch (status) {
    case StatusBadge::Status::Good:
        path.moveTo(0.28, 0.53);
        path.lineTo(0.44, 0.68);
        path.lineTo(0.72, 0.36);
        break;
    case StatusBadge::Status::Bad:
        path.moveTo(0.34, 0.34);
        path.lineTo(0.66, 0.66);
        path.moveTo(0.66, 0.34);
        path.lineTo(0.34, 0.66);
        break;
    case StatusBadge::Status::Warning:
        path.moveTo(0.5, 0.26);
        path.lineTo(0.5, 0.56);
        path.moveTo(0.5, 0.73);
        path.lineTo(0.5, 0.74);
        break;
    case StatusBadge::Status::Unknown:
        path.moveTo(0.32, 0.5);
        path.lineTo(0.68, 0.5);
        break;
    }
    return path;
}

} // namespace

StatusBadge::StatusBadge(QWidget* parent)
    : QWidget(parent)
{
    setFixedSize(side, side);
}

QSize StatusBadge::sizeHint() const
{
    return {side, side};
}

void StatusBadge::setStatus(Status status)
{
    if (status == m_status)
        return;
    m_status = status;
    update();
}

void StatusBadge::paintEvent(QPaintEvent*)
{
    QColor colour = palette().color(QPalette::PlaceholderText);
    if (m_status == Status::Good)
        colour = goodColour(palette());
    else if (m_status == Status::Warning)
        colour = warningColour(palette());
    else if (m_status == Status::Bad)
        colour = errorColour(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(QRectF(rect()).adjusted(1, 1, -1, -1));
    painter.scale(side, side);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Window), 0.09, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(signOf(m_status));
}

} // namespace ramure
