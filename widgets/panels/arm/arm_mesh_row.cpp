#include "widgets/panels/arm/arm_mesh_row.h"

#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

namespace ramure {

/// Item data: a node, or one of these.
static constexpr uint cylinderItem = noNode;
static constexpr uint wornItem = ~0U;

ArmMeshRow::ArmMeshRow(Document* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_dresser(new ArmDresser(document, this))
    , m_choice(new QComboBox(this))
    , m_fit(new QCheckBox(tr("Fit"), this))
    , m_axis(named(new QComboBox(this), "wornAxis"))
    , m_import(new QPushButton(tr("From a file…"), this))
    , m_again(named(new QPushButton(tr("Fit again"), this), "fitAgain"))
    , m_problem(named(new QLabel(this), "problem"))
{
    auto* label = new QLabel(tr("Skin"), this);
    label->setBuddy(m_choice);
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_fit->setChecked(true);
    m_axis->addItems({tr("The longest along"), tr("X along"), tr("Y along"), tr("Z along")});
    connect(m_fit, &QCheckBox::toggled, m_axis, &QWidget::setEnabled);
    connect(m_axis, &QComboBox::activated, this, [this](int index) { turn(static_cast<MeshAxis>(index)); });
    m_problem->setWordWrap(true);
    m_problem->hide();
    auto* grid = layoutOf<QGridLayout>(this);
    grid->addWidget(label, 0, 0);
    grid->addWidget(m_choice, 0, 1, 1, 2);
    grid->addWidget(m_fit, 1, 1);
    grid->addWidget(m_import, 1, 2);
    grid->addWidget(m_axis, 2, 1);
    grid->addWidget(m_again, 2, 2);
    grid->addWidget(m_problem, 3, 0, 1, 3);
    grid->setColumnStretch(1, 1);
    connect(m_choice, &QComboBox::activated, this, &ArmMeshRow::choose);
    connect(m_import, &QPushButton::clicked, this, &ArmMeshRow::importRequested);
    connect(m_again, &QPushButton::clicked, this, &ArmMeshRow::fitAgain);
    connect(m_dresser, &ArmDresser::finished, this, [this](const std::optional<Error>& error) {
        const bool wrong = error && error->code != ErrorCode::Cancelled;
        showProblem(wrong ? Expected<void>(fail(*error)) : Expected<void>());
    });
    connect(m_dresser->job(), &Job::runningChanged, this, &ArmMeshRow::takeArm);
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeReset | changeStructure | changeSelection | changeNodeState | changeJoints |
                       changeParams))
            takeArm();
    });
    m_choice->setAccessibleName(tr("Skin"));
    m_choice->setToolTip(tr("Outer shape of the arm: the cylinder, or a copy of an imported mesh whose "
                            "vertices follow the nearest segments. The object itself is hidden."));
    m_fit->setToolTip(tr(
        "Makes the mesh as long as the arm and stands it on the foot; otherwise it is bound where it stands "
        "around the straight arm"));
    m_axis->setAccessibleName(tr("Axis along the arm"));
    m_axis->setToolTip(
        tr("Which axis of a fitted mesh lies along the arm: of a tree that is Y. The mesh that is "
           "worn is put on again."));
    m_again->setToolTip(tr(
        "Makes the worn mesh as long as the arm is now, its foot on the arm's foot. A mesh is bound to the "
        "straight arm: lengths that change later move the joints along it and do not stretch it."));
    m_import->setToolTip(tr("Imports an object and binds it to the arm"));
    takeArm();
}

