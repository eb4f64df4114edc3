#include "widgets/panels/properties/profile_curve.h"

#include "core/generators/colonisation/crown_shape.h"
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr double handleRadius = 5.0, handleReach = 10.0;
/// Between the heights of two pairs.
constexpr double heightGap = 0.01;

struct Outline
{
    const char* name;
    std::vector<glm::dvec2> pairs;
};

const std::vector<Outline>& outlines()
{
    static const std::vector<Outline> all{
        {QT_TRANSLATE_NOOP("ramure::ProfileCurve", "Round"),
         {{0.0, 0.2}, {0.2, 0.8}, {0.5, 1.0}, {0.8, 0.8}, {1.0, 0.1}}},
        {QT_TRANSLATE_NOOP("ramure::ProfileCurve", "Egg"),
         {{0.0, 0.3}, {0.35, 1.0}, {0.75, 0.7}, {1.0, 0.0}}},
        {QT_TRANSLATE_NOOP("ramure::ProfileCurve", "Column"),
         {{0.0, 0.5}, {0.3, 0.9}, {0.8, 1.0}, {1.0, 0.2}}},
        {QT_TRANSLATE_NOOP("ramure::ProfileCurve", "Vase"),
         {{0.0, 0.1}, {0.4, 0.4}, {0.85, 1.0}, {1.0, 0.6}}},
        {QT_TRANSLATE_NOOP("ramure::ProfileCurve", "Umbrella"),
         {{0.0, 0.0}, {0.6, 0.15}, {0.72, 1.0}, {0.9, 0.8}, {1.0, 0.2}}},
        {QT_TRANSLATE_NOOP("ramure::ProfileCurve", "In tiers"),
         {{0.0, 0.9}, {0.18, 1.0}, {0.28, 0.2}, {0.45, 0.75}, {0.56, 0.15}, {0.75, 0.5}, {1.0, 0.0}}},
    };
    return all;
}

double rounded(double share)
{
    return std::round(std::clamp(share, 0.0, 1.0) * 1000.0) / 1000.0;
}

} // namespace

ProfileCurve::ProfileCurve(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize ProfileCurve::sizeHint() const
{
    return {200, 180};
}

void ProfileCurve::setPairs(Pairs pairs)
{
    m_pairs = std::move(pairs);
    m_chosen = std::min(m_chosen, static_cast<int>(m_pairs.size()) - 1);
    update();
}

QRectF ProfileCurve::field() const
{
    const double margin = handleRadius + 3.0;
    return QRectF(rect()).adjusted(margin, margin, -margin, -margin);
}

QPointF ProfileCurve::handleAt(const glm::dvec2& pair) const
{
    const QRectF all = field();
    return {all.center().x() + 0.5 * all.width() * pair.y, all.bottom() - all.height() * pair.x};
}

glm::dvec2 ProfileCurve::pairAt(const QPointF& at) const
{
    const QRectF all = field();
    return {rounded((all.bottom() - at.y()) / all.height()),
            rounded((at.x() - all.center().x()) / (0.5 * all.width()))};
}

int ProfileCurve::handleUnder(const QPointF& at) const
{
    int best = -1;
    double nearest = handleReach;
    for (std::size_t i = 0; i < m_pairs.size(); ++i) {
        const QPointF way = handleAt(m_pairs[i]) - at;
        if (const double distance = std::hypot(way.x(), way.y()); distance < nearest) {
            nearest = distance;
            best = static_cast<int>(i);
        }
    }
    return best;
}

void ProfileCurve::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette& colours = palette();
    painter.setPen(colours.color(hasFocus() ? QPalette::Highlight : QPalette::Mid));
    painter.setBrush(colours.base());
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    const QRectF all = field();
    painter.setPen(QPen(colours.color(QPalette::Mid), 1.0, Qt::DashLine));
    painter.drawLine(QPointF(all.center().x(), all.top()), QPointF(all.center().x(), all.bottom()));
    const auto outline = CrownOutline::through(m_pairs);
    if (!outline)
        return;
    QPolygonF right, left;
    constexpr int samples = 120;
    for (int i = 0; i <= samples; ++i) {
        const double height = std::lerp(m_pairs.front().x, m_pairs.back().x, i / double(samples));
        const QPointF at = handleAt({height, outline->radiusAt(height)});
        right.append(at);
        left.prepend({2.0 * all.center().x() - at.x(), at.y()});
    }
    QColor filled = colours.color(QPalette::Highlight);
    painter.setPen(QPen(filled, 1.5));
    filled.setAlphaF(isEnabled() ? 0.25F : 0.1F);
    painter.setBrush(filled);
    painter.drawPolygon(right + left);
    for (std::size_t i = 0; i < m_pairs.size(); ++i) {
        const bool isChosen = static_cast<int>(i) == m_chosen;
        painter.setPen(QPen(colours.color(QPalette::Highlight), 1.5));
        painter.setBrush(isChosen ? colours.highlight() : colours.base());
        painter.drawEllipse(handleAt(m_pairs[i]), handleRadius, handleRadius);
    }
}

