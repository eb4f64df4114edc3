#include "widgets/dialogs/moment_form.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSpinBox>
#include <QStandardItemModel>
#include <algorithm>

namespace ramure {

static constexpr int leastTurns = 2, mostTurns = 10'000, usualTurns = 72;

static QSpinBox* frameBox(std::int64_t value, int least, QWidget* parent)
{
    auto* box = new QSpinBox(parent);
    box->setRange(least, static_cast<int>(mostFrame));
    box->setValue(static_cast<int>(std::clamp<std::int64_t>(value, least, mostFrame)));
    return box;
}

MomentForm::MomentForm(const TimelineSettings& timeline, std::int64_t shown, QWidget* parent)
    : QWidget(parent)
    , m_timeline(timeline)
    , m_shown(std::max<std::int64_t>(shown, 0))
    , m_moment(new QComboBox(this))
    , m_range(new QWidget(this))
    , m_first(frameBox(timeline.firstFrame, 0, m_range))
    , m_last(frameBox(timeline.lastFrame, 0, m_range))
    , m_step(frameBox(1, 1, m_range))
    , m_turns(new QSpinBox(this))
    , m_dash(new QLabel(QStringLiteral("–"), m_range))
    , m_stepLabel(new QLabel(m_range))
    , m_rate(new QLabel(m_range))
{
    m_moment->setObjectName(QStringLiteral("exportMoment"));
    m_first->setObjectName(QStringLiteral("firstFrame"));
    m_last->setObjectName(QStringLiteral("lastFrame"));
    m_step->setObjectName(QStringLiteral("frameStep"));
    m_turns->setObjectName(QStringLiteral("turns"));
    m_rate->setObjectName(QStringLiteral("dim"));
    m_turns->setRange(leastTurns, mostTurns);
    m_turns->setValue(usualTurns);
    for (int i = 0; i < 4; ++i)
        m_moment->addItem(QString());
    auto* row = new QHBoxLayout(m_range);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(m_first);
    row->addWidget(m_dash);
    row->addWidget(m_last);
    row->addSpacing(8);
    row->addWidget(m_stepLabel);
    row->addWidget(m_step);
    row->addSpacing(8);
    row->addWidget(m_rate);
    row->addStretch(1);
    m_stepLabel->setBuddy(m_step);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(m_moment);
    column->addWidget(m_range);
    column->addWidget(m_turns, 0, Qt::AlignLeft);
    connect(m_moment, &QComboBox::currentIndexChanged, this, &MomentForm::update);
    for (QSpinBox* box : {m_first, m_last, m_step, m_turns})
        connect(box, &QSpinBox::valueChanged, this, &MomentForm::changed);
    setFocusProxy(m_moment);
    retranslate();
    setPictures(false);
}

void MomentForm::setPictures(bool pictures)
{
    m_pictures = pictures;
    auto* items = qobject_cast<QStandardItemModel*>(m_moment->model());
    items->item(static_cast<int>(ExportMoment::Turntable))->setEnabled(pictures);
    if (!pictures && moment() == ExportMoment::Turntable)
        setMoment(ExportMoment::Rest);
    update();
}

void MomentForm::setMoment(ExportMoment moment)
{
    m_moment->setCurrentIndex(static_cast<int>(moment));
}

ExportMoment MomentForm::moment() const
{
    return static_cast<ExportMoment>(m_moment->currentIndex());
}

FrameSequence MomentForm::frames() const
{
    const double rate = m_timeline.framesPerSecond;
    if (moment() == ExportMoment::Sequence)
        return {m_first->value(), m_last->value(), m_step->value(), rate};
    const std::int64_t frame = moment() == ExportMoment::Rest ? 0 : m_shown;
    return {frame, frame, 1, rate};
}

double MomentForm::timeSeconds() const
{
    return moment() == ExportMoment::Rest ? 0.0 : m_timeline.timeOf(m_shown);
}

int MomentForm::turns() const
{
    return m_turns->value();
}

bool MomentForm::isNumbered() const
{
    return moment() == ExportMoment::Sequence || moment() == ExportMoment::Turntable;
}

void MomentForm::update()
{
    m_range->setVisible(moment() == ExportMoment::Sequence);
    m_turns->setVisible(moment() == ExportMoment::Turntable);
    emit changed();
}

void MomentForm::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void MomentForm::retranslate()
{
    const QLocale locale;
    m_moment->setItemText(0, tr("At rest, as at frame 0"));
    m_moment->setItemText(1, tr("The frame on show, %1").arg(m_shown));
    m_moment->setItemText(2, tr("A sequence of frames"));
    m_moment->setItemText(3, tr("A turn around the tree (pictures)"));
    m_moment->setAccessibleName(tr("Moment"));
    m_first->setToolTip(tr("First frame that is written"));
    m_last->setToolTip(tr("Last frame that is written"));
    m_first->setAccessibleName(tr("First frame"));
    m_last->setAccessibleName(tr("Last frame"));
    m_stepLabel->setText(tr("every"));
    m_step->setToolTip(tr("Frames from one file to the next: 1 writes all"));
    m_rate->setText(tr("at %1 fps").arg(locale.toString(m_timeline.framesPerSecond)));
    m_turns->setSuffix(tr(" pictures"));
    m_turns->setToolTip(tr(
        "Pictures all around, 2 to 10000, from the slope of the view and as near as the whole crown allows"));
    m_turns->setAccessibleName(tr("Pictures all around"));
}

} // namespace ramure
