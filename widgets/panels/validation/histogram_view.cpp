#include "widgets/panels/validation/histogram_view.h"

#include "widgets/base/theme/theme.h"
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr int usualHeight = 96, leastHeight = 56;

} // namespace

HistogramView::HistogramView(QWidget* parent)
    : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

QSize HistogramView::sizeHint() const
{
    return {160, usualHeight};
}

QSize HistogramView::minimumSizeHint() const
{
    return {60, leastHeight};
}

void HistogramView::setCounts(std::vector<quint64> counts, int warnBelow)
{
    if (counts == m_counts && warnBelow == m_warnBelow)
        return;
    m_counts = std::move(counts);
    m_warnBelow = warnBelow;
    update();
}

void HistogramView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const quint64 most = m_counts.empty() ? 0 : *std::max_element(m_counts.begin(), m_counts.end());
    const double step = double(width()) / double(std::max<std::size_t>(1, m_counts.size()));
    const double room = height() - 1;
    painter.fillRect(QRectF(0, height() - 1, width(), 1), palette().color(QPalette::Mid));
    for (std::size_t i = 0; i < m_counts.size(); ++i) {
        if (m_counts[i] == 0)
            continue;
        // Square roots: three bad triangles among a million are to be seen.
        const double share = std::sqrt(double(m_counts[i]) / double(most));
        const double bar = std::max(2.0, std::round(room * share));
        const bool warns = static_cast<int>(i) < m_warnBelow;
        painter.fillRect(QRectF(std::round(double(i) * step) + 1, room - bar,
                                std::round(double(i + 1) * step) - std::round(double(i) * step) - 2, bar),
                         warns ? warningColour(palette()) : palette().color(QPalette::Highlight));
    }
}

} // namespace ramure
