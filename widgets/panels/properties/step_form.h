/// \file
/// The values of one step of a tree's recipe, above the parameters of the tree.
#pragma once

#include "core/params/tree_edit.h"
#include "core/qt/document/document.h"
#include "widgets/base/texts/number_format.h"
#include <QWidget>
#include <optional>
#include <vector>

class QLabel;
class QVBoxLayout;

namespace ramure {

class GroupSection;
class ParamRow;

class StepForm : public QWidget
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive the form, which is hidden until a step is chosen.
    StepForm(Document* document, QWidget* parent);

    /// \param step 0: none. A step without parameters, as a hand edit, hides the form too.
    void setStep(NodeId tree, std::uint64_t step);
    void setAngleUnit(AngleUnit unit);
    [[nodiscard]] const std::vector<ParamRow*>& rows() const { return m_rows; }

private:
    [[nodiscard]] const TreeEdit* step() const;
    void build(EditOperation operation);
    void addRow(const ParamDef& def);
    void show();
    void scrollHere();
    void set(ParamRow* row, const ParamValue& value, quint64 gesture);

    Document* m_document;
    NodeId m_tree = noNode;
    std::uint64_t m_id = 0;
    std::optional<EditOperation> m_built;
    AngleUnit m_angleUnit = AngleUnit::Degrees;
    QLabel* m_title;
    QVBoxLayout* m_layout;
    std::vector<GroupSection*> m_sections;
    std::vector<ParamRow*> m_rows;
};

} // namespace ramure
