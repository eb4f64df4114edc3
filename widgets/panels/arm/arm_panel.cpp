#include "widgets/panels/arm/arm_panel.h"

#include "core/qt/session/motion/auto_key.h"
#include "core/qt/session/motion/player.h"
#include "core/rig/arm/arm_chain.h"
#include "widgets/base/empty_page.h"
#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/panels/arm/arm_mesh_row.h"
#include "widgets/panels/arm/bake_keys_dialog.h"
#include "widgets/panels/arm/joint_form.h"
#include "widgets/view/tools/arm/arm_overlay.h"
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>

namespace ramure {

static constexpr int statusLines = 4; ///< residual, reached or not, joints at their limits

ArmPanel::ArmPanel(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_none(new EmptyPage(this))
    , m_scroll(new QScrollArea(this))
    , m_content(new QWidget(m_scroll))
    , m_list(new QListWidget(m_content))
    , m_add(new QPushButton(tr("Add"), m_content))
    , m_remove(new QPushButton(tr("Remove"), m_content))
    , m_joint(new JointForm(document, m_content))
    , m_go(new QPushButton(tr("Reach"), m_content))
    , m_pause(new QPushButton(tr("Pause"), m_content))
    , m_step(new QPushButton(tr("Step"), m_content))
    , m_status(named(new QLabel(m_content), "armStatus"))
    , m_keyPose(named(new QPushButton(tr("Key the pose"), m_content), "keyPose"))
    , m_bake(named(new QPushButton(tr("Bake to keys…"), m_content), "bakeToKeys"))
    , m_baker(new ArmBaker(document, this))
    , m_worn(new ArmMeshRow(document, m_content))
{
    m_list->setFixedHeight(130); // what is below it would take and give its height
    m_list->setSpacing(2);
    m_status->setWordWrap(true);
    m_status->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    // The first way must not move what is below, and not bring a scroll bar.
    m_status->setFixedHeight(statusLines * m_status->fontMetrics().lineSpacing());
    m_pause->setCheckable(true);
    m_keyPose->setEnabled(false);
    layOut();
    connect(m_add, &QPushButton::clicked, this, &ArmPanel::addJoint);
    connect(m_remove, &QPushButton::clicked, this, &ArmPanel::removeJoint);
    connect(m_list, &QListWidget::currentRowChanged, this,
            [this](int row) { m_joint->setJoint(m_arm, row); });
    connect(m_keyPose, &QPushButton::clicked, this, &ArmPanel::keyPose);
    connect(m_bake, &QPushButton::clicked, this, &ArmPanel::askBake);
    connect(m_baker, &ArmBaker::finished, this, &ArmPanel::tellBake);
    connect(document, &Document::changed, this, &ArmPanel::follow);
    m_none->setText(
        tr("No arm. Edit > Add to the scene > Arm makes one; the demo of the arm has one already."));
    m_list->setAccessibleName(tr("Joints"));
    m_add->setToolTip(tr("Adds a joint behind the chosen one, the same as it (1 to 64)"));
    m_remove->setToolTip(tr("Takes the chosen joint out"));
    m_go->setToolTip(tr("Sends the arm to its target; Ctrl+click on a terrain sets another one"));
    m_pause->setToolTip(tr("Holds the arm on its way, to go through it step by step"));
    m_step->setToolTip(tr("One sixtieth of a second further"));
    m_keyPose->setToolTip(tr("Inserts a key at this frame for the angles of all joints"));
    m_bake->setToolTip(
        tr("The motion towards the target becomes keys of the joints' angles, at the frames you choose; "
           "then the arm follows those"));
    takeArm();
}

ArmPanel::~ArmPanel() = default;

void ArmPanel::layOut()
{
    auto* edits = new QHBoxLayout;
    edits->addWidget(m_add);
    edits->addWidget(m_remove);
    auto* way = new QHBoxLayout;
    for (QPushButton* button : {m_go, m_pause, m_step})
        way->addWidget(button);
    auto* inner = new QVBoxLayout(m_content);
    inner->addWidget(m_list);
    inner->addLayout(edits);
    inner->addWidget(m_joint);
    connect(m_joint, &JointForm::messageRaised, this, &ArmPanel::messageRaised);
    inner->addWidget(m_keyPose);
    inner->addWidget(m_worn);
    inner->addLayout(way);
    inner->addWidget(m_status);
    inner->addWidget(m_bake);
    inner->addStretch();
    m_scroll->setWidget(m_content);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    auto* outer = layoutOf<QVBoxLayout>(this);
    outer->addWidget(m_none);
    outer->addWidget(m_scroll);
}

void ArmPanel::setReach(ArmReach* reach)
{
    m_reach = reach;
    if (!reach)
        return;
    connect(reach, &ArmReach::moved, this, &ArmPanel::showProgress);
    connect(m_go, &QPushButton::clicked, this, [this] {
        if (const auto done = m_reach->reach(m_arm); !done)
            emit messageRaised(errorText(done.error()));
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

void ArmPanel::setKeys(AutoKey* keys)
{
    m_keys = keys;
    m_keyPose->setEnabled(keys);
    m_joint->setKeys(keys);
}

/// All angles of all joints as they are seen, at the frame on show.
void ArmPanel::keyPose()
{
    const std::vector<ArmJoint>* all = joints();
    if (!m_keys || !all)
        return;
    std::vector<double> angles = armAngles(*all);
    const auto motion = m_keys->player()->motion();
    const NodeMotion* moving = motion ? motion->of(m_arm) : nullptr;
    const ArmProgress* seen = m_reach ? m_reach->shown(m_arm) : nullptr;
    if (!seen && moving && moving->moves())
        seen = moving->arm.get();
    if (seen && seen->angles.size() == angles.size())
        angles = seen->angles;
    std::vector<std::pair<Channel, double>> values;
    for (std::size_t i = 0; i < angles.size(); ++i)
        values.push_back({{ChannelPart::Joint, static_cast<std::uint8_t>(i / 2),
                           static_cast<ParamId>(jointAngleNumber(i % 2 == 0))},
                          angles[i]});
    if (const auto done = m_keys->insert(m_arm, values, tr("Key the pose")); !done)
        emit messageRaised(errorText(done.error()));
}

void ArmPanel::askBake()
{
    const Node* node = m_document->scene().find(m_arm);
    if (!node)
        return;
    auto* dialog = new BakeKeysDialog(QString::fromStdString(node->name), m_document->scene().timeline(),
                                      m_bakeOptions, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { bake(dialog->options()); });
    dialog->open();
}

/// The range is remembered where it is another one than the timeline's.
void ArmPanel::bake(const ArmBakeOptions& options)
{
    const TimelineSettings& timeline = m_document->scene().timeline();
    m_bakeOptions = options;
    if (options.range && options.range->every == 1 && options.range->firstFrame == timeline.firstFrame &&
        options.range->lastFrame == timeline.lastFrame)
        m_bakeOptions.range.reset();
    if (const auto started = m_baker->start(m_arm, options); !started)
        tellBake(started.error());
}

void ArmPanel::tellBake(const std::optional<Error>& error)
{
    emit messageRaised(error ? errorText(*error) : tr("The arm follows its keys now, no target."));
}

const std::vector<ArmJoint>* ArmPanel::joints() const
{
    const Node* node = m_document->scene().find(m_arm);
    return node ? &node->params.joints : nullptr;
}

void ArmPanel::follow(const Change& change)
{
    if (change.has(changeReset)) {
        m_pause->setChecked(false);
        m_bakeOptions = {};
    }
    if (change.has(changeReset | changeStructure | changeSelection))
        takeArm();
    else if (change.has(changeJoints | changeNodeState | changeTracks | changeParams))
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
    m_scroll->setVisible(all);
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
    m_joint->setJoint(m_arm, m_list->currentRow());
    const Node* node = m_document->scene().find(m_arm);
    m_bake->setEnabled(node && node->params.arm.follows);
}

void ArmPanel::addJoint()
{
    const int chosen = m_list->currentRow();
    if (joints() && chosen >= 0 && edit::addJoint(*m_document, m_arm, static_cast<std::size_t>(chosen)))
        m_list->setCurrentRow(chosen + 1);
}

void ArmPanel::removeJoint()
{
    const int chosen = m_list->currentRow();
    // What is refused (the last one, locked meanwhile) stays.
    if (joints() && chosen >= 0)
        (void)edit::removeJoint(*m_document, m_arm, static_cast<std::size_t>(chosen));
}

void ArmPanel::showProgress()
{
    const ArmProgress* shown = m_reach ? m_reach->shown(m_arm) : nullptr;
    m_status->setText(shown ? armStatusText(*shown) : QString());
    m_status->setToolTip(m_status->text());
    m_step->setEnabled(shown && shown->moves && m_reach->isAtRest());
}

} // namespace ramure
