#include "widgets/panels/properties/group_clipboard.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>
#include <QRegularExpression>
#include <cmath>

namespace ramure {
namespace {

const QLatin1String rootKey("ramure-parameters");
const QString valueFormat = QStringLiteral("application/x-ramure-parameters");

/// As the program holds it: never the unit of the interface, which loses digits.
const char* unitSuffix(const ParamDef& def)
{
    if (def.type != ParamType::Real)
        return "";
    switch (def.unit) {
    case ParamUnit::Metre:
        return " m";
    case ParamUnit::Radian:
        return " rad";
    case ParamUnit::Second:
        return " s";
    case ParamUnit::Kilogram:
        return " kg";
    case ParamUnit::Year:
    case ParamUnit::Day:
    case ParamUnit::Factor: // its sign multiplies
    case ParamUnit::None:
    case ParamUnit::Ratio:
    case ParamUnit::Count:
    case ParamUnit::Degree:
    case ParamUnit::Share:
        break;
    }
    return "";
}

Expected<ParamValue> readText(const ParamDef& def, const QString& text, AngleUnit unit)
{
    if (def.type != ParamType::Int && def.type != ParamType::Real)
        return parseValue(def, text.toStdString());
    return numberFormat(def, unit).parse(text).map([&](double number) {
        return def.type == ParamType::Int ? ParamValue(std::int64_t{std::llround(number)})
                                          : ParamValue(number);
    });
}

} // namespace

QString writeParamList(const ParamList& values)
{
    QJsonObject list;
    for (const auto& [def, value] : values)
        list.insert(QLatin1String(def->key), QString::fromStdString(formatValue(value)));
    return QString::fromUtf8(QJsonDocument(QJsonObject{{rootKey, list}}).toJson());
}

Expected<ParamList> readParamList(const QString& text)
{
    const QJsonDocument document = QJsonDocument::fromJson(text.toUtf8());
    const QJsonValue root = document.object().value(rootKey);
    if (!root.isObject())
        return fail(ErrorCode::Syntax, RAMURE_NOOP("The clipboard holds no copied parameters"));
    ParamList values;
    const QJsonObject list = root.toObject();
    for (auto it = list.begin(); it != list.end(); ++it) {
        const ParamDef* def = findParam(it.key().toStdString());
        if (!def)
            continue;
        auto value = parseValue(*def, it.value().toString().toStdString(), false);
        RAMURE_TRY(value);
        values.emplace_back(def, std::move(*value));
    }
    return values;
}

void copyValue(const ParamDef& def, const ParamValue& value)
{
    auto* data = new QMimeData;
    if (def.unit == ParamUnit::Share)
        data->setText(numberFormat(def, AngleUnit::Radians).text(std::get<double>(value)));
    else
        data->setText(QString::fromStdString(formatValue(value) + unitSuffix(def)));
    data->setData(valueFormat, writeParamList({{&def, value}}).toUtf8());
    QGuiApplication::clipboard()->setMimeData(data);
}

Expected<ParamValue> pastedValue(const ParamDef& def, AngleUnit unit)
{
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    const bool isOwn = data && data->hasFormat(valueFormat);
    const QString text =
        isOwn ? QString::fromUtf8(data->data(valueFormat)) : QGuiApplication::clipboard()->text();
    const auto list = readParamList(text);
    if (!list)
        return readText(def, text, unit);
    for (const auto& [from, value] : *list)
        if (from == &def || (list->size() == 1 && value.index() == static_cast<std::size_t>(def.type)))
            return value;
    return fail(ErrorCode::Invalid, RAMURE_NOOP("The clipboard holds no value of this kind"));
}

QString settingText(const ParamDef& def, const ParamValue& value)
{
    QString text = QString::fromStdString(formatValue(value));
    if (def.type == ParamType::Text)
        text.replace(u'\\', QStringLiteral("\\\\")).replace(u'\n', QStringLiteral("\\n"));
    const QString setting = QLatin1String(def.key) + u'=' + text;
    static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_.,=+-]*$"));
    if (plain.match(setting).hasMatch())
        return QStringLiteral("--set ") + setting;
    return QStringLiteral("--set '%1'").arg(QString(setting).replace(u'\'', QStringLiteral("'\\''")));
}

} // namespace ramure
