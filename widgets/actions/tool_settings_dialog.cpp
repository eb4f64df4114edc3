#include "widgets/actions/tool_settings_dialog.h"

#include "widgets/base/named.h"
#include "widgets/view/tools/gizmo_settings.h"
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace ramure {

ToolSettingsDialog::ToolSettingsDialog(GizmoSettings* settings, QWidget* parent)
    : QDialog(parent)
    , m_settings(settings)
    , m_move(named(new QDoubleSpinBox(this), "moveStep"))
    , m_turn(named(new QDoubleSpinBox(this), "turnStep"))
    , m_scale(named(new QDoubleSpinBox(this), "scaleStep"))
    , m_before(named(new QSpinBox(this), "ghostsBefore"))
    , m_after(named(new QSpinBox(this), "ghostsAfter"))
    , m_step(named(new QSpinBox(this), "ghostStep"))
{
    setObjectName(QStringLiteral("toolSettings"));
    m_move->setDecimals(3);
    m_move->setRange(0.001, 1000.0);
    m_move->setSingleStep(0.05);
    m_turn->setDecimals(2);
    m_turn->setRange(0.01, 180.0);
    m_scale->setDecimals(3);
    m_scale->setRange(0.001, 10.0);
    m_scale->setSingleStep(0.05);
    m_before->setRange(0, GizmoSettings::mostGhosts);
    m_after->setRange(0, GizmoSettings::mostGhosts);
    m_step->setRange(1, GizmoSettings::mostGhostStep);
    build();
    setWindowTitle(tr("Steps and ghosts"));
    m_move->setSuffix(tr(" m"));
    m_turn->setSuffix(tr("°"));
    m_step->setSuffix(tr(" frames"));
    m_move->setToolTip(tr("Moves go in steps of so many metres"));
    m_turn->setToolTip(tr("Turns go in steps of so many degrees"));
    m_scale->setToolTip(tr("Factors go in steps of so much"));
    m_before->setToolTip(
        tr("How many copies show where the node was, from 0 to %1").arg(GizmoSettings::mostGhosts));
    m_after->setToolTip(
        tr("How many copies show where the node will be, from 0 to %1").arg(GizmoSettings::mostGhosts));
    m_step->setToolTip(tr("Frames from one copy to the next"));
    take();
    for (QDoubleSpinBox* box : {m_move, m_turn, m_scale})
        connect(box, &QDoubleSpinBox::valueChanged, this, &ToolSettingsDialog::applySteps);
    for (QSpinBox* box : {m_before, m_after, m_step})
        connect(box, &QSpinBox::valueChanged, this, &ToolSettingsDialog::applyGhosts);
    connect(settings, &GizmoSettings::changed, this, &ToolSettingsDialog::take);
}

void ToolSettingsDialog::build()
{
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(12);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    using Row = std::pair<QString, QAbstractSpinBox*>;
    const auto add = [this, layout](const QString& title, std::initializer_list<Row> rows) {
        auto* group = new QGroupBox(title, this);
        auto* form = new QFormLayout(group);
        for (const auto& [label, field] : rows) {
            field->setKeyboardTracking(false);
            form->addRow(label, field);
        }
        layout->addWidget(group);
    };
    add(tr("Dragging snaps to"),
        {{tr("&Move:"), m_move}, {tr("&Rotate:"), m_turn}, {tr("&Scale:"), m_scale}});
    add(tr("Ghosts of moving nodes"), {{tr("&Before the playhead:"), m_before},
                                       {tr("&After the playhead:"), m_after},
                                       {tr("&Every:"), m_step}});
    auto* buttons = new QDialogButtonBox(this);
    buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole)->setDefault(true);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ToolSettingsDialog::take()
{
    m_taking = true;
    const SnapSteps steps = m_settings->steps();
    const GhostFrames ghosts = m_settings->ghostFrames();
    m_move->setValue(steps.move);
    m_turn->setValue(steps.turnDeg);
    m_scale->setValue(steps.scale);
    m_before->setValue(ghosts.before);
    m_after->setValue(ghosts.after);
    m_step->setValue(ghosts.step);
    m_taking = false;
}

void ToolSettingsDialog::applySteps()
{
    if (!m_taking)
        m_settings->setSteps({m_move->value(), m_turn->value(), m_scale->value()});
}

void ToolSettingsDialog::applyGhosts()
{
    if (!m_taking)
        m_settings->setGhostFrames({m_before->value(), m_after->value(), m_step->value()});
}

} // namespace ramure
