/// \file
/// How a range of numbers lies under the hand: along a slider, and while a number is dragged.
#pragma once

namespace ramure {

/// Linear; by the logarithm where the range spans two powers of ten or more above 0; by the cube root where
/// it begins at 0 and has hundreds of steps. Small numbers of a wide range get as much room as large ones.
class NumberScale
{
public:
    NumberScale() = default;
    NumberScale(double minimum, double maximum, double step, bool whole);

    [[nodiscard]] double minimum() const { return m_minimum; }
    [[nodiscard]] double maximum() const { return m_maximum; }
    [[nodiscard]] double step() const { return m_step; }
    [[nodiscard]] bool isWhole() const { return m_whole; }
    [[nodiscard]] bool isLogarithmic() const { return m_shape == Shape::Logarithm; }
    /// 0 at the minimum, 1 at the maximum; values outside lie beyond.
    [[nodiscard]] double positionOf(double value) const;
    /// The roundest number near this position: one that has no more digits, multiplied by \p factor, than a
    /// change of the position by \p precision can tell apart.
    [[nodiscard]] double numberAt(double position, double precision, double factor = 1.0) const;

private:
    enum class Shape { Linear, Logarithm, Cube };
    [[nodiscard]] double valueAt(double position) const;

    double m_minimum = 0.0;
    double m_maximum = 1.0;
    double m_step = 0.01;
    bool m_whole = false;
    Shape m_shape = Shape::Linear;
};

} // namespace ramure
