/// \file
/// Chooses the arm's outer shape: the cylinder, or the mesh of an imported object.
#pragma once

#include "core/qt/session/arm/arm_dresser.h"
#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace ramure {

class ArmMeshRow : public QWidget
{
    Q_OBJECT
public:
    /// Follows the active arm, else the first one. \p document is not owned and must outlive this object.
    explicit ArmMeshRow(Document* document, QWidget* parent = nullptr);

    /// The arm puts on the next object that is imported; false: it does not.
    void setWaiting(bool waiting) { m_waiting = waiting; }
    /// An import has added this node and those below it.
    void takeImported(ramure::NodeId top);
    /// The job that puts on a large mesh.
    [[nodiscard]] Job* job() { return m_dresser->job(); }

signals:
    void importRequested();

private:
    void takeArm();
    void choose(int index);
    void wear(NodeId mesh, std::optional<MeshAxis> axis = {});
    void fitAgain();
    void turn(MeshAxis axis);
    [[nodiscard]] NodeId wornNode() const;
    void showProblem(const Expected<void>& done);

    Document* m_document;
    ArmDresser* m_dresser;
    NodeId m_arm = noNode;
    bool m_waiting = false;
    QComboBox* m_choice;
    QCheckBox* m_fit;
    QComboBox* m_axis;
    QPushButton *m_import, *m_again;
    QLabel* m_problem;
};

} // namespace ramure
