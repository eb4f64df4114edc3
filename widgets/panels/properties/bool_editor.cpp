#include "widgets/panels/properties/bool_editor.h"

#include <QCheckBox>
#include <QHBoxLayout>

namespace ramure {

BoolEditor::BoolEditor(const ParamDef& def, QWidget* parent)
    : ParamEditor(def, parent)
    , m_box(new QCheckBox(this))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_box);
    layout->addStretch(1);
    m_box->setAccessibleName(name());
    showState();
    setFocusProxy(m_box);
    connect(m_box, &QCheckBox::clicked, this, [this] {
        m_box->setTristate(false);
        const bool on = m_box->checkState() != Qt::Unchecked;
        m_box->setChecked(on);
        showState();
        emitSingleEdit(on);
    });
}

void BoolEditor::showValues(std::span<const ParamValue> values)
{
    const auto value = commonValue(values);
    if (value) {
        m_box->setTristate(false);
        m_box->setChecked(std::get<bool>(*value));
    } else {
        m_box->setTristate(true);
        m_box->setCheckState(Qt::PartiallyChecked);
    }
    showState();
}

void BoolEditor::showState()
{
    m_box->setText(m_box->checkState() == Qt::PartiallyChecked ? QStringLiteral("—")
                   : m_box->isChecked()                        ? tr("on")
                                                               : tr("off"));
}

} // namespace ramure
