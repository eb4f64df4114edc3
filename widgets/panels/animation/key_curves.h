/// \file
/// The curve editor: values of the channels in sight over time, with Bézier handles to drag.
///
/// Click selects a key (Shift adds or takes away), a drag from empty space a box; dragging a selected key
/// moves the selection in time and value, with Ctrl only in value; one step of undo, Escape gives up. Wheel:
/// values; Ctrl+wheel: time; middle drag both. Orientations have three curves, of their angles in degrees;
/// dragging one of them leaves the two others where they are.
#pragma once

#include "widgets/base/texts/number_format.h"
#include "widgets/panels/animation/key_commands.h"
#include "widgets/panels/animation/key_curve.h"
#include <QImage>
#include <QWidget>

namespace ramure {

class PixelPainter;
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
    /// Shows the selected keys, or all where none is selected, in time and value.
    void fit() { fitKeys(m_model->selection().empty()); }
    /// Shows all keys.
    void fitAll() { fitKeys(true); }
    /// Returns the place of a value; for orientations the value is the angle about X.
    [[nodiscard]] QPointF placeOf(const TrackRef& ref, Ticks time, double value) const;
    [[nodiscard]] QPointF placeOf(const CurveRef& ref, Ticks time, double value) const;
    [[nodiscard]] const std::vector<KeyCurve>& curves() const { return m_curves; }
    /// "Values: m · °" where curves of several units stand on one axis; else empty.
    [[nodiscard]] QString axisUnits() const;
    /// Returns the name of a key, a handle or a line of a curve at this place, with its value and unit. Empty
    /// if there is none.
    [[nodiscard]] QString tipAt(const QPointF& place) const;

signals:
    void menuRequested(const QPoint& globalPosition);

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Drag : std::uint8_t { None, Keys, Handle, Box, Scroll };

    using Curve = KeyCurve;
    struct Hit
    {
        CurveRef ref;
        Ticks time = 0;
        int side = 0; ///< -1, 1: the handle before, behind
    };
    /// Converts the keys of one curve to pixels, fast enough for very many of them.
    struct Scale
    {
        double left = 0.0;    ///< x of 0 s
        double perTick = 0.0; ///< pixels
        double top = 0.0;     ///< the value at y = 0
        double perUnit = 0.0; ///< pixels
        [[nodiscard]] QPointF at(Ticks time, double value) const
        {
            return {left + double(time) * perTick, (top - value) * perUnit};
        }
    };

    void takeCurves();
    void fitKeys(bool all);
    void followModel();
    [[nodiscard]] const Curve* curveOf(const CurveRef& ref) const;
    [[nodiscard]] double xOf(double seconds) const;
    [[nodiscard]] Ticks ticksAt(double x) const;
    [[nodiscard]] double yOf(const Curve& curve, double value) const;
    [[nodiscard]] double unitsPerPixel(const Curve& curve) const;
    [[nodiscard]] bool isSelected(const TrackRef& ref, Ticks time) const;
    [[nodiscard]] const std::vector<Ticks>& selectedOf(const Curve& curve) const;
    /// Goes along when the value of the key is dragged that was hit.
    [[nodiscard]] bool follows(const Curve& curve) const;
    [[nodiscard]] bool showsHandle(const Curve& curve, std::size_t key, int side) const;
    [[nodiscard]] QPointF handlePlace(const Curve& curve, const Key& key, int side) const;
    [[nodiscard]] std::optional<Hit> hitAt(const QPointF& place) const;
    void paintCurve(QPainter& painter, const Curve& curve) const;
    void paintKeys(QPainter& painter, const Curve& curve) const;
    void paintHandles(QPainter& painter, const Curve& curve, std::size_t key, const QPointF& place) const;
    [[nodiscard]] Scale scaleOf(const Curve& curve) const;
    [[nodiscard]] bool isDense() const;
    void paintDense(QPainter& painter);
    void paintLines();
    void paintThin(PixelPainter& pixels, const Curve& curve) const;
    void paintDots();
    [[nodiscard]] std::pair<std::size_t, std::size_t> keysInSight(const Curve& curve) const;
    [[nodiscard]] QPointF keyPlace(const Curve& curve, std::size_t key, bool selected) const;
    void paintGrid(QPainter& painter) const;
    [[nodiscard]] const Curve* lineAt(const QPointF& place) const;
    [[nodiscard]] QString tipOf(const Curve& curve, double value, double seconds) const;
    /// In which all curves are shown; plain numbers where they differ.
    [[nodiscard]] NumberFormat commonFormat() const;
    void dragHandle(const QPointF& place);
    void finishKeys();
    void finishBox(bool adds);
    void giveUp();

    KeyModel* m_model;
    KeyCommands* m_commands;
    TimelineRuler* m_ruler;
    std::vector<Curve> m_curves;
    bool m_dense = false; ///< very many keys are in sight
    bool m_stale = false; ///< the tracks have changed since the last look
    // Where there are very many keys:
    QImage m_lines;                    ///< all but the keys, kept while only those move
    std::array<double, 6> m_linesOf{}; ///< the view for which it was drawn
    QImage m_dots;                     ///< with the keys
    qint64 m_frame = 0;
    double m_low = -1.0, m_high = 1.0; ///< at the lower and upper edge
    bool m_normalised = false;
    bool m_fitted = false;
    Drag m_drag = Drag::None;
    bool m_moved = false;
    QPointF m_press, m_at;
    Hit m_hit;
    Ticks m_offset = 0;    ///< offset of the dragged keys
    double m_pixels = 0.0; ///< they are dragged down by
    GestureId m_gesture = 0;
};

} // namespace ramure
