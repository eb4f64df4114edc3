#include "widgets/view/outline_key.h"

#include <QPainter>
#include <algorithm>

namespace ramure {

static constexpr int outlineStaysMs = 1000;
static constexpr double outlineFadesMs = 300.0;
static constexpr int outlineStepMs = 50; ///< while it fades

OutlineKey::OutlineKey(QObject* parent)
    : QObject(parent)
{
    connect(&m_fades, &QTimer::timeout, this, [this] {
        m_fades.setInterval(outlineStepMs);
        if (opacity() <= 0.0)
            m_fades.stop();
        emit changed();
    });
}

void OutlineKey::show()
{
    m_since.start();
    m_fades.start(outlineStaysMs);
    emit changed();
}

double OutlineKey::opacity() const
{
    const double past = m_since.isValid() ? double(m_since.elapsed() - outlineStaysMs) : outlineFadesMs;
    return std::clamp(1.0 - past / outlineFadesMs, 0.0, 1.0);
}

void OutlineKey::paint(QPainter& painter) const
{
    const double opacity = this->opacity();
    if (opacity <= 0.0)
        return;
    constexpr double margin = 12.0, swatch = 22.0, gap = 8.0;
    const QString key = m_key ? m_key() : QString();
    const QString text = key.isEmpty() ? tr("selected") : tr("selected · %1: on or off").arg(key);
    const QSizeF size =
        painter.fontMetrics().size(Qt::TextSingleLine, text) + QSizeF(swatch + 3.0 * gap, 10.0);
    const QRectF box(QPointF(margin, margin), size);
    painter.save();
    painter.setOpacity(opacity);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 26, 32, 190));
    painter.drawRoundedRect(box, 6.0, 6.0);
    painter.setPen(QPen(QColor::fromRgbF(1.0f, 0.50f, 0.06f), 3.0)); // as in outline_ink.frag
    const QPointF from(box.left() + gap, box.center().y());
    painter.drawLine(from, from + QPointF(swatch, 0.0));
    painter.setPen(Qt::white);
    painter.drawText(box.adjusted(swatch + 2.0 * gap, 0.0, 0.0, 0.0), Qt::AlignVCenter | Qt::AlignLeft, text);
    painter.restore();
}

} // namespace ramure
