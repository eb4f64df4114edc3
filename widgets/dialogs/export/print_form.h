/// \file
/// How a tree is made ready for a printer, and what is known about it afterwards.
#pragma once

#include "core/print/print_tree.h"
#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace ramure {

class NumberField;
class PrintPreview;

class PrintForm : public QWidget
{
    Q_OBJECT
public:
    explicit PrintForm(QWidget* parent = nullptr);

    [[nodiscard]] bool isWanted() const;
    void setWanted(bool wanted);
    [[nodiscard]] PrintOptions options() const;
    void setOptions(const PrintOptions& options);
    /// Null: nothing is known any more, or not yet.
    void setPrint(std::shared_ptr<const PrintedTree> print);
    /// It is being prepared: the bar is shown, and what stops it.
    void setPreparing(bool preparing);
    /// Whether there is something that could be.
    void setMayPrepare(bool may);
    [[nodiscard]] PrintPreview* preview() const { return m_preview; }

public slots:
    void setProgress(double fraction);

signals:
    void changed();
    void prepareRequested();
    void cancelRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void buildForm();
    void buildNumbers(QVBoxLayout* rest);
    void buildWork(QVBoxLayout* rest);
    void retranslate();
    void updateWidgets();
    void takeProcess();

    QCheckBox* m_wanted;
    QWidget* m_rest; ///< all but the tick
    QComboBox* m_process;
    QLabel* m_heightLabel;
    NumberField* m_height; ///< mm
    QLabel* m_thinnestLabel;
    NumberField* m_thinnest; ///< mm
    QCheckBox* m_disc;
    QLabel* m_leavesLabel;
    QComboBox* m_leaves;
    QPushButton* m_prepare;
    QProgressBar* m_progress;
    QToolButton* m_cancel;
    PrintPreview* m_preview;
};

} // namespace ramure
