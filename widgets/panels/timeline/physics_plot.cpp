#include "widgets/panels/timeline/physics_plot.h"

#include "widgets/base/theme/icons.h"
#include "widgets/view/tools/arm/arm_overlay.h"
#include <QClipboard>
#include <QContextMenuEvent>
#include <QEvent>
#include <QGuiApplication>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ramure {
namespace {

constexpr int plotGap = 6;              ///< beside the names and numbers
constexpr std::size_t shownTicks = 600; ///< of the solver that are shown: ten seconds
constexpr double leastShown = 1e-9;     ///< of all curves: what is below is the noise of rounding

} // namespace

QString PhysicsPlot::shortNumber(double value)
{
    const double size = std::abs(value);
    if (size > 0.0 && size < leastShown)
        return QStringLiteral("< ") + QLocale().toString(leastShown, 'e', 0);
    const bool plain = size == 0.0 || (size >= 1e-3 && size < 1e5);
    return QLocale().toString(value, plain ? 'g' : 'e', plain ? 3 : 1);
}

PhysicsPlot::PhysicsPlot(QWidget* parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("physicsPlot"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred); // a share of what a wide window has
    setMinimumWidth(sizeHint().width());
    buildMenu();
    updateToolTip();
}

QSize PhysicsPlot::sizeHint() const
{
    return {240, 3 * (fontMetrics().height() + 2) + 4};
}

int PhysicsPlot::rowCount() const
{
    return m_content == Content::Arms ? 1 : std::max(1, int(shownCurves().size()));
}

/// The number stands below the name where rows are high enough, else at the other end.
bool PhysicsPlot::isStacked() const
{
    return height() >= rowCount() * (2 * fontMetrics().height() + 2);
}

/// Names and numbers keep their room, however long they are just now: the curve must not jump.
QRectF PhysicsPlot::curvesArea() const
{
    constexpr int leastCurve = 60;
    int names = 0, numbers = 0;
    if (m_content == Content::Arms)
        names = fontMetrics().horizontalAdvance(tr("Residual"));
    else
        for (const Curve curve : {Energy, LengthError, StepTime})
            names = std::max(names, fontMetrics().horizontalAdvance(nameOf(curve)));
    for (const double value : {1.888e-8, 0.00888})
        numbers = std::max(numbers, fontMetrics().horizontalAdvance(tr("%1 ms").arg(shortNumber(value))));
    if (isStacked())
        return QRectF(rect()).adjusted(std::max(names, numbers) + 2 * plotGap, 0.0, 0.0, 0.0);
    const int room = width() - numbers - leastCurve - 4 * plotGap;
    return QRectF(rect()).adjusted(std::clamp(room, 0, names) + 2 * plotGap, 0.0, -numbers - 2 * plotGap,
                                   0.0);
}

QString PhysicsPlot::nameOf(Curve curve)
{
    return curve == Energy ? tr("Energy") : curve == LengthError ? tr("Length error") : tr("Step");
}

