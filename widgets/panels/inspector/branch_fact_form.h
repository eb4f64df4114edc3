/// \file
/// The facts of one branch in two columns, its relatives as links.
#pragma once

#include "core/skeleton/branch_facts.h"
#include "widgets/base/texts/number_format.h"
#include "widgets/panels/inspector/fact_form.h"

namespace ramure {

class BranchFactForm : public QWidget
{
    Q_OBJECT
public:
    explicit BranchFactForm(QWidget* parent = nullptr);

    void setFacts(const BranchFacts& facts);
    void setAngleUnit(AngleUnit unit);

signals:
    /// A link to a relative was followed.
    void branchChosen(ramure::Index branch);

private:
    void showFacts();

    FactForm* m_form = nullptr;
    BranchFacts m_facts;
    AngleUnit m_unit = AngleUnit::Degrees;
};

} // namespace ramure
