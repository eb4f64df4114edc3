/// \file
/// The table of levels of detail: one row for each, with its triangles, its leaves and when it is shown.
#pragma once

#include "core/session/level_watch.h"
#include <QAbstractTableModel>
#include <memory>

namespace ramure {

class LevelModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Column { Level, Triangles, Bark, Leaves, LeavesLeft, From, Screen, Columns };

    explicit LevelModel(QObject* parent = nullptr);

    void setLevels(std::shared_ptr<const TreeLevels> levels); ///< null: no rows
    void retranslate();
    /// The rows with the names of the columns before them, tabs between: for a spreadsheet.
    [[nodiscard]] QString text(int firstRow, int count) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString cell(std::size_t row, int column) const;
    [[nodiscard]] QString tip(std::size_t row) const;

    std::shared_ptr<const TreeLevels> m_levels;
};

/// "12.5 m": as many digits as matter.
QString metresText(double metres);
/// "100,742", as the language groups them.
QString countText(std::int64_t count);

} // namespace ramure
