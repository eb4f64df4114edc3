/// \file
/// Small curves of the latest frames. Of trees: kinetic energy, worst length error, time of a physics step.
/// In scenes with arms alone: how far their tips are from their targets. Where there is no curve yet a
/// sentence says how to get one.
#pragma once

#include "core/document/motion.h"
#include "widgets/timeline/arm_residuals.h"
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

    /// Of trees: adds the sums over all (of errors the largest). A frame before the last one starts anew.
    void add(const MotionFrame& frame);
    /// Of arms: in the place of what was shown; nothing = no arm has a target.
    void setResiduals(std::optional<ArmResiduals> residuals);
    /// What stands where there is no curve; empty where there is one.
    [[nodiscard]] QString hint() const;
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
    void paintResiduals(QPainter& painter) const;
    void paintLine(QPainter& painter, const QRectF& area, const std::vector<double>& values,
                   double step) const;
    void paintTexts(QPainter& painter, const QRectF& area, const QString& name, const QString& value) const;
    void changed();
    void updateToolTip();

    Content m_content = Content::Trees;
    std::deque<Values> m_frames; ///< of trees
    std::optional<ArmResiduals> m_residuals;
    std::int64_t m_last = 0;
};

} // namespace ramure
