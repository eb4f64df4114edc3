#include "widgets/panels/properties/stem_curves.h"

#include "core/generators/weber_penn/stem_formulas.h"
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr int samples = 96;

} // namespace

StemCurves::StemCurves(Document* document, std::optional<std::size_t> level, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_level(level)
{
    setObjectName(level ? QStringLiteral("stemCurve%1").arg(*level) : QStringLiteral("crownCurve"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeParams | changeReset | changeStructure))
            refresh();
    });
    setToolTip(
        m_level
            ? tr("How a stem of this level tapers and bends, without chance. Thickness is drawn larger.")
            : tr("How far limbs reach from the trunk, by height. Dashed: the envelope that prunes them."));
    setAccessibleName(toolTip());
}

QSize StemCurves::sizeHint() const
{
    return {160, m_level ? 72 : 120};
}

void StemCurves::setNode(NodeId node)
{
    m_node = node;
    refresh();
}

void StemCurves::refresh()
{
    const Node* node = m_document->scene().find(m_node);
    std::optional<WeberPennParams> now;
    if (node && node->kind == NodeKind::Tree)
        now = node->params.weberPenn;
    setVisible(now.has_value());
    if (now == m_params)
        return;
    m_params = now;
    update();
}

void StemCurves::paintEvent(QPaintEvent*)
{
    if (!m_params)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(palette().base());
    const QRectF all = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.drawRoundedRect(all, 4, 4);
    painter.setClipRect(all);
    QColor filled = palette().color(QPalette::Highlight);
    painter.setPen(QPen(filled, 1.5));
    filled.setAlphaF(isEnabled() ? 0.25F : 0.1F);
    painter.setBrush(filled);
    const QRectF field = all.adjusted(8, 8, -8, -8);
    if (m_level)
        paintStem(painter, field);
    else
        paintCrown(painter, field);
}

void StemCurves::paintCrown(QPainter& painter, const QRectF& field) const
{
    const WeberPennParams& p = *m_params;
    const auto ratioAt = [&](double height) { return (1.0 - height) / (1.0 - p.baseSize); };
    double widest = 0.25;
    const auto outline = [&](auto&& reach) {
        std::vector<std::pair<double, double>> sides;
        for (int i = 0; i <= samples; ++i) {
            const double height = std::lerp(p.baseSize, 1.0, i / double(samples));
            sides.emplace_back(height, reach(std::clamp(ratioAt(height), 0.0, 1.0)));
            widest = std::max(widest, sides.back().second);
        }
        return sides;
    };
    const auto crown =
        outline([&](double ratio) { return p.level[1].length * shapeRatio(p, p.shape, ratio); });
    const auto envelope = outline([&](double ratio) { return p.pruneWidth * envelopeRatio(p, ratio); });
    const double scale = std::min(field.height(), 0.5 * field.width() / widest);
    const auto polygon = [&](const auto& sides) {
        QPolygonF right, left;
        for (const auto& [height, reach] : sides) {
            right.append({field.center().x() + scale * reach, field.bottom() - scale * height});
            left.prepend({field.center().x() - scale * reach, field.bottom() - scale * height});
        }
        return right + left;
    };
    if (p.levels > 1)
        painter.drawPolygon(polygon(crown));
    painter.setBrush(Qt::NoBrush);
    if (p.levels > 1 && p.pruneRatio > 0.0) {
        painter.setPen(QPen(palette().color(QPalette::Text), 1.0, Qt::DashLine));
        painter.drawPolygon(polygon(envelope));
    }
    painter.setPen(QPen(palette().color(QPalette::Text), 2.0));
    painter.drawLine(QPointF(field.center().x(), field.bottom()),
                     QPointF(field.center().x(), field.bottom() - scale));
}

void StemCurves::paintStem(QPainter& painter, const QRectF& field) const
{
    const WeberPennParams& p = *m_params;
    const WeberPennLevel& level = p.level[*m_level];
    // A stem as long as the trunk: periodic tapers have their beads by its thickness.
    const double thin = std::max(p.ratio, 1e-4), drawn = 0.09;
    QPolygonF upper, lower;
    QPointF at;
    double angle = 0.0;
    for (int i = 0; i <= samples; ++i) {
        const double z = i / double(samples);
        double radius = taperedRadius(level.taper, thin, 1.0, z) / thin * drawn;
        if (*m_level == 0)
            radius *= trunkFactor(p, z);
        const QPointF along(std::cos(angle), -std::sin(angle)), aside(along.y(), -along.x());
        upper.append(at + radius * aside);
        lower.prepend(at - radius * aside);
        const double bend = level.curveBack == 0.0 ? level.curve
                            : z < 0.5              ? 2.0 * level.curve
                                                   : 2.0 * level.curveBack;
        // Positive curves lead away from the sky.
        angle -= bend / samples;
        at += along / samples;
    }
    QPolygonF outline = upper + lower;
    const QRectF box = outline.boundingRect();
    const double scale = std::min(field.width() / box.width(), field.height() / box.height());
    for (QPointF& point : outline)
        point = field.center() + scale * (point - box.center());
    painter.drawPolygon(outline);
}

} // namespace ramure
