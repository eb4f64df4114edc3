#include "widgets/panels/properties/text_editor.h"

#include <QHBoxLayout>
#include <QLineEdit>

namespace ramure {

TextEditor::TextEditor(const ParamDef& def, QWidget* parent)
    : ParamEditor(def, parent)
    , m_edit(new QLineEdit(this))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_edit);
    m_edit->setAccessibleName(name());
    setFocusProxy(m_edit);
    connect(m_edit, &QLineEdit::editingFinished, this, [this] {
        if (m_edit->isModified())
            emitSingleEdit(m_edit->text().toStdString());
        m_edit->setModified(false);
    });
}

void TextEditor::showValues(std::span<const ParamValue> values)
{
    if (m_edit->isModified())
        return; // what is being typed stays
    const auto value = commonValue(values);
    m_edit->setText(value ? QString::fromStdString(std::get<std::string>(*value)) : QString());
    m_edit->setPlaceholderText(value ? QString() : QStringLiteral("—"));
}

} // namespace ramure
