#include "widgets/panels/properties/leaf_view.h"

#include "widgets/base/texts/core_text.h"
#include "widgets/panels/properties/leaf_scene.h"
#include "widgets/view/drawn_picture.h"
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace ramure {
namespace {

constexpr double frontYaw = 0.25, frontPitch = 0.15;      ///< rad
constexpr double mostNearness = 6.0, leastNearness = 0.4; ///< of what fills the window

} // namespace

/// What draws, and what it drew last.
struct LeafView::Drawer
{
    OffscreenRenderer renderer; ///< made on the thread of the interface
    bool hasBegun = false;
    std::optional<NodeParams> params;
    RenderScene scene;

    Expected<QImage> draw(const NodeParams& wanted, const Camera& angles, double nearness, QSize size)
    {
        if (!hasBegun)
            RAMURE_TRY(renderer.begin());
        hasBegun = true;
        if (params != wanted)
            scene = leafScene(wanted);
        params = wanted;
        Camera camera = angles;
        const std::vector<glm::dvec3> points = scene.framePoints();
        camera.frameAllAround(points, double(size.width()) / double(size.height()));
        camera.distance /= nearness;
        RenderOptions options;
        options.quality = Quality::Good;
        options.ground = false;
        options.light.backdrop = Backdrop::LightStudio;
        options.light.azimuthDeg = 150.0; // from the front, a little from the right
        return renderer.draw(scene, camera, size, options);
    }
};

LeafView::LeafView(QWidget* parent)
    : QWidget(parent)
    , m_drawer(std::make_shared<Drawer>())
{
    setObjectName(QStringLiteral("leafView"));
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::OpenHandCursor);
    m_yawRad = frontYaw;
    m_pitchRad = frontPitch;
    setAccessibleName(tr("One leaf, and a twig with its leaves"));
    setToolTip(tr("Drag or arrow keys: turn · wheel, + and −: nearer or farther · Home: from the front"));
}

/// The context ends on the thread that it was made on.
LeafView::~LeafView()
{
    m_job.start([drawer = m_drawer](const Progress&) -> Expected<void> {
        if (std::exchange(drawer->hasBegun, false))
            drawer->renderer.end();
        return {};
    });
    m_job.wait(Job::patience);
}

/// Only what a leaf looks like: another grammar draws no new picture.
void LeafView::setParams(const NodeParams& params)
{
    NodeParams own;
    own.foliage = params.foliage;
    own.leaf = params.leaf;
    own.bark = params.bark;
    own.leafPictures = params.leafPictures;
    if (own == m_params && !m_picture.isNull())
        return;
    m_params = std::move(own);
    draw();
}

void LeafView::draw()
{
    const QSize size = (QSizeF(this->size()) * devicePixelRatioF())
                           .toSize()
                           .boundedTo({mostPicturePixels, mostPicturePixels});
    if (size.isEmpty())
        return;
    Camera camera;
    camera.yawRad = m_yawRad;
    camera.pitchRad = m_pitchRad;
    m_job.start([drawer = m_drawer, params = m_params, camera, nearness = m_nearness,
                 size](const Progress&) { return drawer->draw(params, camera, nearness, size); },
                [this](Expected<QImage>&& made) {
                    m_problem = made ? QString() : errorText(made.error());
                    if (made)
                        m_picture = std::move(*made);
                    update();
                },
                Job::Running::GoesOn);
}

void LeafView::resetView()
{
    m_yawRad = frontYaw;
    m_pitchRad = frontPitch;
    m_nearness = 1.0;
    draw();
}

void LeafView::turn(double yawRad, double pitchRad)
{
    constexpr double most = 0.49 * std::numbers::pi;
    m_yawRad = std::remainder(m_yawRad + yawRad, 2.0 * std::numbers::pi);
    m_pitchRad = std::clamp(m_pitchRad + pitchRad, -most, most);
    draw();
}

void LeafView::zoom(double factor)
{
    m_nearness = std::clamp(m_nearness * factor, leastNearness, mostNearness);
    draw();
}

void LeafView::mousePressEvent(QMouseEvent* event)
{
    m_last = event->position();
}

void LeafView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF moved = event->position() - m_last;
    m_last = event->position();
    if (event->buttons() != Qt::NoButton)
        turn(-turnPerPixel * moved.x(), turnPerPixel * moved.y());
}

void LeafView::wheelEvent(QWheelEvent* event)
{
    zoom(std::pow(1.1, event->angleDelta().y() / 120.0));
    event->accept();
}

void LeafView::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Left:
        return turn(-turnPerKey, 0.0);
    case Qt::Key_Right:
        return turn(turnPerKey, 0.0);
    case Qt::Key_Up:
        return turn(0.0, turnPerKey);
    case Qt::Key_Down:
        return turn(0.0, -turnPerKey);
    case Qt::Key_Plus:
        return zoom(1.2);
    case Qt::Key_Minus:
        return zoom(1.0 / 1.2);
    case Qt::Key_Home:
        return resetView();
    default:
        QWidget::keyPressEvent(event);
    }
}

void LeafView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    draw();
}

void LeafView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!m_picture.isNull()) // a little blurred while the window's size changes
        painter.drawImage(rect(), m_picture);
    if (!m_problem.isEmpty())
        painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, m_problem);
}

} // namespace ramure
