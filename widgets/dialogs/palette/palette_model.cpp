#include "widgets/dialogs/palette/palette_model.h"

#include "widgets/dialogs/palette/palette_match.h"

namespace ramure {

void PaletteModel::setItems(std::vector<PaletteItem> items, const QStringList& recent)
{
    beginResetModel();
    m_items = std::move(items);
    m_recent = recent;
    m_rows = rankedItems(m_items, {}, m_recent);
    endResetModel();
}

void PaletteModel::setTyped(const QString& typed)
{
    beginResetModel();
    m_rows = rankedItems(m_items, typed, m_recent);
    endResetModel();
}

const PaletteItem* PaletteModel::item(int row) const
{
    return row >= 0 && row < rowCount() ? &m_items[m_rows[static_cast<std::size_t>(row)]] : nullptr;
}

int PaletteModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

QVariant PaletteModel::data(const QModelIndex& index, int role) const
{
    const PaletteItem* item = this->item(index.row());
    if (!item)
        return {};
    if (role == Qt::DisplayRole)
        return item->title;
    if (role == Qt::DecorationRole)
        return item->icon;
    if (role == Qt::AccessibleTextRole) {
        QStringList parts{item->title, item->place, item->keys, item->reason};
        parts.removeAll(QString());
        return parts.join(QStringLiteral(", "));
    }
    return {};
}

Qt::ItemFlags PaletteModel::flags(const QModelIndex& index) const
{
    return index.isValid() ? Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemNeverHasChildren
                           : Qt::NoItemFlags;
}

} // namespace ramure
