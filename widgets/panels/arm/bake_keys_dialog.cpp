#include "widgets/panels/arm/bake_keys_dialog.h"

#include "widgets/base/fields/number_field.h"
#include "widgets/base/named.h"
#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>
#include <numbers>

namespace ramure {

static QSpinBox* frameBox(std::int64_t value, std::int64_t least, const char* name, QWidget* parent)
{
    auto* box = new QSpinBox(parent);
    box->setObjectName(QLatin1String(name));
    box->setRange(static_cast<int>(least), static_cast<int>(mostFrame));
    box->setValue(static_cast<int>(std::clamp(value, least, mostFrame)));
    return box;
}

BakeKeysDialog::BakeKeysDialog(const QString& arm, const TimelineSettings& timeline,
                               const ArmBakeOptions& options, QWidget* parent)
    : QDialog(parent)
    , m_timeline(timeline)
    , m_whole(named(new QPushButton(this), "wholeTimeline"))
    , m_tolerance(new NumberField(this))
    , m_target(new QCheckBox(this))
    , m_note(named(new QLabel(this), "bakeNote"))
    , m_bake(named(new QPushButton(this), "bake"))
    , m_cancel(new QPushButton(this))
{
    const ArmBakeRange range =
        options.range.value_or(ArmBakeRange{timeline.firstFrame, timeline.lastFrame, 1});
    m_first = frameBox(range.firstFrame, leastFrame, "firstFrame", this);
    m_last = frameBox(range.lastFrame, leastFrame, "lastFrame", this);
    m_every = frameBox(range.every, 1, "everyFrame", this);
    m_whole->setAutoDefault(false);
    m_tolerance->setRange(0.0, std::numbers::pi);
    m_tolerance->setStep(0.1 * std::numbers::pi / 180.0);
    m_tolerance->setValue(options.toleranceRad);
    m_target->setChecked(options.target);
    m_note->setWordWrap(true);
    m_bake->setDefault(true);
    m_cancel->setAutoDefault(false);
    layOut(arm);
    setTexts();
    for (QSpinBox* box : {m_first, m_last, m_every})
        connect(box, &QSpinBox::valueChanged, this, &BakeKeysDialog::update);
    connect(m_tolerance, &NumberField::valueEdited, this, [this](double value) {
        m_tolerance->setValue(value);
        update();
    });
    connect(m_whole, &QPushButton::clicked, this, [this] {
        m_first->setValue(static_cast<int>(m_timeline.firstFrame));
        m_last->setValue(static_cast<int>(m_timeline.lastFrame));
    });
    connect(m_bake, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::reject);
    update();
    m_first->setFocus();
    m_first->selectAll();
}

void BakeKeysDialog::layOut(const QString& arm)
{
    setWindowTitle(tr("Bake \"%1\" to keys").arg(arm));
    auto* range = new QHBoxLayout;
    range->setSpacing(6);
    range->addWidget(m_first);
    range->addWidget(new QLabel(QStringLiteral("–"), this));
    range->addWidget(m_last);
    range->addWidget(m_whole);
    range->addStretch(1);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(8);
    form->addRow(tr("&Frames"), range);
    static_cast<QLabel*>(form->labelForField(range))->setBuddy(m_first);
    form->addRow(tr("&A key every"), m_every);
    form->addRow(tr("&Tolerance"), m_tolerance);
    form->addRow(QString(), m_target);
    m_every->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_tolerance->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    for (QWidget* field : {static_cast<QWidget*>(m_every), static_cast<QWidget*>(m_tolerance)})
        field->setMinimumWidth(110);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_bake);
    buttons->addWidget(m_cancel);
    auto* outer = layoutOf<QVBoxLayout>(this, 12, {18, 18, 18, 14});
    outer->addLayout(form);
    outer->addWidget(m_note);
    outer->addStretch(1);
    outer->addLayout(buttons);
    m_note->setMinimumWidth(380);
}

void BakeKeysDialog::setTexts()
{
    m_first->setToolTip(tr("First frame that gets a key"));
    m_last->setToolTip(tr("Last frame that gets a key, whatever the step"));
    m_first->setAccessibleName(tr("First frame"));
    m_last->setAccessibleName(tr("Last frame"));
    m_whole->setText(tr("Whole timeline"));
    m_whole->setToolTip(tr("Frames %1 to %2").arg(m_timeline.firstFrame).arg(m_timeline.lastFrame));
    m_every->setToolTip(tr("Frames from one key to the next: 1 gives each a key; between keys the angles go "
                           "straight"));
    m_every->setAccessibleName(tr("Frames from one key to the next"));
    NumberFormat degrees;
    degrees.unit = ParamUnit::Radian;
    degrees.factor = 180.0 / std::numbers::pi;
    degrees.suffix = tr("°");
    m_tolerance->setFormat(degrees);
    m_tolerance->setToolTip(
        tr("Keys that a straight line comes as near to are left out, degrees; 0 keeps all"));
    m_tolerance->setAccessibleName(tr("Tolerance"));
    m_target->setText(tr("The target &gets a key too"));
    m_target->setToolTip(tr("If the target has no keys yet. It then stays in place, as during the baking"));
    m_bake->setText(tr("&Bake"));
    m_cancel->setText(tr("Cancel"));
}

ArmBakeOptions BakeKeysDialog::options() const
{
    ArmBakeOptions options;
    options.toleranceRad = m_tolerance->value().value_or(0.0);
    options.target = m_target->isChecked();
    options.range = ArmBakeRange{m_first->value(), m_last->value(), m_every->value()};
    return options;
}

/// How many keys it will be, or why it cannot be done.
void BakeKeysDialog::update()
{
    const ArmBakeRange range = *options().range;
    const bool good = range.lastFrame >= range.firstFrame;
    m_bake->setEnabled(good);
    m_every->setSuffix(range.every == 1 ? tr(" frame") : tr(" frames"));
    const std::int64_t keys = (range.lastFrame - range.firstFrame + range.every - 1) / range.every + 1;
    const bool thinned = m_tolerance->value().value_or(0.0) > 0.0;
    const int count = static_cast<int>(keys);
    m_note->setText(
        !good ? tr("The last frame stands before the first one.")
        : thinned
            ? tr("At most %n key(s) for each angle. Then the arm follows its keys, no target.", nullptr,
                 count)
            : tr("%n key(s) for each angle. Then the arm follows its keys, no target.", nullptr, count));
}

} // namespace ramure
