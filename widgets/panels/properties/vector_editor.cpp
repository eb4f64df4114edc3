#include "widgets/panels/properties/vector_editor.h"

#include "widgets/base/fields/number_field.h"
#include "widgets/base/named.h"
#include <QHBoxLayout>
#include <QLabel>

namespace ramure {
namespace {

constexpr const char* axisNames[] = {"X", "Y", "Z"};

}

VectorEditor::VectorEditor(const ParamDef& def, QWidget* parent)
    : ParamEditor(def, parent)
{
    auto* layout = layoutOf<QHBoxLayout>(this, 5);
    for (int axis = 0; axis < 3; ++axis) {
        auto* letter = new QLabel(QString::fromLatin1(axisNames[axis]), this);
        letter->setObjectName(QStringLiteral("axis%1").arg(QString::fromLatin1(axisNames[axis])));
        auto* field = new NumberField(this);
        field->setRange(def.hardMin, def.hardMax);
        field->setStep(def.step);
        field->setScale(NumberScale(def.softMin, def.softMax, def.step, false));
        field->addHandle(letter);
        field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        field->setAccessibleName(QStringLiteral("%1 %2").arg(name(), letter->text()));
        letter->setBuddy(field);
        m_fields[static_cast<std::size_t>(axis)] = field;
        if (axis > 0)
            layout->addSpacing(3);
        layout->addWidget(letter);
        layout->addWidget(field, 1);
        connect(field, &NumberField::valueEdited, this,
                [this, axis](double value) { emitComponent(axis, value); });
        connect(field, &NumberField::gestureBegan, this, &VectorEditor::nextGesture);
        connect(field, &NumberField::gestureEnded, this, &VectorEditor::nextGesture);
        connect(field, &NumberField::refused, this, &VectorEditor::refused);
        connect(field, &NumberField::held, this, &VectorEditor::held);
    }
    setFocusProxy(m_fields[0]);
    setAngleUnit(AngleUnit::Degrees);
}

void VectorEditor::showValues(std::span<const ParamValue> values)
{
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<ParamValue> components;
        components.reserve(values.size());
        for (const ParamValue& value : values)
            components.emplace_back(std::get<glm::dvec3>(value)[axis]);
        const auto common = commonValue(components);
        m_fields[static_cast<std::size_t>(axis)]->setValue(common ? std::optional(std::get<double>(*common))
                                                                  : std::nullopt);
    }
}

void VectorEditor::setStandard(const std::optional<ParamValue>& value)
{
    for (int axis = 0; axis < 3; ++axis)
        m_fields[static_cast<std::size_t>(axis)]->setDefault(
            value ? std::optional(std::get<glm::dvec3>(*value)[axis]) : std::nullopt);
}

void VectorEditor::setAngleUnit(AngleUnit unit)
{
    const NumberFormat format = numberFormat(def(), unit);
    for (NumberField* field : m_fields) {
        field->setFormat(format);
        field->setStep(def().unit == ParamUnit::Radian && unit == AngleUnit::Degrees ? 1.0 / format.factor
                                                                                     : def().step);
    }
}

} // namespace ramure
