/// \file
/// Asks which frames of an arm's motion become keys, and how exactly.
#pragma once

#include "core/rig/arm/arm_bake.h"
#include <QDialog>

class QCheckBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace ramure {

class NumberField;

class BakeKeysDialog : public QDialog
{
    Q_OBJECT
public:
    /// \param options what the fields begin with; where it has no range, the timeline's frames.
    BakeKeysDialog(const QString& arm, const TimelineSettings& timeline, const ArmBakeOptions& options,
                   QWidget* parent = nullptr);

    /// Always with a range.
    [[nodiscard]] ArmBakeOptions options() const;

private:
    void layOut(const QString& arm);
    void setTexts();
    void update();

    TimelineSettings m_timeline;
    QSpinBox *m_first, *m_last, *m_every;
    QPushButton* m_whole;
    NumberField* m_tolerance;
    QCheckBox* m_target;
    QLabel* m_note;
    QPushButton *m_bake, *m_cancel;
};

} // namespace ramure
