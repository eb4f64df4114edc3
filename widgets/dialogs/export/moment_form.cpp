#include "widgets/dialogs/export/moment_form.h"

#include "widgets/base/named.h"
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSpinBox>
#include <QStandardItemModel>
#include <algorithm>
#include <cmath>

namespace ramure {

/// s: the wind has taken hold of what was at rest; as the command line has it.
static constexpr double settled = 2.0;
static constexpr double leastLoop = 0.1, mostLoop = 60.0, usualLoop = 4.0;
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
    , m_moment(named(new QComboBox(this), "exportMoment"))
    , m_range(new QWidget(this))
    , m_first(named(frameBox(timeline.firstFrame, 0, m_range), "firstFrame"))
    , m_last(named(frameBox(timeline.lastFrame, 0, m_range), "lastFrame"))
    , m_step(named(frameBox(1, 1, m_range), "frameStep"))
    , m_turns(named(new QSpinBox(this), "turns"))
    , m_seconds(named(new QDoubleSpinBox(this), "loopSeconds"))
    , m_dash(new QLabel(QStringLiteral("–"), m_range))
    , m_stepLabel(new QLabel(m_range))
    , m_rate(named(new QLabel(m_range), "dim"))
{
    m_seconds->setRange(leastLoop, mostLoop);
    m_seconds->setDecimals(1);
    m_seconds->setValue(usualLoop);
    m_turns->setRange(leastTurns, mostTurns);
    m_turns->setValue(usualTurns);
    for (int i = 0; i < 5; ++i)
        m_moment->addItem(QString());
    auto* row = layoutOf<QHBoxLayout>(m_range, 6);
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
    auto* column = layoutOf<QVBoxLayout>(this, 6);
    column->addWidget(m_moment);
    column->addWidget(m_range);
    column->addWidget(m_turns, 0, Qt::AlignLeft);
    column->addWidget(m_seconds, 0, Qt::AlignLeft);
    connect(m_seconds, &QDoubleSpinBox::valueChanged, this, &MomentForm::changed);
    connect(m_moment, &QComboBox::currentIndexChanged, this, &MomentForm::update);
    for (QSpinBox* box : {m_first, m_last, m_step, m_turns})
        connect(box, &QSpinBox::valueChanged, this, &MomentForm::changed);
    setFocusProxy(m_moment);
    setTexts();
    setClips(false);
    setPictures(false);
}

void MomentForm::setPictures(bool pictures)
{
    m_pictures = pictures;
    enableMoment(ExportMoment::Turntable, pictures);
}

void MomentForm::setClips(bool clips)
{
    enableMoment(ExportMoment::WindLoop, clips);
}

/// What cannot be had any more is not kept as the choice.
void MomentForm::enableMoment(ExportMoment which, bool enabled)
{
    auto* items = qobject_cast<QStandardItemModel*>(m_moment->model());
    items->item(static_cast<int>(which))->setEnabled(enabled);
    if (!enabled && moment() == which)
        setMoment(ExportMoment::Rest);
    update();
}

void MomentForm::setFrames(int first, int last, int step)
{
    m_first->setValue(first);
    m_last->setValue(last);
    m_step->setValue(step);
}

void MomentForm::setTurns(int turns)
{
    m_turns->setValue(turns);
}

void MomentForm::setLoopSeconds(double seconds)
{
    m_seconds->setValue(seconds);
}

double MomentForm::loopSeconds() const
{
    return m_seconds->value();
}

std::optional<TimelineSettings> MomentForm::loop() const
{
    if (moment() != ExportMoment::WindLoop)
        return std::nullopt;
    const FrameSequence all = frames();
    return TimelineSettings{m_timeline.framesPerSecond, all.first, all.last - 1, PlayLoop::Loop, true};
}

void MomentForm::setMoment(ExportMoment moment)
{
    m_moment->setCurrentIndex(static_cast<int>(moment));
}

ExportMoment MomentForm::moment() const
{
    return static_cast<ExportMoment>(m_moment->currentIndex());
}

FrameSequence MomentForm::range() const
{
    return {m_first->value(), m_last->value(), m_step->value(), m_timeline.framesPerSecond};
}

FrameSequence MomentForm::frames() const
{
    const double rate = m_timeline.framesPerSecond;
    if (moment() == ExportMoment::Sequence)
        return range();
    if (moment() == ExportMoment::WindLoop) { // its frames and the first one again
        const auto first = static_cast<std::int64_t>(std::ceil(settled * rate));
        return {first, first + std::max<std::int64_t>(2, std::llround(loopSeconds() * rate)), 1, rate};
    }
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
    m_seconds->setVisible(moment() == ExportMoment::WindLoop);
    emit changed();
}

void MomentForm::setTexts()
{
    const QLocale locale;
    m_moment->setItemText(0, tr("At rest, as at frame 0"));
    m_moment->setItemText(1, tr("The frame on show, %1").arg(m_shown));
    m_moment->setItemText(2, tr("A sequence of frames"));
    m_moment->setItemText(3, tr("A turn around the tree (pictures)"));
    m_moment->setItemText(4, tr("A loop of wind without a seam (GLB)"));
    m_moment->setAccessibleName(tr("Moment"));
    m_first->setToolTip(tr("First frame that is written"));
    m_last->setToolTip(tr("Last frame that is written"));
    m_first->setAccessibleName(tr("First frame"));
    m_last->setAccessibleName(tr("Last frame"));
    m_stepLabel->setText(tr("every"));
    m_step->setToolTip(tr("Frames from one file to the next: 1 writes all"));
    m_rate->setText(tr("at %1 fps").arg(locale.toString(m_timeline.framesPerSecond)));
    m_seconds->setSuffix(tr(" s"));
    m_seconds->setToolTip(
        tr("Length of the loop in seconds, 0.1 to 60: the last frame is the first one again, and the "
           "motion goes on without a seam"));
    m_seconds->setAccessibleName(tr("Length of the loop"));
    m_turns->setSuffix(tr(" pictures"));
    m_turns->setToolTip(tr(
        "Pictures all around, 2 to 10000, from the slope of the view and as near as the whole crown allows"));
    m_turns->setAccessibleName(tr("Pictures all around"));
}

} // namespace ramure
