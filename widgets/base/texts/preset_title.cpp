#include "widgets/base/texts/preset_title.h"

#include "core/presets/presets.h"
#include "core/scene/scene.h"
#include "widgets/base/texts/core_text.h"
#include <QCoreApplication>
#include <algorithm>
#include <string_view>

namespace ramure {
namespace {

/// For the files of translations alone, which take no name that the program makes up.
[[maybe_unused]] constexpr const char* titles[] = {
    QT_TRANSLATE_NOOP("presets", "American Elm"),
    QT_TRANSLATE_NOOP("presets", "Aono Kunii Tree"),
    QT_TRANSLATE_NOOP("presets", "Balsam Fir"),
    QT_TRANSLATE_NOOP("presets", "Bamboo"),
    QT_TRANSLATE_NOOP("presets", "Baobab"),
    QT_TRANSLATE_NOOP("presets", "Black Locust"),
    QT_TRANSLATE_NOOP("presets", "Black Tupelo"),
    QT_TRANSLATE_NOOP("presets", "Blue Gum"),
    QT_TRANSLATE_NOOP("presets", "Blue Spruce"),
    QT_TRANSLATE_NOOP("presets", "Bonsai"),
    QT_TRANSLATE_NOOP("presets", "California Black Oak"),
    QT_TRANSLATE_NOOP("presets", "Cliff Hawthorn"),
    QT_TRANSLATE_NOOP("presets", "Coast Redwood"),
    QT_TRANSLATE_NOOP("presets", "Coconut Palm"),
    QT_TRANSLATE_NOOP("presets", "Coconut Palm Rules"),
    QT_TRANSLATE_NOOP("presets", "Common Alder"),
    QT_TRANSLATE_NOOP("presets", "Common Ash"),
    QT_TRANSLATE_NOOP("presets", "Common Walnut"),
    QT_TRANSLATE_NOOP("presets", "Common Yew"),
    QT_TRANSLATE_NOOP("presets", "Date Palm"),
    QT_TRANSLATE_NOOP("presets", "Dead Snag"),
    QT_TRANSLATE_NOOP("presets", "Deodar Cedar"),
    QT_TRANSLATE_NOOP("presets", "Douglas Fir"),
    QT_TRANSLATE_NOOP("presets", "Eastern Cottonwood"),
    QT_TRANSLATE_NOOP("presets", "Eastern White Pine"),
    QT_TRANSLATE_NOOP("presets", "English Oak"),
    QT_TRANSLATE_NOOP("presets", "European Beech"),
    QT_TRANSLATE_NOOP("presets", "European Larch"),
    QT_TRANSLATE_NOOP("presets", "Fan Palm"),
    QT_TRANSLATE_NOOP("presets", "Fan Tree"),
    QT_TRANSLATE_NOOP("presets", "Fern2D"),
    QT_TRANSLATE_NOOP("presets", "Field Elm"),
    QT_TRANSLATE_NOOP("presets", "Giant Sequoia"),
    QT_TRANSLATE_NOOP("presets", "Ginkgo"),
    QT_TRANSLATE_NOOP("presets", "Hawthorn"),
    QT_TRANSLATE_NOOP("presets", "Hedge"),
    QT_TRANSLATE_NOOP("presets", "Honda Tree"),
    QT_TRANSLATE_NOOP("presets", "Honey Locust"),
    QT_TRANSLATE_NOOP("presets", "Hornbeam"),
    QT_TRANSLATE_NOOP("presets", "Horse Chestnut"),
    QT_TRANSLATE_NOOP("presets", "Italian Cypress"),
    QT_TRANSLATE_NOOP("presets", "Jacaranda"),
    QT_TRANSLATE_NOOP("presets", "Japanese Maple"),
    QT_TRANSLATE_NOOP("presets", "Joshua Tree"),
    QT_TRANSLATE_NOOP("presets", "Lebanon Cedar"),
    QT_TRANSLATE_NOOP("presets", "Live Oak"),
    QT_TRANSLATE_NOOP("presets", "Lombardy Poplar"),
    QT_TRANSLATE_NOOP("presets", "London Plane"),
    QT_TRANSLATE_NOOP("presets", "Norway Maple"),
    QT_TRANSLATE_NOOP("presets", "Norway Spruce"),
    QT_TRANSLATE_NOOP("presets", "Olive Tree"),
    QT_TRANSLATE_NOOP("presets", "Orchard Apple"),
    QT_TRANSLATE_NOOP("presets", "Park Tree"),
    QT_TRANSLATE_NOOP("presets", "Quaking Aspen"),
    QT_TRANSLATE_NOOP("presets", "Rain Tree"),
    QT_TRANSLATE_NOOP("presets", "Red Oak"),
    QT_TRANSLATE_NOOP("presets", "Rowan"),
    QT_TRANSLATE_NOOP("presets", "Saguaro"),
    QT_TRANSLATE_NOOP("presets", "Sapling"),
    QT_TRANSLATE_NOOP("presets", "Sassafras"),
    QT_TRANSLATE_NOOP("presets", "Scots Pine"),
    QT_TRANSLATE_NOOP("presets", "Silver Birch"),
    QT_TRANSLATE_NOOP("presets", "Small Leaved Linden"),
    QT_TRANSLATE_NOOP("presets", "Small Tree"),
    QT_TRANSLATE_NOOP("presets", "Southern Magnolia"),
    QT_TRANSLATE_NOOP("presets", "Stone Pine"),
    QT_TRANSLATE_NOOP("presets", "Sugar Maple"),
    QT_TRANSLATE_NOOP("presets", "Sweet Chestnut"),
    QT_TRANSLATE_NOOP("presets", "Sweetgum"),
    QT_TRANSLATE_NOOP("presets", "Ternary Tree"),
    QT_TRANSLATE_NOOP("presets", "Tiny Tree"),
    QT_TRANSLATE_NOOP("presets", "Tree Fern"),
    QT_TRANSLATE_NOOP("presets", "Tulip Tree"),
    QT_TRANSLATE_NOOP("presets", "Umbrella Acacia"),
    QT_TRANSLATE_NOOP("presets", "Weeping Willow"),
    QT_TRANSLATE_NOOP("presets", "White Willow"),
    QT_TRANSLATE_NOOP("presets", "Wild Cherry"),
    QT_TRANSLATE_NOOP("presets", "Winter Oak"),
};

} // namespace

QString presetTitle(const QString& name)
{
    if (const QString year = QStringLiteral("1995"); name.endsWith(year))
        return presetTitle(name.chopped(year.size())) + u' ' + year;
    return QCoreApplication::translate("presets", spacedName(name).toUtf8().constData());
}

QString presetGroupTitle(const char* group)
{
    return std::string_view(group) == "Coursework"
               ? QCoreApplication::translate("presets", "Grammar examples")
               : coreText(group);
}

QString presetNames(const Preset& preset)
{
    const QString name = QString::fromLatin1(preset.name);
    return QStringList{presetTitle(name), name, spacedName(name), QString::fromUtf8(preset.latin)}.join(u' ');
}

QString presetTip(const Preset& preset)
{
    const QString latin = QString::fromUtf8(preset.latin);
    QString about = coreText(preset.description);
    if (preset.ages[0] > 0)
        about += QStringLiteral(". ") +
                 QCoreApplication::translate(
                     "presets", "Grows year by year: young at the age of %1, mature at %2, old at %3")
                     .arg(preset.ages[0])
                     .arg(preset.ages[1])
                     .arg(preset.ages[2]);
    return latin.isEmpty()
               ? about
               : QCoreApplication::translate("presets", "%1: %2", "Latin name: habit").arg(latin, about);
}

bool isSpecies(const Preset& preset)
{
    const auto first = std::ranges::find_if(presets(), [](const Preset& each) {
        return each.params.generator.kind == EditOperation::WeberPenn ||
               each.params.generator.kind == EditOperation::Growth;
    });
    return &preset >= &*first;
}

void giveTitle(Node& tree)
{
    const QString name = QString::fromStdString(tree.name), title = presetTitle(name);
    if (title != spacedName(name))
        tree.name = title.toStdString();
}

} // namespace ramure
