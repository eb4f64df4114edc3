/// \file
/// The sky of Backdrop::Sky as a picture all around, for other renderers.
#pragma once

#include "core/base/error.h"
#include "widgets/view/render/renderer_options.h"
#include <string>

namespace ramure {

/// Writes a Radiance picture (.hdr, RGBE; Ward, "Real Pixels", Graphics Gems II, 1991), \p width (16..8192,
/// even) by half of it. Values are linear, like those of a picture before exposure. The sky is seen from
/// inside: the west (-X) is at the left edge, then the north (-Z), the east in the middle and the south; the
/// zenith is above. Below the horizon is the lit ground. Two lines of the header, "# sun" and "# sunlight",
/// give the way towards the sun and its light on a white surface that faces it. \param hasSun whether the sun
/// is in the picture too. Errors: Io.
Expected<void> saveSkyPicture(const SceneLight& light, int width, const std::string& path,
                              bool hasSun = false);

} // namespace ramure
