/// \file
/// A variation in the grid: its picture with the seed below, and a star in the corner that a click sets.
#pragma once

#include <QStyledItemDelegate>

namespace ramure {

class VariationDelegate : public QStyledItemDelegate
{
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    static constexpr QSize pictureSize{176, 110}; ///< logical pixels

    /// \param cell of the item in the view
    [[nodiscard]] static QRect starPlace(const QRect& cell);
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

signals:
    void starClicked(const QModelIndex& index);

protected:
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;
};

} // namespace ramure
