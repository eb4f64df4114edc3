/// \file
/// How a tree is made ready for a printer, and what is known about it afterwards.
#pragma once

#include "core/print/print_tree.h"
#include <QWidget>
#include <utility>
#include <vector>

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace ramure {

class OptionFields;
class PrintPreview;

class PrintForm : public QWidget
{
    Q_OBJECT
public:
    /// \param fields get those of prints; must outlive the form
    explicit PrintForm(OptionFields* fields, QWidget* parent = nullptr);

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

private:
    void buildForm();
    void addField(QHBoxLayout* row, const char* key, bool hasLabel);
    void buildNumbers(QVBoxLayout* rest);
    void buildWork(QVBoxLayout* rest);
    void setTexts();
    void updateWidgets();
    void takeProcess();

    QCheckBox* m_wanted;
    QWidget* m_rest; ///< all but the tick
    OptionFields* m_fields;
    std::vector<std::pair<const char*, QLabel*>> m_labels; ///< beside fields, by key
    QPushButton* m_prepare;
    QProgressBar* m_progress;
    QToolButton* m_cancel;
    PrintPreview* m_preview;
};

} // namespace ramure
