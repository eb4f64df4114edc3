#include "widgets/actions/tool_settings_dialog.h"

#include "widgets/view/tools/gizmo_settings.h"
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QEvent>
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
    , m_stepsGroup(new QGroupBox(this))
    , m_ghostsGroup(new QGroupBox(this))
    , m_labels{}
    , m_move(new QDoubleSpinBox(this))
    , m_turn(new QDoubleSpinBox(this))
    , m_scale(new QDoubleSpinBox(this))
    , m_before(new QSpinBox(this))
    , m_after(new QSpinBox(this))
    , m_step(new QSpinBox(this))
{
    setObjectName(QStringLiteral("toolSettings"));
    m_move->setObjectName(QStringLiteral("moveStep"));
    m_turn->setObjectName(QStringLiteral("turnStep"));
    m_scale->setObjectName(QStringLiteral("scaleStep"));
    m_before->setObjectName(QStringLiteral("ghostsBefore"));
    m_after->setObjectName(QStringLiteral("ghostsAfter"));
    m_step->setObjectName(QStringLiteral("ghostStep"));
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
    retranslate();
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
    QAbstractSpinBox* fields[6] = {m_move, m_turn, m_scale, m_before, m_after, m_step};
    for (int part = 0; part < 2; ++part) {
        QGroupBox* group = part == 0 ? m_stepsGroup : m_ghostsGroup;
        auto* form = new QFormLayout(group);
        for (int i = 3 * part; i < 3 * part + 3; ++i) {
            m_labels[i] = new QLabel(group);
            m_labels[i]->setBuddy(fields[i]);
            fields[i]->setKeyboardTracking(false);
            form->addRow(m_labels[i], fields[i]);
        }
        layout->addWidget(group);
    }
    auto* buttons = new QDialogButtonBox(this);
    m_close = buttons->addButton(QString(), QDialogButtonBox::RejectRole);
    m_close->setDefault(true);
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

void ToolSettingsDialog::retranslate()
{
    setWindowTitle(tr("Steps and ghosts"));
    m_stepsGroup->setTitle(tr("Dragging snaps to"));
    m_ghostsGroup->setTitle(tr("Ghosts of moving nodes"));
    m_labels[0]->setText(tr("&Move:"));
    m_labels[1]->setText(tr("&Rotate:"));
    m_labels[2]->setText(tr("&Scale:"));
    m_labels[3]->setText(tr("&Before the playhead:"));
    m_labels[4]->setText(tr("&After the playhead:"));
    m_labels[5]->setText(tr("&Every:"));
    for (QDoubleSpinBox* box : {m_move, m_turn, m_scale})
        box->setLocale(QLocale()); // its own is of the language it was made in
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
    m_close->setText(tr("Close"));
    take();
}

void ToolSettingsDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

} // namespace ramure
