#include "widgets/panels/properties/number_editor.h"

#include "widgets/base/fields/number_field.h"
#include "widgets/base/fields/number_slider.h"
#include "widgets/base/named.h"
#include "widgets/base/theme/icons.h"
#include <QHBoxLayout>
#include <QRandomGenerator>
#include <QToolButton>
#include <cmath>

namespace ramure {
namespace {

constexpr std::int64_t diceMax = 999'999; ///< seeds that can be told on the telephone

std::optional<double> asNumber(const std::optional<ParamValue>& value)
{
    if (!value)
        return std::nullopt;
    if (const auto* whole = std::get_if<std::int64_t>(&*value))
        return static_cast<double>(*whole);
    return std::get<double>(*value);
}

} // namespace

NumberEditor::NumberEditor(const ParamDef& def, QWidget* parent)
    : ParamEditor(def, parent)
{
    auto* layout = layoutOf<QHBoxLayout>(this, 6);
    m_field = new NumberField(this);
    m_field->setRange(def.hardMin, def.hardMax);
    m_field->setStep(def.step);
    m_field->setAccessibleName(name());
    if (def.flags & paramSeed) {
        m_dice = new QToolButton(this);
        m_dice->setAutoRaise(true);
        m_dice->setIcon(icon("dice"));
        m_dice->setFocusPolicy(Qt::TabFocus);
        m_dice->setToolTip(tr("Another random seed"));
        m_dice->setAccessibleName(m_dice->toolTip());
        layout->addWidget(m_field, 1);
        layout->addWidget(m_dice);
        connect(m_dice, &QToolButton::clicked, this, &NumberEditor::throwDice);
    } else {
        m_slider = new NumberSlider(this);
        m_slider->setSoftRange(def.softMin, def.softMax, def.step, def.type == ParamType::Int);
        m_field->setScale(NumberScale(def.softMin, def.softMax, def.step, def.type == ParamType::Int));
        m_slider->setAccessibleName(tr("%1 slider").arg(name()));
        layout->addWidget(m_slider, 1);
        layout->addWidget(m_field);
        m_field->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        connect(m_slider, &NumberSlider::numberEdited, this, [this](double number) {
            m_field->setValue(number);
            emitEdit(asValue(number));
        });
        connect(m_slider, &NumberSlider::gestureBegan, this, &NumberEditor::nextGesture);
        connect(m_slider, &NumberSlider::gestureEnded, this, &NumberEditor::nextGesture);
    }
    setFocusProxy(m_field);
    setAngleUnit(AngleUnit::Degrees);
    connect(m_field, &NumberField::valueEdited, this, [this](double number) { emitEdit(asValue(number)); });
    connect(m_field, &NumberField::gestureBegan, this, &NumberEditor::nextGesture);
    connect(m_field, &NumberField::gestureEnded, this, &NumberEditor::nextGesture);
    connect(m_field, &NumberField::refused, this, &NumberEditor::refused);
    connect(m_field, &NumberField::held, this, &NumberEditor::held);
}

ParamValue NumberEditor::asValue(double number) const
{
    if (def().type == ParamType::Int)
        return static_cast<std::int64_t>(std::llround(number));
    return number;
}

void NumberEditor::showValues(std::span<const ParamValue> values)
{
    const auto number = asNumber(commonValue(values));
    m_field->setValue(number);
    if (m_slider)
        m_slider->setNumber(number);
}

void NumberEditor::setStandard(const std::optional<ParamValue>& value)
{
    m_field->setDefault(asNumber(value));
}

void NumberEditor::addHandle(QWidget* label)
{
    m_field->addHandle(label);
}

void NumberEditor::setAngleUnit(AngleUnit unit)
{
    m_field->setFormat(numberFormat(def(), unit));
    if (m_slider)
        m_slider->setFactor(numberFormat(def(), unit).factor);
    // One arrow key is a round step in what is shown.
    if (def().unit == ParamUnit::Radian && unit == AngleUnit::Degrees) {
        const NumberFormat format = numberFormat(def(), unit);
        const double shown = def().step * format.factor;
        const double roundStep = std::pow(10.0, std::round(std::log10(shown)));
        m_field->setStep(roundStep / format.factor);
    } else {
        m_field->setStep(def().step);
    }
}

void NumberEditor::throwDice()
{
    const auto top = static_cast<std::int64_t>(std::min(def().hardMax, static_cast<double>(diceMax)));
    emitSingleEdit(ParamValue(std::int64_t{QRandomGenerator::global()->bounded(qint64{1}, qint64{top + 1})}));
}

} // namespace ramure
