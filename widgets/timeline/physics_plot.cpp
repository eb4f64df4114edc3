#include "widgets/timeline/physics_plot.h"

#include "widgets/viewport/arm_overlay.h"
#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ramure {
namespace {

constexpr std::size_t shownTicks = 600; ///< of the solver that are shown: ten seconds

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
    }
    m_frames.push_back(values);
    if (m_frames.size() > length)
        m_frames.pop_front();
    changed();
}

void PhysicsPlot::setResiduals(std::optional<ArmResiduals> residuals)
{
    m_residuals = std::move(residuals);
    if (m_residuals && m_residuals->way.size() > shownTicks)
        m_residuals->way.erase(m_residuals->way.begin(), m_residuals->way.end() - std::ptrdiff_t(shownTicks));
    changed();
}

void PhysicsPlot::clear()
{
    m_frames.clear();
    m_residuals.reset();
    changed();
}

void PhysicsPlot::changed()
{
    setAccessibleDescription(hint());
    update();
}

QString PhysicsPlot::hint() const
{
    if (m_content == Content::Trees)
        return m_frames.empty() ? tr("Energy, length error and time of a step are drawn while it plays.")
                                : QString();
    if (m_content == Content::Nothing || (m_residuals && m_residuals->way.size() > 1))
        return {};
    return m_residuals ? tr("Play, or Ctrl+click a surface, to see a curve.")
                       : tr("No arm follows a target: Ctrl+click sets one.");
}

void PhysicsPlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    const QString text = hint();
    const bool arms = m_content == Content::Arms;
    if (!text.isEmpty()) {
        QColor soft = palette().color(QPalette::Text);
        soft.setAlphaF(0.75f);
        painter.setPen(soft);
        const double top = arms ? fontMetrics().height() + 4.0 : 2.0;
        painter.drawText(QRectF(rect()).adjusted(6.0, top, -6.0, -2.0),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, text);
    }
    if (arms)
        return paintResiduals(painter);
    const double third = double(height()) / 3.0;
    for (const Curve curve : {Energy, LengthError, StepTime})
        if (!m_frames.empty())
            paintCurve(painter, QRectF(0.0, int(curve) * third, width(), third), curve);
}

void PhysicsPlot::paintCurve(QPainter& painter, const QRectF& area, Curve curve) const
{
    std::vector<double> values;
    for (const Values& frame : m_frames)
        values.push_back(frame[curve]);
    const QString name = curve == Energy        ? tr("Energy")
                         : curve == LengthError ? tr("Length error")
                                                : tr("Step");
    const QString now = shortNumber(values.back());
    paintLine(painter, area, values, area.width() / double(length - 1));
    paintTexts(painter, area, name, curve == StepTime ? tr("%1 ms").arg(now) : now);
}

/// The whole way fills the width, below the texts.
void PhysicsPlot::paintResiduals(QPainter& painter) const
{
    if (m_residuals && m_residuals->way.size() > 1)
        paintLine(
            painter,
            QRectF(rect()).adjusted(0.0, std::min(1.4 * fontMetrics().height(), 0.3 * height()), 0.0, 0.0),
            m_residuals->way, width() / double(m_residuals->way.size() - 1));
    paintTexts(painter, rect(), tr("Residual"), m_residuals ? shortLengthText(m_residuals->now) : QString());
}

/// The last value stands at the right edge; the largest one is as high as there is room.
void PhysicsPlot::paintLine(QPainter& painter, const QRectF& area, const std::vector<double>& values,
                            double step) const
{
    const double most = *std::max_element(values.begin(), values.end());
    if (!(most > 0.0) || values.size() < 2)
        return;
    QPainterPath path;
    const double start = area.right() - step * double(values.size() - 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const QPointF at(start + step * double(i),
                         area.bottom() - 1.0 - (area.height() - 3.0) * values[i] / most);
        i == 0 ? path.moveTo(at) : path.lineTo(at);
    }
    QColor colour = palette().color(QPalette::Highlight);
    colour.setAlpha(170);
    painter.setPen(QPen(colour, 1.3));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

void PhysicsPlot::paintTexts(QPainter& painter, const QRectF& area, const QString& name,
                             const QString& value) const
{
    painter.setPen(palette().color(QPalette::Text));
    const double line =
        std::min(area.height(), 1.6 * fontMetrics().height()); // at the top, where there is room
    const QRectF text(area.left() + 6.0, area.top(), area.width() - 12.0, line);
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, name);
    painter.drawText(text, Qt::AlignRight | Qt::AlignVCenter, value);
}

void PhysicsPlot::updateToolTip()
{
    const bool arms = m_content == Content::Arms;
    setAccessibleName(arms ? tr("Residual") : tr("Physics"));
    setToolTip(
        arms ? tr("The largest distance from an arm's tip to its target (m), now and over the last ten "
                  "seconds of "
                  "its way; there is a curve once an arm has moved: played, or sent to a target by "
                  "Ctrl+click on a "
                  "surface")
             : tr("Of all trees, over the latest frames: kinetic energy, the largest relative error of a "
                  "branch's length, "
                  "and the time that one step of the physics takes (ms)"));
}

bool PhysicsPlot::event(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        updateToolTip();
        changed();
    }
    return QWidget::event(event);
}

} // namespace ramure
