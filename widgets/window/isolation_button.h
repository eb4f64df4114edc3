/// \file
/// In the status bar while only some branches are shown: says so, and a click shows everything again.
#pragma once

#include <QToolButton>

namespace ramure {

class Isolation;

class IsolationButton : public QToolButton
{
    Q_OBJECT
public:
    /// \p isolation is not owned and must outlive the button.
    explicit IsolationButton(Isolation* isolation, QWidget* parent = nullptr);

private:
    void update();

    Isolation* m_isolation;
};

} // namespace ramure
