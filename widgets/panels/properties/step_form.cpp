#include "widgets/panels/properties/step_form.h"

#include "core/params/param_relevance.h"
#include "core/params/tree_edit_table.h"
#include "core/qt/document/commands.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/panels/properties/group_section.h"
#include "widgets/panels/properties/param_row.h"
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <string_view>

namespace ramure {

StepForm::StepForm(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_title(new QLabel(this))
    , m_layout(new QVBoxLayout(this))
{
    setObjectName(QStringLiteral("stepForm"));
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(0);
    m_title->setObjectName(QStringLiteral("partTitle"));
    m_title->setTextFormat(Qt::PlainText);
    m_title->setContentsMargins(12, 6, 8, 6);
    m_layout->addWidget(m_title);
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeReset | changeStructure | changeBranches | changeNodeState))
            show();
    });
    hide();
}

const TreeEdit* StepForm::step() const
{
    const Node* node = m_id == 0 ? nullptr : m_document->scene().find(m_tree);
    if (!node)
        return nullptr;
    const auto found = std::ranges::find(node->params.edits, m_id, &TreeEdit::id);
    return found == node->params.edits.end() ? nullptr : &*found;
}

void StepForm::setStep(NodeId tree, std::uint64_t step)
{
    const bool isOther = tree != m_tree || step != m_id;
    m_tree = tree;
    m_id = step;
    show();
    if (isOther && !isHidden())
        scrollHere();
}

/// Whoever chooses a step sees its values, however far down the parameters were.
void StepForm::scrollHere()
{
    if (parentWidget() && parentWidget()->layout())
        parentWidget()->layout()->activate();
    for (QWidget* above = parentWidget(); above; above = above->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(above))
            area->ensureWidgetVisible(m_title);
}

void StepForm::setAngleUnit(AngleUnit unit)
{
    m_angleUnit = unit;
    for (ParamRow* row : m_rows)
        row->setAngleUnit(unit);
}

void StepForm::build(EditOperation operation)
{
    if (m_built == operation)
        return;
    for (GroupSection* section : m_sections)
        delete section;
    m_sections.clear();
    m_rows.clear();
    for (const ParamDef* def : stepParams(operation))
        addRow(*def);
    int width = 0;
    for (const ParamRow* row : m_rows)
        width = std::max(width, row->labelWidth());
    for (ParamRow* row : m_rows)
        row->setLabelWidth(width);
    m_built = operation;
}

void StepForm::addRow(const ParamDef& def)
{
    const auto isOfGroup = [&def](const GroupSection* section) {
        return std::string_view(section->group()) == def.group;
    };
    auto found = std::ranges::find_if(m_sections, isOfGroup);
    if (found == m_sections.end()) {
        auto* section = new GroupSection(def.group, this);
        section->setMenuShown(false);
        m_layout->addWidget(section);
        connect(section, &GroupSection::foldedChanged, this, [section] { section->updateHeading(); });
        found = m_sections.insert(m_sections.end(), section);
    }
    auto* row = new ParamRow(def, this);
    row->setAngleUnit(m_angleUnit);
    (*found)->addRow(row);
    m_rows.push_back(row);
    connect(row->editor(), &ParamEditor::valueEdited, this,
            [this, row](const ParamValue& value, GestureId gesture) { set(row, value, gesture); });
    connect(row->editor(), &ParamEditor::componentEdited, this,
            [this, row](int axis, double value, GestureId gesture) {
                const TreeEdit* const now = step();
                auto vector = now ? std::get<glm::dvec3>(row->def().get(*now->values)) : glm::dvec3(0.0);
                vector[axis] = value;
                set(row, vector, gesture);
            });
    connect(row, &ParamRow::resetRequested, this, [this, row] {
        if (const TreeEdit* const now = step())
            set(row, row->def().get(*newStep(now->operation).values), 0);
    });
}

void StepForm::show()
{
    const TreeEdit* const now = step();
    const bool hasValues = now && !stepParams(now->operation).empty();
    setVisible(hasValues);
    if (!hasValues)
        return;
    build(now->operation);
    m_title->setText(tr("Step: %1")
                         .arg(now->name.empty() ? coreText(infoOf(now->operation).label)
                                                : QString::fromStdString(now->name)));
    const NodeParams& values = *now->values;
    const TreeEdit begun = newStep(now->operation);
    const std::vector<std::string> presets{std::string()};
    for (ParamRow* row : m_rows) {
        const ParamValue value = row->def().get(values);
        row->editor()->showGrammar(values.grammar);
        row->showValues(std::span(&value, 1), presets);
        row->resetButton()->setVisible(value != row->def().get(*begun.values));
        row->setRelevant(isRelevant(values, row->def()));
        row->setActs(acts(values, row->def()));
    }
    for (GroupSection* section : m_sections) {
        section->filter(section->rows().front()->def().kinds, {});
        section->updateHeading();
    }
}

void StepForm::set(ParamRow* row, const ParamValue& value, quint64 gesture)
{
    const auto done = edit::setStepParam(*m_document, m_tree, m_id, row->def(), value, gesture);
    row->showRefusal(done ? QString() : errorText(done.error()));
}

} // namespace ramure
