/// \file
/// Draws a row of the palette: icon, title, where it stands, its keys.
#pragma once

#include <QStyledItemDelegate>

namespace ramure {

class PaletteDelegate : public QStyledItemDelegate
{
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// \p index belongs to a PaletteModel.
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace ramure