void ProfileCurve::choose(int handle)
{
    m_chosen = handle;
    update();
}

void ProfileCurve::take(Pairs pairs)
{
    if (pairs == m_pairs || !CrownOutline::through(pairs))
        return;
    setPairs(std::move(pairs));
    emit pairsEdited();
}

void ProfileCurve::moveTo(const glm::dvec2& pair)
{
    if (m_chosen < 0)
        return;
    const auto i = static_cast<std::size_t>(m_chosen);
    Pairs pairs = m_pairs;
    const double low = i > 0 ? pairs[i - 1].x + heightGap : 0.0;
    const double high = i + 1 < pairs.size() ? pairs[i + 1].x - heightGap : 1.0;
    pairs[i] = {rounded(std::clamp(pair.x, std::min(low, high), high)), rounded(pair.y)};
    take(std::move(pairs));
}

void ProfileCurve::add(const glm::dvec2& pair)
{
    const bool isTaken = std::ranges::any_of(
        m_pairs, [&](const glm::dvec2& own) { return std::abs(own.x - pair.x) < heightGap; });
    if (m_pairs.empty() || isTaken || m_pairs.size() >= maxProfilePairs)
        return;
    emit gestureStarted();
    Pairs pairs = m_pairs;
    const auto at = std::ranges::upper_bound(pairs, pair.x, {}, &glm::dvec2::x);
    m_chosen = static_cast<int>(at - pairs.begin());
    pairs.insert(at, pair);
    take(std::move(pairs));
}

void ProfileCurve::removeChosen()
{
    if (m_chosen < 0 || m_pairs.size() <= 2)
        return;
    emit gestureStarted();
    Pairs pairs = m_pairs;
    pairs.erase(pairs.begin() + m_chosen);
    take(std::move(pairs));
}

void ProfileCurve::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return QWidget::mousePressEvent(event);
    choose(handleUnder(event->position()));
    m_drags = m_chosen >= 0;
    if (m_drags)
        emit gestureStarted();
}

void ProfileCurve::mouseMoveEvent(QMouseEvent* event)
{
    if (m_drags)
        moveTo(pairAt(event->position()));
    else
        setCursor(handleUnder(event->position()) >= 0 ? Qt::SizeAllCursor : Qt::ArrowCursor);
}

void ProfileCurve::mouseReleaseEvent(QMouseEvent*)
{
    m_drags = false;
}

void ProfileCurve::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && handleUnder(event->position()) < 0)
        add(pairAt(event->position()));
}

void ProfileCurve::contextMenuEvent(QContextMenuEvent* event)
{
    const QPointF at = event->reason() == QContextMenuEvent::Keyboard && m_chosen >= 0
                           ? handleAt(m_pairs[std::size_t(m_chosen)])
                           : QPointF(event->pos());
    if (const int under = handleUnder(at); under >= 0)
        choose(under);
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Add a point here"), this, [this, at] { add(pairAt(at)); })
        ->setEnabled(handleUnder(at) < 0 && !m_pairs.empty());
    menu->addAction(tr("Remove the point"), QKeySequence::Delete, this, &ProfileCurve::removeChosen)
        ->setEnabled(m_chosen >= 0 && m_pairs.size() > 2);
    menu->addSeparator();
    for (const Outline& outline : outlines())
        menu->addAction(tr(outline.name), this, [this, &outline] {
            emit gestureStarted();
            m_chosen = -1;
            take(outline.pairs);
        });
    menu->popup(mapToGlobal(at.toPoint()));
}

void ProfileCurve::keyPressEvent(QKeyEvent* event)
{
    const int last = static_cast<int>(m_pairs.size()) - 1;
    const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.05 : 0.01;
    const auto nudge = [&](double height, double radius) {
        if (m_chosen < 0)
            return event->ignore();
        if (!event->isAutoRepeat())
            emit gestureStarted();
        moveTo(m_pairs[std::size_t(m_chosen)] + glm::dvec2(height, radius));
    };
    switch (event->key()) {
    case Qt::Key_PageUp:
        return choose(std::min(m_chosen + 1, last));
    case Qt::Key_PageDown:
        return choose(m_chosen < 0 ? last : std::max(m_chosen - 1, 0));
    case Qt::Key_Up:
        return nudge(step, 0.0);
    case Qt::Key_Down:
        return nudge(-step, 0.0);
    case Qt::Key_Right:
        return nudge(0.0, step);
    case Qt::Key_Left:
        return nudge(0.0, -step);
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return removeChosen();
    case Qt::Key_Insert:
        if (m_chosen >= 0 && m_chosen < last)
            add(0.5 * (m_pairs[std::size_t(m_chosen)] + m_pairs[std::size_t(m_chosen) + 1]));
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace ramure
