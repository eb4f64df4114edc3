#include "widgets/view/tools/readout.h"

#include <QPainter>

namespace ramure {

void paintReadout(QPainter& painter, QPointF at, QSize picture, const QString& text)
{
    QFont font = painter.font();
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    QRectF box(QPointF(0.0, 0.0), painter.fontMetrics().size(Qt::TextSingleLine, text) + QSize(18, 10));
    box.moveTopLeft(at + QPointF(18.0, 18.0));
    if (box.right() > picture.width() - 4.0)
        box.moveRight(picture.width() - 4.0);
    if (box.bottom() > picture.height() - 4.0)
        box.moveBottom(at.y() - 12.0);
    painter.setPen(QPen(QColor(255, 255, 255, 60), 1.0));
    painter.setBrush(QColor(20, 26, 32, 215));
    painter.drawRoundedRect(box, 5.0, 5.0);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace ramure
