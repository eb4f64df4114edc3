/// \file
/// The list of what a hand did to the active tree: rename, switch off, reorder, delete, select the branch,
/// copy to another tree.
#pragma once

#include "core/qt/document/document.h"
#include <QWidget>
#include <set>

class QLabel;
class QMenu;
class QStackedWidget;
class QToolButton;
class QTreeView;

namespace ramure {

class EditModel;
class EmptyPage;

class EditsPanel : public QWidget
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive the panel.
    explicit EditsPanel(Document* document, QWidget* parent = nullptr);

    [[nodiscard]] EditModel* model() const { return m_model; }
    [[nodiscard]] QTreeView* view() const { return m_view; }

public slots:
    void removeSelected();
    void moveCurrent(int rows); ///< up where negative
    void selectBranches();      ///< of the selected edits, in the document

signals:
    void messageRaised(const QString& text);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void follow();
    void fillCopyMenu();
    void showMenu(const QPoint& at);
    [[nodiscard]] bool hasBend(const std::vector<std::uint64_t>& ids) const;
    void updateButtons();
    void report(const Expected<void>& done);
    [[nodiscard]] std::vector<std::uint64_t> selectedIds() const;

    Document* m_document;
    EditModel* m_model;
    QStackedWidget* m_pages;
    EmptyPage* m_empty;
    QWidget* m_list;
    QLabel* m_title;
    QTreeView* m_view;
    QToolButton *m_up, *m_down, *m_copy, *m_delete;
    QMenu* m_copyMenu;
    std::set<std::uint64_t> m_kept; ///< selected before the list became another one
    std::uint64_t m_current = 0;
    bool m_restores = false;
};

} // namespace ramure
