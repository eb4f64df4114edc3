/// \file
/// Levels of detail of an export: how many, and how many triangles each may have.
#pragma once

#include "core/levels/level_options.h"
#include <QWidget>

class QLabel;
class QLineEdit;
class QSpinBox;

namespace ramure {

class LevelForm : public QWidget
{
    Q_OBJECT
public:
    explicit LevelForm(QWidget* parent = nullptr);

    /// What is written there, which checkLevels() may refuse; nothing where one level is asked for without a
    /// budget: the tree as it is.
    [[nodiscard]] LevelOptions options() const;
    void setOptions(const LevelOptions& options);
    /// For a panel: what stands in the empty field is shorter.
    void setNarrow();
    /// A text that holds no numbers is no budget. Error: Invalid, with what is expected; those of
    /// checkLevels.
    [[nodiscard]] Expected<void> check() const;

signals:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QSpinBox* m_count;
    QLabel* m_label;
    QLineEdit* m_budgets;
    bool m_isNarrow = false;
};

} // namespace ramure
