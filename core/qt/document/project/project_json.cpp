#include "core/qt/document/project/project_json.h"

#include "core/scene/kinds/node_kinds.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>

namespace ramure::json {

std::string indexPlace(qsizetype index)
{
    return std::string("[").append(std::to_string(index)).append("]");
}

tl::unexpected<Error> failAt(std::string path, ErrorCode code, const char* text,
                             std::vector<std::string> args)
{
    auto error = fail(code, text, std::move(args));
    error.value().path = std::move(path);
    return error;
}

tl::unexpected<Error> failInside(const std::string& outer, Error error)
{
    const bool joins = error.path.empty() || error.path.front() == '[';
    error.path = std::string(outer).append(joins ? "" : ".").append(error.path);
    return fail(std::move(error));
}

QString kindName(const Node& node)
{
    if (node.kind == NodeKind::Unknown)
        return QJsonDocument::fromJson(QByteArray::fromStdString(node.extras))
            .object()
            .value(QLatin1String("kind"))
            .toString();
    return QLatin1String(kindRow(node.kind).name);
}

/// Zero is written without its sign: JSON readers drop it.
static double plainZero(double value)
{
    return value == 0.0 ? 0.0 : value;
}

static QJsonValue fromText(const std::string& text)
{
    const QString whole = QString::fromStdString(text);
    if (!whole.contains(u'\n'))
        return whole;
    return QJsonArray::fromStringList(whole.split(u'\n'));
}

QJsonValue fromParam(const ParamValue& value)
{
    struct Visitor
    {
        QJsonValue operator()(bool v) const { return v; }
        QJsonValue operator()(std::int64_t v) const { return qint64{v}; }
        QJsonValue operator()(double v) const { return plainZero(v); }
        QJsonValue operator()(const std::string& v) const { return fromText(v); }
        QJsonValue operator()(const EnumValue& v) const { return QString::fromStdString(v.name); }
        QJsonValue operator()(const glm::dvec3& v) const
        {
            return QJsonArray{plainZero(v.x), plainZero(v.y), plainZero(v.z)};
        }
    };
    return std::visit(Visitor{}, value);
}

static Expected<ParamValue> toText(const QJsonValue& value)
{
    if (value.isString())
        return value.toString().toStdString();
    if (!value.isArray())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a text, or an array of its lines, is expected here"));
    QStringList lines;
    const QJsonArray array = value.toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        if (!array[i].isString())
            return failAt(indexPlace(i), ErrorCode::Invalid, RAMURE_NOOP("a text is expected here"));
        lines.push_back(array[i].toString());
    }
    return lines.join(u'\n').toStdString();
}

static Expected<ParamValue> toVector(const QJsonValue& value)
{
    const QJsonArray array = value.toArray();
    if (!value.isArray() || array.size() != 3)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("an array of three numbers is expected here"));
    glm::dvec3 vector{0.0};
    for (int i = 0; i < 3; ++i) {
        if (!array[i].isDouble())
            return failAt(indexPlace(i), ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
        vector[i] = array[i].toDouble();
    }
    return vector;
}

static Expected<std::int64_t> toWhole(const QJsonValue& value)
{
    // Two different defaults: only a number that is whole and in range gives the same answer to both.
    const qint64 whole = value.toInteger(0);
    if (!value.isDouble() || whole != value.toInteger(1))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("a whole number is expected here"));
    return whole;
}

Expected<ParamValue> toParam(const ParamDef& def, const QJsonValue& value)
{
    switch (def.type) {
    case ParamType::Bool:
        if (!value.isBool())
            return fail(ErrorCode::Invalid, RAMURE_NOOP("true or false is expected here"));
        return value.toBool();
    case ParamType::Int: {
        const auto whole = toWhole(value);
        return whole ? Expected<ParamValue>(*whole) : fail(whole.error());
    }
    case ParamType::Real:
        if (!value.isDouble())
            return fail(ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
        return value.toDouble();
    case ParamType::Text:
        return toText(value);
    case ParamType::Vec3:
        return toVector(value);
    case ParamType::Enum:
        if (!value.isString())
            return fail(ErrorCode::Invalid, RAMURE_NOOP("a text is expected here"));
        return EnumValue{value.toString().toStdString()};
    }
    return fail(ErrorCode::Invalid, RAMURE_NOOP("a number is expected here"));
}

QString branchKey(std::uint64_t key)
{
    return QString::number(quint64{key}, 16).rightJustified(16, u'0');
}

Expected<std::uint64_t> branchKeyFromText(const QString& text)
{
    const bool hex = text.size() == 16 && std::all_of(text.begin(), text.end(), [](QChar c) {
                         return (c >= u'0' && c <= u'9') || (c >= u'a' && c <= u'f');
                     });
    if (!hex)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("the key of a branch has 16 digits 0-9, a-f"));
    return text.toULongLong(nullptr, 16);
}

QJsonObject merged(QJsonObject known, const std::string& extras)
{
    const QJsonObject more = QJsonDocument::fromJson(QByteArray::fromStdString(extras)).object();
    for (auto it = more.begin(); it != more.end(); ++it) {
        const QJsonValue have = known.value(it.key());
        if (have.isUndefined())
            known.insert(it.key(), it.value());
        else if (have.isObject() && it.value().isObject())
            known.insert(it.key(), merged(have.toObject(), extrasText(it.value().toObject())));
    }
    return known;
}

std::string extrasText(const QJsonObject& extras)
{
    return extras.isEmpty() ? std::string()
                            : QJsonDocument(extras).toJson(QJsonDocument::Compact).toStdString();
}

} // namespace ramure::json