std::vector<PhysicsPlot::Curve> PhysicsPlot::shownCurves() const
{
    std::vector<Curve> shown;
    for (const Curve curve : {Energy, LengthError, StepTime})
        if (m_shown[curve]->isChecked())
            shown.push_back(curve);
    return shown;
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
    Values values;
    values.frame = frame.frame;
    for (const auto& [node, motion] : frame.nodes) {
        values.of[Energy] += motion.figures.kineticEnergy;
        values.of[LengthError] = std::max(values.of[LengthError], motion.figures.lengthError);
        values.of[StepTime] += 1e3 * motion.stepSeconds;
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
    if (arms) {
        const bool drawn = m_residuals && m_residuals->way.size() > 1;
        const double line = drawn ? height() : fontMetrics().height() + 4.0; // else the hint stands below
        const std::vector<double> way = drawn ? m_residuals->way : std::vector<double>();
        // The whole way fills the width.
        return paintRow(painter, QRectF(0.0, 0.0, width(), line), tr("Residual"),
                        m_residuals ? shortLengthText(m_residuals->now) : QString(), way,
                        curvesArea().width() / std::max(1.0, double(way.size()) - 1.0));
    }
    const std::vector<Curve> shown = m_frames.empty() ? std::vector<Curve>() : shownCurves();
    const double share = double(height()) / std::max(1.0, double(shown.size()));
    for (std::size_t i = 0; i < shown.size(); ++i) {
        std::vector<double> values;
        for (const Values& frame : m_frames)
            values.push_back(frame.of[shown[i]]);
        const QString now = shortNumber(values.back());
        paintRow(painter, QRectF(0.0, double(i) * share, width(), share), nameOf(shown[i]),
                 shown[i] == StepTime ? tr("%1 ms").arg(now) : now, values,
                 curvesArea().width() / double(length - 1));
    }
}

void PhysicsPlot::paintRow(QPainter& painter, const QRectF& row, const QString& name, const QString& now,
                           const std::vector<double>& values, double step) const
{
    const QRectF whole = curvesArea();
    const QRectF area(whole.left(), row.top(), whole.width(), row.height());
    if (values.size() > 1 && area.width() > 1.0) {
        painter.setClipRect(area);
        paintLine(painter, area, values, step);
        painter.setClipping(false);
    }
    painter.setPen(palette().color(QPalette::Text));
    const double line = fontMetrics().height();
    const double top = row.center().y() - line; // of the two lines
    const bool stacked = isStacked() && row.height() >= 2.0 * line;
    const QRectF text = stacked ? QRectF(plotGap, top, whole.left() - plotGap, line)
                                : row.adjusted(plotGap, 0.0, -plotGap, 0.0);
    const double room = whole.left() - 2.0 * plotGap;
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(name, Qt::ElideRight, int(room) + 1));
    painter.drawText(stacked ? text.translated(0.0, line) : text,
                     int((stacked ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter), now);
}

/// The last value stands at the right edge; the largest one is as high as there is room.
void PhysicsPlot::paintLine(QPainter& painter, const QRectF& area, const std::vector<double>& values,
                            double step) const
{
    const double most = *std::max_element(values.begin(), values.end());
    if (!(most >= leastShown) || values.size() < 2)
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

QString PhysicsPlot::valuesText(QChar separator) const
{
    const auto number = [](double value) { return QString::number(value, 'g', 9); };
    QString text;
    if (m_content == Content::Arms) {
        text = QStringLiteral("tick%1residual_m\n").arg(separator);
        for (std::size_t i = 0; m_residuals && i < m_residuals->way.size(); ++i)
            text += QString::number(i) + separator + number(m_residuals->way[i]) + u'\n';
        return text;
    }
    constexpr const char* headings[curves] = {"energy", "length_error", "step_ms"};
    text = QStringLiteral("frame");
    for (const Curve curve : shownCurves())
        text += separator + QLatin1String(headings[curve]);
    text += u'\n';
    for (const Values& frame : m_frames) {
        text += QString::number(frame.frame);
        for (const Curve curve : shownCurves())
            text += separator + number(frame.of[curve]);
        text += u'\n';
    }
    return text;
}

void PhysicsPlot::buildMenu()
{
    m_menu = new QMenu(this);
    const auto copy = [this](QChar separator) {
        QGuiApplication::clipboard()->setText(valuesText(separator));
    };
    m_copyCsv = m_menu->addAction(icon("copy"), tr("Copy the values as CSV"), this, [copy] { copy(u','); });
    m_copyTsv = m_menu->addAction(tr("Copy the values for a spreadsheet"), this, [copy] { copy(u'\t'); });
    m_copyTsv->setToolTip(tr("Copies the columns, separated by tabs"));
    m_menu->addSeparator();
    for (const Curve curve : {Energy, LengthError, StepTime}) {
        QAction*& shown = m_shown[curve];
        shown = m_menu->addAction(nameOf(curve));
        shown->setCheckable(true);
        shown->setChecked(true);
        connect(shown, &QAction::toggled, this, qOverload<>(&QWidget::update));
    }
    m_menu->addSeparator();
    m_anew = m_menu->addAction(tr("Start anew"), this, &PhysicsPlot::clear);
    m_menu->setToolTipsVisible(true);
}

void PhysicsPlot::contextMenuEvent(QContextMenuEvent* event)
{
    const bool trees = m_content == Content::Trees;
    const bool any = trees ? !m_frames.empty() : m_residuals && !m_residuals->way.empty();
    const auto shown = shownCurves().size();
    for (QAction* action : {m_copyCsv, m_copyTsv})
        action->setEnabled(any);
    for (QAction* curve : m_shown) {
        curve->setVisible(trees);
        curve->setEnabled(shown > 1 || !curve->isChecked()); // one stays
    }
    m_anew->setVisible(trees);
    m_anew->setEnabled(any);
    m_menu->popup(event->globalPos());
}

void PhysicsPlot::updateToolTip()
{
    const bool arms = m_content == Content::Arms;
    setAccessibleName(arms ? tr("Residual") : tr("Physics"));
    setToolTip(arms
                   ? tr("The largest distance from an arm's tip to its target (m), now and over the last ten "
                        "seconds of "
                        "its way; there is a curve once an arm has moved: played, or sent to a target by "
                        "Ctrl+click on a "
                        "surface")
                   : tr("Figures of all trees over the latest frames: kinetic energy, the largest relative "
                        "error of a branch's length, and the time of one physics step (ms)"));
}

} // namespace ramure
