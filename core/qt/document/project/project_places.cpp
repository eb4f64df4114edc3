#include "core/qt/document/project/project_places.h"

#include "core/qt/document/project/project_json.h"

#include <QJsonArray>
#include <limits>

namespace ramure::json {

namespace {

struct PrintCount
{
    const char* key;
    std::uint32_t AxisPrint::*member;
};
constexpr PrintCount printCounts[] = {{"fork", &AxisPrint::fork},
                                      {"mate", &AxisPrint::mate},
                                      {"forks", &AxisPrint::forks},
                                      {"mates", &AxisPrint::mates}};

struct PrintNumber
{
    const char* key;
    double AxisPrint::*member;
};
constexpr PrintNumber printNumbers[] = {{"s", &AxisPrint::s},
                                        {"share", &AxisPrint::share},
                                        {"downAngle", &AxisPrint::downAngle},
                                        {"azimuth", &AxisPrint::azimuth},
                                        {"length", &AxisPrint::length},
                                        {"radius", &AxisPrint::radius}};

Expected<std::uint64_t> readHex(const QJsonObject& object, const char* key)
{
    auto number = branchKeyFromText(object.value(QLatin1String(key)).toString());
    if (!number)
        return failInside(key, number.error());
    return *number;
}

Expected<std::uint32_t> readCount(const QJsonObject& object, const char* key)
{
    const qint64 number = object.value(QLatin1String(key)).toInteger(-1);
    if (number < 0 || number > std::numeric_limits<std::uint32_t>::max())
        return failAt(key, ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
    return static_cast<std::uint32_t>(number);
}

Expected<AxisPrint> readPrint(const QJsonObject& object)
{
    AxisPrint print;
    const auto address = readHex(object, "id");
    RAMURE_TRY(address);
    print.address = *address;
    for (const PrintCount& field : printCounts) {
        const auto number = readCount(object, field.key);
        RAMURE_TRY(number);
        print.*field.member = *number;
    }
    for (const PrintNumber& field : printNumbers) {
        const QJsonValue number = object.value(QLatin1String(field.key));
        if (!number.isDouble())
            return failAt(field.key, ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
        print.*field.member = number.toDouble();
    }
    return print;
}

QJsonObject writePrint(const AxisPrint& print)
{
    QJsonObject object{{QStringLiteral("id"), branchKey(print.address)}};
    for (const PrintCount& field : printCounts)
        object.insert(QLatin1String(field.key), qint64(print.*field.member));
    for (const PrintNumber& field : printNumbers)
        object.insert(QLatin1String(field.key), print.*field.member + 0.0); // -0 is written as 0
    return object;
}

} // namespace

QJsonObject writePlace(const BranchPlace& place)
{
    QJsonArray way;
    for (const AxisPrint& print : place.way)
        way.append(writePrint(print));
    return {{QStringLiteral("tree"), branchKey(place.tree)},
            {QStringLiteral("way"), way},
            {QStringLiteral("fork"), qint64(place.fork)},
            {QStringLiteral("piece"), qint64(place.piece)},
            {QStringLiteral("share"), place.share}};
}

Expected<BranchPlace> readPlace(const QJsonValue& value)
{
    BranchPlace place;
    if (value.isUndefined())
        return place;
    if (!value.isObject())
        return failAt({}, ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
    const QJsonObject object = value.toObject();
    const auto tree = readHex(object, "tree");
    const auto fork = readCount(object, "fork"), piece = readCount(object, "piece");
    RAMURE_TRY(tree);
    for (const auto* number : {&fork, &piece})
        if (!*number)
            return fail(number->error());
    place.tree = *tree;
    place.fork = *fork;
    place.piece = *piece;
    if (!object.value(QLatin1String("share")).isDouble())
        return failAt("share", ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
    place.share = object.value(QLatin1String("share")).toDouble();
    if (!object.value(QLatin1String("way")).isArray())
        return failAt("way", ErrorCode::Invalid, RAMURE_NOOP("an array is expected here"));
    for (const QJsonValue& axis : object.value(QLatin1String("way")).toArray()) {
        auto print = readPrint(axis.toObject());
        if (!print)
            return failInside(std::string("way").append(indexPlace(qsizetype(place.way.size()))),
                              std::move(print.error()));
        place.way.push_back(*print);
    }
    return place;
}

} // namespace ramure::json
