#include "widgets/timeline/physics_plot.h"

#include "widgets/viewport/arm_overlay.h"
#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// Three digits, and an exponent where the number would be long.
QString shortNumber(double value)
{
    const double size = std::abs(value);
    const bool plain = size == 0.0 || (size >= 1e-3 && size < 1e5);
    return QLocale().toString(value, plain ? 'g' : 'e', plain ? 3 : 1);
}

} // namespace

PhysicsPlot::PhysicsPlot(QWidget* parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("physicsPlot"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    updateToolTip();
}

QSize PhysicsPlot::sizeHint() const
{
    return {220, 3 * (fontMetrics().height() + 2) + 4};
}

void PhysicsPlot::setContent(Content content)
{
    if (content == m_content)
        return;
    m_content = content;
    updateToolTip();
    clear();
}

void PhysicsPlot::add(const MotionFrame& frame)
{
    if (frame.frame < m_last)
        m_frames.clear();
    m_last = frame.frame;
    Values values{};
    for (const auto& [node, motion] : frame.nodes) {
        values[Energy] += motion.figures.kineticEnergy;
        values[LengthError] = std::max(values[LengthError], motion.figures.lengthError);
        values[StepTime] += 1e3 * motion.stepSeconds;
        if (motion.arm)
            values[Residual] = std::max(values[Residual], motion.arm->residual);
    }
    m_frames.push_back(values);
    if (m_frames.size() > length)
        m_frames.pop_front();
    update();
}

void PhysicsPlot::clear()
{
    m_frames.clear();
    update();
}

void PhysicsPlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    if (m_content == Content::Arms)
        return paintCurve(painter, rect(), Residual);
    const double third = double(height()) / 3.0;
    for (const Curve curve : {Energy, LengthError, StepTime})
        paintCurve(painter, QRectF(0.0, int(curve) * third, width(), third), curve);
}

QString PhysicsPlot::nameOf(Curve curve)
{
    return curve == Energy        ? tr("Energy")
           : curve == LengthError ? tr("Length error")
           : curve == StepTime    ? tr("Step")
                                  : tr("Residual");
}

QString PhysicsPlot::textOf(Curve curve, double value)
{
    return curve == StepTime   ? tr("%1 ms").arg(shortNumber(value))
           : curve == Residual ? shortLengthText(value)
                               : shortNumber(value);
}

void PhysicsPlot::paintCurve(QPainter& painter, const QRectF& area, Curve curve) const
{
    const double now = m_frames.empty() ? 0.0 : m_frames.back()[curve];
    double most = 0.0;
    for (const Values& values : m_frames)
        most = std::max(most, values[curve]);
    if (most > 0.0 && m_frames.size() > 1) {
        QPainterPath path;
        const double step = area.width() / double(length - 1);
        const double start = area.right() - step * double(m_frames.size() - 1);
        for (std::size_t i = 0; i < m_frames.size(); ++i) {
            const QPointF at(start + step * double(i),
                             area.bottom() - 1.0 - (area.height() - 3.0) * m_frames[i][curve] / most);
            i == 0 ? path.moveTo(at) : path.lineTo(at);
        }
        QColor colour = palette().color(QPalette::Highlight);
        colour.setAlpha(170);
        painter.setPen(QPen(colour, 1.3));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(path);
    }
    painter.setPen(palette().color(QPalette::Text));
    const double line =
        std::min(area.height(), 1.6 * fontMetrics().height()); // at the top, where there is room
    const QRectF text(area.left() + 6.0, area.top(), area.width() - 12.0, line);
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, nameOf(curve));
    if (!m_frames.empty())
        painter.drawText(text, Qt::AlignRight | Qt::AlignVCenter, textOf(curve, now));
}

void PhysicsPlot::updateToolTip()
{
    const bool arms = m_content == Content::Arms;
    setAccessibleName(arms ? tr("Residual") : tr("Physics"));
    setToolTip(
        arms ? tr("Over the latest frames: the largest distance from an arm's tip to its target (m)")
             : tr("Of all trees, over the latest frames: kinetic energy, the largest relative error of a "
                  "branch's length, "
                  "and the time that one step of the physics takes (ms)"));
}

bool PhysicsPlot::event(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        updateToolTip();
    return QWidget::event(event);
}

} // namespace ramure
