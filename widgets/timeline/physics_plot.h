/// \file
/// Small curves of the latest frames. Of trees: kinetic energy, worst length error, time of a physics step.
/// In scenes with arms alone: how far their tips are from their targets.
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

    enum class Content { Nothing, Arms, Trees };
    /// What moves in the scene; trees come first. Another content starts anew.
    void setContent(Content content);
    [[nodiscard]] Content content() const { return m_content; }

    /// Adds the sums over all trees (of errors and of arms' residuals the largest). A frame before the last
    /// one starts anew.
    void add(const MotionFrame& frame);
    void clear();
    [[nodiscard]] std::size_t count() const { return m_frames.size(); }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 40}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum Curve { Energy, LengthError, StepTime, Residual };
    static constexpr int curves = 4;
    using Values = std::array<double, std::size_t(curves)>;
    void paintCurve(QPainter& painter, const QRectF& area, Curve curve) const;
    [[nodiscard]] static QString nameOf(Curve curve);
    [[nodiscard]] static QString textOf(Curve curve, double value);
    void updateToolTip();

    Content m_content = Content::Trees;
    std::deque<Values> m_frames;
    std::int64_t m_last = 0;
};

} // namespace ramure
