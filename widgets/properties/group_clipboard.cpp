#include "widgets/properties/group_clipboard.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace ramure {
namespace {

const QLatin1String rootKey("ramure-parameters");

}

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
        if (!value)
            return fail(value.error());
        values.emplace_back(def, std::move(*value));
    }
    return values;
}

} // namespace ramure
