#include "widgets/base/theme.h"

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
        {"@dim@", blended(window, text, 0.6)},
        {"@line@", blended(window, text, dark ? 0.14 : 0.16)},
        {"@field-line@", blended(window, text, dark ? 0.2 : 0.26)},
        {"@bar@", dark ? blended(window, Qt::white, 0.045) : blended(window, Qt::black, 0.045)},
        {"@hover@", blended(window, text, 0.1)},
        {"@pressed@", blended(window, text, 0.18)},
        {"@groove@", blended(window, text, 0.22)},
        {"@accent@", accent},
        {"@accent-soft@", blended(window, accent, dark ? 0.45 : 0.3)},
        {"@accent-text@", palette.color(QPalette::HighlightedText)},
        {"@error@", errorColour(palette)},
        {"@good@", goodColour(palette)},
        {"@warning@", warningColour(palette)},
        {"@tip@", palette.color(QPalette::ToolTipBase)},
        {"@axis-x@", dark ? QColor(0xe0, 0x80, 0x78) : QColor(0xb4, 0x3c, 0x33)},
        {"@axis-y@", dark ? QColor(0x86, 0xc2, 0x7c) : QColor(0x3c, 0x83, 0x32)},
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
