/// \file
/// The numbers of one joint of an arm, made from the joint table: fields, sliders, and buttons for keys.
#pragma once

#include "core/qt/document/commands.h"
#include <QWidget>
#include <memory>
#include <vector>

class QCheckBox;
class QFormLayout;
class QLabel;

namespace ramure {

class AutoKey;

class JointForm : public QWidget
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive the form.
    explicit JointForm(Document* document, QWidget* parent = nullptr);
    ~JointForm() override;

    /// Numbers with keys are shown as they are at the frame on show, and edits become keys. Must outlive the
    /// form.
    void setKeys(AutoKey* keys);
    /// The joint of an arm; -1 or a joint that there is not: nothing is shown.
    void setJoint(NodeId arm, int joint);
    void showValues();

signals:
    void messageRaised(const QString& text);

private:
    struct Row;
    void addRow(QFormLayout* form, const JointDef& def, std::size_t number);
    void addLimited(QFormLayout* form, bool phi);
    void set(Row& row, double value, GestureId gesture);
    void setLimited(bool phi, bool limited);
    void push(std::vector<ArmJoint> joints, const QString& text, GestureId gesture = 0);
    void take(const Expected<void>& done);
    void showKeyState(const Row& row);
    [[nodiscard]] Channel channelOf(const Row& row) const;
    /// Null where no joint is shown.
    [[nodiscard]] const std::vector<ArmJoint>* joints() const;

    Document* m_document;
    AutoKey* m_keys = nullptr;
    NodeId m_arm = noNode;
    int m_joint = -1;
    QCheckBox *m_limitPhi = nullptr, *m_limitTheta = nullptr;
    QLabel* m_message;
    std::vector<std::unique_ptr<Row>> m_rows; ///< as the joint table
};

} // namespace ramure
