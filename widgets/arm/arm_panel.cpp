#include "widgets/arm/arm_panel.h"

#include "widgets/numbers/number_field.h"
#include "widgets/numbers/number_slider.h"
#include "widgets/viewport/arm_overlay.h"
#include <QCheckBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <numbers>

namespace ramure {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

NumberFormat formatOf(ParamUnit unit, const QString& suffix)
{
    NumberFormat format;
    format.unit = unit;
    format.factor = unit == ParamUnit::Radian ? 1.0 / degree : 1.0;
    format.suffix = suffix;
    format.decimals = unit == ParamUnit::Radian ? 1 : 3;
    return format;
}

} // namespace

/// One number of the chosen joint.
struct ArmPanel::Row
{
    QLabel* label = nullptr;
    NumberField* field = nullptr;
    NumberSlider* slider = nullptr;      ///< not of limits
    ArmAngle ArmJoint::*angle = nullptr; ///< null: the length
    double ArmAngle::*member = nullptr;
    GestureId gesture = 0;

    [[nodiscard]] double& of(ArmJoint& joint) const { return angle ? (joint.*angle).*member : joint.length; }
};

ArmPanel::ArmPanel(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_none(new QLabel(this))
    , m_content(new QWidget(this))
    , m_list(new QListWidget(m_content))
    , m_add(new QPushButton(m_content))
    , m_remove(new QPushButton(m_content))
    , m_go(new QPushButton(m_content))
    , m_pause(new QPushButton(m_content))
    , m_step(new QPushButton(m_content))
    , m_status(new QLabel(m_content))
{
    m_none->setAlignment(Qt::AlignCenter);
    m_none->setWordWrap(true);
    m_list->setMaximumHeight(130);
    m_status->setWordWrap(true);
    m_pause->setCheckable(true);
    auto* form = new QFormLayout;
    addNumber(form, 0.01, 5.0, false);
    addAngle(form, true);
    addAngle(form, false);
    auto* edits = new QHBoxLayout;
    edits->addWidget(m_add);
    edits->addWidget(m_remove);
    auto* way = new QHBoxLayout;
    for (QPushButton* button : {m_go, m_pause, m_step})
        way->addWidget(button);
    auto* inner = new QVBoxLayout(m_content);
    inner->addWidget(m_list);
    inner->addLayout(edits);
    inner->addLayout(form);
    inner->addLayout(way);
    inner->addWidget(m_status);
    inner->addStretch();
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(m_content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(m_none);
    outer->addWidget(scroll);
    connect(m_add, &QPushButton::clicked, this, &ArmPanel::addJoint);
    connect(m_remove, &QPushButton::clicked, this, &ArmPanel::removeJoint);
    connect(m_list, &QListWidget::currentRowChanged, this, [this] { showValues(); });
    connect(document, &Document::changed, this, &ArmPanel::follow);
    retranslate();
    takeArm();
}

ArmPanel::~ArmPanel() = default;

void ArmPanel::setReach(ArmReach* reach)
{
    m_reach = reach;
    if (!reach)
        return;
    connect(reach, &ArmReach::moved, this, &ArmPanel::showProgress);
    connect(m_go, &QPushButton::clicked, this, [this] {
        const Node* node = m_document->scene().find(m_arm);
        if (node && m_reach)
            m_reach->reachFor(m_arm, node->params.arm.target, 0);
    });
    connect(m_pause, &QPushButton::toggled, reach, &ArmReach::setPaused);
    connect(m_step, &QPushButton::clicked, reach, &ArmReach::step);
    showProgress();
}

int ArmPanel::joint() const
{
    return m_list->currentRow();
}

void ArmPanel::chooseJoint(int joint)
{
    m_list->setCurrentRow(joint);
}

ArmPanel::Row& ArmPanel::addNumber(QFormLayout* form, double low, double high, bool angle)
{
    auto row = std::make_unique<Row>();
    Row& made = *row;
    made.label = new QLabel(m_content);
    made.field = new NumberField(m_content);
    made.label->setBuddy(made.field);
    made.field->setRange(angle ? -1e3 : 1e-4, angle ? 1e3 : 1e4);
    made.field->setStep(angle ? degree : 0.1);
    made.slider = new NumberSlider(m_content);
    made.slider->setSoftRange(low, high, angle ? degree : 0.05, false);
    auto* line = new QHBoxLayout;
    line->addWidget(made.slider, 1);
    line->addWidget(made.field);
    form->addRow(made.label, line);
    const auto begin = [&made] { made.gesture = newGesture(); };
    const auto end = [&made] { made.gesture = 0; };
    connect(made.field, &NumberField::gestureBegan, this, begin);
    connect(made.field, &NumberField::gestureEnded, this, end);
    connect(made.slider, &NumberSlider::gestureBegan, this, begin);
    connect(made.slider, &NumberSlider::gestureEnded, this, end);
    const auto edited = [this, &made](double value) { set(made, value, made.gesture); };
    connect(made.field, &NumberField::valueEdited, this, edited);
    connect(made.slider, &NumberSlider::numberEdited, this, edited);
    m_rows.push_back(std::move(row));
    return made;
}

void ArmPanel::addAngle(QFormLayout* form, bool phi)
{
    const auto add = [&](double ArmAngle::*member, double low, double high) {
        Row& row = addNumber(form, low, high, true);
        row.angle = phi ? &ArmJoint::phi : &ArmJoint::theta;
        row.member = member;
        if (member == &ArmAngle::mostSpeed)
            row.field->setRange(0.0, 1e3);
    };
    constexpr double half = std::numbers::pi;
    add(&ArmAngle::angleRad, -half, half);
    auto*& limited = phi ? m_limitPhi : m_limitTheta;
    limited = new QCheckBox(m_content);
    form->addRow(QString(), limited);
    connect(limited, &QCheckBox::clicked, this, [this, phi](bool on) { setLimited(phi, on); });
    add(&ArmAngle::minRad, -half, half);
    add(&ArmAngle::maxRad, -half, half);
    add(&ArmAngle::mostSpeed, 0.0, 2.0 * half);
}

const std::vector<ArmJoint>* ArmPanel::joints() const
{
    const Node* node = m_document->scene().find(m_arm);
    return node ? &node->params.joints : nullptr;
}

void ArmPanel::follow(const Change& change)
{
    if (change.has(changeReset | changeStructure | changeSelection))
        takeArm();
    else if (change.has(changeJoints | changeNodeState))
        showJoints();
}

/// The active node where it is an arm, else the first arm there is.
void ArmPanel::takeArm()
{
    const Scene& scene = m_document->scene();
    const Node* active = scene.find(m_document->selection().activeNode());
    m_arm = active && active->kind == NodeKind::Arm ? active->id : noNode;
    for (const Node& node : scene.nodes())
        if (m_arm == noNode && node.kind == NodeKind::Arm)
            m_arm = node.id;
    showJoints();
    showProgress();
}

void ArmPanel::showJoints()
{
    const std::vector<ArmJoint>* all = joints();
    m_none->setVisible(!all);
    m_content->setVisible(all);
    m_content->setEnabled(all && !m_document->scene().isLocked(m_arm));
    const int count = all ? static_cast<int>(all->size()) : 0;
    if (m_list->count() != count) {
        const QSignalBlocker quiet(m_list);
        const int chosen = std::max(m_list->currentRow(), 0);
        m_list->clear();
        for (int i = 0; i < count; ++i)
            m_list->addItem(tr("Joint %1").arg(i + 1));
        m_list->setCurrentRow(std::min(chosen, count - 1));
    }
    m_add->setEnabled(count < static_cast<int>(mostArmJoints));
    m_remove->setEnabled(count > static_cast<int>(leastArmJoints));
    showValues();
}

void ArmPanel::showValues()
{
    const std::vector<ArmJoint>* all = joints();
    const int chosen = m_list->currentRow();
    if (!all || chosen < 0 || chosen >= static_cast<int>(all->size()))
        return;
    ArmJoint joint = (*all)[static_cast<std::size_t>(chosen)];
    for (const auto& row : m_rows) {
        const double value = row->of(joint);
        row->field->setValue(value);
        row->slider->setNumber(value);
        const bool ofLimit = row->member == &ArmAngle::minRad || row->member == &ArmAngle::maxRad;
        const bool counts = !ofLimit || (joint.*row->angle).limited;
        row->field->setEnabled(counts);
        row->slider->setEnabled(counts);
    }
    m_limitPhi->setChecked(joint.phi.limited);
    m_limitTheta->setChecked(joint.theta.limited);
}

void ArmPanel::set(Row& row, double value, GestureId gesture)
{
    const std::vector<ArmJoint>* all = joints();
    const int chosen = m_list->currentRow();
    if (!all || chosen < 0)
        return;
    std::vector<ArmJoint> changed = *all;
    ArmJoint& joint = changed[static_cast<std::size_t>(chosen)];
    row.of(joint) = value;
    if (row.angle) { // a limit takes the other one along, and the angle stays between them
        ArmAngle& angle = joint.*row.angle;
        if (row.member == &ArmAngle::minRad)
            angle.maxRad = std::max(angle.maxRad, value);
        if (row.member == &ArmAngle::maxRad)
            angle.minRad = std::min(angle.minRad, value);
        if (angle.limited)
            angle.angleRad = std::clamp(angle.angleRad, angle.minRad, angle.maxRad);
    }
    push(std::move(changed), tr("Change joint %1").arg(chosen + 1), gesture);
}

void ArmPanel::setLimited(bool phi, bool limited)
{
    const std::vector<ArmJoint>* all = joints();
    const int chosen = m_list->currentRow();
    if (!all || chosen < 0)
        return;
    std::vector<ArmJoint> changed = *all;
    ArmJoint& joint = changed[static_cast<std::size_t>(chosen)];
    ArmAngle& angle = phi ? joint.phi : joint.theta;
    angle.limited = limited;
    if (limited)
        angle.angleRad = std::clamp(angle.angleRad, angle.minRad, angle.maxRad);
    push(std::move(changed), tr("Limit joint %1").arg(chosen + 1));
}

void ArmPanel::addJoint()
{
    const std::vector<ArmJoint>* all = joints();
    const int chosen = m_list->currentRow();
    if (!all || chosen < 0 || all->size() >= mostArmJoints)
        return;
    std::vector<ArmJoint> changed = *all;
    const auto at = changed.begin() + chosen;
    changed.insert(at + 1, ArmJoint(*at));
    push(std::move(changed), tr("Add a joint"));
    m_list->setCurrentRow(chosen + 1);
}

void ArmPanel::removeJoint()
{
    const std::vector<ArmJoint>* all = joints();
    const int chosen = m_list->currentRow();
    if (!all || chosen < 0 || all->size() <= leastArmJoints)
        return;
    std::vector<ArmJoint> changed = *all;
    changed.erase(changed.begin() + chosen);
    push(std::move(changed), tr("Remove joint %1").arg(chosen + 1));
}

void ArmPanel::push(std::vector<ArmJoint> joints, const QString& text, GestureId gesture)
{
    // What is refused (locked meanwhile) is shown as it was.
    if (!edit::setJoints(*m_document, m_arm, std::move(joints), text, gesture))
        showValues();
}

void ArmPanel::showProgress()
{
    const ArmProgress* progress = m_reach ? m_reach->progress() : nullptr;
    const bool own = progress && progress->node == m_arm;
    m_status->setText(own ? armStatusText(*progress) : QString());
    m_step->setEnabled(own && progress->moves);
}

void ArmPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void ArmPanel::retranslate()
{
    m_none->setText(tr("No arm. Add one with Edit > Add > Arm, or open the demo."));
    m_list->setAccessibleName(tr("Joints"));
    m_add->setText(tr("Add"));
    m_add->setToolTip(tr("Adds a joint behind the chosen one, the same as it (1 to 64)"));
    m_remove->setText(tr("Remove"));
    m_remove->setToolTip(tr("Takes the chosen joint out"));
    m_go->setText(tr("Reach"));
    m_go->setToolTip(tr("Sends the arm to its target; Ctrl+click on a terrain sets another one"));
    m_pause->setText(tr("Pause"));
    m_pause->setToolTip(tr("Holds the arm on its way, to go through it step by step"));
    m_step->setText(tr("Step"));
    m_step->setToolTip(tr("One sixtieth of a second further"));
    const QString limited = tr("Limited");
    const QString limitTip = tr("The angle stays between its limits; otherwise it may turn for ever");
    for (QCheckBox* box : {m_limitPhi, m_limitTheta}) {
        box->setText(limited);
        box->setToolTip(limitTip);
    }
    for (const auto& row : m_rows) {
        QString name = tr("Length"), tip = tr("Of the segment behind the joint, metres");
        if (row->angle) {
            const bool phi = row->angle == &ArmJoint::phi;
            name = phi ? tr("Phi") : tr("Theta");
            tip = phi ? tr("Turns about the segment before the joint, degrees")
                      : tr("Bends the arm about the joint's Y axis, degrees");
            if (row->member == &ArmAngle::minRad) {
                name = tr("From");
                tip = tr("Lower limit of the angle, degrees");
            } else if (row->member == &ArmAngle::maxRad) {
                name = tr("To");
                tip = tr("Upper limit of the angle, degrees");
            } else if (row->member == &ArmAngle::mostSpeed) {
                name = tr("Speed");
                tip = tr("The most it turns, degrees a second; 0 is as fast as it likes");
            }
        }
        row->label->setText(name);
        row->field->setAccessibleName(name);
        row->slider->setAccessibleName(name);
        for (QWidget* widget : {static_cast<QWidget*>(row->label), static_cast<QWidget*>(row->field),
                                static_cast<QWidget*>(row->slider)})
            widget->setToolTip(tip);
        const bool speed = row->member == &ArmAngle::mostSpeed;
        row->field->setFormat(row->angle ? formatOf(ParamUnit::Radian, speed ? tr("°/s") : tr("°"))
                                         : formatOf(ParamUnit::Metre, tr(" m")));
    }
}

} // namespace ramure
