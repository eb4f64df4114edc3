#include "widgets/panels/levels/level_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

namespace ramure {
namespace {

constexpr double wheelStep = 1.1; ///< of the wheel, times the distance
constexpr int finer = 2;          ///< pixels drawn a side for one shown
/// More than these, and leaves that are a few pixels are drawn with fewer, as the view does: software
/// rasterisers take their time for each.
constexpr std::int64_t mostExact = 150'000;

std::int64_t facesOf(const RenderScene& scene)
{
    std::int64_t faces = 0;
    for (const MeshItem& item : scene.meshes)
        faces += item.mesh->faceCount();
    return faces;
}

} // namespace

/// The scenes that were drawn last.
struct LevelView::Drawn
{
    SceneBuilder builder;
    std::shared_ptr<const TreeLevels> levels;
    std::map<std::optional<std::size_t>, RenderScene> scenes; ///< of these levels

    const RenderScene& sceneOf(const std::shared_ptr<const TreeLevels>& of, std::optional<std::size_t> level)
    {
        if (std::exchange(levels, of) != of)
            scenes.clear();
        if (!scenes.contains(level))
            scenes[level] = levelScene(builder, *of, level);
        return scenes[level];
    }
};

LevelView::LevelView(QWidget* parent)
    : DrawnPicture(parent)
    , m_kept(std::make_shared<Drawn>())
{
    setToolTip(tr("Drag or arrow keys: turn · wheel, + and −: nearer or farther · Home: from the front"));
}

void LevelView::setLevel(std::shared_ptr<const TreeLevels> levels, std::optional<std::size_t> level)
{
    if (levels == m_levels && level == m_level)
        return;
    m_levels = std::move(levels);
    m_level = level;
    redraw();
}

void LevelView::setShot(const LevelShot& shot)
{
    if (std::exchange(m_shot, shot) != shot)
        redraw();
}

void LevelView::redraw()
{
    if (!m_levels)
        return clear([kept = m_kept] { // with the meshes of the tree
            kept->scenes.clear();
            kept->levels.reset();
        });
    start(
        [kept = m_kept, levels = m_levels, level = m_level, shot = m_shot](
            OffscreenRenderer& renderer, QSize pixels, const Progress& progress) -> Expected<QImage> {
            const RenderScene& scene = kept->sceneOf(levels, level);
            if (progress.cancelled())
                return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
            RenderOptions options;
            options.quality = Quality::Good;
            options.sparing = facesOf(scene) > mostExact;
            options.ground = options.outline = false;
            options.samples = 0; // dearer than pixels where triangles are smaller than these
            const QSize shown = pixels / finer;
            return renderer.draw(scene, levelCamera(*levels, shot, {shown.width(), shown.height()}), pixels,
                                 options);
        },
        finer, [this, level = m_level] { m_drawn = level; });
}

void LevelView::turnTo(double yawRad, double pitchRad)
{
    constexpr double most = 0.49 * std::numbers::pi;
    m_shot.yawRad = std::remainder(yawRad, 2.0 * std::numbers::pi);
    m_shot.pitchRad = std::clamp(pitchRad, -most, most);
    redraw();
    emit turned(m_shot.yawRad, m_shot.pitchRad);
}

void LevelView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF by = movedBy(*event);
    if (event->buttons() & (Qt::LeftButton | Qt::MiddleButton))
        turnTo(m_shot.yawRad - turnPerPixel * by.x(), m_shot.pitchRad + turnPerPixel * by.y());
}

void LevelView::wheelEvent(QWheelEvent* event)
{
    emit moved(std::pow(wheelStep, -event->angleDelta().y() / 120.0));
    event->accept();
}

void LevelView::keyPressEvent(QKeyEvent* event)
{
    const LevelShot usual;
    switch (event->key()) {
    case Qt::Key_Left:
        return turnTo(m_shot.yawRad - turnPerKey, m_shot.pitchRad);
    case Qt::Key_Right:
        return turnTo(m_shot.yawRad + turnPerKey, m_shot.pitchRad);
    case Qt::Key_Up:
        return turnTo(m_shot.yawRad, m_shot.pitchRad + turnPerKey);
    case Qt::Key_Down:
        return turnTo(m_shot.yawRad, m_shot.pitchRad - turnPerKey);
    case Qt::Key_Plus:
        return emit moved(1.0 / wheelStep);
    case Qt::Key_Minus:
        return emit moved(wheelStep);
    case Qt::Key_Home:
        return turnTo(usual.yawRad, usual.pitchRad);
    default:
        QWidget::keyPressEvent(event);
    }
}

QString LevelView::waitText() const
{
    return m_levels && (picture().isNull() || m_drawn != m_level) ? tr("Drawing…") : QString();
}

} // namespace ramure
