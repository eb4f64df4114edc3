#include "widgets/dialogs/export/print_form.h"

#include "widgets/base/fields/number_field.h"
#include "widgets/base/named.h"
#include "widgets/base/progress_steps.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/dialogs/export/option_fields.h"
#include "widgets/dialogs/export/print_preview.h"
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace ramure {

PrintForm::PrintForm(OptionFields* fields, QWidget* parent)
    : QWidget(parent)
    , m_wanted(new QCheckBox(this))
    , m_rest(new QWidget(this))
    , m_fields(fields)
    , m_prepare(new QPushButton(m_rest))
    , m_progress(new QProgressBar(m_rest))
    , m_cancel(new QToolButton(m_rest))
    , m_preview(new PrintPreview(m_rest))
{
    buildForm();
    connect(m_wanted, &QCheckBox::toggled, this, [this] {
        updateWidgets();
        emit changed();
    });
    connect(m_fields, &OptionFields::changed, this, [this](const ExportOption& option) {
        if (std::string_view(option.key) == "process")
            takeProcess();
        if (option.is(ofPrint))
            emit changed();
    });
    connect(m_prepare, &QPushButton::clicked, this, &PrintForm::prepareRequested);
    connect(m_cancel, &QToolButton::clicked, this, &PrintForm::cancelRequested);
    setFocusProxy(m_wanted);
    setTexts();
    takeProcess();
    updateWidgets();
}

void PrintForm::buildForm()
{
    m_wanted->setObjectName(QStringLiteral("printWanted"));
    m_prepare->setObjectName(QStringLiteral("printPrepare"));
    m_progress->setObjectName(QStringLiteral("printProgress"));
    m_cancel->setObjectName(QStringLiteral("printCancel"));
    auto* rest = layoutOf<QVBoxLayout>(m_rest, 6);
    buildNumbers(rest);
    buildWork(rest);
    rest->addWidget(m_preview, 1);
    auto* all = layoutOf<QVBoxLayout>(this, 6);
    all->addWidget(m_wanted);
    all->addWidget(m_rest, 1);
    m_preview->hide();
    setPreparing(false);
}

void PrintForm::addField(QHBoxLayout* row, const char* key, bool hasLabel)
{
    QWidget* field = m_fields->make(key, m_rest);
    if (hasLabel) {
        auto* label = new QLabel(m_rest);
        label->setBuddy(field);
        row->addSpacing(8);
        row->addWidget(label);
        m_labels.emplace_back(key, label);
    }
    row->addWidget(field);
}

void PrintForm::buildNumbers(QVBoxLayout* rest)
{
    auto* numbers = new QHBoxLayout;
    numbers->setSpacing(6);
    addField(numbers, "process", false);
    addField(numbers, "height", true);
    addField(numbers, "thinnest", true);
    numbers->addStretch(1);
    rest->addLayout(numbers);
}

/// What it stands on and carries, and the work itself.
void PrintForm::buildWork(QVBoxLayout* rest)
{
    m_prepare->setAutoDefault(false);
    m_progress->setRange(0, progressSteps);
    m_progress->setTextVisible(false);
    m_cancel->setIcon(icon("cancel"));
    m_cancel->setIconSize({14, 14});
    m_cancel->setAutoRaise(true);
    auto* second = new QHBoxLayout;
    second->setSpacing(6);
    addField(second, "disc", false);
    addField(second, "shells", true);
    second->addSpacing(8);
    second->addWidget(m_prepare);
    second->addWidget(m_progress, 1);
    second->addWidget(m_cancel);
    second->addStretch(0);
    rest->addLayout(second);
}

bool PrintForm::isWanted() const
{
    return m_wanted->isChecked();
}

void PrintForm::setWanted(bool wanted)
{
    m_wanted->setChecked(wanted);
}

PrintOptions PrintForm::options() const
{
    return m_fields->options().print;
}

void PrintForm::setOptions(const PrintOptions& options)
{
    ExportOptions all;
    all.print = options;
    all.print.thinnest = options.smallestDiameter();
    m_fields->set(all, ofPrint);
    emit changed();
}

/// Each process has its own smallest diameter.
void PrintForm::takeProcess()
{
    PrintOptions usual;
    usual.process = options().process;
    auto* thinnest = m_fields->of<NumberField>("thinnest");
    thinnest->setDefault(mmPerMetre * usual.smallestDiameter());
    thinnest->setValue(mmPerMetre * usual.smallestDiameter());
}

void PrintForm::setPrint(std::shared_ptr<const PrintedTree> print)
{
    const bool isThere = print != nullptr;
    m_preview->setPrint(std::move(print), options());
    m_preview->setVisible(isThere);
}

void PrintForm::setPreparing(bool preparing)
{
    if (preparing && m_progress->isHidden())
        m_progress->setValue(0);
    m_progress->setVisible(preparing);
    m_cancel->setVisible(preparing);
}

void PrintForm::setMayPrepare(bool may)
{
    m_prepare->setEnabled(may);
}

void PrintForm::setProgress(double fraction)
{
    m_progress->setValue(static_cast<int>(fraction * progressSteps));
}

void PrintForm::updateWidgets()
{
    m_rest->setVisible(m_wanted->isChecked());
}

void PrintForm::setTexts()
{
    m_wanted->setText(tr("Make ready for a printer"));
    m_wanted->setToolTip(
        tr("One tree as one closed surface that is thick enough and flat at the ground, in millimetres "
           "with Z up"));
    for (const auto& [key, label] : m_labels)
        label->setText(coreText(optionOfKey(key).label));
    m_prepare->setText(tr("Prepare"));
    m_prepare->setToolTip(
        tr("Makes the print, shows it and says how thin it is and whether it stands; writes nothing"));
    m_progress->setAccessibleName(tr("Preparing the print"));
    m_progress->setToolTip(m_progress->accessibleName());
    m_cancel->setToolTip(tr("Give this up"));
    m_cancel->setAccessibleName(tr("Cancel"));
}

} // namespace ramure
