#include "widgets/viewport/viewport.h"

#include "widgets/viewport/navigation_cube.h"
#include "widgets/viewport/viewport_private.h"
#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QPainter>
#include <numeric>

namespace ramure {
namespace {

constexpr int flightMs = 180;
constexpr int hoverRestMs = 25;

double milliseconds(const QElapsedTimer& timer)
{
    return 1e-6 * double(timer.nsecsElapsed());
}

/// The box of the selected branches, else of the selected nodes' trees; world.
Box selectionBox(const Document& document, const RenderScene& scene)
{
    const Selection& selection = document.selection();
    Box box;
    const NodeResult* result = document.result(selection.branchNode);
    if (result && result->tree.simplified) {
        const Skeleton& skeleton = result->tree.simplified->skeleton;
        const glm::dmat4 world = worldMatrix(document.scene(), selection.branchNode);
        for (const Index branch : selection.branches) {
            if (branch >= skeleton.size())
                continue;
            Box own;
            own.add(skeleton.p0[branch]);
            own.add(skeleton.p1[branch]);
            box.add(own.grown(2.0 * skeleton.a0[branch]).transformed(world));
        }
    }
    if (!box.empty())
        return box;
    for (const MeshItem& item : scene.meshes) {
        if (std::ranges::find(selection.nodes, item.node) != selection.nodes.end())
            box.add(item.box.transformed(item.world));
    }
    for (const LineItem& item : scene.lines) {
        if (std::ranges::find(selection.nodes, item.node) != selection.nodes.end())
            box.add(item.lines->box.transformed(item.world));
    }
    return box.empty() ? scene.box : box;
}

} // namespace

SceneView Viewport::Private::sceneView() const
{
    const Selection& selection = document->selection();
    SceneView view;
    view.mode = settings->displayMode();
    view.leaves = settings->leavesVisible();
    view.apples = settings->applesVisible();
    view.frames = settings->frameDisplay();
    view.selectedNodes = selection.nodes;
    view.branchNode = selection.branchNode;
    view.branches = selection.branches;
    view.activeBranch = selection.activeBranch;
    view.hoverNode = hoverNode;
    view.hoverBranch = hoverBranch;
    view.inspected = inspected;
    view.isolatedNode = isolatedNode;
    view.isolatedBranches = isolatedBranches;
    return view;
}

RenderOptions Viewport::Private::options(double pixelRatio) const
{
    RenderOptions options;
    options.shading = settings->shadingMode();
    options.grid = settings->gridVisible();
    options.pixelRatio = pixelRatio;
    options.smoothing = software;
    return options;
}

Viewport::Viewport(Document* document, ViewSettings* settings, QWidget* parent)
    : QOpenGLWidget(parent)
    , d(std::make_unique<Private>())
{
    d->document = document;
    d->settings = settings;
    d->camera.orthographic = settings->orthographic();
    QSurfaceFormat wanted = format();
    wanted.setVersion(3, 3);
    wanted.setProfile(QSurfaceFormat::CoreProfile);
    wanted.setDepthBufferSize(24);
    wanted.setSamples(4);
    setFormat(wanted);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    setAccessibleName(tr("3D view"));

    connect(document, &Document::changed, this, &Viewport::onDocumentChanged);
    connect(settings, &ViewSettings::changed, this, &Viewport::onSettingsChanged);
    connect(&d->picker, &BackgroundPicker::readyChanged, this, [this] {
        if (d->pending)
            finishSelecting();
        if (underMouse())
            hoverAt(d->hoverPosition);
    });
    d->flight.setDuration(flightMs);
    d->flight.setStartValue(0.0);
    d->flight.setEndValue(1.0);
    d->flight.setEasingCurve(QEasingCurve::OutCubic);
    connect(&d->flight, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
        d->camera = mixed(d->from, d->to, value.toDouble());
        emit cameraChanged();
        update();
    });
    d->hoverRest.setSingleShot(true);
    d->hoverRest.setInterval(hoverRestMs);
    connect(&d->hoverRest, &QTimer::timeout, this, [this] { hoverAt(d->hoverPosition); });
}

Viewport::~Viewport()
{
    releaseRenderer();
}

void Viewport::releaseRenderer()
{
    disconnect(d->contextGone);
    if (!d->renderer)
        return;
    makeCurrent();
    d->renderer.reset();
    doneCurrent();
}

const Camera& Viewport::camera() const
{
    return d->camera;
}

bool Viewport::isPickPending() const
{
    return d->pending.has_value();
}

FrameTimes Viewport::frameTimes() const
{
    return d->times;
}

QSize Viewport::sizeHint() const
{
    return {960, 720};
}

void Viewport::setSoftware(bool software)
{
    d->software = software;
    QSurfaceFormat wanted = format();
    wanted.setSamples(software ? 0 : 4);
    setFormat(wanted);
}

void Viewport::onDocumentChanged(const Change& change)
{
    if (change.has(changeReset)) {
        d->frameNext = true;
        d->hoverNode = noNode;
        d->hoverBranch = noIndex;
        d->inspected = {};
        clearDefect();
    }
    if (change.kinds == changeFile)
        return;
    d->sceneStale = true;
    update();
}

void Viewport::onSettingsChanged()
{
    if (d->camera.orthographic != d->settings->orthographic()) {
        d->camera.orthographic = d->settings->orthographic();
        d->to.orthographic = d->camera.orthographic;
        emit cameraChanged();
    }
    d->sceneStale = true;
    update();
}

