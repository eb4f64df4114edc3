#include "widgets/dialogs/print_form.h"

#include "widgets/base/core_text.h"
#include "widgets/base/number_field.h"
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace ramure {
namespace {

constexpr double perMetre = 1000.0; // the fields have mm

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
    , m_prepare(new QPushButton(m_rest))
    , m_report(new QLabel(m_rest))
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
    connect(m_prepare, &QPushButton::clicked, this, &PrintForm::prepareRequested);
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
    m_prepare->setObjectName(QStringLiteral("printPrepare"));
    m_report->setObjectName(QStringLiteral("printReport"));
    const PrintOptions usual;
    for (std::size_t i = 0; i < printProcesses().size(); ++i)
        m_process->addItem(QString());
    m_height->setRange(perMetre * PrintOptions::leastHeight, perMetre * PrintOptions::mostHeight);
    m_height->setDefault(perMetre * usual.height);
    m_height->setValue(perMetre * usual.height);
    m_thinnest->setRange(perMetre * PrintOptions::leastThinnest, perMetre * PrintOptions::mostThinnest);
    m_disc->setChecked(usual.hasFootDisc);
    m_heightLabel->setBuddy(m_height);
    m_thinnestLabel->setBuddy(m_thinnest);
    m_prepare->setAutoDefault(false);
    m_report->setTextFormat(Qt::PlainText);
    m_report->setWordWrap(true);
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
    auto* second = new QHBoxLayout;
    second->setSpacing(12);
    second->addWidget(m_disc);
    second->addWidget(m_prepare);
    second->addStretch(1);
    auto* rest = new QVBoxLayout(m_rest);
    rest->setContentsMargins(0, 0, 0, 0);
    rest->setSpacing(6);
    rest->addLayout(numbers);
    rest->addLayout(second);
    rest->addWidget(m_report);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(6);
    all->addWidget(m_wanted);
    all->addWidget(m_rest);
    m_report->hide();
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
    options.height = m_height->value().value_or(perMetre * options.height) / perMetre;
    options.thinnest = m_thinnest->value().value_or(0.0) / perMetre;
    options.hasFootDisc = m_disc->isChecked();
    return options;
}

void PrintForm::setOptions(const PrintOptions& options)
{
    m_process->setCurrentIndex(static_cast<int>(options.process));
    m_height->setValue(perMetre * options.height);
    m_thinnest->setValue(perMetre * options.smallestDiameter());
    m_disc->setChecked(options.hasFootDisc);
    emit changed();
}

/// Each process has its own smallest diameter.
void PrintForm::takeProcess()
{
    PrintOptions options;
    options.process = static_cast<PrintProcess>(m_process->currentIndex());
    m_thinnest->setDefault(perMetre * options.smallestDiameter());
    m_thinnest->setValue(perMetre * options.smallestDiameter());
    emit changed();
}

void PrintForm::setPrint(const PrintedTree* print)
{
    m_report->setText(print ? reportText(*print) : QString());
    m_report->setVisible(print != nullptr);
}

QString PrintForm::reportText(const PrintedTree& print) const
{
    const PrintReport& r = print.report;
    const QLocale locale;
    const auto mm = [&locale](double metres, int digits = 1) {
        return locale.toString(perMetre * metres, 'f', digits);
    };
    const glm::dvec3 size = r.size(), at = r.thinnestAt;
    QStringList lines;
    lines += tr("%1 × %2 × %3 mm, %4 cm³, 1 : %5")
                 .arg(mm(size.x), mm(size.z), mm(size.y), locale.toString(1e6 * r.volume, 'f', 1),
                      locale.toString(1.0 / print.scale, 'f', 1));
    lines +=
        tr("Thinnest place: %1 mm, at (%2, %3, %4) mm").arg(mm(r.thinnest, 2), mm(at.x), mm(-at.z), mm(at.y));
    lines += tr("Overhangs steeper than 45°: %1 cm²").arg(locale.toString(1e4 * r.overhang, 'f', 1));
    lines += r.standsUp()
                 ? tr("It stands: its weight is %1 mm inside of the foot’s border.").arg(mm(r.balance))
                 : tr("It falls over: its weight is not over the foot.");
    lines += tr("%n closed piece(s)", nullptr, static_cast<int>(r.pieces)) + QStringLiteral("  ·  ") +
             tr("%Ln triangle(s)", nullptr, static_cast<int>(r.triangles));
    lines += tr("%1 branches are thicker than their share, %2 are left out.")
                 .arg(locale.toString(print.thickened), locale.toString(print.cut));
    return lines.join(u'\n');
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
        tr("One tree, without leaves, as one closed surface that is thick enough and flat at "
           "the ground, in millimetres with Z up"));
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
    m_prepare->setText(tr("Prepare"));
    m_prepare->setToolTip(
        tr("Makes the print and says how thin it is and whether it stands; writes nothing"));
}

} // namespace ramure
