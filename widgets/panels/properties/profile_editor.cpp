#include "widgets/panels/properties/profile_editor.h"

#include "core/generators/colonisation/crown_shape.h"
#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/panels/properties/profile_curve.h"
#include <QLineEdit>
#include <QVBoxLayout>

namespace ramure {

ProfileEditor::ProfileEditor(const ParamDef& def, QWidget* parent)
    : ParamEditor(def, parent)
    , m_curve(new ProfileCurve(this))
    , m_text(new QLineEdit(this))
{
    auto* layout = layoutOf<QVBoxLayout>(this, 4);
    layout->addWidget(m_curve);
    layout->addWidget(m_text);
    m_curve->setAccessibleName(name());
    m_curve->setToolTip(tr("Drag the points; double-click to add one, right-click for more. Height goes up, "
                           "half the width to the right."));
    m_text->setAccessibleName(tr("%1 as text").arg(name()));
    setFocusProxy(m_curve);
    connect(m_curve, &ProfileCurve::gestureStarted, this, &ProfileEditor::nextGesture);
    connect(m_curve, &ProfileCurve::pairsEdited, this, [this] {
        emit refused(QString());
        emitEdit(profileText(m_curve->pairs()));
    });
    connect(m_text, &QLineEdit::editingFinished, this, &ProfileEditor::takeText);
}

void ProfileEditor::showValues(std::span<const ParamValue> values)
{
    const auto value = commonValue(values);
    const std::string text = value ? std::get<std::string>(*value) : std::string();
    m_curve->setPairs(parseProfile(text).value_or(ProfileCurve::Pairs()));
    if (m_text->isModified() && m_text->hasFocus())
        return; // what is being typed stays
    m_text->setText(QString::fromStdString(text));
    m_text->setPlaceholderText(value ? QString() : QStringLiteral("—"));
}

void ProfileEditor::takeText()
{
    if (!m_text->isModified())
        return;
    m_text->setModified(false);
    const std::string text = m_text->text().toStdString();
    const auto pairs = parseProfile(text);
    emit refused(pairs ? QString() : errorText(pairs.error()));
    if (pairs)
        emitSingleEdit(text);
}

} // namespace ramure
