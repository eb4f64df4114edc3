#include "widgets/panels/animation/key_values.h"

#include "widgets/base/fields/number_field.h"
#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/panels/animation/key_model.h"
#include "widgets/panels/animation/key_texts.h"
#include <QHBoxLayout>
#include <QLabel>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace ramure {
namespace {

/// The format and the range of the channel's parameter; of translations metres.
void dress(NumberField& field, const Channel& channel)
{
    if (const JointDef* joint = channel.jointDef()) {
        field.setRange(joint->hardMin, joint->hardMax);
        field.setStep(joint->step);
    } else if (const ParamDef* def = channel.def()) {
        field.setRange(def->hardMin, def->hardMax);
        field.setStep(def->step);
    } else {
        field.setRange(-1e9, 1e9);
        field.setStep(0.1);
    }
    field.setFormat(channelFormat(channel));
}

glm::dvec3 anglesOf(const glm::dquat& q)
{
    const auto placement = decomposePlacement(glm::mat4_cast(q));
    return placement ? placement->rotation : glm::dvec3(0.0);
}

} // namespace

KeyValues::KeyValues(KeyModel* model, QWidget* parent)
    : QWidget(parent)
    , m_model(model)
{
    auto* label = new QLabel(tr("Value"), this);
    auto* row = layoutOf<QHBoxLayout>(this, 3);
    row->addWidget(label);
    for (int i = 0; i < 3; ++i) {
        auto* field = new NumberField(this);
        field->setObjectName(QStringLiteral("keyValue%1").arg(i));
        m_fields[static_cast<std::size_t>(i)] = field;
        row->addWidget(field);
        connect(field, &NumberField::gestureBegan, this, [this] { m_gesture = newGesture(); });
        connect(field, &NumberField::gestureEnded, this, [this] { m_gesture = 0; });
        connect(field, &NumberField::refused, this, &KeyValues::messageRaised);
        connect(field, &NumberField::valueEdited, this,
                [this, i](double value) { m_angles ? setAngle(i, value) : setNumber(value); });
    }
    label->setBuddy(m_fields[0]);
    connect(model, &KeyModel::selectionChanged, this, &KeyValues::showValues);
    const QString axes[] = {tr("X"), tr("Y"), tr("Z")};
    for (std::size_t i = 0; i < 3; ++i) {
        m_fields[i]->setToolTip(
            tr("Value of the selected keys: metres, a factor, the parameter's unit, or degrees about %1")
                .arg(axes[i]));
        m_fields[i]->setAccessibleName(tr("Key value %1").arg(axes[i]));
    }
    showValues();
}

/// Of the selected orientations; nothing where they differ.
std::array<std::optional<double>, 3> KeyValues::commonAngles() const
{
    std::array<std::optional<double>, 3> common;
    bool begun = false;
    for (const auto& [ref, times] : m_model->selection()) {
        const auto track = keys::find(m_model->document()->scene(), ref);
        const auto* held = track ? std::get_if<OrientationTrack>(track.get()) : nullptr;
        for (std::size_t i = 0; held && i < times.size(); ++i) {
            const glm::dvec3 angles = anglesOf(held->keys()[*held->find(times[i])].value);
            for (int c = 0; c < 3; ++c) {
                auto& mine = common[std::size_t(c)];
                if (!begun)
                    mine = angles[c];
                else if (mine && std::abs(*mine - angles[c]) > 1e-9)
                    mine.reset();
            }
            begun = true;
            if (!common[0] && !common[1] && !common[2])
                return common;
        }
    }
    return common;
}

void KeyValues::showValues()
{
    const KeySelection& selection = m_model->selection();
    setVisible(!selection.empty());
    if (selection.empty())
        return;
    const TrackRef first = selection.begin()->first;
    m_angles = first.channel.isOrientation();
    for (std::size_t i = 0; i < 3; ++i)
        m_fields[i]->setVisible(i == 0 || m_angles);
    if (m_angles) {
        const auto angles = commonAngles();
        for (int i = 0; i < 3; ++i) {
            NumberField* field = m_fields[static_cast<std::size_t>(i)];
            field->setFormat(channelFormat(first.channel));
            field->setRange(-1e4, 1e4);
            field->setStep(std::numbers::pi / 180.0);
            field->setValue(angles[std::size_t(i)]);
        }
        return;
    }
    dress(*m_fields[0], first.channel);
    std::optional<double> common;
    bool differ = false;
    for (const auto& [ref, times] : selection) {
        const auto track = keys::find(m_model->document()->scene(), ref);
        const auto* number = track ? std::get_if<Track>(track.get()) : nullptr;
        for (std::size_t i = 0; number && !differ && i < times.size(); ++i) {
            const double value = number->keys()[*number->find(times[i])].value;
            differ = common && *common != value;
            common = value;
        }
    }
    m_fields[0]->setValue(differ ? std::nullopt : common);
}

void KeyValues::report(const Expected<void>& done)
{
    if (!done) {
        emit messageRaised(errorText(done.error()));
        showValues();
    }
}

void KeyValues::setNumber(double value)
{
    report(keys::changeValues(
        *m_model->document(), m_model->selection(), [value](const TrackRef&, double) { return value; },
        tr("Change Key Values"), m_gesture));
}

void KeyValues::setAngle(int axis, double angleRad)
{
    report(keys::changeOrientations(
        *m_model->document(), m_model->selection(),
        [axis, angleRad](const glm::dquat& q) {
            glm::dvec3 angles = anglesOf(q);
            angles[axis] = angleRad;
            return glm::quat_cast(rotationMatrix(angles));
        },
        tr("Change Key Values"), m_gesture));
}

} // namespace ramure
