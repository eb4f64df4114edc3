/// \file
/// How a tree is made ready for a printer, and what is known about it afterwards.
#pragma once

#include "core/print/print_tree.h"
#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace ramure {

class NumberField;

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
    void setPrint(const PrintedTree* print);

signals:
    void changed();
    void prepareRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void buildForm();
    void retranslate();
    void updateWidgets();
    void takeProcess();
    [[nodiscard]] QString reportText(const PrintedTree& print) const;

    QCheckBox* m_wanted;
    QWidget* m_rest; ///< all but the tick
    QComboBox* m_process;
    QLabel* m_heightLabel;
    NumberField* m_height; ///< mm
    QLabel* m_thinnestLabel;
    NumberField* m_thinnest; ///< mm
    QCheckBox* m_disc;
    QPushButton* m_prepare;
    QLabel* m_report;
};

} // namespace ramure
