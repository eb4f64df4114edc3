#include "widgets/panels/levels/level_view.h"

#include "widgets/base/core_text.h"
#include "widgets/view/render/offscreen_renderer.h"
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

namespace ramure {
namespace {

constexpr double perPixel = 0.01, perKey = 0.15; ///< rad, of the mouse and of the arrow keys
constexpr double perStep = 1.1;                  ///< of the wheel, times the distance
constexpr int mostPixels = 2000;                 ///< a side
constexpr int finer = 2;                         ///< pixels drawn a side for one shown
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

/// What draws, and what it drew last.
struct LevelView::Drawer
{
    OffscreenRenderer renderer; ///< made on the thread of the interface
    bool hasBegun = false;
    SceneBuilder builder;
    std::shared_ptr<const TreeLevels> levels;
    std::map<std::optional<std::size_t>, RenderScene> scenes; ///< of these levels

    Expected<QImage> draw(const std::shared_ptr<const TreeLevels>& of, std::optional<std::size_t> level,
                          const LevelShot& shot, QSize size, const Progress& progress)
    {
        if (!hasBegun)
            if (auto begun = renderer.begin(); !begun)
                return fail(std::move(begun.error()));
        hasBegun = true;
        if (std::exchange(levels, of) != of)
            scenes.clear();
        if (!scenes.contains(level))
            scenes[level] = levelScene(builder, *of, level);
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        RenderOptions options;
        options.quality = Quality::Good;
        options.sparing = facesOf(scenes[level]) > mostExact;
        options.ground = options.outline = false;
        options.samples = 0; // dearer than pixels where triangles are smaller than these
        auto picture = renderer.draw(scenes[level], levelCamera(*of, shot, {size.width(), size.height()}),
                                     finer * size, options);
        if (!picture)
            return picture;
        return picture->scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }
};

LevelView::LevelView(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::OpenHandCursor);
    retranslate();
}

/// The context ends on the thread that it was made on.
LevelView::~LevelView()
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

void LevelView::setLevel(std::shared_ptr<const TreeLevels> levels, std::optional<std::size_t> level)
{
    if (levels == m_levels && level == m_level)
        return;
    m_levels = std::move(levels);
    m_level = level;
    draw();
}

void LevelView::setShot(const LevelShot& shot)
{
    if (std::exchange(m_shot, shot) != shot)
        draw();
}

void LevelView::draw()
{
    const QSize size =
        (QSizeF(this->size()) * devicePixelRatioF()).toSize().boundedTo({mostPixels, mostPixels});
    if (!m_levels) {
        m_picture = {};
        if (m_drawer)
            m_job.start([drawer = m_drawer](const Progress&) -> Expected<void> {
                drawer->scenes.clear(); // with the meshes of the tree
                drawer->levels.reset();
                return {};
            });
        return update();
    }
    if (size.isEmpty() || !isVisible())
        return;
    if (!m_drawer)
        m_drawer = std::make_shared<Drawer>();
    m_job.start([drawer = m_drawer, levels = m_levels, level = m_level, shot = m_shot, size](
                    const Progress& progress) { return drawer->draw(levels, level, shot, size, progress); },
                [this, level = m_level](Expected<QImage>&& made) {
                    m_drawn = level;
                    m_problem = made ? QString() : errorText(made.error());
                    if (made)
                        m_picture = std::move(*made);
                    update();
                },
                Job::Running::GoesOn);
}

void LevelView::turnTo(double yawRad, double pitchRad)
{
    constexpr double most = 0.49 * std::numbers::pi;
    m_shot.yawRad = std::remainder(yawRad, 2.0 * std::numbers::pi);
    m_shot.pitchRad = std::clamp(pitchRad, -most, most);
    draw();
    emit turned(m_shot.yawRad, m_shot.pitchRad);
}

void LevelView::mousePressEvent(QMouseEvent* event)
{
    m_last = event->position();
}

void LevelView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF by = event->position() - m_last;
    m_last = event->position();
    if (event->buttons() & (Qt::LeftButton | Qt::MiddleButton))
        turnTo(m_shot.yawRad - perPixel * by.x(), m_shot.pitchRad + perPixel * by.y());
}

void LevelView::wheelEvent(QWheelEvent* event)
{
    emit moved(std::pow(perStep, -event->angleDelta().y() / 120.0));
    event->accept();
}

void LevelView::keyPressEvent(QKeyEvent* event)
{
    const LevelShot usual;
    switch (event->key()) {
    case Qt::Key_Left:
        return turnTo(m_shot.yawRad - perKey, m_shot.pitchRad);
    case Qt::Key_Right:
        return turnTo(m_shot.yawRad + perKey, m_shot.pitchRad);
    case Qt::Key_Up:
        return turnTo(m_shot.yawRad, m_shot.pitchRad + perKey);
    case Qt::Key_Down:
        return turnTo(m_shot.yawRad, m_shot.pitchRad - perKey);
    case Qt::Key_Plus:
        return emit moved(1.0 / perStep);
    case Qt::Key_Minus:
        return emit moved(perStep);
    case Qt::Key_Home:
        return turnTo(usual.yawRad, usual.pitchRad);
    default:
        QWidget::keyPressEvent(event);
    }
}

void LevelView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    draw();
}

void LevelView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    draw();
}

void LevelView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(),
                     m_picture.isNull() ? palette().color(QPalette::Base) : m_picture.pixelColor(0, 0));
    if (!m_picture.isNull()) { // at its size while that of the window changes
        const QSizeF shown = QSizeF(m_picture.size()) / devicePixelRatioF();
        const QPointF corner(0.5 * (width() - shown.width()), 0.5 * (height() - shown.height()));
        painter.drawImage(QRectF(corner, shown), m_picture);
    }
    const QString text = !m_problem.isEmpty()                                     ? m_problem
                         : m_levels && (m_picture.isNull() || m_drawn != m_level) ? tr("Drawing…")
                                                                                  : QString();
    const int above = int(m_problem.isEmpty() ? Qt::AlignBottom : Qt::AlignVCenter);
    if (!text.isEmpty())
        painter.drawText(rect().adjusted(8, 8, -8, -8), above | int(Qt::AlignHCenter) | int(Qt::TextWordWrap),
                         text);
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void LevelView::retranslate()
{
    setToolTip(tr("Drag or arrow keys: turn · wheel, + and −: nearer or farther · Home: from the front"));
}

void LevelView::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace ramure
