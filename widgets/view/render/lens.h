/// \file
/// Depth of field: a picture through a lens is the mean of pictures through its points.
#pragma once

#include "widgets/view/render/camera.h"
#include <QSize>
#include <cmath>

namespace ramure {

inline constexpr int lensSamples = 32; ///< points of the lens

/// What a lens does not show sharp.
struct Lens
{
    double diameter = 0.0; ///< of its opening, m; 0: everything is sharp
    double focus = 0.0;    ///< m from the eye along the view; 0: the camera's target
    /// \param fStop focal length over the opening, of a film of 24 mm \param fovRad the picture's vertical
    /// angle
    static double diameterOf(double fStop, double fovRad) { return 0.012 / std::tan(0.5 * fovRad) / fStop; }
    bool operator==(const Lens&) const = default;
};

/// The camera seen through one point of the lens: what lies at the distance that is sharp stays where it is.
/// Points spread evenly over the opening (Vogel 1979), and over a pixel.
/// \param sample of \p count
Camera throughLens(const Camera& camera, const Lens& lens, QSize size, int sample, int count);

} // namespace ramure
