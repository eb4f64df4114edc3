#include "widgets/dialogs/export/option_fields.h"

#include "widgets/base/fields/number_field.h"
#include "widgets/base/texts/core_text.h"
#include <QCheckBox>
#include <QComboBox>
#include <algorithm>

namespace ramure {

static QWidget* newField(const ExportOption& option, QWidget* parent)
{
    if (option.items.empty() && option.most > option.least) {
        auto* number = new NumberField(parent);
        number->setRange(option.factor * option.least, option.factor * option.most);
        number->setDefault(option.factor * option.place.get(ExportOptions()));
        return number;
    }
    if (option.items.empty() || *option.items.front().label == '\0')
        return new QCheckBox(parent);
    auto* list = new QComboBox(parent);
    for (const OptionItem& item : option.items)
        list->addItem(QString(), static_cast<int>(item.value));
    return list;
}

/// Returns the value in the program's unit.
static QVariant valueOf(const ExportOption& option, const QWidget* widget)
{
    if (const auto* box = qobject_cast<const QCheckBox*>(widget))
        return box->isChecked();
    if (const auto* number = qobject_cast<const NumberField*>(widget))
        return number->value().value_or(option.factor * option.place.get(ExportOptions())) / option.factor;
    return static_cast<const QComboBox*>(widget)->currentData();
}

static void setValue(const ExportOption& option, QWidget* widget, double value)
{
    if (auto* box = qobject_cast<QCheckBox*>(widget))
        return box->setChecked(value != 0.0);
    if (auto* number = qobject_cast<NumberField*>(widget))
        return number->setValue(option.factor * value);
    auto* list = static_cast<QComboBox*>(widget);
    if (const int row = list->findData(static_cast<int>(value)); row >= 0)
        list->setCurrentIndex(row);
}

void OptionFields::connectChange(const ExportOption& option, QWidget* widget)
{
    const auto tell = [this, &option] { emit changed(option); };
    if (auto* box = qobject_cast<QCheckBox*>(widget))
        connect(box, &QCheckBox::toggled, this, tell);
    else if (auto* list = qobject_cast<QComboBox*>(widget))
        connect(list, &QComboBox::currentIndexChanged, this, tell);
    else if (auto* number = qobject_cast<NumberField*>(widget))
        connect(number, &NumberField::valueEdited, this, [number, tell](double value) {
            number->setValue(value);
            tell();
        });
}

QWidget* OptionFields::make(const char* key, QWidget* parent)
{
    const ExportOption& option = optionOfKey(key);
    QWidget* made = newField(option, parent);
    QString name = QString::fromLatin1(key);
    name.front() = name.front().toUpper();
    made->setObjectName(QStringLiteral("export") + name);
    setValue(option, made, option.place.get(ExportOptions()));
    connectChange(option, made);
    m_fields.push_back({&option, made});
    return made;
}

bool OptionFields::has(const ExportOption& option) const
{
    return std::ranges::find(m_fields, &option, &Field::option) != m_fields.end();
}

QWidget* OptionFields::find(const char* key) const
{
    return std::ranges::find(m_fields, &optionOfKey(key), &Field::option)->widget;
}

void OptionFields::setTexts()
{
    for (const auto& [option, widget] : m_fields) {
        widget->setToolTip(coreText(option->tip));
        if (auto* box = qobject_cast<QCheckBox*>(widget)) {
            box->setText(coreText(option->label));
            continue;
        }
        widget->setAccessibleName(coreText(option->label));
        auto* list = qobject_cast<QComboBox*>(widget);
        for (int row = 0; list && row < list->count(); ++row)
            list->setItemText(row, coreText(option->items[std::size_t(row)].label)
                                       .replace(QLatin1String("%1"), list->itemData(row).toString()));
    }
}

void OptionFields::setEnabled(bool enabled)
{
    for (const Field& field : m_fields)
        field.widget->setEnabled(enabled);
}

void OptionFields::show(const ExportPage& page)
{
    for (const auto& [option, widget] : m_fields)
        widget->setVisible(isOffered(*option, page));
}

ExportOptions OptionFields::options(const ExportPage* page) const
{
    ExportOptions out;
    for (const auto& [option, widget] : m_fields)
        if (!page || isOffered(*option, *page))
            option->place.set(out, valueOf(*option, widget).toDouble());
    return out;
}

void OptionFields::set(const ExportOptions& options, OptionFlag flag)
{
    for (const auto& [option, widget] : m_fields)
        if (option->is(flag))
            setValue(*option, widget, option->place.get(options));
}

void OptionFields::store(QVariantMap& kept) const
{
    for (const auto& [option, widget] : m_fields)
        kept.insert(QString::fromLatin1(option->key), valueOf(*option, widget));
}

void OptionFields::take(const QVariantMap& kept)
{
    for (const auto& [option, widget] : m_fields)
        if (const QVariant value = kept.value(QString::fromLatin1(option->key)); value.isValid())
            setValue(*option, widget, value.toDouble());
}

const ExportOption& optionOfKey(std::string_view key)
{
    return *std::ranges::find_if(exportOptions(),
                                 [key](const ExportOption& option) { return key == option.key; });
}

} // namespace ramure
