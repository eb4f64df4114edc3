/// \file
/// The handbook in a window of its own: contents, search over all pages, the page.
#pragma once

#include "widgets/help/page_document.h"
#include <QWidget>

class QLineEdit;
class QSplitter;
class QStackedWidget;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace ramure {

class PageBrowser;

class HandbookWindow : public QWidget
{
    Q_OBJECT
public:
    /// A window without a parent: dialogs, which hold the main window, do not hold it.
    HandbookWindow();

    /// Shows the window and, in it, this place ("page" or "page#anchor").
    void showPlace(const QString& place);
    [[nodiscard]] PageBrowser* browser() const { return m_browser; }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void fillContents();
    void follow();
    void search(const QString& typed);
    void openItem(const QTreeWidgetItem* item);
    void step(bool down);
    void focusSearch();

    QToolButton* m_back;
    QToolButton* m_forward;
    QToolButton* m_start;
    QLineEdit* m_search;
    QStackedWidget* m_lists;
    QTreeWidget* m_contents;
    QTreeWidget* m_found;
    PageBrowser* m_browser;
    std::vector<HandbookSection> m_sections; ///< made at the first search
};

} // namespace ramure
