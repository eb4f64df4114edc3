#include "widgets/panels/arm/joint_form.h"

#include "core/qt/session/motion/auto_key.h"
#include "core/qt/session/motion/player.h"
#include "widgets/base/fields/key_button.h"
#include "widgets/base/fields/number_field.h"
#include "widgets/base/fields/number_slider.h"
#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <numbers>

namespace ramure {
namespace {

NumberFormat formatOf(const JointDef& def, const QString& suffix)
{
    NumberFormat format;
    format.unit = def.unit;
    format.factor = def.unit == ParamUnit::Radian ? 180.0 / std::numbers::pi : 1.0;
    format.suffix = suffix;
    format.decimals = def.decimals;
    return format;
}

} // namespace

/// One number of the joint.
struct JointForm::Row
{
    const JointDef* def = nullptr;
    std::size_t number = 0; ///< of the table
    QToolButton* key = nullptr;
    QLabel* label = nullptr;
    NumberField* field = nullptr;
    NumberSlider* slider = nullptr;
    GestureId gesture = 0;
};

JointForm::JointForm(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_message(named(new QLabel(this), "problem"))
{
    auto* form = layoutOf<QFormLayout>(this);
    const auto table = jointTable();
    for (std::size_t i = 0; i < table.size(); ++i) {
        addRow(form, table[i], i);
        if (table[i].member == &ArmAngle::angleRad)
            addLimited(form, table[i].angle == &ArmJoint::phi);
    }
    m_message->setWordWrap(true);
    m_message->hide();
    form->addRow(m_message);
}

JointForm::~JointForm() = default;

void JointForm::addRow(QFormLayout* form, const JointDef& def, std::size_t number)
{
    auto row = std::make_unique<Row>();
    Row& made = *row;
    made.def = &def;
    made.number = number;
    made.key = newKeyButton(this);
    const QString title = coreText(def.label);
    made.label = new QLabel(title, this);
    made.field = new NumberField(this);
    made.label->setBuddy(made.field);
    made.field->setRange(def.hardMin, def.hardMax);
    made.field->setStep(def.step);
    made.field->setScale(NumberScale(def.softMin, def.softMax, def.step, false));
    made.field->addHandle(made.label);
    made.slider = new NumberSlider(this);
    made.slider->setSoftRange(def.softMin, def.softMax, def.step, false);
    const bool speed = def.member == &ArmAngle::mostSpeed;
    const NumberFormat format = formatOf(def, !def.angle ? tr(" m") : speed ? tr("°/s") : tr("°"));
    made.field->setFormat(format);
    made.slider->setFactor(format.factor);
    made.field->setAccessibleName(title);
    made.slider->setAccessibleName(title);
    for (QWidget* widget : {static_cast<QWidget*>(made.label), static_cast<QWidget*>(made.field),
                            static_cast<QWidget*>(made.slider)})
        widget->setToolTip(coreText(def.tooltip));
    auto* named = new QWidget(this);
    auto* name = layoutOf<QHBoxLayout>(named, 2);
    name->addWidget(made.key);
    name->addWidget(made.label, 1);
    auto* line = new QHBoxLayout;
    line->addWidget(made.slider, 1);
    line->addWidget(made.field);
    form->addRow(named, line);
    const auto begin = [&made] { made.gesture = newGesture(); };
    const auto end = [&made] { made.gesture = 0; };
    connect(made.field, &NumberField::gestureBegan, this, begin);
    connect(made.field, &NumberField::gestureEnded, this, end);
    connect(made.slider, &NumberSlider::gestureBegan, this, begin);
    connect(made.slider, &NumberSlider::gestureEnded, this, end);
    const auto edited = [this, &made](double value) { set(made, value, made.gesture); };
    connect(made.field, &NumberField::valueEdited, this, edited);
    connect(made.slider, &NumberSlider::numberEdited, this, edited);
    connect(made.key, &QToolButton::clicked, this, [this, &made] {
        if (!m_keys || !joints())
            return;
        const KeyState before = m_keys->state(m_arm, channelOf(made));
        const auto done = m_keys->toggle(m_arm, channelOf(made));
        take(done);
        if (done)
            emit messageRaised(keyToggledText(coreText(made.def->label), before, m_keys->player()->frame()));
    });
    m_rows.push_back(std::move(row));
    showKeyState(made);
}

void JointForm::addLimited(QFormLayout* form, bool phi)
{
    QCheckBox*& box = phi ? m_limitPhi : m_limitTheta;
    box = new QCheckBox(tr("Limited"), this);
    box->setToolTip(tr("The angle stays between its limits; otherwise it may turn for ever. Has no keys: key "
                       "the limits instead, which do"));
    form->addRow(QString(), box);
    connect(box, &QCheckBox::clicked, this, [this, phi](bool on) { setLimited(phi, on); });
}

void JointForm::setKeys(AutoKey* keys)
{
    m_keys = keys;
    connect(keys->player(), &Player::frameChanged, this, &JointForm::showValues);
    connect(keys, &AutoKey::changed, this, &JointForm::showValues);
    showValues();
}

void JointForm::setJoint(NodeId arm, int joint)
{
    if (arm != m_arm || joint != m_joint)
        m_message->hide();
    m_arm = arm;
    m_joint = joint;
    showValues();
}

const std::vector<ArmJoint>* JointForm::joints() const
{
    const Node* node = m_document->scene().find(m_arm);
    return node && m_joint >= 0 && m_joint < static_cast<int>(node->params.joints.size())
               ? &node->params.joints
               : nullptr;
}

Channel JointForm::channelOf(const Row& row) const
{
    return {ChannelPart::Joint, static_cast<std::uint8_t>(m_joint), static_cast<ParamId>(row.number)};
}

void JointForm::showValues()
{
    const std::vector<ArmJoint>* all = joints();
    if (!all)
        return;
    const ArmJoint& joint = (*all)[static_cast<std::size_t>(m_joint)];
    for (const auto& row : m_rows) {
        const double value = m_keys ? m_keys->value(m_arm, channelOf(*row)) : row->def->of(joint);
        row->field->setValue(value);
        row->slider->setNumber(value);
        const bool ofLimit = row->def->member == &ArmAngle::minRad || row->def->member == &ArmAngle::maxRad;
        const bool counts = !ofLimit || (joint.*row->def->angle).limited;
        row->field->setEnabled(counts);
        row->slider->setEnabled(counts);
        showKeyState(*row);
    }
    m_limitPhi->setChecked(joint.phi.limited);
    m_limitTheta->setChecked(joint.theta.limited);
}

void JointForm::showKeyState(const Row& row)
{
    row.key->setVisible(m_keys != nullptr);
    if (!m_keys || !joints())
        return;
    ramure::showKeyState(row.key, coreText(row.def->label), m_keys->state(m_arm, channelOf(row)));
}

void JointForm::set(Row& row, double value, GestureId gesture)
{
    const std::vector<ArmJoint>* all = joints();
    if (!all)
        return;
    if (m_keys && m_keys->takes(m_arm, channelOf(row)))
        return take(m_keys->set(m_arm, channelOf(row), value, gesture));
    std::vector<ArmJoint> changed = *all;
    ArmJoint& joint = changed[static_cast<std::size_t>(m_joint)];
    row.def->of(joint) = value;
    if (row.def->angle) { // a limit takes the other one along, and the angle stays between them
        ArmAngle& angle = joint.*row.def->angle;
        if (row.def->member == &ArmAngle::maxRad)
            angle.minRad = std::min(angle.minRad, value);
        settleAngle(angle);
    }
    push(std::move(changed), tr("Change joint %1").arg(m_joint + 1), gesture);
}

void JointForm::setLimited(bool phi, bool limited)
{
    const std::vector<ArmJoint>* all = joints();
    if (!all)
        return;
    std::vector<ArmJoint> changed = *all;
    ArmJoint& joint = changed[static_cast<std::size_t>(m_joint)];
    ArmAngle& angle = phi ? joint.phi : joint.theta;
    angle.limited = limited;
    settleAngle(angle);
    push(std::move(changed), tr("Limit joint %1").arg(m_joint + 1));
}

void JointForm::push(std::vector<ArmJoint> joints, const QString& text, GestureId gesture)
{
    take(edit::setJoints(*m_document, m_arm, std::move(joints), text, gesture));
}

/// What is refused (locked meanwhile, no key here) is shown as it was, and why.
void JointForm::take(const Expected<void>& done)
{
    m_message->setVisible(!done);
    if (done)
        return;
    QString text = errorText(done.error());
    text[0] = text[0].toUpper();
    m_message->setText(text);
    showValues();
}

} // namespace ramure
