/// \file
/// Shows the result of the rules: the length of the string and the number of branches. Below, folded at
/// first, are its growth and the strings of the generations.
#pragma once

#include "core/qt/document/document.h"
#include "widgets/panels/properties/grammar/grammar_growth.h"
#include <QPlainTextEdit>
#include <QWidget>

class QLabel;
class QTimer;
class QToolButton;

namespace ramure {

class GrammarHighlighter;

class GenerationsView : public QWidget
{
    Q_OBJECT
public:
    /// \param document is not owned and must outlive the view.
    GenerationsView(Document* document, QWidget* parent);

    /// The tree whose generations are shown; noNode: none, as with several selected.
    void setTree(NodeId tree);
    void setUnfolded(bool unfolded);
    /// "A(1, 0.5)", of the module at a place of the text; empty where there is none with numbers.
    [[nodiscard]] QString moduleAt(int position) const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void follow(const Change& change);
    void showSummary();
    void showGenerations();

    Document* m_document;
    NodeId m_tree = noNode;
    QToolButton* m_fold;
    QLabel* m_summary;
    QPlainTextEdit* m_text;
    GrammarHighlighter* m_highlighter;
    std::vector<Generation> m_generations; ///< two lines of the text each
    QTimer* m_timer;
    bool m_unfolded = false;
    bool m_stale = true;
};

} // namespace ramure
