#include "widgets/panels/properties/choice_editor.h"

#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/wheel_guard.h"
#include <QComboBox>
#include <QHBoxLayout>

namespace ramure {

ChoiceEditor::ChoiceEditor(const ParamDef& def, QWidget* parent)
    : ParamEditor(def, parent)
    , m_box(new QComboBox(this))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_box);
    layout->addStretch(1);
    for (const EnumItem& item : def.items)
        m_box->addItem(coreText(item.label), QString::fromLatin1(item.name));
    m_box->setPlaceholderText(QStringLiteral("—"));
    constexpr int leastLetters = 8; // a narrow panel shortens a long choice and is not cut at its side
    m_box->setMinimumContentsLength(leastLetters);
    m_box->setAccessibleName(name());
    guardFromWheel(m_box);
    setFocusProxy(m_box);
    connect(m_box, &QComboBox::activated, this,
            [this] { emitSingleEdit(EnumValue{m_box->currentData().toString().toStdString()}); });
}

void ChoiceEditor::showValues(std::span<const ParamValue> values)
{
    const auto value = commonValue(values);
    m_box->setCurrentIndex(value ? m_box->findData(QString::fromStdString(std::get<EnumValue>(*value).name))
                                 : -1);
}

} // namespace ramure
