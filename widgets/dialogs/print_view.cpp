#include "widgets/dialogs/print_view.h"

#include "widgets/base/core_text.h"
#include "widgets/view/render/offscreen_renderer.h"
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ramure {
namespace {

constexpr double perPixel = 0.01, perKey = 0.15; ///< rad, of the mouse and of the arrow keys
constexpr double perStep = 1.15;                 ///< of the wheel, times the distance
constexpr int mostPixels = 2000;                 ///< a side
constexpr int finer = 2;                         ///< pixels drawn a side for one shown, at rest
constexpr int restMs = 150;
constexpr double ringPixels = 11.0;

} // namespace

/// What draws, and what it drew last.
struct PrintView::Drawer
{
    OffscreenRenderer renderer; ///< made on the thread of the interface
    bool hasBegun = false;
    std::shared_ptr<const PrintedTree> print;
    RenderScene scene; ///< of it

    Expected<QImage> draw(const std::shared_ptr<const PrintedTree>& of, const Camera& camera, QSize size,
                          int pixels)
    {
        if (!hasBegun)
            if (auto begun = renderer.begin(); !begun)
                return fail(std::move(begun.error()));
        hasBegun = true;
        if (std::exchange(print, of) != of)
            scene = previewScene(*of);
        RenderOptions options;
        options.quality = pixels > 1 ? Quality::Good : Quality::Draft;
        options.ground = options.outline = false;
        options.samples = 0; // dearer than pixels where triangles are smaller than these
        auto picture = renderer.draw(scene, camera, pixels * size, options);
        if (!picture || pixels == 1)
            return picture;
        return picture->scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }
    void forget()
    {
        scene = {};
        print.reset();
    }
};

PrintView::PrintView(QWidget* parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("printPicture"));
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::OpenHandCursor);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMs);
    connect(&m_rest, &QTimer::timeout, this, [this] { draw(false); });
    connect(&m_flight, &CameraFlight::moved, this, [this] { draw(true); });
    retranslate();
}

/// The context ends on the thread that it was made on.
PrintView::~PrintView()
{
    if (!m_drawer)
        return;
    m_job.start([drawer = m_drawer](const Progress&) -> Expected<void> {
        if (std::exchange(drawer->hasBegun, false))
            drawer->renderer.end();
        return {};
    });
    m_job.wait(Job::patience);
}

bool PrintView::isBusy() const
{
    return m_job.isRunning() || m_rest.isActive() || m_flight.isFlying();
}

void PrintView::setPrint(std::shared_ptr<const PrintedTree> print)
{
    m_print = std::move(print);
    m_picture = {};
    m_problem.clear();
    if (m_print)
        return setCamera(wholePrint(*m_print, camera(), aspect()));
    if (m_drawer)
        m_job.start([drawer = m_drawer](const Progress&) -> Expected<void> {
            drawer->forget(); // with the mesh
            return {};
        });
    update();
}

/// \param hurried it moves: drawn coarser, and again when it rests
void PrintView::draw(bool hurried)
{
    const QSize size =
        (QSizeF(this->size()) * devicePixelRatioF()).toSize().boundedTo({mostPixels, mostPixels});
    if (!m_print || size.isEmpty() || !isVisible())
        return;
    if (hurried)
        m_rest.start();
    if (!m_drawer)
        m_drawer = std::make_shared<Drawer>();
    m_job.start([drawer = m_drawer, print = m_print, camera = camera(), size, pixels = hurried ? 1 : finer](
                    const Progress&) { return drawer->draw(print, camera, size, pixels); },
                [this, camera = camera()](Expected<QImage>&& made) {
                    m_problem = made ? QString() : errorText(made.error());
                    m_drawn = camera;
                    if (made)
                        m_picture = std::move(*made);
                    update();
                },
                Job::Running::GoesOn);
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

void PrintView::mousePressEvent(QMouseEvent* event)
{
    m_last = event->position();
}

void PrintView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF by = event->position() - m_last;
    m_last = event->position();
    Camera moved = camera();
    const bool shifts =
        event->buttons() & (Qt::MiddleButton | Qt::RightButton) || event->modifiers() & Qt::ShiftModifier;
    if (!event->buttons() || !m_print)
        return;
    if (shifts)
        moved.pan({2.0 * by.x() / std::max(1, width()), -2.0 * by.y() / std::max(1, height())}, aspect());
    else
        moved.orbit(-perPixel * by.x(), perPixel * by.y());
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
        moved.zoom(std::pow(perStep, -event->angleDelta().y() / 120.0),
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
        moved.orbit(-perKey, 0.0);
        break;
    case Qt::Key_Right:
        moved.orbit(perKey, 0.0);
        break;
    case Qt::Key_Up:
        moved.orbit(0.0, perKey);
        break;
    case Qt::Key_Down:
        moved.orbit(0.0, -perKey);
        break;
    case Qt::Key_Plus:
        moved.zoom(1.0 / perStep, moved.target);
        break;
    case Qt::Key_Minus:
        moved.zoom(perStep, moved.target);
        break;
    case Qt::Key_Home:
        return showWhole();
    default:
        return QWidget::keyPressEvent(event);
    }
    setCamera(moved);
}

void PrintView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    draw(true);
}

void PrintView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    draw(false);
}

/// As the picture has it, which may be a little behind.
void PrintView::paintThinnest(QPainter& painter) const
{
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

void PrintView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(),
                     m_picture.isNull() ? palette().color(QPalette::Base) : m_picture.pixelColor(0, 0));
    if (!m_picture.isNull() && m_print) { // at its size while that of the window changes
        const QSizeF shown = QSizeF(m_picture.size()) / devicePixelRatioF();
        const QPointF corner(0.5 * (width() - shown.width()), 0.5 * (height() - shown.height()));
        painter.drawImage(QRectF(corner, shown), m_picture);
        paintThinnest(painter);
    }
    const QString text = !m_problem.isEmpty()            ? m_problem
                         : m_print && m_picture.isNull() ? tr("Drawing…")
                                                         : QString();
    if (!text.isEmpty())
        painter.drawText(rect().adjusted(8, 8, -8, -8), int(Qt::AlignCenter) | int(Qt::TextWordWrap), text);
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(palette().color(QPalette::Highlight));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void PrintView::retranslate()
{
    setAccessibleName(tr("Picture of the print"));
    setToolTip(tr("Drag or arrow keys: turn · Shift or the right button: move · wheel, + and −: nearer or "
                  "farther · Home or a double click: all of it"));
}

void PrintView::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace ramure