/// The active node where it is an arm, else the first arm there is; and what it can wear.
void ArmMeshRow::takeArm()
{
    const Scene& scene = m_document->scene();
    const Node* arm = scene.find(m_document->selection().activeNode());
    if (!arm || arm->kind != NodeKind::Arm) {
        const auto first = std::find_if(scene.nodes().begin(), scene.nodes().end(),
                                        [](const Node& node) { return node.kind == NodeKind::Arm; });
        arm = first == scene.nodes().end() ? nullptr : &*first;
    }
    if (m_arm != (arm ? arm->id : noNode))
        m_problem->hide();
    m_arm = arm ? arm->id : noNode;
    setEnabled(arm && !scene.isLocked(m_arm) && !m_dresser->job()->isRunning());
    m_again->setEnabled(arm && arm->mesh);
    m_axis->setCurrentIndex(static_cast<int>(arm ? arm->params.armSkin.axis : MeshAxis::Longest));
    const QSignalBlocker quiet(m_choice);
    m_choice->clear();
    m_choice->addItem(tr("Cylinder"), cylinderItem);
    if (arm && arm->mesh) {
        const auto triangles = static_cast<qlonglong>(arm->mesh->faceCount());
        m_choice->addItem(tr("Own mesh, %1 triangles").arg(QLocale().toString(triangles)), wornItem);
        m_choice->setCurrentIndex(1);
    }
    for (const Node& node : scene.nodes())
        if (node.kind == NodeKind::Mesh && node.mesh && !node.mesh->empty())
            m_choice->addItem(QString::fromStdString(node.name), node.id);
}

void ArmMeshRow::choose(int index)
{
    const uint item = m_choice->itemData(index).toUInt();
    if (item == cylinderItem)
        showProblem(edit::setArmMesh(*m_document, m_arm, {}, tr("Wear the cylinder")));
    else if (item != wornItem)
        wear(item);
}

void ArmMeshRow::wear(NodeId mesh, std::optional<MeshAxis> axis)
{
    showProblem(m_dresser->wear(m_arm, mesh, m_fit->isChecked(), axis));
}

/// What is worn is a copy that was turned already: it is put on again from the object, where that is there.
void ArmMeshRow::turn(MeshAxis axis)
{
    const Node* arm = m_document->scene().find(m_arm);
    if (!arm || axis == arm->params.armSkin.axis)
        return;
    if (const NodeId worn = wornNode(); worn != noNode)
        return wear(worn, axis);
    const bool wears = static_cast<bool>(arm->mesh);
    NodeParams params;
    params.armSkin.axis = axis;
    const ParamDef& def = *findParam("armSkin.axis");
    showProblem(edit::setParam(*m_document, {m_arm}, def, def.get(params)));
    if (wears && m_problem->isHidden()) {
        m_problem->setText(
            tr("The object that the arm's mesh was copied from is not in the scene: choose one "
               "again under “Skin”."));
        m_problem->show();
    }
}

/// The object that the arm's mesh is a copy of, or none.
NodeId ArmMeshRow::wornNode() const
{
    const Scene& scene = m_document->scene();
    const Node* arm = scene.find(m_arm);
    if (!arm || !arm->mesh)
        return noNode;
    for (const Node& node : scene.nodes())
        if (node.kind == NodeKind::Mesh && node.mesh && node.mesh->triangles == arm->mesh->triangles)
            return node.id;
    return noNode;
}

void ArmMeshRow::fitAgain()
{
    showProblem(m_dresser->fitAgain(m_arm));
}

/// What was refused is told, and the choice is what it was.
void ArmMeshRow::showProblem(const Expected<void>& done)
{
    m_problem->setText(done ? QString() : errorText(done.error()));
    m_problem->setVisible(!done);
    takeArm();
}

void ArmMeshRow::takeImported(NodeId top)
{
    if (!m_waiting || m_arm == noNode)
        return;
    m_waiting = false;
    const std::vector<Node> added = m_document->scene().subtree(top);
    const auto mesh = std::find_if(added.begin(), added.end(), [](const Node& node) {
        return node.kind == NodeKind::Mesh && node.mesh && !node.mesh->empty();
    });
    if (mesh != added.end())
        return wear(mesh->id);
    m_problem->setText(tr("The file has no triangles: the arm cannot wear it."));
    m_problem->show();
}

} // namespace ramure
