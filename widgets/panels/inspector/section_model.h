/// \file
/// The cross-sections of one branch as a table, one row each.
#pragma once

#include "core/skeleton/branch_facts.h"
#include "widgets/base/texts/number_format.h"
#include <QAbstractTableModel>
#include <vector>

namespace ramure {

class SectionModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Column {
        SectionColumn, ///< counted from 1
        ParameterColumn,
        ArcLengthColumn,
        CentreColumn,
        TangentColumn,
        NormalColumn,
        BinormalColumn,
        RadiusColumn,
        CurvatureColumn,
        TwistPerMetreColumn,
        TwistColumn,
        columnTotal
    };

    using QAbstractTableModel::QAbstractTableModel;

    /// Rows come and go only where their number changes: the current row stays while a tree is being shaped.
    void setFacts(std::vector<SectionFacts> facts);
    [[nodiscard]] const std::vector<SectionFacts>& facts() const { return m_facts; }
    void setAngleUnit(AngleUnit unit);

    /// "Tangent", "Radius" ... in the interface's language.
    [[nodiscard]] static QString columnName(int column);
    /// One value with its unit. \param decimals of vectors.
    [[nodiscard]] static QString valueText(const SectionFacts& section, int column, AngleUnit unit,
                                           int decimals);
    /// What the quantity is.
    [[nodiscard]] static QString columnHelp(int column);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<SectionFacts> m_facts;
    AngleUnit m_unit = AngleUnit::Degrees;
};

} // namespace ramure
