#include "widgets/base/timeline_ruler.h"

#include "widgets/base/theme/theme.h"
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr int margin = 14;    ///< left and right, logical pixels
constexpr int bandHeight = 6; ///< at the bottom
constexpr int handleReach = 6;
constexpr double leastShown = 4.0; ///< frames over the whole width, at the strongest zoom

/// Steps that are easy to count: 1, 2, 5, 10 ... frames, or whole seconds and minutes.
double tickStep(double least, double framesPerSecond, TimeDisplay display)
{
    std::vector<double> steps{1,   2,   5,   10,  20,  50,  100, 200, 500, 1e3,
                              2e3, 5e3, 1e4, 2e4, 5e4, 1e5, 2e5, 5e5, 1e6};
    if (display != TimeDisplay::Frames) {
        steps = {1, 2, 5};
        for (const double seconds :
             {0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0, 3600.0, 7200.0})
            if (seconds * framesPerSecond > 5.0)
                steps.push_back(std::round(seconds * framesPerSecond));
    }
    const auto enough =
        std::find_if(steps.begin(), steps.end(), [least](double step) { return step >= least; });
    return enough == steps.end() ? steps.back() : *enough;
}

} // namespace

TimelineRuler::TimelineRuler(QWidget* parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("timelineRuler"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Timeline ruler"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_edgeScroll.setInterval(30);
    connect(&m_edgeScroll, &QTimer::timeout, this, [this] {
        const double beyond =
            m_dragX < margin ? m_dragX - margin : std::max(0.0, m_dragX - (width() - margin));
        const double frames = beyond / pixelsPerFrame() * 0.15;
        setView(m_from + frames, m_to + frames);
        dragTo(m_dragX);
    });
    fit();
}

QSize TimelineRuler::sizeHint() const
{
    return {400, 2 * fontMetrics().height() + bandHeight + 8};
}

QSize TimelineRuler::minimumSizeHint() const
{
    return {160, sizeHint().height()};
}

void TimelineRuler::setTimeline(const TimelineSettings& settings)
{
    m_timeline = settings;
    if (!m_zoomed && m_drag == Drag::None)
        fit();
    update();
}

void TimelineRuler::setFrame(qint64 frame)
{
    if (frame == m_frame)
        return;
    m_frame = frame;
    // Playing past the edge of a zoomed view turns the page.
    if (m_zoomed && m_drag == Drag::None && (double(frame) < m_from || double(frame) > m_to)) {
        const double span = m_to - m_from;
        setView(double(frame) - 0.1 * span, double(frame) + 0.9 * span);
    }
    update();
}

void TimelineRuler::setBand(std::vector<FrameRange> band)
{
    m_band = std::move(band);
    update();
}

void TimelineRuler::setDisplay(TimeDisplay display)
{
    m_display = display;
    update();
}

void TimelineRuler::setKeys(std::vector<double> frames)
{
    if (frames == m_keys)
        return;
    m_keys = std::move(frames);
    update();
}

bool TimelineRuler::hasKeyAt(qint64 frame) const
{
    const auto near = std::ranges::lower_bound(m_keys, double(frame) - 0.5);
    return near != m_keys.end() && *near < double(frame) + 0.5;
}

void TimelineRuler::fit()
{
    m_zoomed = false;
    const double first = double(m_timeline.firstFrame), last = double(m_timeline.lastFrame);
    const double pad = std::max(1.0, 0.02 * (last - first));
    setView(first - pad, last + pad);
}

void TimelineRuler::setView(double from, double to)
{
    const double span = std::clamp(to - from, leastShown, 4.0 * double(mostFrame));
    m_from = std::clamp(from, 2.0 * double(leastFrame), 2.0 * double(mostFrame) - span);
    m_to = m_from + span;
    update();
    emit viewChanged();
}

void TimelineRuler::showFrames(double from, double to)
{
    m_zoomed = true;
    setView(from, to);
}

void TimelineRuler::zoomAbout(double frame, double factor)
{
    showFrames(frame - (frame - m_from) * factor, frame + (m_to - frame) * factor);
}

void TimelineRuler::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    emit viewChanged();
}

