/// \file
/// The rows of the palette: what fits the typed words, the best first.
#pragma once

#include "widgets/dialogs/palette/palette_item.h"
#include <QAbstractListModel>
#include <vector>

namespace ramure {

class PaletteModel : public QAbstractListModel
{
    Q_OBJECT
public:
    using QAbstractListModel::QAbstractListModel;

    /// \param recent paletteName of what was used, the latest first.
    void setItems(std::vector<PaletteItem> items, const QStringList& recent);
    void setTyped(const QString& typed);
    /// Null outside the rows. Valid until the next change.
    [[nodiscard]] const PaletteItem* item(int row) const;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    /// Title, icon and, for assistive techniques, one text of all that a row shows.
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// What cannot be done now can be chosen, to read why, but not run.
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    std::vector<PaletteItem> m_items;
    QStringList m_recent;
    std::vector<std::size_t> m_rows;
};

} // namespace ramure
