/// \file
/// The joints of the active arm: add, remove, lengths, angles, limits and speeds; and the way to its target.
#pragma once

#include "core/document/arm_reach.h"
#include <QWidget>
#include <vector>

class QCheckBox;
class QFormLayout;
class QLabel;
class QListWidget;
class QPushButton;

namespace ramure {

class NumberField;
class NumberSlider;

class ArmPanel : public QWidget
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive the panel.
    explicit ArmPanel(Document* document, QWidget* parent = nullptr);
    ~ArmPanel() override;

    /// Shows and steers the arm on its way; may be null. Must outlive the panel.
    void setReach(ArmReach* reach);
    /// The arm that is shown; noNode where there is none.
    [[nodiscard]] NodeId arm() const { return m_arm; }
    [[nodiscard]] int joint() const;

public slots:
    void addJoint();    ///< behind the chosen one, as it
    void removeJoint(); ///< the chosen one; the last one stays
    void chooseJoint(int joint);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row;
    void addAngle(QFormLayout* form, bool phi);
    Row& addNumber(QFormLayout* form, double low, double high, bool angle);
    void follow(const Change& change);
    void takeArm();
    void showJoints();
    void showValues();
    void showProgress();
    void set(Row& row, double value, GestureId gesture);
    void setLimited(bool phi, bool limited);
    void push(std::vector<ArmJoint> joints, const QString& text, GestureId gesture = 0);
    void retranslate();
    [[nodiscard]] const std::vector<ArmJoint>* joints() const;

    Document* m_document;
    ArmReach* m_reach = nullptr;
    NodeId m_arm = noNode;
    QLabel* m_none;
    QWidget* m_content;
    QListWidget* m_list;
    QPushButton *m_add, *m_remove, *m_go, *m_pause, *m_step;
    QCheckBox *m_limitPhi = nullptr, *m_limitTheta = nullptr;
    QLabel* m_status;
    std::vector<std::unique_ptr<Row>> m_rows;
};

} // namespace ramure