double TimelineRuler::pixelsPerFrame() const
{
    return std::max(1.0, double(width() - 2 * margin)) / (m_to - m_from);
}

double TimelineRuler::xOf(double frame) const
{
    return margin + (frame - m_from) * pixelsPerFrame();
}

double TimelineRuler::framesAt(double x) const
{
    return m_from + (x - margin) / pixelsPerFrame();
}

qint64 TimelineRuler::frameAt(double x) const
{
    return std::llround(std::clamp(framesAt(x), double(leastFrame), double(mostFrame)));
}

QString TimelineRuler::labelOf(qint64 frame) const
{
    if (m_display != TimeDisplay::Seconds)
        return timeText(frame, m_timeline.framesPerSecond, m_display);
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const double seconds = double(frame) / m_timeline.framesPerSecond;
    return locale.toString(seconds, 'f', seconds == std::floor(seconds) ? 0 : 2) + QStringLiteral(" s");
}

void TimelineRuler::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    paintRange(painter);
    paintTicks(painter);
    paintBand(painter);
    paintKeys(painter);
    paintPlayhead(painter);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

/// What lies outside the range is darker; its ends have handles.
void TimelineRuler::paintRange(QPainter& painter) const
{
    const QColor outside =
        blended(palette().color(QPalette::Base), palette().color(QPalette::WindowText), 0.10);
    const double left = xOf(double(m_timeline.firstFrame)), right = xOf(double(m_timeline.lastFrame));
    painter.fillRect(QRectF(0.0, 0.0, std::max(0.0, left), height()), outside);
    painter.fillRect(QRectF(right, 0.0, std::max(0.0, width() - right), height()), outside);
    painter.setPen(Qt::NoPen);
    painter.setBrush(blended(palette().color(QPalette::Base), palette().color(QPalette::WindowText), 0.55));
    const double top = height() - bandHeight - 9.0;
    for (const auto& [x, side] : {std::pair{left, -1.0}, std::pair{right, 1.0}}) {
        QPainterPath handle;
        handle.moveTo(x, top);
        handle.lineTo(x + 7.0 * side, top + 4.5);
        handle.lineTo(x, top + 9.0);
        handle.closeSubpath();
        painter.drawPath(handle);
    }
}

void TimelineRuler::paintTicks(QPainter& painter) const
{
    const QColor text = palette().color(QPalette::WindowText);
    const double labelWidth = fontMetrics().horizontalAdvance(labelOf(std::llround(m_to))) + 24.0;
    const double rate = m_timeline.framesPerSecond;
    const double step = tickStep(labelWidth / pixelsPerFrame(), rate, m_display);
    const double fine = tickStep(6.0 / pixelsPerFrame(), rate, m_display);
    const double bottom = height() - bandHeight;
    painter.setPen(QPen(blended(palette().color(QPalette::Base), text, 0.35), 1.0));
    for (double frame = std::ceil(m_from / fine) * fine; frame <= m_to; frame += fine) {
        const double x = std::floor(xOf(frame)) + 0.5;
        painter.drawLine(QPointF(x, bottom - 4.0), QPointF(x, bottom));
    }
    painter.setPen(QPen(blended(palette().color(QPalette::Base), text, 0.75), 1.0));
    for (double frame = std::ceil(m_from / step) * step; frame <= m_to; frame += step) {
        const double x = std::floor(xOf(frame)) + 0.5;
        painter.drawLine(QPointF(x, bottom - 9.0), QPointF(x, bottom));
        painter.drawText(QRectF(x - 0.5 * labelWidth, 2.0, labelWidth, fontMetrics().height()),
                         Qt::AlignCenter, labelOf(std::llround(frame)));
    }
}

