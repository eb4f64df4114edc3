#include "widgets/base/texts/time_text.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

std::int64_t wholeRate(double framesPerSecond)
{
    return std::max<std::int64_t>(1, std::llround(std::ceil(framesPerSecond - 1e-9)));
}

QString timecode(std::int64_t frame, double framesPerSecond)
{
    const std::int64_t rate = wholeRate(framesPerSecond), all = std::abs(frame);
    const std::int64_t seconds = all / rate;
    const auto two = [](std::int64_t value) { return QString::number(value).rightJustified(2, u'0'); };
    return (frame < 0 ? QStringLiteral("-") : QString()) + two(seconds / 3600) + u':' +
           two(seconds / 60 % 60) + u':' + two(seconds % 60) + u':' + two(all % rate);
}

std::optional<std::int64_t> fromTimecode(QString text, double framesPerSecond)
{
    const bool negative = text.startsWith(u'-');
    if (negative)
        text.remove(0, 1);
    const QStringList parts = text.split(u':');
    if (parts.size() < 2 || parts.size() > 4)
        return std::nullopt;
    const std::int64_t rate = wholeRate(framesPerSecond);
    const std::int64_t worth[] = {1, rate, 60 * rate, 3600 * rate};
    std::int64_t frames = 0;
    for (qsizetype i = 0; i < parts.size(); ++i) {
        bool whole = false;
        const qlonglong value = parts[parts.size() - 1 - i].toLongLong(&whole);
        if (!whole || value < 0 || value > mostFrame)
            return std::nullopt;
        frames += value * worth[i];
    }
    return std::clamp(negative ? -frames : frames, leastFrame, mostFrame);
}

std::optional<double> number(QString text)
{
    text = text.trimmed();
    bool good = false;
    double value = QLocale().toDouble(text, &good);
    if (!good)
        value = QLocale::c().toDouble(text, &good);
    return good && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace

QString timeText(std::int64_t frame, double framesPerSecond, TimeDisplay display)
{
    switch (display) {
    case TimeDisplay::Frames:
        return QString::number(qlonglong{frame});
    case TimeDisplay::Seconds: {
        QLocale locale;
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        return locale.toString(double(frame) / framesPerSecond, 'f', 2) + QStringLiteral(" s");
    }
    case TimeDisplay::Timecode:
        return timecode(frame, framesPerSecond);
    }
    return {};
}

std::optional<std::int64_t> frameFromText(const QString& text, double framesPerSecond, TimeDisplay display)
{
    QString plain = text.trimmed();
    if (plain.contains(u':'))
        return fromTimecode(plain, framesPerSecond);
    bool seconds = display == TimeDisplay::Seconds;
    if (plain.endsWith(u's', Qt::CaseInsensitive) || plain.endsWith(u'f', Qt::CaseInsensitive)) {
        seconds = plain.endsWith(u's', Qt::CaseInsensitive);
        plain.chop(1);
    }
    const std::optional<double> value = number(plain);
    if (!value)
        return std::nullopt;
    const double frames = seconds ? *value * framesPerSecond : *value;
    return std::llround(std::clamp(frames, double(leastFrame), double(mostFrame)));
}

} // namespace ramure
