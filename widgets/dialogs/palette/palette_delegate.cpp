#include "widgets/dialogs/palette/palette_delegate.h"

#include "widgets/dialogs/palette/palette_model.h"
#include <QApplication>
#include <QPainter>

namespace ramure {

static constexpr int rowMargin = 10, spacing = 10, rowIcon = 16, rowPadding = 10;

void PaletteDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const
{
    const PaletteItem* item = static_cast<const PaletteModel*>(index.model())->item(index.row());
    if (!item)
        return;
    QStyleOptionViewItem row = option;
    row.text.clear();
    const QStyle* style = row.widget ? row.widget->style() : QApplication::style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &row, painter, row.widget);
    const QColor text = row.palette.color(QPalette::Text);
    const QColor dim = row.palette.color(QPalette::PlaceholderText);
    QRect room = row.rect.adjusted(rowMargin, 0, -rowMargin, 0);
    const QRect picture(room.left(), room.center().y() - rowIcon / 2, rowIcon, rowIcon);
    item->icon.paint(painter, picture, Qt::AlignCenter, item->enabled ? QIcon::Normal : QIcon::Disabled);
    room.setLeft(picture.right() + spacing);
    painter->save();
    if (!item->keys.isEmpty()) {
        painter->setPen(dim);
        painter->drawText(room, Qt::AlignRight | Qt::AlignVCenter, item->keys);
        room.setRight(room.right() - row.fontMetrics.horizontalAdvance(item->keys) - 2 * spacing);
    }
    const QString title = row.fontMetrics.elidedText(item->title, Qt::ElideRight, room.width());
    painter->setPen(item->enabled ? text : dim);
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter, title);
    room.setLeft(room.left() + row.fontMetrics.horizontalAdvance(title) + spacing);
    painter->setPen(dim);
    const QString beside =
        item->reason.isEmpty() ? item->place : item->place + QStringLiteral(" – ") + item->reason;
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                      row.fontMetrics.elidedText(beside, Qt::ElideRight, room.width()));
    painter->restore();
}

QSize PaletteDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const
{
    return {0, option.fontMetrics.height() + rowPadding};
}

} // namespace ramure
