/// \file
/// Hints on mouse and keys over one widget. Each widget with hints owns such a source, and one line of the
/// status bar shows the source under the cursor.
#pragma once

#include <QObject>

namespace ramure {

class HintSource : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    /// Shows this hint, in the present language. An empty one says nothing.
    void say(const QString& hint);
    /// While a gesture goes on the hint is shown wherever the cursor is.
    void setGesture(bool goesOn);
    [[nodiscard]] const QString& hint() const { return m_hint; }
    [[nodiscard]] bool isGesture() const { return m_gesture; }

signals:
    void changed();
    void gestureBegan();

private:
    QString m_hint;
    bool m_gesture = false;
};

} // namespace ramure
