#include "widgets/view/texture_legend.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLinearGradient>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <array>
#include <utility>

namespace ramure {

namespace {

constexpr double legendMargin = 12.0;
constexpr double padding = 10.0;
constexpr double barWidth = 220.0;
constexpr double barHeight = 12.0;

struct Mark
{
    double stretch;
    QColor colour; ///< those of texture.glsl
};

const std::array<Mark, 5>& scale()
{
    static const std::array<Mark, 5> marks{{{1.0, QColor::fromRgbF(0.16f, 0.35f, 0.62f)},
                                            {1.12, QColor::fromRgbF(0.35f, 0.66f, 0.72f)},
                                            {1.25, QColor::fromRgbF(0.96f, 0.93f, 0.62f)},
                                            {1.5, QColor::fromRgbF(0.95f, 0.55f, 0.15f)},
                                            {2.0, QColor::fromRgbF(0.72f, 0.08f, 0.10f)}}};
    return marks;
}

/// A length of one tile, in the unit that reads best.
QString tileText(double metres)
{
    const QLocale locale;
    if (metres < 0.01)
        return QCoreApplication::translate("TextureLegend", "%1 mm")
            .arg(locale.toString(1000.0 * metres, 'g', 3));
    if (metres < 1.0)
        return QCoreApplication::translate("TextureLegend", "%1 cm")
            .arg(locale.toString(100.0 * metres, 'g', 3));
    return QCoreApplication::translate("TextureLegend", "%1 m").arg(locale.toString(metres, 'g', 3));
}

QStringList linesOf(DisplayMode mode, const TextureSummary& texture)
{
    const QLocale locale;
    if (mode == DisplayMode::Checker)
        return {QCoreApplication::translate("TextureLegend", "One square: a tile, %1 on the thickest wood")
                    .arg(tileText(texture.tileSize)),
                QCoreApplication::translate("TextureLegend", "Tiles too small to see are joined: 2, 4, 8 …")};
    const double good = 100.0 * (1.0 - double(texture.stretched) / double(texture.triangles));
    return {QCoreApplication::translate("TextureLegend", "Stretch of the texture"),
            QCoreApplication::translate("TextureLegend", "Under 1.25: %1 % of the triangles")
                .arg(locale.toString(good, 'f', 1)),
            QCoreApplication::translate("TextureLegend", "Mirrored: %1")
                .arg(locale.toString(qlonglong(texture.mirrored)))};
}

} // namespace

void paintTextureLegend(QPainter& painter, QSize area, DisplayMode mode, const TextureSummary& texture)
{
    const bool colours = mode == DisplayMode::Stretch;
    if ((mode != DisplayMode::Checker && !colours) || texture.triangles == 0)
        return;
    const QStringList lines = linesOf(mode, texture);
    const QFontMetricsF metrics(painter.font());
    double width = colours ? barWidth : 0.0;
    for (const QString& line : lines)
        width = std::max(width, metrics.horizontalAdvance(line));
    const double lineHeight = metrics.height();
    const double height = lineHeight * double(lines.size()) + (colours ? barHeight + lineHeight + 8.0 : 0.0);
    const QRectF box(legendMargin, area.height() - legendMargin - height - 2.0 * padding,
                     width + 2.0 * padding, height + 2.0 * padding);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 24, 22, 190));
    painter.drawRoundedRect(box, 6.0, 6.0);
    painter.setPen(Qt::white);
    double y = box.top() + padding;
    for (const QString& line : lines) {
        painter.drawText(QRectF(box.left() + padding, y, width, lineHeight), Qt::AlignVCenter | Qt::AlignLeft,
                         line);
        y += lineHeight;
    }
    if (!colours)
        return;
    const QRectF bar(box.left() + padding, y + 4.0, barWidth, barHeight);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    const auto along = [](std::size_t i) { return double(i) / double(scale().size() - 1); };
    for (std::size_t i = 0; i < scale().size(); ++i)
        gradient.setColorAt(along(i), scale()[i].colour);
    painter.fillRect(bar, gradient);
    for (std::size_t i = 0; i < scale().size(); ++i) {
        const QString number = QLocale().toString(scale()[i].stretch, 'g', 3);
        const double half = 0.5 * metrics.horizontalAdvance(number);
        const double x = std::clamp(bar.left() + along(i) * barWidth, bar.left() + half, bar.right() - half);
        painter.drawText(QRectF(x - half, bar.bottom() + 2.0, 2.0 * half, lineHeight), Qt::AlignCenter,
                         number);
    }
}

} // namespace ramure
