/// \file
/// Small curves of the latest frames. Of trees: kinetic energy, worst length error, time of a physics step.
/// In scenes with arms alone: how far their tips are from their targets. Where there is no curve yet a
/// sentence says how to get one. Names stand before the curves and the latest numbers behind them; the menu
/// of a right click copies all of them.
#pragma once

#include "core/qt/session/motion/motion.h"
#include "widgets/panels/timeline/arm_residuals.h"
#include <QWidget>
#include <array>
#include <deque>
#include <vector>

class QAction;
class QMenu;

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

    /// Adds the sums over all trees, and the largest of their errors. A frame before the last one starts
    /// anew.
    void add(const MotionFrame& frame);
    /// Replaces the shown residuals of arms; nothing: no arm has a target.
    void setResiduals(std::optional<ArmResiduals> residuals);
    /// What stands where there is no curve; empty where there is one.
    [[nodiscard]] QString hint() const;
    void clear();
    [[nodiscard]] std::size_t count() const { return m_frames.size(); }
    /// Where curves are drawn, and nothing else.
    [[nodiscard]] QRectF curvesArea() const;
    /// Three digits, and an exponent where the number would be long; what is only noise is "< 1E-09".
    [[nodiscard]] static QString shortNumber(double value);
    /// What is shown as a table with a line of headings. \param separator of the columns; numbers have a
    /// point.
    [[nodiscard]] QString valuesText(QChar separator) const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 40}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    enum Curve { Energy, LengthError, StepTime };
    static constexpr int curves = 3;
    struct Values
    {
        std::int64_t frame = 0;
        std::array<double, std::size_t(curves)> of{};
    };
    void buildMenu();
    [[nodiscard]] static QString nameOf(Curve curve);
    [[nodiscard]] std::vector<Curve> shownCurves() const;
    [[nodiscard]] int rowCount() const;
    [[nodiscard]] bool isStacked() const;
    /// One line of the plot: its name, its number now, and the curve between them.
    void paintRow(QPainter& painter, const QRectF& row, const QString& name, const QString& now,
                  const std::vector<double>& values, double step) const;
    void paintLine(QPainter& painter, const QRectF& area, const std::vector<double>& values,
                   double step) const;
    void changed();
    void updateToolTip();

    Content m_content = Content::Trees;
    std::deque<Values> m_frames; ///< of trees
    QMenu* m_menu = nullptr;
    QAction *m_copyCsv = nullptr, *m_copyTsv = nullptr, *m_anew = nullptr;
    std::array<QAction*, std::size_t(curves)> m_shown{}; ///< checked: the curve is drawn
    std::optional<ArmResiduals> m_residuals;
    std::int64_t m_last = 0;
};

} // namespace ramure
