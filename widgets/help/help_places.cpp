#include "widgets/help/help_places.h"

#include "widgets/panels/properties/param_row.h"
#include <QApplication>
#include <QVariant>
#include <algorithm>

namespace ramure {
namespace {

struct HelpPlace
{
    const char* name; ///< of the object, or of its class
    const char* place;
};

constexpr HelpPlace places[] = {
    {"ramure::GrammarEdit", "grammar#how-rules-are-written"},
    {"ramure::ViewportHost", "window#the-view"},
    {"ramure::KeyCurves", "keys#curves"},
    {"ramure::StatusPanel", "window#status-bar"},
    {"ramure::WelcomePanel", "index#ramure"},
    {"ramure::ExportDialog", "files#exporting"},
    {"ramure::PreferencesDialog", "window#preferences"},
    {"ramure::ShortcutsDialog", "window#commands-and-keys"},
    {"ramure::SeparateDialog", "window#validation"},
    {"ramure::BakeKeysDialog", "arm#baking-to-keys"},
    {"ramure::ToolSettingsDialog", "transform#path-and-ghosts"},
    {"ramure::RecoveryDialog", "files#after-a-crash"},
};

const ParamRow* rowAround(const QWidget* widget)
{
    while (widget && !qobject_cast<const ParamRow*>(widget))
        widget = widget->parentWidget();
    return qobject_cast<const ParamRow*>(widget);
}

} // namespace

QString helpPlace(const QWidget* widget)
{
    for (const QWidget* at = widget; at; at = at->parentWidget()) {
        if (const auto* row = qobject_cast<const ParamRow*>(at))
            return QStringLiteral("parameters#") + QString::fromLatin1(row->def().key);
        const auto found = std::ranges::find_if(places, [at](const HelpPlace& place) {
            return at->objectName() == QLatin1String(place.name) ||
                   qstrcmp(at->metaObject()->className(), place.name) == 0;
        });
        if (found != std::end(places))
            return QString::fromLatin1(found->place);
        if (const QVariant place = at->property(helpPlaceProperty); place.isValid())
            return place.toString();
    }
    return {};
}

QString helpPlaceHere()
{
    const QWidget* pointed = QApplication::widgetAt(QCursor::pos());
    const QWidget* focused = QApplication::focusWidget();
    if (const ParamRow* row = rowAround(pointed))
        return helpPlace(row);
    const QString place = helpPlace(focused);
    return place.isEmpty() ? helpPlace(pointed) : place;
}

QList<QString> helpPlaces()
{
    QList<QString> all;
    for (const HelpPlace& place : places)
        all += QString::fromLatin1(place.place);
    return all;
}

} // namespace ramure
