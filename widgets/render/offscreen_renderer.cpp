#include "widgets/render/offscreen_renderer.h"

namespace ramure {

Expected<QImage> renderImage(const RenderScene&, const Camera&, QSize, const RenderOptions&)
{
    return fail(ErrorCode::Unknown, RAMURE_NOOP("No OpenGL 3.3 context is available here"));
}

} // namespace ramure
