#include "widgets/dialogs/variations/variation_delegate.h"

#include "widgets/dialogs/variations/variations_model.h"
#include "widgets/panels/presets/picture_button.h"
#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

namespace ramure {
namespace {

constexpr int cellMargin = 6;

QRect pictureIn(const QRect& cell)
{
    const QSize size = VariationDelegate::pictureSize;
    return {QPoint(cell.center().x() - size.width() / 2 + 1, cell.top() + cellMargin), size};
}

void paintPicture(QPainter& painter, const QRectF& place, const QStyleOptionViewItem& option,
                  const QModelIndex& index)
{
    QPainterPath rounded;
    rounded.addRoundedRect(place, PictureButton::cornerRadius, PictureButton::cornerRadius);
    painter.save();
    painter.setClipPath(rounded);
    const auto picture = index.data(Qt::DecorationRole).value<QPixmap>();
    if (picture.isNull()) {
        painter.fillRect(place, option.palette.color(QPalette::AlternateBase));
        const QString problem = index.data(VariationsModel::ProblemRole).toString();
        painter.setPen(option.palette.color(QPalette::PlaceholderText));
        painter.drawText(place.adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                         problem.isEmpty() ? QStringLiteral("…") : problem);
    } else {
        painter.drawPixmap(place, picture, QRectF(picture.rect()));
    }
    painter.restore();
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    const bool lit = selected || option.state.testFlag(QStyle::State_MouseOver);
    QColor line = option.palette.color(lit ? QPalette::Link : QPalette::WindowText);
    if (!lit)
        line.setAlpha(50);
    painter.setPen(QPen(line, selected ? 3.0 : lit ? 2.0 : 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(rounded);
}

} // namespace

QRect VariationDelegate::starPlace(const QRect& cell)
{
    return pictureStarPlace(pictureIn(cell).topRight());
}

void VariationDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const
{
    painter->save();
    painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRect picture = pictureIn(option.rect);
    paintPicture(*painter, picture, option, index);
    const bool starred = index.data(VariationsModel::StarRole).toBool();
    if (starred || option.state.testFlag(QStyle::State_MouseOver))
        paintPictureStar(*painter, starPlace(option.rect), starred);
    const QRect below(picture.left(), picture.bottom() + PictureButton::textGap, picture.width(),
                      option.fontMetrics.height());
    painter->setPen(option.palette.color(QPalette::Text));
    painter->drawText(below, Qt::AlignCenter, index.data().toString());
    painter->restore();
}

QSize VariationDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const
{
    return pictureSize +
           QSize(2 * cellMargin, 2 * cellMargin + PictureButton::textGap + option.fontMetrics.height());
}

bool VariationDelegate::editorEvent(QEvent* event, QAbstractItemModel*, const QStyleOptionViewItem& option,
                                    const QModelIndex& index)
{
    if (event->type() != QEvent::MouseButtonRelease && event->type() != QEvent::MouseButtonDblClick)
        return false;
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() != Qt::LeftButton || !starPlace(option.rect).contains(mouse->position().toPoint()))
        return false;
    if (event->type() == QEvent::MouseButtonRelease)
        emit starClicked(index);
    return true; // a double click on the star opens nothing
}

} // namespace ramure
