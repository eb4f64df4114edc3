#include "widgets/view/tools/arm/arm_overlay.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <vector>

namespace ramure {
namespace {

constexpr double overlayMargin = 12.0, leastWidth = 260.0, plotHeight = 84.0;

struct ArmWords
{
    Q_DECLARE_TR_FUNCTIONS(ArmOverlay)
};

constexpr double leastResidual = 1e-6; ///< m; less is drawn as this

/// Powers of ten that a plot shows, both ends.
struct Decades
{
    double low = -1.0, high = 0.0;

    explicit Decades(const std::vector<float>& residuals)
    {
        const auto [smallest, largest] = std::minmax_element(residuals.begin(), residuals.end());
        high = std::ceil(std::log10(std::max(double(*largest), leastResidual)));
        low = std::min(std::floor(std::log10(std::max(double(*smallest), leastResidual))), high - 1.0);
    }
    [[nodiscard]] double y(double metres, const QRectF& place) const
    {
        return place.bottom() -
               (std::log10(std::max(metres, leastResidual)) - low) / (high - low) * place.height();
    }
};

/// At most one point a pixel, the largest there: a plot of thousands is as quick as one of tens.
QPolygonF curve(const std::vector<float>& residuals, const Decades& decades, const QRectF& place)
{
    QPolygonF points;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        const double x =
            place.left() +
            (residuals.size() > 1 ? double(i) / double(residuals.size() - 1) : 0.0) * place.width();
        const double y = decades.y(double(residuals[i]), place);
        if (!points.isEmpty() && x - points.back().x() < 0.5)
            points.back().setY(std::min(points.back().y(), y));
        else
            points << QPointF(x, y);
    }
    return points;
}

QString decadeText(double exponent)
{
    const QLocale locale;
    if (exponent >= 0.0)
        return ArmWords::tr("%1 m").arg(locale.toString(std::pow(10.0, exponent), 'f', 0));
    if (exponent >= -3.0)
        return ArmWords::tr("%1 mm").arg(locale.toString(std::pow(10.0, exponent + 3.0), 'f', 0));
    return ArmWords::tr("%1 µm").arg(locale.toString(std::pow(10.0, exponent + 6.0), 'f', 0));
}

/// The labels of a plot stand on its left, clear of its lines and its curve.
QFont labelFont(const QFont& text)
{
    QFont font = text;
    if (font.pointSizeF() > 0.0)
        font.setPointSizeF(0.8 * font.pointSizeF());
    return font;
}

/// As many powers of ten as there is room for, from the highest on.
std::vector<double> exponentsShown(const Decades& decades, double height, double lineHeight)
{
    const double every = std::max(1.0, std::ceil((decades.high - decades.low) * lineHeight / height));
    std::vector<double> shown;
    for (double exponent = decades.high; exponent >= decades.low; exponent -= every)
        shown.push_back(exponent);
    return shown;
}

/// The curve beside its labels, with a line for each label.
void paintPlot(QPainter& painter, const std::vector<float>& residuals, const QRectF& place)
{
    const QFont before = painter.font();
    painter.setFont(labelFont(before));
    const QFontMetricsF metrics(painter.font());
    const Decades decades(residuals);
    const double half = 0.5 * metrics.height();
    const std::vector<double> shown = exponentsShown(decades, place.height() - 2.0 * half, metrics.height());
    double gutter = 0.0;
    for (const double exponent : shown)
        gutter = std::max(gutter, metrics.horizontalAdvance(decadeText(exponent)));
    const QRectF field = place.adjusted(gutter + 6.0, half, 0.0, -half);
    for (const double exponent : shown) {
        const double y = decades.y(std::pow(10.0, exponent), field);
        painter.setPen(QPen(QColor(255, 255, 255, 50), 1.0));
        painter.drawLine(QPointF(field.left(), y), QPointF(field.right(), y));
        painter.setPen(QColor(255, 255, 255, 190));
        painter.drawText(QRectF(place.left(), y - half, gutter, 2.0 * half),
                         Qt::AlignRight | Qt::AlignVCenter, decadeText(exponent));
    }
    painter.setPen(QPen(QColor(90, 220, 120), 1.6));
    painter.drawPolyline(curve(residuals, decades, field));
    painter.setFont(before);
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
                     .arg(limits[i] == ArmLimit::Upper ? ArmWords::tr("max") : ArmWords::tr("min"));
    }
    if (count == 0)
        return {};
    if (count > mostNamed)
        names += QStringLiteral("…");
    return ArmWords::tr("%n angle(s) at a limit", nullptr, count) + QStringLiteral(": ") +
           names.join(QStringLiteral(", "));
}

} // namespace

