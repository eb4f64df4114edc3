#include "core/qt/session/jobs/shape_checks.h"

#include "core/qt/session/jobs/job.h"
#include "core/scene/object_mesh.h"
#include <QTimer>
#include <optional>

namespace ramure {
namespace {

Expected<ShapeCheck> checkAtRest(const Node& node, const Progress& progress)
{
    return checkShapeAtRest(node, true, progress);
}

/// Does the check of one hold for the other too? Where a node stands and what it is called does not count.
bool checksAlike(const Node& a, const Node& b)
{
    NodeParams placed = a.params;
    placed.tree = b.params.tree;
    placed.local = b.params.local;
    placed.surface = b.params.surface;
    return a.id == b.id && a.kind == b.kind && placed == b.params && a.animation == b.animation &&
           a.mesh.pointer() == b.mesh.pointer();
}

/// As the panels know meshes. A boundary is no defect of an open surface.
std::shared_ptr<const ShapeChecks::Outcome> outcomeOf(ShapeCheck&& check)
{
    auto outcome = std::make_shared<ShapeChecks::Outcome>();
    auto branches = std::make_shared<BranchMesh>();
    branches->mesh.positions = check.mesh->positions;
    branches->mesh.triangles = check.mesh->triangles;
    branches->roots = check.report.components;
    auto report = std::make_shared<MeshReport>(std::move(check.report));
    outcome->isOpen = check.isOpen;
    if (check.isOpen) {
        report->boundaryEdges = 0;
        std::erase_if(report->defects,
                      [](const Defect& defect) { return defect.kind == DefectKind::BoundaryEdge; });
        // OpenMesh is asked for a closed mesh: its refusal says nothing here.
        report->openMeshChecked = report->openMeshAgrees = false;
    }
    outcome->result.tree.report = std::move(report);
    outcome->result.tree.branches = std::move(branches);
    outcome->analysis = std::make_shared<const MeshAnalysis>(std::move(check.analysis));
    return outcome;
}

} // namespace

struct ShapeChecks::Private
{
    explicit Private(ShapeChecks* checks, Document* doc, Function work)
        : q(checks)
        , document(doc)
        , function(std::move(work))
    {
    }

    void look();
    void launch();
    void take(Expected<std::shared_ptr<const Outcome>>&& made);
    void set(State next);

    ShapeChecks* q;
    Document* document;
    Function function;
    NodeId node = noNode;
    State state = State::None;
    double fraction = 0.0;
    std::optional<Node> looked; ///< the node as it was when its check began
    std::shared_ptr<const Outcome> outcome;
    QTimer rest;
    Job job;
};

ShapeChecks::ShapeChecks(Document* document, QObject* parent)
    : ShapeChecks(document, &checkAtRest, parent)
{
}

ShapeChecks::ShapeChecks(Document* document, Function function, QObject* parent)
    : QObject(parent)
    , d(std::make_unique<Private>(this, document, std::move(function)))
{
    d->rest.setSingleShot(true);
    d->rest.setInterval(150);
    connect(&d->rest, &QTimer::timeout, this, [this] { d->launch(); });
    connect(&d->job, &Job::progress, this, [this](double fraction) {
        d->fraction = fraction;
        emit progress(d->node, fraction);
    });
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeReset))
            d->looked.reset();
        d->look();
    });
}

ShapeChecks::~ShapeChecks() = default;

NodeId ShapeChecks::node() const
{
    return d->node;
}

ShapeChecks::State ShapeChecks::state() const
{
    return d->state;
}

std::shared_ptr<const ShapeChecks::Outcome> ShapeChecks::outcome() const
{
    return d->outcome;
}

double ShapeChecks::fraction() const
{
    return d->fraction;
}

void ShapeChecks::setRest(int milliseconds)
{
    d->rest.setInterval(std::max(0, milliseconds));
}

void ShapeChecks::lookAt(NodeId node)
{
    if (node != d->node) {
        d->node = node;
        d->outcome.reset();
        d->looked.reset();
    }
    d->look();
}

void ShapeChecks::cancel()
{
    d->rest.stop();
    d->job.forget();
    if (d->state == State::Waiting || d->state == State::Running)
        d->set(State::Cancelled);
}

void ShapeChecks::start()
{
    if (d->state != State::Cancelled && d->state != State::Waiting)
        return;
    d->rest.stop();
    d->launch();
}

/// Waits for a check where the shape is another one than the one that was looked at.
void ShapeChecks::Private::look()
{
    const Node* now = document->scene().find(node);
    if (!now || !isShape(now->kind)) {
        rest.stop();
        job.forget();
        outcome.reset();
        looked.reset();
        if (state != State::None)
            set(State::None);
        return;
    }
    if (looked && checksAlike(*looked, *now))
        return;
    looked = *now;
    job.forget();
    rest.start();
    set(State::Waiting);
}

void ShapeChecks::Private::launch()
{
    if (!looked)
        return;
    set(State::Running);
    job.start(
        [work = function,
         node = *looked](const Progress& progress) -> Expected<std::shared_ptr<const Outcome>> {
            auto check = work(node, progress);
            RAMURE_TRY(check);
            return outcomeOf(std::move(*check));
        },
        [this](Expected<std::shared_ptr<const Outcome>>&& made) { take(std::move(made)); });
}

void ShapeChecks::Private::take(Expected<std::shared_ptr<const Outcome>>&& made)
{
    if (made) {
        outcome = std::move(*made);
    } else {
        auto failed = std::make_shared<Outcome>();
        failed->result.error = std::move(made.error());
        outcome = std::move(failed);
    }
    set(State::Done);
}

void ShapeChecks::Private::set(State next)
{
    state = next;
    fraction = 0.0;
    emit q->changed(node);
}

} // namespace ramure

#include "moc_shape_checks.cpp"
