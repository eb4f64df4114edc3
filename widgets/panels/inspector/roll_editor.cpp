#include "widgets/panels/inspector/roll_editor.h"

#include "core/math/angle.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/fields/number_slider.h"
#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/texts/fact_text.h"
#include "widgets/base/theme/icons.h"
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace ramure {
namespace {

constexpr double mostTyped = 1000.0 * 2.0 * pi; ///< whole turns are taken off

/// The roll that all have, or nothing where they differ.
std::optional<double> commonRoll(const std::vector<double>& rolls)
{
    const bool differ = std::ranges::adjacent_find(rolls, std::not_equal_to()) != rolls.end();
    return differ || rolls.empty() ? std::nullopt : std::optional(rolls.front());
}

} // namespace

RollEditor::RollEditor(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_gesture(newGesture())
{
    auto* grid = layoutOf<QGridLayout>(this);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    m_name = new QLabel(tr("Roll by hand"), this);
    m_slider = named(new NumberSlider(this), "rollSlider");
    m_field = named(new NumberField(this), "rollField");
    m_field->setRange(-mostTyped, mostTyped);
    m_field->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_reset = named(new QToolButton(this), "rollReset");
    m_reset->setAutoRaise(true);
    m_reset->setIcon(icon("reset"));
    m_hint = new QLabel(this);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    m_hint->setWordWrap(true);
    m_name->setBuddy(m_field);
    m_field->setScale(NumberScale(-pi, pi, pi / 180.0, false));
    m_field->addHandle(m_name);
    setFocusProxy(m_field);
    grid->addWidget(m_name, 0, 0, 1, 3);
    grid->addWidget(m_slider, 1, 0);
    grid->addWidget(m_field, 1, 1);
    grid->addWidget(m_reset, 1, 2);
    grid->addWidget(m_hint, 2, 0, 1, 3);
    grid->setColumnStretch(0, 1);

    connect(m_slider, &NumberSlider::numberEdited, this, [this](double roll) { apply(roll, m_gesture); });
    connect(m_field, &NumberField::valueEdited, this, [this](double roll) { apply(roll, m_gesture); });
    connect(m_slider, &NumberSlider::gestureBegan, this, &RollEditor::nextGesture);
    connect(m_slider, &NumberSlider::gestureEnded, this, &RollEditor::nextGesture);
    connect(m_field, &NumberField::gestureBegan, this, &RollEditor::nextGesture);
    connect(m_field, &NumberField::gestureEnded, this, &RollEditor::nextGesture);
    connect(m_field, &NumberField::refused, this, &RollEditor::refused);
    connect(m_field, &NumberField::held, this, &RollEditor::refused);
    connect(m_reset, &QToolButton::clicked, this, [this] { apply(0.0, 0); });
    const QString help = tr("Turns the branch's frames about its curve. The branches it carries turn along, "
                            "and the mesh follows.");
    m_name->setToolTip(help);
    m_field->setToolTip(help);
    m_slider->setToolTip(help);
    m_field->setAccessibleName(tr("Roll by hand"));
    m_slider->setAccessibleName(tr("Roll by hand, slider"));
    m_reset->setToolTip(tr("Back to no roll"));
    m_reset->setAccessibleName(m_reset->toolTip());
    m_hint->hide();
    setAngleUnit(AngleUnit::Degrees);
}

void RollEditor::nextGesture()
{
    m_gesture = newGesture();
}

void RollEditor::setAngleUnit(AngleUnit unit)
{
    const NumberFormat format = facttext::angleFormat(unit);
    m_field->setFormat(format);
    m_slider->setFactor(format.factor);
    m_field->setStep(unit == AngleUnit::Degrees ? oneDegree : 0.01);
    m_slider->setSoftRange(-pi, pi, unit == AngleUnit::Degrees ? oneDegree : 0.01, false);
}

void RollEditor::showBranches(NodeId node, std::vector<std::uint64_t> keys)
{
    m_node = node;
    m_keys = std::move(keys);
    const Node* tree = m_document->scene().find(node);
    const bool editable = tree && !m_keys.empty() && !m_document->scene().isLocked(node);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_name, m_slider, m_field})
        widget->setEnabled(editable);
    const std::optional<double> roll = tree ? commonRoll(edit::branchRolls(*m_document, node, m_keys)) : 0.0;
    m_slider->setNumber(roll);
    m_field->setValue(roll);
    m_reset->setEnabled(editable && (!roll || *roll != 0.0));
    const bool locked = tree && m_document->scene().isLocked(m_node);
    m_hint->setVisible(locked || m_keys.size() > 1);
    m_hint->setText(locked ? tr("The tree is locked.")
                           : tr("For all %n selected branch(es).", nullptr, static_cast<int>(m_keys.size())));
}

void RollEditor::apply(double rollRad, GestureId gesture)
{
    const double turn = std::abs(rollRad) > pi ? std::remainder(rollRad, 2.0 * pi) : rollRad;
    if (const auto done = edit::setBranchRoll(*m_document, m_node, m_keys, turn, gesture); !done)
        emit refused(errorText(done.error()));
    showBranches(m_node, m_keys); // also where the document said no, or took whole turns off
}

} // namespace ramure