void Viewport::rebuildScene()
{
    d->sceneStale = false;
    d->highlightsStale = false;
    const auto resultOf = [this](NodeId id) { return d->resultOf(id); };
    auto built =
        std::make_shared<RenderScene>(d->builder.build(d->document->scene(), resultOf, d->sceneView()));
    if (d->defectLines)
        built->lines.push_back({d->defectLines, glm::dmat4(1.0), noNode, true, false});
    if (d->defectPoints)
        built->points.push_back({d->defectPoints, glm::dmat4(1.0), noNode, true});
    d->scene = std::move(built);
    d->picker.setScene(d->scene);
    if (d->frameNext && !d->scene->box.empty()) {
        d->frameNext = false;
        d->flight.stop();
        d->camera.frame(d->scene->framePoints(), double(width()) / std::max(1, height()));
        emit cameraChanged();
    }
}

void Viewport::rebuildHighlights()
{
    d->highlightsStale = false;
    auto changed = std::make_shared<RenderScene>(*d->scene);
    d->builder.updateHighlights(
        *changed, [this](NodeId id) { return d->resultOf(id); }, d->sceneView());
    d->scene = std::move(changed);
}

void Viewport::initializeGL()
{
    // Called again whenever the widget got another context; the old one took its objects along.
    d->renderer.reset();
    auto made = Renderer::make();
    if (!made) {
        d->failure = QCoreApplication::translate("core", made.error().plain().c_str());
        return;
    }
    d->failure.clear();
    d->renderer = std::move(*made);
    disconnect(d->contextGone);
    d->contextGone = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::releaseRenderer,
                             Qt::DirectConnection);
}

void Viewport::resizeGL(int, int)
{
}

void Viewport::paintGL()
{
    QElapsedTimer timer;
    timer.start();
    const bool rebuilt = d->sceneStale;
    if (d->sceneStale)
        rebuildScene();
    else if (d->highlightsStale)
        rebuildHighlights();
    d->times.buildMs = milliseconds(timer);
    if (!d->renderer) {
        QPainter painter(this);
        painter.fillRect(rect(), palette().window());
        painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap, d->failure);
        return;
    }
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    d->renderer->draw(*d->scene, d->camera, pixels, defaultFramebufferObject(),
                      d->options(devicePixelRatioF()));
    const RenderStats stats = d->renderer->stats();
    d->times.uploadMs = stats.uploadMs;
    d->times.drawMs = stats.drawMs;
    d->times.rebuilt = rebuilt;
    ++d->times.frame;
    paintOverlay();
    emit frameDrawn(d->times);
}

void Viewport::paintOverlay()
{
    QPainter painter(this);
    NavigationCube::paint(painter, d->camera, size(), d->hoverSide);
    if (d->gesture == Gesture::Select && d->dragging) {
        const QColor colour = palette().color(QPalette::Highlight);
        painter.setPen(QPen(colour, 1.0, Qt::DashLine));
        painter.setBrush(QColor(colour.red(), colour.green(), colour.blue(), 40));
        painter.drawRect(QRectF(d->pressed, d->last).normalized());
    }
}

void Viewport::setCamera(const Camera& camera)
{
    d->flight.stop();
    d->frameNext = false;
    d->camera = camera;
    d->settings->setOrthographic(camera.orthographic);
    emit cameraChanged();
    update();
}

void Viewport::moveCamera(const Camera& to)
{
    d->flight.stop();
    if (!isVisible()) {
        setCamera(to);
        return;
    }
    d->frameNext = false;
    d->from = d->camera;
    d->to = to;
    d->flight.start();
}

void Viewport::frameBox(const Box& box)
{
    Camera to = d->flight.state() == QAbstractAnimation::Running ? d->to : d->camera;
    to.frame(box, double(width()) / std::max(1, height()));
    moveCamera(to);
}

void Viewport::frameAll()
{
    if (d->sceneStale)
        rebuildScene();
    const std::vector<glm::dvec3> points = d->scene->framePoints();
    Camera to = d->flight.state() == QAbstractAnimation::Running ? d->to : d->camera;
    to.frame(points, double(width()) / std::max(1, height()));
    if (!points.empty())
        moveCamera(to);
}

void Viewport::frameSelection()
{
    if (d->sceneStale)
        rebuildScene();
    const Box box = selectionBox(*d->document, *d->scene);
    if (!box.empty())
        frameBox(box);
}

void Viewport::setAxisView(AxisView view)
{
    Camera to = d->flight.state() == QAbstractAnimation::Running ? d->to : d->camera;
    to.setAxisView(view);
    moveCamera(to);
}

void Viewport::orbitBy(double yawRad, double pitchRad)
{
    Camera to = d->flight.state() == QAbstractAnimation::Running ? d->to : d->camera;
    to.orbit(yawRad, pitchRad);
    moveCamera(to);
}

void Viewport::zoomBy(double factor)
{
    if (!(factor > 0.0))
        return;
    Camera to = d->flight.state() == QAbstractAnimation::Running ? d->to : d->camera;
    to.zoom(factor, to.target);
    moveCamera(to);
}

void Viewport::clearSelection()
{
    Selection next = d->document->selection();
    if (next.branches.empty())
        next.nodes.clear();
    next.branches.clear();
    next.branchNode = noNode;
    next.activeBranch = noIndex;
    d->document->setSelection(std::move(next));
}

void Viewport::selectAllBranches()
{
    Selection next = d->document->selection();
    const TreeResult* tree = d->resultOf(next.activeNode());
    if (!tree || !tree->simplified)
        return;
    next.branchNode = next.activeNode();
    next.branches.resize(tree->simplified->skeleton.size());
    std::iota(next.branches.begin(), next.branches.end(), Index(0));
    if (next.activeBranch >= next.branches.size())
        next.activeBranch = next.branches.empty() ? noIndex : 0;
    d->document->setSelection(std::move(next));
}

} // namespace ramure
