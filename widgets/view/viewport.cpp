#include "widgets/view/viewport.h"
#include "core/evaluate/evaluator.h"
#include "core/qt/session/motion/auto_key.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/base/theme/theme.h"
#include "widgets/view/render/framing_points.h"
#include "widgets/view/render/passes/gl_setup.h"

#include "widgets/view/texture_legend.h"
#include "widgets/view/viewport_private.h"
#include <QOpenGLContext>
#include <QPainter>
#include <numeric>
#include <utility>

namespace ramure {
namespace {

constexpr int settleMs = 300; ///< without a move, until pictures are as good as was chosen
constexpr int hoverRestMs = 25;

/// The box of the selected branches, else of the selected nodes' trees; world.
Box selectionBox(const Document& document, const RenderScene& scene, double timeSeconds)
{
    const Selection& selection = document.selection();
    Box box;
    const NodeResult* result = document.result(selection.branchNode);
    if (result && result->tree.simplified) {
        const Skeleton& skeleton = result->tree.simplified->skeleton;
        const EvaluatedScene now(document.scene(), timeSeconds);
        const glm::dmat4 world = now.transforms(selection.branchNode).geometry;
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
    for (const CrowdItem& item : scene.crowds) {
        if (std::ranges::find(selection.nodes, item.node) != selection.nodes.end())
            box.add(item.crowd->box().transformed(item.world));
    }
    return box.empty() ? scene.box : box;
}

} // namespace

RenderOptions Viewport::Private::options(double pixelRatio) const
{
    RenderOptions options;
    options.shading = settings->shadingMode();
    options.quality = settings->quality();
    options.hurried = software && (settling.isActive() || isWindy());
    options.grid = settings->gridVisible();
    options.ground = settings->groundVisible();
    options.outlineOpacity = float(outline.opacity());
    options.outline = settings->outlineVisible() && options.outlineOpacity > 0.0f;
    options.light = settings->light();
    options.pixelRatio = pixelRatio;
    options.smoothing = options.sparing = software;
    options.wind = {settings->gameWindStrength(),
                    1e-3 * double(windClock.isValid() ? windClock.elapsed() : 0)};
    return options;
}

Viewport::Viewport(Document* document, ViewSettings* settings, QWidget* parent)
    : QOpenGLWidget(parent)
    , d(std::make_unique<Private>(this, document, settings))
{
    d->flight.setOrthographic(settings->orthographic());
    QSurfaceFormat wanted = openGlFormat();
    wanted.setDepthBufferSize(24);
    wanted.setSamples(4);
    setFormat(wanted);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    setAccessibleName(tr("3D view"));

    connect(document, &Document::changed, this, &Viewport::onDocumentChanged);
    settings->windVisible.follow(this, [this] { explainWind(); });
    settings->gameWind.follow(this, [this] { beginGameWind(); });
    settings->outlineVisible.follow(this, [this] { d->outline.show(); });
    connect(settings, &ViewSettings::changed, this, &Viewport::onSettingsChanged);
    connect(&d->tools.picks(), &PendingPick::missed, this, &Viewport::clearDefect);
    connect(&d->tools.picks(), &PendingPick::menuWanted, this, [this](QPointF at, NodeId node, Index branch) {
        emit menuRequested(mapToGlobal(at.toPoint()), node, branch);
    });
    d->picker.setDisposal([this](std::shared_ptr<const void> last) { d->builder.dispose(std::move(last)); });
    connect(&d->builder, &BackgroundBuilder::built, this, &Viewport::takeScene);
    const auto complain = [this](const Error& error) { emit messageRaised(errorText(error)); };
    connect(&d->builder, &BackgroundBuilder::failed, this, complain);
    connect(&d->picker, &BackgroundPicker::failed, this, complain);
    connect(&d->upload.turns, &QTimer::timeout, this, &Viewport::uploadScene);
    connect(&d->picker, &BackgroundPicker::readyChanged, this, [this] {
        d->tools.sceneReady();
        if (underMouse())
            hoverAt(d->pointer.at);
    });
    connect(&d->pending.barks, &BarkWaiter::ready, this, &Viewport::wishScene);
    connect(d->pending.barks.job(), &Job::runningChanged, this, &Viewport::barkMissing);
    connect(&d->fine.turns, &QTimer::timeout, this, &Viewport::drawOn);
    d->settling.setInterval(settleMs);
    connect(&d->settling, &QTimer::timeout, this, qOverload<>(&QWidget::update));
    connect(&d->flight, &CameraFlight::moved, this, [this] {
        d->settling.start();
        emit cameraChanged();
        update();
    });
    connect(&d->reach, &ArmReach::moved, this, [this] {
        d->reachPose.forget();
        update();
    });
    d->hoverRest.setInterval(hoverRestMs);
    connect(&d->hoverRest, &QTimer::timeout, this, [this] { hoverAt(d->pointer.at); });
    connect(settings->gizmo(), &GizmoSettings::changed, this, [this] {
        updateTrail();
        update();
    });
    connect(&d->trail, &GizmoTrail::changed, this, qOverload<>(&QWidget::update));
    connect(&d->outline, &OutlineKey::changed, this, qOverload<>(&QWidget::update));
    connect(&d->marks, &ViewMarks::sceneChanged, this, &Viewport::wishScene);
    connect(&d->marks, &ViewMarks::highlightsChanged, this, [this] {
        d->highlightsStale = true;
        update();
    });
    wishScene();
}

Viewport::~Viewport()
{
    d->document->disconnect(this);
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
    return d->camera();
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

void Viewport::initializeGL()
{
    // Called again whenever the widget got another context; the old one took its objects along.
    d->renderer.reset();
    d->forgetPicture();
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
    if (!d->frame.isAll || d->scene->box.empty() || d->flight.isFlying())
        return;
    Camera to = d->camera();
    to.frame(framingPoints(d->document->scene(), *d->scene), d->view().aspect());
    if (d->frame.followed == d->camera())
        d->frame.followed = to;
    d->flight.setCamera(to);
}

void Viewport::paintGL()
{
    if (d->highlightsStale)
        rebuildHighlights();
    if (!d->renderer) {
        QPainter painter(this);
        painter.fillRect(rect(), palette().window());
        painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap, d->failure);
        return;
    }
    d->followCamera();
    d->updateShown();
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
    d->draw(pixels, d->options(devicePixelRatioF()));
    const RenderStats stats = d->renderer->stats();
    for (auto& block : d->renderer->takeReleased())
        d->builder.dispose(std::move(block));
    d->times.uploadMs = stats.uploadMs + (d->sceneIsNew ? d->upload.pastMs : 0.0);
    d->times.drawMs = stats.drawMs;
    d->times.drawCpuMs = stats.drawCpuMs;
    d->times.rebuilt = std::exchange(d->sceneIsNew, false);
    ++d->times.frame;
    paintOverlay();
    if (d->isWindy())
        QTimer::singleShot(0, this, qOverload<>(&QWidget::update));
    emit frameDrawn(d->times);
}

void Viewport::paintOverlay()
{
    QPainter painter(this);
    const PickView view = d->view();
    paintTextureLegend(painter, size(), d->settings->displayMode(), d->scene->texture);
    d->defect.paintLabel(painter, view);
    painter.setRenderHint(QPainter::Antialiasing);
    paintLabels(painter);
    if (d->settings->outlineVisible() && !d->document->selection().nodes.empty())
        d->outline.paint(painter);
    d->trail.paintPlayhead(painter, view, d->context.seconds());
    d->tools.paint(painter, view);
    if (d->context.keys && d->context.keys->isOn()) {
        constexpr double wide = 3.0;
        painter.setPen(QPen(errorColour(palette()), wide));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(wide / 2, wide / 2, -wide / 2, -wide / 2));
    }
}

void Viewport::setCamera(const Camera& camera)
{
    d->frame.next = false;
    d->leaveCamera();
    d->setCamera(camera);
    d->settings->orthographic.set(camera.orthographic);
}

void Viewport::moveCamera(const Camera& to)
{
    if (!isVisible()) {
        setCamera(to);
        return;
    }
    d->frame.next = false;
    d->frame.isAll = false;
    d->leaveCamera();
    d->flight.flyTo(to);
}

void Viewport::frameBox(const Box& box)
{
    Camera to = d->flight.goal();
    to.frame(box, d->view().aspect());
    moveCamera(to);
}

std::optional<PickHit> Viewport::hitAt(QPointF position) const
{
    const auto& scene = d->picker.latest();
    return scene ? scene->pick(d->view(), {position.x(), position.y()}) : std::nullopt;
}

std::optional<glm::dvec3> Viewport::groundAt(QPointF position) const
{
    constexpr double farthest = 20.0; // times the camera's distance
    const PickView view = d->view();
    const ViewRay ray = d->camera().ray(view.ndc({position.x(), position.y()}), view.aspect());
    const double way = (d->scene->ground - ray.origin.y) / ray.direction.y;
    if (!(way > 0.0 && way < farthest * d->camera().distance))
        return std::nullopt;
    const glm::dvec3 at = ray.origin + way * ray.direction;
    return glm::dvec3(at.x, d->scene->ground, at.z);
}

void Viewport::frameAll()
{
    if (d->isStale()) {
        d->frame.wanted = Private::Frame::Wish::All;
        return;
    }
    const std::vector<glm::dvec3> points = framingPoints(d->document->scene(), *d->scene);
    Camera to = d->flight.goal();
    to.frame(points, d->view().aspect());
    if (!points.empty()) {
        moveCamera(to);
        d->frame.isAll = true;
    }
}

void Viewport::frameSelection()
{
    if (d->isStale()) {
        d->frame.wanted = Private::Frame::Wish::Selection;
        return;
    }
    const Box box = selectionBox(*d->document, *d->scene, d->context.seconds());
    if (!box.empty())
        frameBox(box);
}

void Viewport::flyTo(const Camera& camera)
{
    d->settings->orthographic.set(camera.orthographic);
    moveCamera(camera);
}

void Viewport::steer(const std::function<void(Camera&)>& change)
{
    Camera to = d->flight.goal();
    change(to);
    moveCamera(to);
}

void Viewport::showDefect(NodeId node, const DefectPlace& place)
{
    d->defect.show(place);
    Box box; // of the node, world
    for (const MeshItem& item : d->scene->meshes)
        if (item.node == node)
            box.add(item.box.transformed(item.world));
    const TreeResult* tree = d->resultOf(node);
    const double reach = defectReach(place, tree ? tree->simplified.get() : nullptr,
                                     EvaluatedScene(d->document->scene()).transforms(node).geometry, box);
    moveCamera(defectView(*d->scene, place, reach, d->camera(), double(width()) / std::max(1, height()),
                          d->settings->groundVisible()));
    update();
}

void Viewport::clearDefect()
{
    if (d->defect.clear())
        update();
}

void Viewport::clearSelection()
{
    clearDefect();
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
