/// \file
/// The joints of the active arm: add, remove, lengths, angles, limits and speeds; and the way to its target.
#pragma once

#include "core/qt/session/arm/arm_baker.h"
#include "core/qt/session/arm/arm_reach.h"
#include <QWidget>
#include <optional>
#include <vector>

class QLabel;
class QListWidget;
class QPushButton;
class QScrollArea;

namespace ramure {

class ArmMeshRow;
class AutoKey;
class EmptyPage;
class JointForm;

class ArmPanel : public QWidget
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive the panel.
    explicit ArmPanel(Document* document, QWidget* parent = nullptr);
    ~ArmPanel() override;

    /// Shows and steers the arm on its way; may be null. Must outlive the panel.
    void setReach(ArmReach* reach);
    /// Numbers of joints can have keys. Must outlive the panel.
    void setKeys(AutoKey* keys);
    /// The job that bakes to keys, for a progress bar.
    [[nodiscard]] Job* bakeJob() { return m_baker->job(); }
    /// The arm that is shown; noNode where there is none.
    [[nodiscard]] NodeId arm() const { return m_arm; }
    [[nodiscard]] ArmMeshRow* meshRow() const { return m_worn; }
    [[nodiscard]] int joint() const;

signals:
    void messageRaised(const QString& text);

public slots:
    void addJoint();    ///< behind the chosen one, as it
    void removeJoint(); ///< the chosen one; the last one stays
    void chooseJoint(int joint);

private:
    void layOut();
    void follow(const Change& change);
    void takeArm();
    void showJoints();
    void showProgress();
    void keyPose();
    void askBake();
    void bake(const ArmBakeOptions& options);
    void tellBake(const std::optional<Error>& error);
    [[nodiscard]] const std::vector<ArmJoint>* joints() const;

    Document* m_document;
    ArmReach* m_reach = nullptr;
    NodeId m_arm = noNode;
    EmptyPage* m_none;
    QScrollArea* m_scroll;
    QWidget* m_content;
    QListWidget* m_list;
    QPushButton *m_add, *m_remove;
    JointForm* m_joint;
    QPushButton *m_go, *m_pause, *m_step;
    QLabel* m_status;
    QPushButton *m_keyPose, *m_bake;
    AutoKey* m_keys = nullptr;
    ArmBaker* m_baker;
    ArmBakeOptions m_bakeOptions; ///< the last options; without a range it is as long as the timeline's
    ArmMeshRow* m_worn;
};

} // namespace ramure