/// Cached: full; stale: hatched; missing: nothing. Shape and colour both tell.
void TimelineRuler::paintBand(QPainter& painter) const
{
    const QColor base = palette().color(QPalette::Base), text = palette().color(QPalette::WindowText);
    const QRectF whole(0.0, height() - bandHeight, width(), bandHeight);
    painter.fillRect(whole, blended(base, text, 0.16));
    const bool dark = base.lightness() < 128;
    for (const FrameRange& range : m_band) {
        if (range.state == FrameState::Missing)
            continue;
        const double left = std::max(0.0, xOf(double(range.first) - 0.5));
        const double right = std::min(double(width()), xOf(double(range.last) + 0.5));
        if (right <= left)
            continue;
        const QRectF part(left, whole.top() + 1.0, right - left, bandHeight - 2.0);
        if (range.state == FrameState::Cached)
            painter.fillRect(part, dark ? QColor(110, 190, 110) : QColor(70, 150, 75));
        else
            painter.fillRect(part,
                             QBrush(dark ? QColor(235, 175, 70) : QColor(200, 130, 20), Qt::BDiagPattern));
    }
}

/// Where many stand in one place, one is drawn.
void TimelineRuler::paintKeys(QPainter& painter) const
{
    constexpr double half = 4.0, least = 1.0;
    const QColor base = palette().color(QPalette::Base);
    painter.setPen(QPen(base, 1.0));
    painter.setBrush(base.lightness() < 128 ? QColor(240, 200, 90) : QColor(190, 120, 0));
    const double y = height() - bandHeight - half - 1.0;
    double last = -half - least;
    for (auto key = std::ranges::lower_bound(m_keys, framesAt(-half)); key != m_keys.end(); ++key) {
        const double x = xOf(*key);
        if (x > width() + half)
            break;
        if (x < last + least)
            continue;
        last = x;
        const QPointF diamond[] = {{x, y - half}, {x + half, y}, {x, y + half}, {x - half, y}};
        painter.drawConvexPolygon(diamond, 4);
    }
}

