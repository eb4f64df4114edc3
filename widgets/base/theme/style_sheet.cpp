#include "widgets/base/theme/theme.h"

#include <QFile>
#include <cmath>

namespace ramure {

QColor blended(const QColor& a, const QColor& b, double share)
{
    const auto mix = [share](int x, int y) { return int(std::lround(x + (y - x) * share)); };
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

QString themeStyleSheet(const QPalette& palette)
{
    QFile file(QStringLiteral(":/theme/theme.qss"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QString sheet = QString::fromUtf8(file.readAll());
    const bool dark = isDark(palette);
    const QColor window = palette.color(QPalette::Window);
    const QColor text = palette.color(QPalette::WindowText);
    const QColor accent = palette.color(QPalette::Highlight);
    const std::pair<const char*, QColor> colours[] = {
        {"@window@", window},
        {"@base@", palette.color(QPalette::Base)},
        {"@text@", text},
        {"@dim@", palette.color(QPalette::PlaceholderText)},
        {"@disabled@", palette.color(QPalette::Disabled, QPalette::WindowText)},
        {"@line@", blended(window, text, dark ? 0.14 : 0.16)},
        {"@field-line@", blended(window, text, dark ? 0.2 : 0.26)},
        {"@bar@", dark ? blended(window, Qt::white, 0.045) : blended(window, Qt::black, 0.045)},
        {"@hover@", blended(window, text, 0.1)},
        {"@pressed@", blended(window, text, 0.18)},
        {"@groove@", blended(window, text, 0.22)},
        {"@accent@", accent},
        {"@accent-soft@", blended(window, accent, dark ? 0.35 : 0.22)},
        {"@accent-text@", palette.color(QPalette::HighlightedText)},
        {"@error@", errorColour(palette)},
        {"@good@", goodColour(palette)},
        {"@warning@", warningColour(palette)},
        {"@tip@", palette.color(QPalette::ToolTipBase)},
        {"@axis-x@", dark ? QColor(0xe8, 0x8f, 0x87) : QColor(0xa8, 0x35, 0x2c)},
        {"@axis-y@", dark ? QColor(0x86, 0xc2, 0x7c) : QColor(0x2f, 0x6f, 0x26)},
        {"@axis-z@", dark ? QColor(0x7f, 0xab, 0xe6) : QColor(0x2f, 0x62, 0xb0)},
    };
    for (const auto& [name, colour] : colours)
        sheet.replace(QLatin1String(name), colour.name());
    sheet.replace(QLatin1String("@icons@"),
                  dark ? QStringLiteral(":/icons/ramure-dark/scalable/actions/ramure-")
                       : QStringLiteral(":/icons/ramure-light/scalable/actions/ramure-"));
    return sheet;
}

} // namespace ramure
