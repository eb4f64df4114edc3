/// \file
/// A message across the top of the view: says what went wrong without stopping the work.
#pragma once

#include "widgets/base/chooser.h"
#include <QFrame>

class QLabel;
class QToolButton;

namespace ramure {

class MessageBanner : public QFrame
{
    Q_OBJECT
public:
    explicit MessageBanner(QWidget* parent = nullptr);

    void showMessage(Severity severity, const QString& text);
    [[nodiscard]] QString text() const;

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void retranslate();

    QLabel* m_icon;
    QLabel* m_text;
    QToolButton* m_close;
    Severity m_severity = Severity::Info;
};

} // namespace ramure
