/// \file
/// The dope sheet: keys as marks over time, a row per channel.
///
/// Click selects a key (Shift: adds or takes away; Alt: the whole column), a drag from empty space a box.
/// Dragging a selected key moves the selection, with Ctrl copies of it; the bar above scales it by its ends.
/// Nothing changes before the button is let go; Escape gives up. Wheel: rows; Ctrl+wheel: zoom; Shift+wheel
/// and middle drag: time.
#pragma once

#include "widgets/panels/animation/key_commands.h"
#include "widgets/panels/animation/key_rows_view.h"
#include <QTimer>
#include <tuple>

namespace ramure {

class TimelineRuler;

class KeySheet : public KeyRowsView
{
    Q_OBJECT
public:
    /// Nothing is owned; the ruler's left edge stands over the sheet's.
    KeySheet(KeyModel* model, KeyCommands* commands, TimelineRuler* ruler, QScrollBar* scroll,
             QWidget* parent = nullptr);

    void setFrame(qint64 frame);
    [[nodiscard]] double xOf(Ticks time) const;
    [[nodiscard]] Ticks timeAt(double x) const;
    [[nodiscard]] std::size_t currentRow() const { return m_row; }
    void setCurrentRow(std::size_t row);
    /// The selected keys, or all, over the whole width.
    void fit();
    [[nodiscard]] QSize sizeHint() const override { return {600, 160}; }

signals:
    void menuRequested(const QPoint& globalPosition);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Drag : std::uint8_t { None, Key, Box, ScaleFirst, ScaleLast, Scroll };

    /// A key, or several that lie closer together than they can be told apart.
    struct Mark
    {
        double from, to;
        KeyMode mode;
    };

    void collect(const KeyRow& row, bool selected);
    void paintMarks(QPainter& painter, std::size_t index, bool selected);
    /// Identifies a row when others come and go.
    using RowName = std::tuple<KeyRow::Kind, NodeId, Channel>;
    [[nodiscard]] static RowName nameOf(const KeyRow& row);
    [[nodiscard]] std::size_t rowOfCurrent() const;
    void paintScaleBar(QPainter& painter) const;
    void paintGrid(QPainter& painter) const;
    void paintOver(QPainter& painter) const;
    [[nodiscard]] const QPixmap& glyph(KeyMode mode, bool aggregate, bool selected);
    /// The key under the mouse.
    [[nodiscard]] std::optional<Ticks> keyAt(std::size_t row, double x) const;
    [[nodiscard]] Drag handleAt(const QPointF& position) const;
    [[nodiscard]] Ticks shownTime(Ticks time) const { return m_preview.of(time); }
    void pressKey(std::size_t row, Ticks time, Qt::KeyboardModifiers modifiers);
    void dragTo(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void dragSelection(double x, bool free);
    void finishBox(Qt::KeyboardModifiers modifiers);
    void giveUp();
    bool keyCommand(const QKeyEvent* event);
    bool keyStep(const QKeyEvent* event);
    void stepKey(bool forward, bool extend);
    QString tipAt(const QPoint& position) const;

    KeyCommands* m_commands;
    TimelineRuler* m_ruler;
    qint64 m_frame = 0;
    std::size_t m_row = 0;
    RowName m_current{KeyRow::Kind::Summary, noNode, {}};
    Drag m_drag = Drag::None;
    bool m_moved = false;
    bool m_wasSelected = false; ///< the pressed key: a plain click then selects it alone
    bool m_copies = false;
    QPointF m_press, m_at;
    double m_dragX = 0.0;
    Ticks m_grabbed = 0; ///< time of the pressed key
    std::size_t m_grabbedRow = 0;
    std::pair<Ticks, Ticks> m_span{0, 0}; ///< span of the selection when the drag began
    Retiming m_preview;
    std::vector<Mark> m_marks;
    std::map<int, QPixmap> m_glyphs;
    QTimer m_edgeScroll; ///< while the pointer is held beyond an edge
};

} // namespace ramure
