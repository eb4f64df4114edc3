/// \file
/// A box with a few words that points at a widget of its window, and a frame around that widget.
#pragma once

#include <QFrame>
#include <QPointer>

class QLabel;
class QPushButton;

namespace ramure {

class Callout : public QFrame
{
    Q_OBJECT
public:
    /// \param window what it lies over; it follows its size.
    explicit Callout(QWidget* window);

    void pointAt(QWidget* target);
    /// \param step counts from 0.
    void setTexts(const QString& title, const QString& text, int step, int steps);
    /// What was asked for has been done.
    void setDone(bool done);

signals:
    void nextRequested();
    void backRequested();
    void leaveRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void place();

    QPointer<QWidget> m_target;
    QPoint m_tip; ///< of the arrow, in the window; where there is no arrow inside the box
    QFrame* m_mark;
    QLabel* m_title;
    QLabel* m_text;
    QLabel* m_count;
    QLabel* m_done;
    QPushButton* m_leave;
    QPushButton* m_back;
    QPushButton* m_next;
};

} // namespace ramure
