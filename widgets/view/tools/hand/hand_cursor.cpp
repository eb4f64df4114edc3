#include "widgets/view/tools/hand/hand_cursor.h"

#include "widgets/base/theme/icons.h"
#include <QGuiApplication>
#include <QPainter>

namespace ramure {
namespace {

constexpr int cursorSide = 32, crossMiddle = 9, crossArm = 6, crossGap = 2, cursorIcon = 17, iconAt = 14;

/// The picture in one colour.
QPixmap inColour(const QPixmap& picture, const QColor& colour)
{
    QPixmap tinted = picture;
    QPainter painter(&tinted);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(tinted.rect(), colour);
    return tinted;
}

void drawCross(QPainter& painter, const QColor& colour, double width)
{
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap));
    for (const QPoint way : {QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)})
        painter.drawLine(QPoint(crossMiddle, crossMiddle) + crossGap * way,
                         QPoint(crossMiddle, crossMiddle) + crossArm * way);
}

QCursor made(HandTool tool, double scale)
{
    QPixmap picture(QSize(cursorSide, cursorSide) * scale);
    picture.setDevicePixelRatio(scale);
    picture.fill(Qt::transparent);
    const QPixmap shape = icon(handTool(tool).icon).pixmap(QSize(cursorIcon, cursorIcon), scale);
    if (shape.isNull())
        return Qt::CrossCursor;
    QPainter painter(&picture);
    drawCross(painter, Qt::white, 3.0);
    drawCross(painter, Qt::black, 1.0);
    const QPixmap halo = inColour(shape, Qt::white);
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            painter.drawPixmap(iconAt + x, iconAt + y, halo);
    painter.drawPixmap(iconAt, iconAt, inColour(shape, QColor(24, 28, 24)));
    painter.end();
    return QCursor(picture, crossMiddle, crossMiddle);
}

} // namespace

QCursor handCursor(HandTool tool)
{
    return made(tool, qGuiApp->devicePixelRatio());
}

} // namespace ramure
