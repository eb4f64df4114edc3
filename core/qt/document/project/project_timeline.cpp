#include "core/qt/document/project/project_timeline.h"

#include "core/qt/document/project/project_json.h"

#include <array>

namespace ramure::json {

static constexpr std::array<const char*, 3> loopNames{"once", "loop", "pingPong"};

QJsonObject writeTimeline(const TimelineSettings& settings)
{
    const TimelineSettings usual;
    QJsonObject object;
    if (settings.framesPerSecond != usual.framesPerSecond)
        object.insert(QLatin1String("framesPerSecond"), settings.framesPerSecond);
    if (settings.firstFrame != usual.firstFrame)
        object.insert(QLatin1String("firstFrame"), qint64{settings.firstFrame});
    if (settings.lastFrame != usual.lastFrame)
        object.insert(QLatin1String("lastFrame"), qint64{settings.lastFrame});
    if (settings.loop != usual.loop)
        object.insert(QLatin1String("loop"),
                      QLatin1String(loopNames[static_cast<std::size_t>(settings.loop)]));
    if (settings.seamless != usual.seamless)
        object.insert(QLatin1String("seamless"), settings.seamless);
    return object;
}

static Expected<void> readFrame(QJsonObject& object, const char* key, std::int64_t& frame)
{
    const QJsonValue value = object.take(QLatin1String(key));
    if (value.isUndefined())
        return {};
    // Two different defaults: only a whole number gives the same answer to both.
    if (!value.isDouble() || value.toInteger(0) != value.toInteger(1))
        return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("a whole number is expected here"));
    frame = value.toInteger();
    return {};
}

static Expected<void> readLoop(QJsonObject& object, PlayLoop& loop)
{
    const QJsonValue value = object.take(QLatin1String("loop"));
    if (value.isUndefined())
        return {};
    for (std::size_t i = 0; i < loopNames.size(); ++i)
        if (value == QJsonValue(QLatin1String(loopNames[i]))) {
            loop = static_cast<PlayLoop>(i);
            return {};
        }
    return failAt("loop", ErrorCode::Invalid, RAMURE_NOOP("once, loop or pingPong is expected here"));
}

static Expected<void> readSeamless(QJsonObject& object, bool& seamless)
{
    const QJsonValue value = object.take(QLatin1String("seamless"));
    if (!value.isUndefined() && !value.isBool())
        return failAt("seamless", ErrorCode::Invalid, RAMURE_NOOP("true or false is expected here"));
    seamless = value.toBool(seamless);
    return {};
}

Expected<TimelineSettings> readTimeline(QJsonObject& object)
{
    TimelineSettings settings;
    const QJsonValue rate = object.take(QLatin1String("framesPerSecond"));
    if (!rate.isUndefined() && !rate.isDouble())
        return failAt("framesPerSecond", ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
    settings.framesPerSecond = rate.toDouble(settings.framesPerSecond);
    RAMURE_TRY(readFrame(object, "firstFrame", settings.firstFrame));
    RAMURE_TRY(readFrame(object, "lastFrame", settings.lastFrame));
    RAMURE_TRY(readLoop(object, settings.loop));
    RAMURE_TRY(readSeamless(object, settings.seamless));
    RAMURE_TRY(checkTimeline(settings));
    return settings;
}

} // namespace ramure::json
