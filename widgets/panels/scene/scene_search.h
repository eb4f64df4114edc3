/// \file
/// The search field of the scene panel with what it says below: how much was found, or what is wrong with the
/// question.
#pragma once

#include "widgets/panels/scene/scene_query.h"
#include <QWidget>

class QLabel;
class QLineEdit;
class QToolButton;

namespace ramure {

class SceneSearch : public QWidget
{
    Q_OBJECT
public:
    explicit SceneSearch(QWidget* parent);

    [[nodiscard]] QLineEdit* field() const { return m_field; }
    void clear();
    /// \param single branches one by one; otherwise axes.
    void showCounts(int nodes, int branches, bool single);

signals:
    /// Another question; an empty one ends the search. Not while what is typed is no question.
    void queryChanged(const ramure::SceneQuery& query);
    void selectAllRequested();
    /// The arrow down: to the list.
    void leftDownwards();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void ask();
    void showBelow();

    QLineEdit* m_field;
    QWidget* m_below;
    QLabel* m_label;
    QToolButton* m_selectAll;
    QString m_problem;
    int m_nodes = 0;
    int m_branches = 0;
    bool m_single = false;
};

} // namespace ramure
