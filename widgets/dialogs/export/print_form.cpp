#include "widgets/dialogs/export/print_form.h"

#include "widgets/base/fields/number_field.h"
#include "widgets/base/progress_steps.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/icons.h"
#include "widgets/dialogs/export/print_preview.h"
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace ramure {
namespace {

} // namespace

PrintForm::PrintForm(QWidget* parent)
    : QWidget(parent)
    , m_wanted(new QCheckBox(this))
    , m_rest(new QWidget(this))
    , m_process(new QComboBox(m_rest))
    , m_heightLabel(new QLabel(m_rest))
    , m_height(new NumberField(m_rest))
    , m_thinnestLabel(new QLabel(m_rest))
    , m_thinnest(new NumberField(m_rest))
    , m_disc(new QCheckBox(m_rest))
    , m_leavesLabel(new QLabel(m_rest))
    , m_leaves(new QComboBox(m_rest))
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
    connect(m_process, &QComboBox::currentIndexChanged, this, &PrintForm::takeProcess);
    for (NumberField* field : {m_height, m_thinnest})
        connect(field, &NumberField::valueEdited, this, [this, field](double value) {
            field->setValue(value);
            emit changed();
        });
    connect(m_disc, &QCheckBox::toggled, this, &PrintForm::changed);
    connect(m_leaves, &QComboBox::currentIndexChanged, this, &PrintForm::changed);
    connect(m_prepare, &QPushButton::clicked, this, &PrintForm::prepareRequested);
    connect(m_cancel, &QToolButton::clicked, this, &PrintForm::cancelRequested);
    setFocusProxy(m_wanted);
    retranslate();
    takeProcess();
    updateWidgets();
}

void PrintForm::buildForm()
{
    m_wanted->setObjectName(QStringLiteral("printWanted"));
    m_process->setObjectName(QStringLiteral("printProcess"));
    m_height->setObjectName(QStringLiteral("printHeight"));
    m_thinnest->setObjectName(QStringLiteral("printThinnest"));
    m_disc->setObjectName(QStringLiteral("printDisc"));
    m_leaves->setObjectName(QStringLiteral("printLeaves"));
    m_prepare->setObjectName(QStringLiteral("printPrepare"));
    m_progress->setObjectName(QStringLiteral("printProgress"));
    m_cancel->setObjectName(QStringLiteral("printCancel"));
    const PrintOptions usual;
    for (std::size_t i = 0; i < printProcesses().size(); ++i)
        m_process->addItem(QString());
    m_leaves->addItems({QString(), QString()});
    m_height->setRange(mmPerMetre * PrintOptions::leastHeight, mmPerMetre * PrintOptions::mostHeight);
    m_height->setDefault(mmPerMetre * usual.height);
    m_height->setValue(mmPerMetre * usual.height);
    m_thinnest->setRange(mmPerMetre * PrintOptions::leastThinnest, mmPerMetre * PrintOptions::mostThinnest);
    m_disc->setChecked(usual.hasFootDisc);
    auto* rest = new QVBoxLayout(m_rest);
    rest->setContentsMargins(0, 0, 0, 0);
    rest->setSpacing(6);
    buildNumbers(rest);
    buildWork(rest);
    rest->addWidget(m_preview, 1);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(6);
    all->addWidget(m_wanted);
    all->addWidget(m_rest, 1);
    m_preview->hide();
    setPreparing(false);
}

void PrintForm::buildNumbers(QVBoxLayout* rest)
{
    m_heightLabel->setBuddy(m_height);
    m_thinnestLabel->setBuddy(m_thinnest);
    auto* numbers = new QHBoxLayout;
    numbers->setSpacing(6);
    numbers->addWidget(m_process);
    numbers->addSpacing(8);
    numbers->addWidget(m_heightLabel);
    numbers->addWidget(m_height);
    numbers->addSpacing(8);
    numbers->addWidget(m_thinnestLabel);
    numbers->addWidget(m_thinnest);
    numbers->addStretch(1);
    rest->addLayout(numbers);
}

