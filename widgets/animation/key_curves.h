/// \file
/// The curve editor: values of the channels in sight over time, with Bézier handles to drag.
///
/// Click selects a key (Shift adds or takes away), a drag from empty space a box; dragging a selected key
/// moves the selection in time and value, with Ctrl only in value; one step of undo, Escape gives up. Wheel:
/// values; Ctrl+wheel: time; middle drag both. Orientations have no curve: their four numbers make no sense
/// one by one.
#pragma once

#include "widgets/animation/key_commands.h"
#include <QWidget>

namespace ramure {

class TimelineRuler;

class KeyCurves : public QWidget
{
    Q_OBJECT
public:
    /// Nothing is owned; the ruler's left edge stands over the widget's.
    KeyCurves(KeyModel* model, KeyCommands* commands, TimelineRuler* ruler, QWidget* parent = nullptr);

    void setFrame(qint64 frame);
    /// Every curve over the same height, whatever its values.
    void setNormalised(bool on);
    [[nodiscard]] bool isNormalised() const { return m_normalised; }
    /// The selected keys, or all, in time and value.
    void fit();
    [[nodiscard]] QPointF placeOf(const TrackRef& ref, Ticks time, double value) const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Drag : std::uint8_t { None, Keys, Handle, Box, Scroll };

    struct Curve
    {
        TrackRef ref;
        NodeAnimation::TrackPtr track;
        double low = 0.0, high = 1.0; ///< of its keys
    };
    struct Hit
    {
        TrackRef ref;
        Ticks time = 0;
        int side = 0; ///< -1, 1: the handle before, behind
    };

    void takeCurves();
    [[nodiscard]] const Curve* curveOf(const TrackRef& ref) const;
    [[nodiscard]] double xOf(double seconds) const;
    [[nodiscard]] double yOf(const Curve& curve, double value) const;
    [[nodiscard]] double unitsPerPixel(const Curve& curve) const;
    [[nodiscard]] bool isSelected(const TrackRef& ref, Ticks time) const;
    [[nodiscard]] QPointF handlePlace(const Curve& curve, const Key& key, int side) const;
    [[nodiscard]] std::optional<Hit> hitAt(const QPointF& place) const;
    void paintCurve(QPainter& painter, const Curve& curve) const;
    void paintKeys(QPainter& painter, const Curve& curve) const;
    void paintGrid(QPainter& painter) const;
    void dragHandle(const QPointF& place);
    void finishKeys();
    void finishBox(bool adds);
    void giveUp();

    KeyModel* m_model;
    KeyCommands* m_commands;
    TimelineRuler* m_ruler;
    std::vector<Curve> m_curves;
    qint64 m_frame = 0;
    double m_low = -1.0, m_high = 1.0; ///< at the lower and upper edge
    bool m_normalised = false;
    bool m_fitted = false;
    Drag m_drag = Drag::None;
    bool m_moved = false;
    QPointF m_press, m_at;
    Hit m_hit;
    Ticks m_offset = 0;    ///< of the dragged keys
    double m_pixels = 0.0; ///< they are dragged down by
    GestureId m_gesture = 0;
};

} // namespace ramure
