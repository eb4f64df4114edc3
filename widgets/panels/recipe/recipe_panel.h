/// \file
/// The recipe of the active tree, a list of steps: add, rename, switch off, reorder, duplicate, delete,
/// select a step's branches, copy to another tree.
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

class RecipeModel;
class EmptyPage;

class RecipePanel : public QWidget
{
    Q_OBJECT
public:
    /// \p document is not owned and must outlive the panel.
    explicit RecipePanel(Document* document, QWidget* parent = nullptr);

    [[nodiscard]] RecipeModel* model() const { return m_model; }
    [[nodiscard]] QTreeView* view() const { return m_view; }
    /// Selects a step of the list by its id.
    void select(quint64 step);
    /// Sets the menu of its button. Not owned.
    void setAddMenu(QMenu* menu);

public slots:
    void removeSelected();
    void moveCurrent(int rows); ///< up where negative
    void selectBranches();      ///< branches of the selected edits, in the document
    void freeze();              ///< freezes the result of the current row and the rows above it
    void addAnswer(QMenu& menu);

signals:
    void messageRaised(const QString& text);
    /// \param step id of the only step that is selected; 0: none is, or the source
    void stepChosen(ramure::NodeId tree, quint64 step);
    /// These steps are to be kept for other trees.
    void saveRequested(ramure::NodeId tree, const std::vector<std::uint64_t>& steps);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void follow();
    void fillCopyMenu();
    void showMenu(const QPoint& at);
    void chooseStep();
    /// Addresses of the axes whose branches are selected in the tree.
    [[nodiscard]] std::vector<std::uint64_t> chosenAxes() const;
    void actOnChosenAxes(std::uint64_t step);
    void updateButtons();
    void report(const Expected<void>& done);
    /// Ids of the selected steps without the source, which cannot be moved.
    [[nodiscard]] std::vector<std::uint64_t> selectedIds() const;

    Document* m_document;
    RecipeModel* m_model;
    QStackedWidget* m_pages;
    EmptyPage* m_empty;
    QWidget* m_list;
    QLabel* m_title;
    QTreeView* m_view;
    QToolButton *m_add, *m_up, *m_down, *m_copy, *m_delete;
    QMenu* m_copyMenu;
    std::set<std::uint64_t> m_kept; ///< selected before the list became another one
    std::set<std::uint64_t> m_open; ///< the first edits of groups that were unfolded then
    std::uint64_t m_current = 0;
    bool m_restores = false;
};

} // namespace ramure
