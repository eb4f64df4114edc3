#include "widgets/panels/inspector/section_browser.h"

#include "widgets/base/fields/number_field.h"
#include "widgets/base/named.h"
#include "widgets/base/theme/icons.h"
#include "widgets/panels/inspector/fact_form.h"
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace ramure {
namespace {

constexpr int firstFormColumn = SectionModel::ParameterColumn; ///< the section's number stands in the stepper
constexpr int formDecimals = 3; ///< of vectors: what fits beside the names in a narrow dock
constexpr int leastSlider = 60; ///< pixels, to be moved at all
constexpr int rowsInSight = 4;  ///< at least

} // namespace

bool SectionTable::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
        event->accept();
        return true;
    }
    return QTableView::event(event);
}

void SectionTable::keyPressEvent(QKeyEvent* event)
{
    if (!event->matches(QKeySequence::Copy))
        return QTableView::keyPressEvent(event);
    emit copyRequested();
    event->accept();
}

SectionBrowser::SectionBrowser(QWidget* parent)
    : QWidget(parent)
    , m_model(new SectionModel(this))
{
    layoutOf<QVBoxLayout>(this, 6);
    buildStepper();
    m_form = new FactForm(SectionModel::columnTotal - firstFormColumn, this);
    buildTable();
    m_slider->setAccessibleName(tr("Section, slider"));
    m_field->setAccessibleName(tr("Section"));
    const QString help = tr("Steps through the sections. The viewport shows the section's plane and frame.");
    m_slider->setToolTip(help);
    m_field->setToolTip(help);
    m_copy->setAccessibleName(tr("Copy as CSV"));
    m_copy->setToolTip(
        tr("Copies all sections as comma-separated values for a spreadsheet. Ctrl+C in the table does "
           "the same, or copies the selected rows where there are several."));
    m_table->setAccessibleName(tr("All sections"));
    for (int row = 0; row < m_form->rowCount(); ++row)
        m_form->setName(row, SectionModel::columnName(firstFormColumn + row),
                        SectionModel::columnHelp(firstFormColumn + row));
    fitColumns();
    setFacts({});
}

void SectionBrowser::buildStepper()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    auto* title = new QLabel(tr("Section"), this);
    m_slider = named(new QSlider(Qt::Horizontal, this), "sectionSlider");
    m_slider->setPageStep(1);
    m_slider->setMinimumWidth(leastSlider);
    m_field = named(new NumberField(this), "sectionField");
    NumberFormat whole;
    whole.whole = true;
    whole.decimals = 0;
    m_field->setFormat(whole);
    m_field->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_field->setMaximumWidth(m_field->fontMetrics().horizontalAdvance(QStringLiteral("0000")) + 20);
    m_total = new QLabel(this);
    title->setBuddy(m_field);
    row->addWidget(title);
    row->addWidget(m_slider, 1);
    row->addWidget(m_field);
    row->addWidget(m_total);
    m_copy = named(new QToolButton(this), "copyCsv");
    m_copy->setIcon(icon("copy"));
    m_copy->setAutoRaise(true);
    row->addWidget(m_copy);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    connect(m_slider, &QSlider::valueChanged, this, &SectionBrowser::setCurrentSection);
    connect(m_field, &NumberField::valueEdited, this,
            [this](double number) { setCurrentSection(static_cast<int>(number) - 1); });
    for (const auto signal : {&NumberField::held, &NumberField::refused})
        connect(m_field, signal, this, &SectionBrowser::messageRaised);
}

void SectionBrowser::buildTable()
{
    m_table = named(new SectionTable(this), "sectionTable");
    m_table->setModel(m_model);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setWordWrap(false);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 6);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->setMinimumHeight((rowsInSight + 1) * m_table->verticalHeader()->defaultSectionSize());
    static_cast<QVBoxLayout*>(layout())->addWidget(m_table, 1);
    connect(m_copy, &QToolButton::clicked, this, [this] { copyCsv(false); });
    connect(m_table, &SectionTable::copyRequested, this, [this] { copyCsv(true); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) {
                if (current.isValid() && !m_showing)
                    setCurrentSection(current.row());
            });
}

void SectionBrowser::setFacts(std::vector<SectionFacts> facts)
{
    const bool first = m_model->facts().empty() && !facts.empty();
    m_showing = true; // rows that go may take the current one with them
    m_model->setFacts(std::move(facts));
    m_showing = false;
    if (first)
        fitColumns();
    showCurrent();
}

int SectionBrowser::currentSection() const
{
    return std::min(m_chosen, m_model->rowCount() - 1);
}

void SectionBrowser::setCurrentSection(int section)
{
    if (m_showing || m_model->facts().empty())
        return;
    const int before = currentSection();
    m_chosen = std::clamp(section, 0, m_model->rowCount() - 1);
    showCurrent();
    if (m_chosen != before)
        emit currentSectionChanged(m_chosen);
}

void SectionBrowser::showCurrent()
{
    const int current = currentSection(), count = m_model->rowCount();
    m_showing = true;
    m_slider->setRange(0, std::max(0, count - 1));
    m_slider->setValue(std::max(0, current));
    m_field->setRange(1.0, std::max(1, count));
    m_field->setValue(current + 1.0);
    m_total->setText(tr("of %1").arg(count));
    if (current >= 0 && m_table->currentIndex().row() != current)
        m_table->setCurrentIndex(m_model->index(current, std::max(0, m_table->currentIndex().column())));
    m_showing = false;
    setEnabled(count > 0);
    for (int row = 0; row < m_form->rowCount(); ++row)
        m_form->setValue(row, current < 0
                                  ? QString()
                                  : SectionModel::valueText(facts()[static_cast<std::size_t>(current)],
                                                            firstFormColumn + row, m_unit, formDecimals));
}

void SectionBrowser::fitColumns()
{
    m_table->resizeColumnsToContents();
    // Room for a minus sign and another digit, so that columns do not jump while a tree is being shaped.
    const int room = m_table->fontMetrics().horizontalAdvance(QStringLiteral("−00"));
    for (int column = 0; column < m_model->columnCount(); ++column)
        m_table->setColumnWidth(column, m_table->columnWidth(column) + room);
}

void SectionBrowser::setAngleUnit(AngleUnit unit)
{
    m_unit = unit;
    m_model->setAngleUnit(unit);
    fitColumns();
    showCurrent();
}

void SectionBrowser::copyCsv(bool selectedRowsOnly)
{
    std::vector<SectionFacts> rows;
    if (selectedRowsOnly)
        for (int row = 0; row < m_model->rowCount(); ++row)
            if (m_table->selectionModel()->isRowSelected(row))
                rows.push_back(facts()[static_cast<std::size_t>(row)]);
    if (rows.size() < 2)
        rows = facts();
    if (rows.empty())
        return;
    QGuiApplication::clipboard()->setText(QString::fromStdString(sectionsCsv(rows)));
    emit messageRaised(tr("%n section(s) copied as CSV", nullptr, static_cast<int>(rows.size())));
}

} // namespace ramure
