#include "widgets/viewport/viewport.h"

#include "core/document/document.h"

namespace ramure {

struct Viewport::Private
{
    Document* document;
    ViewSettings* settings;
    Camera camera;
    FrameTimes times;
};

Viewport::Viewport(Document* document, ViewSettings* settings, QWidget* parent)
    : QOpenGLWidget(parent)
    , d(std::make_unique<Private>(Private{document, settings, {}, {}}))
{
}
Viewport::~Viewport() = default;
const Camera& Viewport::camera() const
{
    return d->camera;
}
FrameTimes Viewport::frameTimes() const
{
    return d->times;
}
QSize Viewport::sizeHint() const
{
    return {900, 700};
}
QImage Viewport::screenshot()
{
    return grabFramebuffer();
}
Expected<void> Viewport::saveScreenshot(const QString&)
{
    return {};
}
void Viewport::setCamera(const Camera& camera)
{
    d->camera = camera;
}
void Viewport::frameAll()
{
}
void Viewport::frameSelection()
{
}
void Viewport::frameBox(const Box&)
{
}
void Viewport::setAxisView(AxisView)
{
}
void Viewport::clearSelection()
{
}
void Viewport::selectAllBranches()
{
}
void Viewport::copyScreenshot()
{
}
void Viewport::setInspectedSection(NodeId, Index, Index)
{
}
void Viewport::clearInspectedSection()
{
}
void Viewport::initializeGL()
{
}
void Viewport::paintGL()
{
}
void Viewport::resizeGL(int, int)
{
}
void Viewport::mousePressEvent(QMouseEvent* e)
{
    QOpenGLWidget::mousePressEvent(e);
}
void Viewport::mouseMoveEvent(QMouseEvent* e)
{
    QOpenGLWidget::mouseMoveEvent(e);
}
void Viewport::mouseReleaseEvent(QMouseEvent* e)
{
    QOpenGLWidget::mouseReleaseEvent(e);
}
void Viewport::wheelEvent(QWheelEvent* e)
{
    QOpenGLWidget::wheelEvent(e);
}
void Viewport::leaveEvent(QEvent* e)
{
    QOpenGLWidget::leaveEvent(e);
}
bool Viewport::event(QEvent* e)
{
    return QOpenGLWidget::event(e);
}

} // namespace ramure
