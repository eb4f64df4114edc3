/// \file
/// The table of levels of detail: one row for each, with its triangles, its leaves and when it is shown,
/// which can be edited.
#pragma once

#include "core/qt/session/export/level_watch.h"
#include <QAbstractTableModel>
#include <memory>

namespace ramure {

class LevelModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Column { Level, Triangles, Bark, Leaves, LeavesLeft, From, Height, Columns };

    explicit LevelModel(QObject* parent = nullptr);

    void setLevels(std::shared_ptr<const TreeLevels> levels); ///< null: no rows
    /// The rows with the names of the columns before them, tabs between: for a spreadsheet.
    [[nodiscard]] QString text(int firstRow, int count) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Takes a distance in m or a height in %, which edited() tells; the model stays as it is.
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;

signals:
    /// As LevelOptions has them; one of both is empty.
    void edited(const std::vector<double>& distances, const std::vector<double>& shares);

private:
    [[nodiscard]] QString editText(const QModelIndex& index) const;
    [[nodiscard]] bool isEditable(const QModelIndex& index) const;
    [[nodiscard]] QString cell(std::size_t row, int column) const;
    [[nodiscard]] QString tip(std::size_t row) const;

    std::shared_ptr<const TreeLevels> m_levels;
};

/// "12.5 m": as many digits as matter.
QString metresText(double metres);
/// "100,742", as the language groups them.
QString countText(std::int64_t count);

} // namespace ramure
