/// \file
/// Parameters of a camera. The member initialisers are the defaults.
#pragma once

namespace ramure {

/// It stands in its node's origin and looks along -Z, with +Y up.
struct CameraParams
{
    double angleRad = 0.471; ///< of the view, from top to bottom: a lens of 50 mm before a film of 24 mm
    double fStop = 0.0;      ///< focal length over the lens's opening; 0: everything is sharp
    double focus = 5.0;      ///< m from the camera along its view
    bool operator==(const CameraParams&) const = default;
};

} // namespace ramure
