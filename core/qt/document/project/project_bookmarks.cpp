#include "core/qt/document/project/project_bookmarks.h"

#include "core/qt/document/project/project_json.h"
#include <QJsonArray>
#include <utility>

namespace ramure::json {
namespace {

struct NumberField
{
    const char* key;
    double ViewBookmark::*field;
};
constexpr NumberField viewNumbers[] = {
    {"distance", &ViewBookmark::distance},
    {"yaw", &ViewBookmark::yawRad},
    {"pitch", &ViewBookmark::pitchRad},
    {"fov", &ViewBookmark::fovRad},
};

QString digit(std::size_t place)
{
    return QString::number(place + 1);
}

Expected<ViewBookmark> readBookmark(const QJsonObject& object)
{
    ViewBookmark view;
    const QJsonArray target = object.value(QLatin1String("target")).toArray();
    if (target.size() != 3)
        return failAt("target", ErrorCode::Invalid, RAMURE_NOOP("three numbers are expected here"));
    for (int axis = 0; axis < 3; ++axis) {
        if (!target[axis].isDouble())
            return failAt("target", ErrorCode::Invalid, RAMURE_NOOP("three numbers are expected here"));
        view.target[axis] = target[axis].toDouble();
    }
    for (const NumberField& number : viewNumbers) {
        const QJsonValue value = object.value(QLatin1String(number.key));
        if (!value.isDouble())
            return failAt(number.key, ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
        view.*number.field = value.toDouble();
    }
    view.orthographic = object.value(QLatin1String("orthographic")).toBool();
    RAMURE_TRY(checkViewBookmark(view));
    return view;
}

} // namespace

QJsonObject writeBookmarks(const ViewBookmarks& bookmarks)
{
    QJsonObject views;
    for (std::size_t place = 0; place < bookmarks.size(); ++place) {
        const auto& view = bookmarks[place];
        if (!view)
            continue;
        QJsonObject object{
            {QStringLiteral("target"), QJsonArray{view->target.x, view->target.y, view->target.z}}};
        for (const NumberField& number : viewNumbers)
            object.insert(QLatin1String(number.key), (*view).*number.field);
        if (view->orthographic)
            object.insert(QLatin1String("orthographic"), true);
        views.insert(digit(place), object);
    }
    return views;
}

Expected<ViewBookmarks> readBookmarks(QJsonObject& object)
{
    ViewBookmarks bookmarks;
    for (std::size_t place = 0; place < bookmarks.size(); ++place) {
        const QJsonValue value = object.take(digit(place));
        if (value.isUndefined())
            continue;
        const std::string inside = digit(place).toStdString();
        if (!value.isObject())
            return failAt(inside, ErrorCode::Invalid, RAMURE_NOOP("an object is expected here"));
        auto view = readBookmark(value.toObject());
        if (!view)
            return failInside(inside, std::move(view.error()));
        bookmarks[place] = *view;
    }
    return bookmarks;
}

} // namespace ramure::json
