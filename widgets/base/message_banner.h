/// \file
/// A message over the top of the view: says what went wrong without stopping the work, and moves nothing.
#pragma once

#include "widgets/base/chooser.h"
#include <QFrame>
#include <QPointer>
#include <functional>

class QLabel;
class QPushButton;
class QToolButton;

namespace ramure {

class MessageBanner : public QFrame
{
    Q_OBJECT
public:
    explicit MessageBanner(QWidget* parent = nullptr);

    /// Lies over the upper edge of \p place, which stands somewhere in the banner's parent. Not owned.
    void lieOver(QWidget* place);

    void showMessage(Severity severity, const QString& text);
    /// Shows a message with a button that does something about it.
    void showMessage(Severity severity, const QString& text, const QString& button,
                     std::function<void()> action);
    [[nodiscard]] QString text() const;
    [[nodiscard]] Severity severity() const { return m_severity; }

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    QPointer<QWidget> m_place;
    QLabel* m_icon;
    QLabel* m_text;
    QPushButton* m_button;
    std::function<void()> m_action;
    Severity m_severity = Severity::Info;
};

} // namespace ramure
