/// \file
/// The tree view of a report: one signal for "show me this one", by mouse or by keyboard.
#pragma once

#include "widgets/panels/validation/report_model.h"
#include <QTreeView>

namespace ramure {

class ReportView : public QTreeView
{
    Q_OBJECT
public:
    /// The kinds that are open stay open when another report comes.
    ReportView(ReportModel* model, QWidget* parent = nullptr);

    /// Some rows are always in sight.
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// A row was clicked, reached with the arrow keys, or Enter was pressed on it.
    void chosen(const QModelIndex& index);
    /// Escape: nothing is to be shown any more.
    void left();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void reopen();

    ReportModel* m_model;
    std::vector<ReportModel::Kind> m_open;
    bool m_reopening = false;
};

} // namespace ramure
