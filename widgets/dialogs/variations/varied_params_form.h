/// \file
/// Which parameters of a tree are varied and between what: picked by searching, each with a range.
#pragma once

#include "core/qt/session/jobs/variations.h"
#include "widgets/base/texts/number_format.h"
#include <QWidget>

class QComboBox;
class QGridLayout;
class QLabel;

namespace ramure {

class NumberField;

class VariedParamsForm : public QWidget
{
    Q_OBJECT
public:
    explicit VariedParamsForm(QWidget* parent);

    /// Begins anew: nothing is varied. \param params the tree's, from which ranges are suggested
    void setTree(const NodeParams& params);
    void setAngleUnit(AngleUnit unit);
    /// With the range that is usual for the tree; one that is there already only gets the focus.
    void add(const ParamDef& def);
    void remove(const ParamDef& def);
    [[nodiscard]] std::vector<VariedParam> params() const;
    [[nodiscard]] QComboBox* picker() const { return m_picker; }
    /// \returns null for a flag, a choice, and what is not varied
    [[nodiscard]] NumberField* field(const ParamDef& def, bool upper) const;

signals:
    void changed();

private:
    struct Row
    {
        VariedParam param;
        QWidget* widget;
        NumberField* from = nullptr; ///< null where all values count
        NumberField* to = nullptr;
    };

    void fillPicker();
    void pickSoon();
    void pick(const QString& typed);
    void describe(const Row& row);
    void addFields(Row& row);
    void clearRows();

    NodeParams m_tree;
    AngleUnit m_unit = AngleUnit::Degrees;
    bool m_isPicking = false;
    QComboBox* m_picker;
    QLabel* m_none;
    QWidget* m_list;
    std::vector<Row> m_rows;
};

} // namespace ramure