QString shortLengthText(double metres)
{
    const QLocale locale;
    const auto digits = [&locale](double value) { return locale.toString(value, 'f', value < 10.0 ? 2 : 1); };
    if (metres >= 0.1)
        return ArmWords::tr("%1 m").arg(locale.toString(metres, 'f', 3));
    if (metres >= 1e-4)
        return ArmWords::tr("%1 mm").arg(digits(1e3 * metres));
    return ArmWords::tr("%1 µm").arg(digits(1e6 * metres));
}

QString armStatusText(const ArmProgress& progress)
{
    QString text = ArmWords::tr("residual %1 after %n step(s)", nullptr, int(progress.figures.steps))
                       .arg(shortLengthText(progress.residual));
    if (progress.figures.status == ArmStatus::Settled)
        text += QLatin1Char('\n') + ArmWords::tr("unreachable: %1 m short")
                                        .arg(QLocale().toString(progress.figures.shortBy(), 'f', 3));
    else if (progress.figures.status == ArmStatus::Reached && !progress.moves)
        text += QLatin1Char('\n') + ArmWords::tr("reached");
    if (const QString limits = limitsText(progress.limits); !limits.isEmpty())
        text += QLatin1Char('\n') + limits;
    return text;
}

void paintTarget(QPainter& painter, const PickView& view, const glm::dvec3& world, bool bright)
{
    const auto pixel = view.pixel(world);
    if (!pixel)
        return;
    const QPointF at(pixel->x, pixel->y);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(QColor(10, 40, 16, 160), 4.0),
                            bright ? QPen(QColor(255, 236, 120), 3.0) : QPen(QColor(90, 230, 120), 2.0)}) {
        painter.setPen(pen);
        painter.drawEllipse(at, 7.0, 7.0);
        for (const QPointF& way :
             {QPointF(1.0, 0.0), QPointF(0.0, 1.0), QPointF(-1.0, 0.0), QPointF(0.0, -1.0)})
            painter.drawLine(at + 5.0 * way, at + 11.0 * way);
    }
}

void paintArmStatus(QPainter& painter, QSize size, const ArmProgress& progress)
{
    const QString text = armStatusText(progress);
    double width = leastWidth;
    for (const QString& line : text.split(QLatin1Char('\n')))
        width = std::max(width, painter.fontMetrics().horizontalAdvance(line) + 20.0);
    width = std::min(width, size.width() - 2.0 * overlayMargin);
    const double textHeight = painter.fontMetrics().lineSpacing() * double(text.count(QLatin1Char('\n')) + 1);
    const bool plots = progress.residuals.size() > 1;
    const double height = textHeight + (plots ? plotHeight + 8.0 : 0.0) + 16.0;
    const QRectF box(overlayMargin, size.height() - overlayMargin - height, width, height);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 26, 32, 170));
    painter.drawRoundedRect(box, 6.0, 6.0);
    painter.setPen(Qt::white);
    painter.drawText(box.adjusted(10.0, 8.0, -10.0, -8.0), Qt::AlignLeft | Qt::AlignTop, text);
    if (!plots)
        return;
    const QRectF place(box.left() + 10.0, box.bottom() - 8.0 - plotHeight, width - 20.0, plotHeight);
    painter.setBrush(Qt::NoBrush);
    paintPlot(painter, progress.residuals, place);
}

} // namespace ramure
