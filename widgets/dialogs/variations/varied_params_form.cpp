#include "widgets/dialogs/variations/varied_params_form.h"

#include "widgets/base/fields/number_field.h"
#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include <QComboBox>
#include <QCompleter>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace ramure {
namespace {

constexpr int pickerLetters = 18;

/// "Leaves: Size"
QString titleOf(const ParamDef& def)
{
    return VariedParamsForm::tr("%1: %2", "Leaves: Size").arg(coreText(def.group), coreText(def.label));
}

} // namespace

VariedParamsForm::VariedParamsForm(QWidget* parent)
    : QWidget(parent)
    , m_picker(new QComboBox(this))
    , m_none(new QLabel(tr("Only chance varies: each tree has another seed. Add parameters above to spread "
                           "their values too."),
                        this))
    , m_list(new QWidget(this))
{
    m_picker->setEditable(true);
    m_picker->setInsertPolicy(QComboBox::NoInsert);
    m_picker->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_picker->setMinimumContentsLength(pickerLetters);
    m_picker->completer()->setCompletionMode(QCompleter::PopupCompletion);
    m_picker->completer()->setFilterMode(Qt::MatchContains);
    m_picker->completer()->setCaseSensitivity(Qt::CaseInsensitive);
    m_none->setWordWrap(true);
    auto* rows = layoutOf<QVBoxLayout>(m_list, 10);
    rows->addWidget(m_none);
    rows->addStretch(1);
    auto* area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(m_list);
    auto* layout = layoutOf<QVBoxLayout>(this);
    layout->addWidget(m_picker);
    layout->addWidget(area, 1);
    setFocusProxy(m_picker);
    connect(m_picker, &QComboBox::activated, this, &VariedParamsForm::pickSoon);
    connect(m_picker->lineEdit(), &QLineEdit::returnPressed, this, &VariedParamsForm::pickSoon);
    m_picker->lineEdit()->setPlaceholderText(tr("Vary a parameter…"));
    m_picker->setToolTip(tr("Choose a parameter, or type a part of its name and press Return"));
    m_picker->setAccessibleName(tr("Parameter to vary"));
    fillPicker();
}

void VariedParamsForm::setTree(const NodeParams& params)
{
    m_tree = params;
    clearRows();
    fillPicker();
}

void VariedParamsForm::clearRows()
{
    for (const Row& row : m_rows)
        delete row.widget;
    m_rows.clear();
    m_none->show();
}

void VariedParamsForm::setAngleUnit(AngleUnit unit)
{
    m_unit = unit;
    for (const Row& row : m_rows)
        describe(row);
}

/// Those that can be varied and are not yet.
void VariedParamsForm::fillPicker()
{
    const QSignalBlocker quiet(m_picker);
    m_picker->clear();
    for (const ParamDef& def : paramTable())
        if (canVary(m_tree, def) &&
            std::ranges::none_of(m_rows, [&](const Row& row) { return row.param.def == &def; }))
            m_picker->addItem(titleOf(def), QLatin1String(def.key));
    m_picker->setCurrentIndex(-1);
    m_picker->clearEditText();
}

/// Return in the list of completions comes twice, and the box goes on with the item that was meant: it must
/// not be gone.
void VariedParamsForm::pickSoon()
{
    if (std::exchange(m_isPicking, true))
        return;
    QMetaObject::invokeMethod(
        this,
        [this, typed = m_picker->currentText().trimmed()] {
            m_isPicking = false;
            pick(typed);
        },
        Qt::QueuedConnection);
}

/// What was chosen from the list, or what was typed where it is the only one it can mean.
void VariedParamsForm::pick(const QString& typed)
{
    int found = m_picker->findText(typed, Qt::MatchFixedString);
    if (found < 0 && !typed.isEmpty()) {
        found = m_picker->findText(typed, Qt::MatchContains);
        for (int i = found + 1; found >= 0 && i < m_picker->count(); ++i)
            if (m_picker->itemText(i).contains(typed, Qt::CaseInsensitive))
                found = -1;
    }
    if (found >= 0)
        if (const ParamDef* def = findParam(m_picker->itemData(found).toString().toStdString()))
            add(*def);
}

