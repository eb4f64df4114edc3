/// \file
/// How long the line around the selection is shown, and the words beside it that name its key.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

class QPainter;

namespace ramure {

class OutlineKey : public QObject
{
    Q_OBJECT
public:
    explicit OutlineKey(QObject* parent = nullptr);

    /// Sets the name of the line's key: "Shift+E".
    void setKey(std::function<QString()> key) { m_key = std::move(key); }
    /// Shows the line from now on for a second; then it fades, so that it is not in the way of what it goes
    /// around.
    void show();
    /// From 1 to 0.
    [[nodiscard]] double opacity() const;
    /// Paints the words beside the line while it is there, in the upper left corner.
    void paint(QPainter& painter) const;

signals:
    void changed(); ///< another picture is to be drawn

private:
    QElapsedTimer m_since;
    QTimer m_fades;
    std::function<QString()> m_key;
};

} // namespace ramure
