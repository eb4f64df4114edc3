#include "widgets/viewport/arm_overlay.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr double margin = 12.0, width = 260.0, plotHeight = 64.0;

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(ArmOverlay)
};

QPolygonF curve(const std::vector<float>& residuals, const QRectF& place)
{
    const auto [least, most] = std::minmax_element(residuals.begin(), residuals.end());
    const double high = std::log10(std::max(double(*most), 1e-6));
    const double low = std::min(std::log10(std::max(double(*least), 1e-6)), high - 1.0);
    QPolygonF points;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        const double x = residuals.size() > 1 ? double(i) / double(residuals.size() - 1) : 0.0;
        const double y = (std::log10(std::max(double(residuals[i]), 1e-6)) - low) / (high - low);
        points << QPointF(place.left() + x * place.width(), place.bottom() - y * place.height());
    }
    return points;
}

/// Which angles lie on which limit, with the signs of their rings; the first few of many.
QString limitsText(const std::vector<ArmLimit>& limits)
{
    constexpr int mostNamed = 4;
    QStringList names;
    int count = 0;
    for (std::size_t i = 0; i < limits.size(); ++i) {
        if (limits[i] == ArmLimit::Free || ++count > mostNamed)
            continue;
        names += QStringLiteral("%1%2 %3")
                     .arg(i % 2 == 0 ? QStringLiteral("φ") : QStringLiteral("θ"))
                     .arg(i / 2 + 1)
                     .arg(limits[i] == ArmLimit::Upper ? Words::tr("max") : Words::tr("min"));
    }
    if (count == 0)
        return {};
    if (count > mostNamed)
        names += QStringLiteral("…");
    return Words::tr("%n angle(s) at a limit", nullptr, count) + QStringLiteral(": ") +
           names.join(QStringLiteral(", "));
}

} // namespace

QString armStatusText(const ArmProgress& progress)
{
    QString text = Words::tr("residual %1 m after %n step(s)", nullptr, int(progress.figures.steps))
                       .arg(progress.residual, 0, 'g', 3);
    if (progress.figures.status == ArmStatus::Settled)
        text += QLatin1Char('\n') +
                Words::tr("unreachable: %1 m short").arg(progress.figures.shortBy(), 0, 'f', 3);
    else if (progress.figures.status == ArmStatus::Reached && !progress.moves)
        text += QLatin1Char('\n') + Words::tr("reached");
    if (const QString limits = limitsText(progress.limits); !limits.isEmpty())
        text += QLatin1Char('\n') + limits;
    return text;
}

void paintArmStatus(QPainter& painter, QSize size, const ArmProgress& progress)
{
    const QString text = armStatusText(progress);
    const double textHeight = painter.fontMetrics().lineSpacing() * double(text.count(QLatin1Char('\n')) + 1);
    const bool plots = progress.residuals.size() > 1;
    const double height = textHeight + (plots ? plotHeight + 8.0 : 0.0) + 16.0;
    const QRectF box(margin, size.height() - margin - height, width, height);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 26, 32, 170));
    painter.drawRoundedRect(box, 6.0, 6.0);
    painter.setPen(Qt::white);
    painter.drawText(box.adjusted(10.0, 8.0, -10.0, -8.0), Qt::AlignLeft | Qt::AlignTop, text);
    if (!plots)
        return;
    const QRectF place(box.left() + 10.0, box.bottom() - 8.0 - plotHeight, width - 20.0, plotHeight);
    painter.setPen(QPen(QColor(255, 255, 255, 70), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(place);
    painter.setPen(QPen(QColor(90, 220, 120), 1.6));
    painter.drawPolyline(curve(progress.residuals, place));
}

} // namespace ramure