void VariedParamsForm::add(const ParamDef& def)
{
    if (std::ranges::any_of(m_rows, [&](const Row& row) { return row.param.def == &def; })) {
        if (NumberField* from = field(def, false))
            from->setFocus();
        return;
    }
    Row row{usualRange(m_tree, def), new QWidget(m_list)};
    auto* grid = layoutOf<QGridLayout>(row.widget);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(3);
    auto* title = named(new QLabel(row.widget), "title");
    title->setWordWrap(true);
    auto* remove = named(new QToolButton(row.widget), "remove");
    remove->setAutoRaise(true);
    remove->setIcon(icon("close"));
    connect(remove, &QToolButton::clicked, this, [this, &def] { this->remove(def); });
    grid->addWidget(title, 0, 0, 1, 3);
    grid->addWidget(remove, 0, 3);
    addFields(row);
    auto* rows = static_cast<QVBoxLayout*>(m_list->layout());
    rows->insertWidget(rows->count() - 1, row.widget);
    row.widget->show();
    m_none->hide();
    m_rows.push_back(row);
    describe(row);
    fillPicker();
    if (row.from)
        row.from->setFocus();
    emit changed();
}

/// "from [ ] to [ ]", or that all values count.
void VariedParamsForm::addFields(Row& row)
{
    auto* grid = static_cast<QGridLayout*>(row.widget->layout());
    const ParamDef& def = *row.param.def;
    auto* between = named(new QLabel(row.widget), "between");
    if (def.type == ParamType::Bool || def.type == ParamType::Enum) {
        grid->addWidget(between, 1, 0, 1, 4);
        return;
    }
    row.from = new NumberField(row.widget);
    row.to = new NumberField(row.widget);
    for (const auto& [field, end, value] : {std::tuple(row.from, &VariedParam::from, row.param.from),
                                            {row.to, &VariedParam::to, row.param.to}}) {
        field->setRange(def.hardMin, def.hardMax);
        field->setScale(NumberScale(def.softMin, def.softMax, def.step, def.type == ParamType::Int));
        field->setValue(value);
        connect(field, &NumberField::valueEdited, this,
                [this, &def, field = field, end = end](double edited) {
                    field->setValue(edited);
                    for (Row& each : m_rows)
                        if (each.param.def == &def)
                            each.param.*end = edited;
                    emit changed();
                });
    }
    grid->addWidget(row.from, 1, 0);
    grid->addWidget(between, 1, 1);
    grid->addWidget(row.to, 1, 2, 1, 2);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(2, 1);
}

void VariedParamsForm::remove(const ParamDef& def)
{
    const auto found = std::ranges::find_if(m_rows, [&](const Row& row) { return row.param.def == &def; });
    if (found == m_rows.end())
        return;
    found->widget->hide();
    found->widget->deleteLater(); // its button is still pressed
    m_rows.erase(found);
    m_none->setVisible(m_rows.empty());
    fillPicker();
    emit changed();
}

std::vector<VariedParam> VariedParamsForm::params() const
{
    std::vector<VariedParam> out;
    for (const Row& row : m_rows)
        out.push_back(row.param);
    return out;
}

NumberField* VariedParamsForm::field(const ParamDef& def, bool upper) const
{
    for (const Row& row : m_rows)
        if (row.param.def == &def)
            return upper ? row.to : row.from;
    return nullptr;
}

void VariedParamsForm::describe(const Row& row)
{
    const ParamDef& def = *row.param.def;
    auto* title = row.widget->findChild<QLabel*>(QStringLiteral("title"));
    auto* between = row.widget->findChild<QLabel*>(QStringLiteral("between"));
    auto* remove = row.widget->findChild<QToolButton*>(QStringLiteral("remove"));
    title->setText(titleOf(def));
    title->setToolTip(coreText(def.tooltip));
    remove->setToolTip(tr("Do not vary it"));
    remove->setAccessibleName(tr("Do not vary %1").arg(titleOf(def)));
    if (!row.from)
        return between->setText(def.type == ParamType::Bool ? tr("on and off") : tr("all of its values"));
    between->setText(tr("to", "from 1 m to 2 m"));
    const NumberFormat format = numberFormat(def, m_unit);
    const QString accepted = rangeText(def, m_unit);
    for (const auto& [field, text] :
         {std::pair(row.from, tr("The least value")), {row.to, tr("The greatest value")}}) {
        field->setFormat(format);
        field->setStep(def.unit == ParamUnit::Radian && m_unit == AngleUnit::Degrees ? 1.0 / format.factor
                                                                                     : def.step);
        field->setToolTip(accepted.isEmpty() ? text : text + u'\n' + accepted);
        field->setAccessibleName(titleOf(def) + QStringLiteral(", ") + text);
    }
}

} // namespace ramure
