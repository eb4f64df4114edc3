/// \file
/// Three small curves of the latest frames: kinetic energy, worst length error, time of a physics step.
#pragma once

#include "core/document/motion.h"
#include <QWidget>
#include <array>
#include <deque>

namespace ramure {

class PhysicsPlot : public QWidget
{
    Q_OBJECT
public:
    static constexpr std::size_t length = 240; ///< frames kept

    explicit PhysicsPlot(QWidget* parent = nullptr);

    /// Adds the sums over all trees (of errors the largest). A frame before the last one starts anew.
    void add(const MotionFrame& frame);
    void clear();
    [[nodiscard]] std::size_t count() const { return m_frames.size(); }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 40}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum Curve { Energy, LengthError, StepTime };
    static constexpr int curves = 3;
    using Values = std::array<double, std::size_t(curves)>;
    void paintCurve(QPainter& painter, const QRectF& area, Curve curve) const;
    void updateToolTip();

    std::deque<Values> m_frames;
    std::int64_t m_last = 0;
};

} // namespace ramure
