#include "widgets/dialogs/export/print_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ramure {
namespace {

constexpr double zoomStep = 1.15; ///< of the wheel, times the distance
constexpr int finerAtRest = 2;    ///< pixels drawn a side for one shown, at rest
constexpr int drawRestMs = 150;
constexpr double ringPixels = 11.0;

} // namespace

/// The scene that was drawn last.
struct PrintView::Drawn
{
    std::shared_ptr<const PrintedTree> print;
    RenderScene scene; ///< of it

    const RenderScene& sceneOf(const std::shared_ptr<const PrintedTree>& of)
    {
        if (std::exchange(print, of) != of)
            scene = previewScene(*of);
        return scene;
    }
};

PrintView::PrintView(QWidget* parent)
    : DrawnPicture(parent)
    , m_kept(std::make_shared<Drawn>())
{
    setObjectName(QStringLiteral("printPicture"));
    m_rest.setSingleShot(true);
    m_rest.setInterval(drawRestMs);
    connect(&m_rest, &QTimer::timeout, this, [this] { draw(false); });
    connect(&m_flight, &CameraFlight::moved, this, [this] { draw(true); });
    PrintView::setTexts();
}

bool PrintView::isBusy() const
{
    return isDrawing() || m_rest.isActive() || m_flight.isFlying();
}

void PrintView::setPrint(std::shared_ptr<const PrintedTree> print)
{
    m_print = std::move(print);
    clear([kept = m_kept] { *kept = {}; }); // with the mesh
    if (m_print)
        setCamera(wholePrint(*m_print, camera(), aspect()));
}

/// \param hurried it moves: drawn coarser, and again when it rests
void PrintView::draw(bool hurried)
{
    if (!m_print)
        return;
    if (hurried)
        m_rest.start();
    start(
        [kept = m_kept, print = m_print, camera = camera(), hurried](OffscreenRenderer& renderer,
                                                                     QSize pixels, const Progress&) {
            RenderOptions options;
            options.quality = hurried ? Quality::Draft : Quality::Good;
            options.ground = options.outline = false;
            options.samples = 0; // dearer than pixels where triangles are smaller than these
            return renderer.draw(kept->sceneOf(print), camera, pixels, options);
        },
        hurried ? 1 : finerAtRest, [this, camera = camera()] { m_drawn = camera; });
}

void PrintView::showThinnest()
{
    if (m_print)
        m_flight.flyTo(thinnestPlace(*m_print, camera()));
}

void PrintView::showWhole()
{
    if (m_print)
        m_flight.flyTo(wholePrint(*m_print, camera(), aspect()));
}

glm::dvec2 PrintView::ndc(const QPointF& at) const
{
    return {2.0 * at.x() / std::max(1, width()) - 1.0, 1.0 - 2.0 * at.y() / std::max(1, height())};
}

void PrintView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF by = movedBy(*event);
    Camera moved = camera();
    const bool shifts =
        event->buttons() & (Qt::MiddleButton | Qt::RightButton) || event->modifiers() & Qt::ShiftModifier;
    if (!event->buttons() || !m_print)
        return;
    if (shifts)
        moved.pan({2.0 * by.x() / std::max(1, width()), -2.0 * by.y() / std::max(1, height())}, aspect());
    else
        moved.orbit(-turnPerPixel * by.x(), turnPerPixel * by.y());
    setCamera(moved);
}

void PrintView::mouseDoubleClickEvent(QMouseEvent*)
{
    showWhole();
}

void PrintView::wheelEvent(QWheelEvent* event)
{
    if (m_print) {
        Camera moved = camera();
        moved.zoom(std::pow(zoomStep, -event->angleDelta().y() / 120.0),
                   moved.pointAtTargetDepth(ndc(event->position()), aspect()));
        setCamera(moved);
    }
    event->accept();
}

void PrintView::keyPressEvent(QKeyEvent* event)
{
    Camera moved = camera();
    switch (event->key()) {
    case Qt::Key_Left:
        moved.orbit(-turnPerKey, 0.0);
        break;
    case Qt::Key_Right:
        moved.orbit(turnPerKey, 0.0);
        break;
    case Qt::Key_Up:
        moved.orbit(0.0, turnPerKey);
        break;
    case Qt::Key_Down:
        moved.orbit(0.0, -turnPerKey);
        break;
    case Qt::Key_Plus:
        moved.zoom(1.0 / zoomStep, moved.target);
        break;
    case Qt::Key_Minus:
        moved.zoom(zoomStep, moved.target);
        break;
    case Qt::Key_Home:
        return showWhole();
    default:
        return QWidget::keyPressEvent(event);
    }
    setCamera(moved);
}

/// As the picture has it, which may be a little behind.
void PrintView::paintOver(QPainter& painter)
{
    if (!m_print)
        return;
    const auto at = m_drawn.project(m_print->report.thinnestAt, aspect());
    if (!at || m_print->report.thinnest <= 0.0)
        return;
    const QPointF middle(0.5 * (1.0 + at->x) * width(), 0.5 * (1.0 - at->y) * height());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(255, 255, 255, 200), 5.0));
    painter.drawEllipse(middle, ringPixels, ringPixels);
    painter.setPen(QPen(QColor(thinnestColour.r, thinnestColour.g, thinnestColour.b), 2.5));
    painter.drawEllipse(middle, ringPixels, ringPixels);
}

QString PrintView::waitText() const
{
    return m_print && picture().isNull() ? tr("Drawing…") : QString();
}

void PrintView::setTexts()
{
    setAccessibleName(tr("Picture of the print"));
    setToolTip(tr("Drag or arrow keys: turn · Shift or the right button: move · wheel, + and −: nearer or "
                  "farther · Home or a double click: all of it"));
}

} // namespace ramure