/// What it stands on and carries, and the work itself.
void PrintForm::buildWork(QVBoxLayout* rest)
{
    m_leavesLabel->setBuddy(m_leaves);
    m_prepare->setAutoDefault(false);
    m_progress->setRange(0, progressSteps);
    m_progress->setTextVisible(false);
    m_cancel->setIcon(icon("cancel"));
    m_cancel->setIconSize({14, 14});
    m_cancel->setAutoRaise(true);
    auto* second = new QHBoxLayout;
    second->setSpacing(6);
    second->addWidget(m_disc);
    second->addSpacing(8);
    second->addWidget(m_leavesLabel);
    second->addWidget(m_leaves);
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
    PrintOptions options;
    options.process = static_cast<PrintProcess>(m_process->currentIndex());
    options.height = m_height->value().value_or(mmPerMetre * options.height) / mmPerMetre;
    options.thinnest = m_thinnest->value().value_or(0.0) / mmPerMetre;
    options.hasFootDisc = m_disc->isChecked();
    options.leaves = static_cast<PrintLeaves>(m_leaves->currentIndex());
    return options;
}

void PrintForm::setOptions(const PrintOptions& options)
{
    m_process->setCurrentIndex(static_cast<int>(options.process));
    m_height->setValue(mmPerMetre * options.height);
    m_thinnest->setValue(mmPerMetre * options.smallestDiameter());
    m_disc->setChecked(options.hasFootDisc);
    m_leaves->setCurrentIndex(static_cast<int>(options.leaves));
    emit changed();
}

/// Each process has its own smallest diameter.
void PrintForm::takeProcess()
{
    PrintOptions options;
    options.process = static_cast<PrintProcess>(m_process->currentIndex());
    m_thinnest->setDefault(mmPerMetre * options.smallestDiameter());
    m_thinnest->setValue(mmPerMetre * options.smallestDiameter());
    emit changed();
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

void PrintForm::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void PrintForm::retranslate()
{
    m_wanted->setText(tr("Make ready for a printer"));
    m_wanted->setToolTip(
        tr("One tree as one closed surface that is thick enough and flat at the ground, in millimetres "
           "with Z up"));
    for (std::size_t i = 0; i < printProcesses().size(); ++i)
        m_process->setItemText(static_cast<int>(i), coreText(printProcesses()[i].title));
    m_process->setToolTip(tr("How the printer works: it says how thin a twig may be"));
    m_process->setAccessibleName(tr("Process"));
    m_heightLabel->setText(tr("Height, mm"));
    m_height->setToolTip(tr("From the ground to the top of the print"));
    m_height->setAccessibleName(tr("Height of the print in millimetres"));
    m_thinnestLabel->setText(tr("Thinnest twig, mm"));
    m_thinnest->setToolTip(
        tr("Thinner twigs are made so thick. Those that would have to be more than 1.5 times "
           "as thick as they are are cut."));
    m_thinnest->setAccessibleName(tr("Smallest diameter of a twig in millimetres"));
    m_disc->setText(tr("Disc as a foot"));
    m_disc->setToolTip(tr("Without it the trunk is cut flat at the ground"));
    m_leavesLabel->setText(tr("Leaves"));
    m_leaves->setItemText(static_cast<int>(PrintLeaves::Off), tr("None"));
    m_leaves->setItemText(static_cast<int>(PrintLeaves::Shells), tr("Thick shells"));
    m_leaves->setToolTip(
        tr("Thick shells: each leaf is as thick as the thinnest twig and in one piece with its own. Small "
           "leaves are enlarged and fewer. Fruit stays off."));
    m_leaves->setAccessibleName(tr("Leaves of the print"));
    m_prepare->setText(tr("Prepare"));
    m_prepare->setToolTip(
        tr("Makes the print, shows it and says how thin it is and whether it stands; writes nothing"));
    m_progress->setAccessibleName(tr("Preparing the print"));
    m_progress->setToolTip(m_progress->accessibleName());
    m_cancel->setToolTip(tr("Give this up"));
    m_cancel->setAccessibleName(tr("Cancel"));
}

} // namespace ramure