void TimelineRuler::paintPlayhead(QPainter& painter) const
{
    const QColor colour = palette().color(QPalette::Highlight);
    const double x = std::floor(xOf(double(m_frame))) + 0.5;
    painter.setPen(QPen(colour, 1.6));
    painter.drawLine(QPointF(x, 0.0), QPointF(x, height()));
    const QString label = labelOf(m_frame);
    const double half = 0.5 * fontMetrics().horizontalAdvance(label) + 6.0;
    const double centre = std::clamp(x, half, std::max(half, width() - half));
    const QRectF flag(centre - half, 1.0, 2.0 * half, fontMetrics().height() + 2.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(flag, 3.0, 3.0);
    painter.setPen(palette().color(QPalette::HighlightedText));
    painter.drawText(flag, Qt::AlignCenter, label);
}

TimelineRuler::Drag TimelineRuler::handleAt(const QPointF& position) const
{
    if (position.y() < height() - bandHeight - 12.0)
        return Drag::None;
    const double left = xOf(double(m_timeline.firstFrame)), right = xOf(double(m_timeline.lastFrame));
    // Outwards of the ends first: they may lie close together.
    if (std::abs(position.x() - (right + 2.0)) <= handleReach && position.x() >= 0.5 * (left + right))
        return Drag::Last;
    return std::abs(position.x() - (left - 2.0)) <= handleReach ? Drag::First : Drag::None;
}

void TimelineRuler::mousePressEvent(QMouseEvent* event)
{
    m_dragX = event->position().x();
    m_dragBegins = true;
    if (event->button() == Qt::MiddleButton)
        m_drag = Drag::Scroll;
    else if (event->button() == Qt::LeftButton) {
        m_drag = handleAt(event->position());
        if (m_drag == Drag::None)
            m_drag = Drag::Scrub;
        if (m_drag == Drag::Scrub)
            dragTo(m_dragX);
    }
}

void TimelineRuler::mouseMoveEvent(QMouseEvent* event)
{
    const double x = event->position().x();
    if (m_drag == Drag::None) {
        setCursor(handleAt(event->position()) == Drag::None ? Qt::ArrowCursor : Qt::SizeHorCursor);
        return;
    }
    if (m_drag == Drag::Scroll) {
        const double frames = (m_dragX - x) / pixelsPerFrame();
        scrollBy(frames);
    }
    m_dragX = x;
    dragTo(x);
    const bool beyond = (x < margin || x > width() - margin) && m_zoomed && m_drag != Drag::Scroll;
    if (beyond && !m_edgeScroll.isActive())
        m_edgeScroll.start();
    else if (!beyond)
        m_edgeScroll.stop();
}

void TimelineRuler::dragTo(double x)
{
    const qint64 frame = frameAt(x);
    switch (m_drag) {
    case Drag::Scrub:
        emit frameSought(frame);
        break;
    case Drag::First:
        emit rangeDragged(std::min<qint64>(frame, m_timeline.lastFrame), m_timeline.lastFrame,
                          std::exchange(m_dragBegins, false));
        break;
    case Drag::Last:
        emit rangeDragged(m_timeline.firstFrame, std::max<qint64>(frame, m_timeline.firstFrame),
                          std::exchange(m_dragBegins, false));
        break;
    case Drag::None:
    case Drag::Scroll:
        break;
    }
}

void TimelineRuler::mouseReleaseEvent(QMouseEvent*)
{
    m_edgeScroll.stop();
    m_drag = Drag::None;
    if (!m_zoomed)
        fit();
}

void TimelineRuler::mouseDoubleClickEvent(QMouseEvent*)
{
    fit();
}

void TimelineRuler::wheelEvent(QWheelEvent* event)
{
    const double notches = double(event->angleDelta().y() + event->angleDelta().x()) / 120.0;
    if (event->modifiers() & Qt::ShiftModifier)
        scrollBy(-notches * 0.1 * (m_to - m_from));
    else
        zoomAbout(framesAt(event->position().x()), std::pow(0.8, notches));
    event->accept();
}

void TimelineRuler::keyPressEvent(QKeyEvent* event)
{
    const qint64 step = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
    const qint64 second = std::max<qint64>(1, std::llround(m_timeline.framesPerSecond));
    switch (event->key()) {
    case Qt::Key_Left:
        return emit frameSought(m_frame - step);
    case Qt::Key_Right:
        return emit frameSought(m_frame + step);
    case Qt::Key_PageUp:
        return emit frameSought(m_frame - second);
    case Qt::Key_PageDown:
        return emit frameSought(m_frame + second);
    case Qt::Key_Home:
        return emit frameSought(m_timeline.firstFrame);
    case Qt::Key_End:
        return emit frameSought(m_timeline.lastFrame);
    default:
        QWidget::keyPressEvent(event);
    }
}

/// By keyboard it is about the frame on show.
void TimelineRuler::contextMenuEvent(QContextMenuEvent* event)
{
    if (m_drag != Drag::None)
        return;
    const bool byMouse = event->reason() == QContextMenuEvent::Mouse;
    const QPoint atPlayhead = mapToGlobal(QPoint(int(xOf(double(m_frame))), height()));
    emit menuRequested(byMouse ? event->globalPos() : atPlayhead,
                       byMouse ? frameAt(event->pos().x()) : m_frame);
}

bool TimelineRuler::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        // Home and the arrows mean the ruler while it has the focus.
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Home || key->key() == Qt::Key_End) {
            event->accept();
            return true;
        }
    }
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const qint64 frame = frameAt(help->pos().x());
    QString state;
    for (const FrameRange& range : m_band)
        if (frame >= range.first && frame <= range.last)
            state = range.state == FrameState::Cached  ? tr("computed")
                    : range.state == FrameState::Stale ? tr("computed for other parameters")
                                                       : tr("not computed yet");
    QString place =
        tr("Frame %1, %2").arg(frame).arg(timeText(frame, m_timeline.framesPerSecond, TimeDisplay::Seconds));
    if (hasKeyAt(frame))
        place += QStringLiteral(", ") + tr("a key");
    QToolTip::showText(help->globalPos(), state.isEmpty() ? place : place + QStringLiteral(": ") + state,
                       this);
    return true;
}

} // namespace ramure
