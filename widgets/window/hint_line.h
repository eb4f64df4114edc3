/// \file
/// In the status bar: what the mouse buttons and Shift, Ctrl, Alt do right now. Of the gesture that goes on,
/// else of the widget under the cursor.
#pragma once

#include "widgets/base/hint_source.h"
#include <QLabel>
#include <QPointer>
#include <vector>

namespace ramure {

class HintLine : public QLabel
{
    Q_OBJECT
public:
    explicit HintLine(QWidget* parent = nullptr);

    /// \p source speaks while the cursor is over \p widget. Neither is owned.
    void addSource(QWidget* widget, HintSource* source);
    /// The whole hint; what is seen of it depends on the room.
    [[nodiscard]] const QString& hint() const { return m_hint; }
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] QSize sizeHint() const override;

signals:
    /// A gesture has something to say: messages of before are in the way.
    void gestureBegan();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void update();
    void elide();

    struct Entry
    {
        QPointer<QWidget> widget;
        QPointer<HintSource> source;
    };
    std::vector<Entry> m_entries;
    QPointer<HintSource> m_under;
    QString m_hint;
};

} // namespace ramure
