/// \file
/// Content of the history dock: every step since the document was opened; a click goes back or forth to it.
#pragma once

#include <QWidget>

class QListView;

namespace ramure {

class Document;
class HistoryModel;

class HistoryDock : public QWidget
{
    Q_OBJECT
public:
    /// \param document is not owned and must outlive the widget.
    explicit HistoryDock(Document* document, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void drawCleanIcon();

    HistoryModel* m_model;
    QListView* m_view;
};

} // namespace ramure
