/// \file
/// What dragged values snap to, and how many ghosts there are. Applies at once.
#pragma once

#include <QDialog>

class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace ramure {

class GizmoSettings;

class ToolSettingsDialog : public QDialog
{
    Q_OBJECT
public:
    /// \p settings are not owned and must outlive the dialog.
    explicit ToolSettingsDialog(GizmoSettings* settings, QWidget* parent = nullptr);

private:
    void build();
    void take();
    void applySteps();
    void applyGhosts();

    GizmoSettings* m_settings;
    QDoubleSpinBox* m_move;
    QDoubleSpinBox* m_turn;
    QDoubleSpinBox* m_scale;
    QSpinBox* m_before;
    QSpinBox* m_after;
    QSpinBox* m_step;
    bool m_taking = false;
};

} // namespace ramure
