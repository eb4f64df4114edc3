#include "widgets/panels/animation/key_texts.h"

#include "core/rig/tracks/easing.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/theme.h"
#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <array>
#include <numbers>

namespace ramure {
namespace {

QString text(const char* english)
{
    return QCoreApplication::translate("keys", english);
}

template <class Enum, std::size_t n> QString named(const std::array<const char*, n>& names, Enum value)
{
    return text(names[static_cast<std::size_t>(value)]);
}

double share(KeyMode mode, Easing easing, double x)
{
    switch (mode) {
    case KeyMode::Constant:
        return x < 1.0 ? 0.0 : 1.0;
    case KeyMode::Linear:
        return x;
    case KeyMode::Bezier:
        return x * x * (3.0 - 2.0 * x);
    case KeyMode::Cubic: // passes through its keys without rest
        return x + 0.35 * x * (1.0 - x) * (2.0 * x - 1.0);
    default:
        break;
    }
    KeyShape shape;
    shape.mode = mode;
    shape.easing = easing;
    shape.period = 0.3;
    return easedShare(shape, x, 1.0, 1.0);
}

QPixmap modePicture(KeyMode mode, Easing easing, const QPalette& palette, qreal scale)
{
    constexpr double width = 22.0, height = 16.0, left = 2.5, top = 3.5, wide = 17.0, high = 9.0;
    QPixmap pixmap(QSizeF(width * scale, height * scale).toSize());
    pixmap.setDevicePixelRatio(scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr int steps = 48;
    QPolygonF line;
    for (int i = 0; i <= steps; ++i) {
        const double x = double(i) / steps;
        const double y = std::clamp(share(mode, easing, x), -0.3, 1.3);
        if (mode == KeyMode::Constant && i == steps)
            line << QPointF(left + wide, top + high);
        line << QPointF(left + x * wide, top + high * (1.0 - y));
    }
    painter.setPen(
        QPen(palette.color(QPalette::WindowText), 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette.color(QPalette::Highlight));
    for (const QPointF& end : {QPointF(left, top + high), QPointF(left + wide, top)})
        painter.drawEllipse(end, 2.0, 2.0);
    return pixmap;
}

} // namespace

QString keyModeText(KeyMode mode)
{
    static constexpr std::array<const char*, keyModeCount> names{
        QT_TRANSLATE_NOOP("keys", "Constant"), QT_TRANSLATE_NOOP("keys", "Linear"),
        QT_TRANSLATE_NOOP("keys", "Bézier"),   QT_TRANSLATE_NOOP("keys", "Spline"),
        QT_TRANSLATE_NOOP("keys", "Sine"),     QT_TRANSLATE_NOOP("keys", "Quadratic"),
        QT_TRANSLATE_NOOP("keys", "Cubic"),    QT_TRANSLATE_NOOP("keys", "Quartic"),
        QT_TRANSLATE_NOOP("keys", "Quintic"),  QT_TRANSLATE_NOOP("keys", "Exponential"),
        QT_TRANSLATE_NOOP("keys", "Circular"), QT_TRANSLATE_NOOP("keys", "Back"),
        QT_TRANSLATE_NOOP("keys", "Bounce"),   QT_TRANSLATE_NOOP("keys", "Elastic")};
    return named(names, mode);
}

QString keyModeTip(KeyMode mode)
{
    switch (mode) {
    case KeyMode::Constant:
        return text(QT_TRANSLATE_NOOP("keys", "The value stays until the next key"));
    case KeyMode::Linear:
        return text(QT_TRANSLATE_NOOP("keys", "Straight to the next key"));
    case KeyMode::Bezier:
        return text(QT_TRANSLATE_NOOP("keys", "Along the handles of this key and the next"));
    case KeyMode::Cubic:
        return text(QT_TRANSLATE_NOOP("keys", "A spline through the keys around, without handles"));
    default:
        return text(QT_TRANSLATE_NOOP("keys", "An easing: the picture shows the way to the next key"));
    }
}

QString easingText(Easing easing)
{
    static constexpr std::array<const char*, easingCount> names{
        QT_TRANSLATE_NOOP("keys", "Automatic"), QT_TRANSLATE_NOOP("keys", "At the start"),
        QT_TRANSLATE_NOOP("keys", "At the end"), QT_TRANSLATE_NOOP("keys", "At both ends")};
    return named(names, easing);
}

QString handleTypeText(HandleType type)
{
    static constexpr std::array<const char*, handleTypeCount> names{
        QT_TRANSLATE_NOOP("keys", "Free"), QT_TRANSLATE_NOOP("keys", "Aligned"),
        QT_TRANSLATE_NOOP("keys", "Vector"), QT_TRANSLATE_NOOP("keys", "Smooth"),
        QT_TRANSLATE_NOOP("keys", "Smooth, never beyond the keys")};
    return named(names, type);
}

QString extrapolationText(Extrapolation extrapolation)
{
    static constexpr std::array<const char*, extrapolationCount> names{
        QT_TRANSLATE_NOOP("keys", "Hold"), QT_TRANSLATE_NOOP("keys", "Go on straight"),
        QT_TRANSLATE_NOOP("keys", "Repeat"), QT_TRANSLATE_NOOP("keys", "Repeat with offset"),
        QT_TRANSLATE_NOOP("keys", "Back and forth")};
    return named(names, extrapolation);
}

QString channelText(const Channel& channel)
{
    static constexpr std::array<const char*, 6> transforms{
        QT_TRANSLATE_NOOP("keys", "Position"),     QT_TRANSLATE_NOOP("keys", "Rotation"),
        QT_TRANSLATE_NOOP("keys", "Scale"),        QT_TRANSLATE_NOOP("keys", "Own position"),
        QT_TRANSLATE_NOOP("keys", "Own rotation"), QT_TRANSLATE_NOOP("keys", "Own scale")};
    if (const JointDef* joint = channel.jointDef())
        return text(QT_TRANSLATE_NOOP("keys", "Joint %1: %2"))
            .arg(channel.component + 1)
            .arg(coreText(joint->label));
    const ParamDef* def = channel.def();
    QString name = def ? coreText(def->label) : named(transforms, channel.part);
    if (def && (def->flags & paramColor) != 0) {
        static constexpr std::array<const char*, 3> parts{QT_TRANSLATE_NOOP("keys", "red"),
                                                          QT_TRANSLATE_NOOP("keys", "green"),
                                                          QT_TRANSLATE_NOOP("keys", "blue")};
        return text(QT_TRANSLATE_NOOP("keys", "%1: %2")).arg(name, named(parts, channel.component));
    }
    if (def ? def->type == ParamType::Vec3 : !channel.isOrientation())
        name += QStringLiteral(" %1").arg(QLatin1Char("XYZ"[channel.component]));
    return name;
}

NumberFormat channelFormat(const Channel& channel)
{
    if (const ParamDef* def = channel.def())
        return numberFormat(*def, AngleUnit::Degrees);
    NumberFormat format;
    format.decimals = 3;
    const JointDef* joint = channel.jointDef();
    if (joint ? joint->angle != nullptr : channel.isOrientation()) {
        format.unit = ParamUnit::Radian;
        format.factor = 180.0 / std::numbers::pi;
        format.suffix = QStringLiteral("°");
        format.decimals = 1;
    } else if (!channel.isScale()) {
        format.unit = ParamUnit::Metre;
        format.suffix = QStringLiteral(" m");
    }
    return format;
}

QIcon keyModeIcon(KeyMode mode, Easing easing, const QPalette& palette)
{
    QIcon icon;
    for (const qreal scale : {1.0, 2.0})
        icon.addPixmap(modePicture(mode, easing, palette, scale));
    return icon;
}

QColor channelColour(const Channel& channel, const QPalette& palette)
{
    const bool dark = isDark(palette);
    const ParamDef* def = channel.def();
    const bool length = channel.jointDef() && !channel.jointDef()->angle;
    if (channel.isOrientation() || length || (def && def->type != ParamType::Vec3))
        return dark ? QColor(0xe0, 0xc0, 0x60) : QColor(0x8a, 0x66, 0x10);
    static const std::array<QColor, 3> onDark{QColor(0xf0, 0x78, 0x70), QColor(0x80, 0xcc, 0x70),
                                              QColor(0x78, 0xa8, 0xf4)};
    static const std::array<QColor, 3> onLight{QColor(0xb8, 0x30, 0x28), QColor(0x2c, 0x80, 0x28),
                                               QColor(0x28, 0x58, 0xc0)};
    // Of joints the colours of their rings: phi blue, theta the warm one.
    const JointDef* joint = channel.jointDef();
    const std::size_t which = !joint ? channel.component : joint->angle == &ArmJoint::phi ? 2 : 0;
    return (dark ? onDark : onLight)[which];
}

void paintKey(QPainter& painter, const QPointF& centre, double side, KeyMode mode)
{
    const double r = 0.5 * side, x = centre.x(), y = centre.y();
    switch (mode) {
    case KeyMode::Constant:
        painter.drawRect(QRectF(x - 0.8 * r, y - 0.8 * r, 1.6 * r, 1.6 * r));
        return;
    case KeyMode::Linear:
        painter.drawPolygon(QPolygonF{{x, y - r}, {x + r, y}, {x, y + r}, {x - r, y}});
        return;
    case KeyMode::Bezier:
    case KeyMode::Cubic:
        painter.drawEllipse(centre, 0.85 * r, 0.85 * r);
        return;
    default:
        painter.drawPolygon(QPolygonF{{x - r, y - r},
                                      {x + r, y - r},
                                      {x + 0.35 * r, y},
                                      {x + r, y + r},
                                      {x - r, y + r},
                                      {x - 0.35 * r, y}});
    }
}

} // namespace ramure
