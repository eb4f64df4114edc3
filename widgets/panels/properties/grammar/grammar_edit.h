/// \file
/// A text editor for axioms and rules: colours, matching brackets, the place of an error underlined. Its
/// height is set by the user, so neither typing nor an error moves the widgets below. Undo belongs to the
/// document.
#pragma once

#include "widgets/panels/properties/grammar/grammar_highlighter.h"
#include <QPlainTextEdit>

class QCompleter;
class QLabel;
class QPushButton;

namespace ramure {

class GrammarEdit : public QPlainTextEdit
{
    Q_OBJECT
public:
    /// \param kind of an axiom new lines are dropped
    GrammarEdit(GrammarText kind, QWidget* parent);

    /// How the text is read. \param names what completes a word that is typed in the parametric dialect
    void setDialect(GrammarDialect dialect, const QStringList& names);

    /// Replaces the text and keeps the cursor's place where it can; never emits edited().
    void showText(const QString& text);
    /// Underlines the place of an error. \param line 1-based, 0 = no error. \param column 1-based, counted in
    /// bytes as the core does; 0 = the whole line. \param isWarning the text can be read all the same
    void showProblem(int line, int column, bool isWarning = false);
    /// Shows an error at the lower edge, inside the frame; an empty text hides it. \param offersReplacement
    /// adds a button that asks for replacementWanted()
    void showMessage(const QString& text, bool offersReplacement = false);
    /// How many lines are in sight; more are scrolled.
    [[nodiscard]] int lines() const { return m_lines; }
    void setLines(int lines);
    [[nodiscard]] int usualLines() const;
    /// First and last character that are underlined, for tests and the status bar; (-1, -1) without a
    /// problem.
    [[nodiscard]] std::pair<int, int> problemRange() const { return m_problem; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void edited(const QString& text);
    /// The typing was interrupted: a pause, another line, deleting after writing, another place. The next
    /// change is another undo step.
    void gestureBroken();
    /// Asks to replace lookalike characters.
    void replacementWanted();

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void insertFromMimeData(const QMimeData* source) override;

private:
    void updateMarks();
    void placeMessage();
    void complete();
    void takeCompletion(const QString& name);
    [[nodiscard]] int heightOfLines() const;

    GrammarText m_kind;
    int m_lines;
    QLabel* m_message;
    QPushButton* m_replace;
    bool m_problemIsWarning = false;
    bool m_showing = false;
    bool m_lastWasDeleting = false;
    std::pair<int, int> m_problem{-1, -1};
    GrammarHighlighter* m_highlighter = nullptr;
    QCompleter* m_completer;
};

/// The bracket that belongs to the one at \p position, or -1. Escaped brackets (after a backquote) do not
/// count.
int matchingBracket(const QString& text, int position);

} // namespace ramure
