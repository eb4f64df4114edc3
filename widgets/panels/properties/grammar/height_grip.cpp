#include "widgets/panels/properties/grammar/height_grip.h"

#include "widgets/panels/properties/grammar/grammar_edit.h"
#include <QMouseEvent>
#include <QPainter>
#include <cmath>

namespace ramure {
namespace {

constexpr int gripHeight = 7;
constexpr double markWidth = 28.0, markHeight = 2.0;

} // namespace

HeightGrip::HeightGrip(GrammarEdit* edit, QWidget* parent)
    : QWidget(parent)
    , m_edit(edit)
{
    setCursor(Qt::SizeVerCursor);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("Drag to make the box higher or lower; double-click for its usual height"));
}

QSize HeightGrip::sizeHint() const
{
    return {60, gripHeight};
}

void HeightGrip::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    m_pressedAt = event->globalPosition().y();
    m_linesThen = m_edit->lines();
}

void HeightGrip::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_pressedAt)
        return event->ignore();
    const double line = m_edit->fontMetrics().lineSpacing();
    m_edit->setLines(m_linesThen +
                     static_cast<int>(std::lround((event->globalPosition().y() - *m_pressedAt) / line)));
}

void HeightGrip::mouseReleaseEvent(QMouseEvent*)
{
    m_pressedAt.reset();
}

void HeightGrip::mouseDoubleClickEvent(QMouseEvent*)
{
    m_edit->setLines(m_edit->usualLines());
}

void HeightGrip::paintEvent(QPaintEvent*)
{
    QColor mark = palette().color(QPalette::WindowText);
    mark.setAlphaF(underMouse() || m_pressedAt ? 0.6f : 0.25f);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(mark);
    const QRectF place(0.5 * (width() - markWidth), 0.5 * (height() - markHeight), markWidth, markHeight);
    painter.drawRoundedRect(place, 1.0, 1.0);
}

} // namespace ramure
