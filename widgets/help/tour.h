/// \file
/// The tour of the first start: five boxes that point at the places where a first hour begins.
#pragma once

#include <QObject>
#include <vector>

class QMainWindow;

namespace ramure {

class ActionSet;
class Callout;
class Document;

class Tour : public QObject
{
    Q_OBJECT
public:
    /// Nothing is owned; all must outlive the tour.
    Tour(QMainWindow* window, ActionSet* actions, Document* document);

    /// From the first step on; again where it runs already.
    void start();
    void leave();
    [[nodiscard]] bool isRunning() const { return m_callout != nullptr; }
    [[nodiscard]] int step() const { return m_step; }
    [[nodiscard]] static int stepCount();

signals:
    /// Seen to its end or left before.
    void finished();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show(int step);
    void showTexts();
    [[nodiscard]] QWidget* target() const;
    void watch();
    void done();

    QMainWindow* m_window;
    ActionSet* m_actions;
    Document* m_document;
    Callout* m_callout = nullptr; ///< while it runs
    int m_step = 0;
    std::vector<QMetaObject::Connection> m_watched; ///< connections that notice when the step has been done
};

} // namespace ramure
