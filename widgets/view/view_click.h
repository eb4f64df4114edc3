/// \file
/// Waits for one click in a widget, which nobody else gets: for dialogs that ask for a place in the view.
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>
#include <optional>

class QWidget;

namespace ramure {

class ViewClick : public QObject
{
public:
    /// Calls \p done once, with the place in \p view, or with nothing after Esc or another mouse button; then
    /// deletes itself. \p view owns it.
    ViewClick(QWidget* view, std::function<void(std::optional<QPointF>)> done);
    ~ViewClick() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* m_view;
    std::function<void(std::optional<QPointF>)> m_done;
};

} // namespace ramure
