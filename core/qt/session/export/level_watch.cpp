#include "core/qt/session/export/level_watch.h"

#include "core/evaluate/evaluator.h"
#include "core/qt/session/export/level_export.h"
#include "core/qt/session/jobs/job.h"
#include "core/rig/physics/animated_physics.h"
#include <QTimer>
#include <algorithm>
#include <optional>
#include <utility>

namespace ramure {

using LevelsPointer = std::shared_ptr<const TreeLevels>;

/// What levels are made of. Where the node stands is no part of it.
struct LevelRequest
{
    NodeId node = noNode;
    LevelOptions options;
    TreeResult result;  ///< of the document
    NodeParams params;  ///< at 0 s
    bool moves = false; ///< the result is of other parameters: the shape has tracks
    double scale = 1.0;

    [[nodiscard]] bool isLike(const LevelRequest& other) const
    {
        NodeParams placed = other.params;
        placed.tree = params.tree;
        placed.local = params.local;
        return node == other.node && options.makesLike(other.options) && scale == other.scale &&
               result.branches == other.result.branches && result.leaves == other.result.leaves &&
               result.apples == other.result.apples && moves == other.moves && placed == params;
    }
};

namespace {

Box boxOf(const TreeResult& tree)
{
    Box box;
    const TriangleMesh* meshes[] = {tree.branches ? &tree.branches->mesh : nullptr, tree.leaves.get(),
                                    tree.apples.get()};
    for (const TriangleMesh* mesh : meshes)
        if (mesh)
            for (const glm::vec3& p : mesh->positions)
                box.add(glm::dvec3(p));
    return box;
}

Expected<LevelsPointer> madeLevels(const LevelRequest& of, const LevelWatch::Function& make,
                                   const Progress& progress)
{
    auto out = std::make_shared<TreeLevels>();
    out->params = of.params;
    out->whole = of.result;
    out->scale = of.scale;
    if (of.moves) {
        auto grown = TreePipeline().evaluate(of.params, Stage::Foliage, progress.part(0.0, 0.3));
        RAMURE_TRY(grown);
        out->whole = std::move(*grown);
    }
    auto levels = make(out->whole, of.params, of.options, progress.part(of.moves ? 0.3 : 0.0, 1.0));
    RAMURE_TRY(levels);
    out->levels = std::move(*levels);
    out->switches = switchesOf(out->levels, of.options, of.scale);
    out->box = boxOf(out->whole);
    return LevelsPointer(std::move(out));
}

} // namespace

std::size_t TreeLevels::levelAt(double distance) const
{
    const std::vector<double>& from = switches.distances;
    const auto next = std::upper_bound(from.begin(), from.end(), distance);
    return next == from.begin() ? 0 : static_cast<std::size_t>(next - from.begin()) - 1;
}

struct LevelWatch::Private
{
    Private(LevelWatch* watch, Document* doc, Function work)
        : q(watch)
        , document(doc)
        , function(std::move(work))
    {
    }

    [[nodiscard]] NodeId treeMeant() const;
    [[nodiscard]] LevelRequest request() const;
    void look();
    void forget();
    void launch();
    void take(Expected<LevelsPointer>&& got);
    void takeSwitches();
    void stopWith(State next);
    void refuse(const Error& why);
    void set(State next);

    LevelWatch* q;
    Document* document;
    Function function;
    LevelOptions options{3, {}};
    bool active = false;
    NodeId tree = noNode;
    State state = State::None;
    Error error;
    LevelsPointer levels;
    std::optional<LevelRequest> looked; ///< what was asked for last
    std::optional<LevelRequest> made;   ///< what the levels are of
    QTimer rest;
    Job job{nullptr, Job::Manner::Polite};
};

LevelWatch::LevelWatch(Document* document, QObject* parent)
    : LevelWatch(
          document,
          [](const TreeResult& tree, const NodeParams& params, const LevelOptions& options,
             const Progress& progress) {
              // Their figures are the same without texture coordinates, which take their time.
              return treeLevels(tree, params, options, {true, true, true, false}, progress);
          },
          parent)
{
}

LevelWatch::LevelWatch(Document* document, Function function, QObject* parent)
    : QObject(parent)
    , d(std::make_unique<Private>(this, document, std::move(function)))
{
    d->rest.setSingleShot(true);
    d->rest.setInterval(300);
    connect(&d->rest, &QTimer::timeout, this, [this] { d->launch(); });
    connect(&d->job, &Job::progress, this, &LevelWatch::progress);
    connect(document, &Document::changed, this, [this](const Change& change) {
        if (change.has(changeReset)) // nodes of another document may have the same ids
            d->forget();
        d->look();
    });
}

LevelWatch::~LevelWatch() = default;

void LevelWatch::setActive(bool on)
{
    if (std::exchange(d->active, on) == on)
        return;
    if (on)
        return d->look();
    if (d->state == State::Waiting || d->state == State::Running) {
        d->looked.reset(); // begun anew when somebody looks again
        d->stopWith(State::None);
    }
}

void LevelWatch::setOptions(const LevelOptions& options)
{
    d->options = options;
    if (d->levels && checkLevels(options))
        d->takeSwitches();
    d->look();
}

const LevelOptions& LevelWatch::options() const
{
    return d->options;
}

NodeId LevelWatch::tree() const
{
    return d->tree;
}

LevelWatch::State LevelWatch::state() const
{
    return d->state;
}

std::shared_ptr<const TreeLevels> LevelWatch::levels() const
{
    return d->levels;
}

const Error& LevelWatch::error() const
{
    return d->error;
}

void LevelWatch::setRest(int milliseconds)
{
    d->rest.setInterval(std::max(0, milliseconds));
}

void LevelWatch::cancel()
{
    if (d->state == State::Waiting || d->state == State::Running)
        d->stopWith(State::Cancelled);
}

void LevelWatch::start()
{
    if (d->state == State::Cancelled || d->state == State::Waiting)
        d->launch();
}

NodeId LevelWatch::Private::treeMeant() const
{
    const Scene& scene = document->scene();
    const auto isTree = [&scene](NodeId id) {
        const Node* node = scene.find(id);
        return node && node->kind == NodeKind::Tree;
    };
    const Selection& selection = document->selection();
    for (const NodeId id : {selection.activeNode(), selection.branchNode})
        if (isTree(id))
            return id;
    for (const NodeId id : selection.nodes)
        if (isTree(id))
            return id;
    NodeId only = noNode;
    if (!selection.nodes.empty())
        return noNode;
    for (const Node& node : scene.nodes())
        if (node.kind == NodeKind::Tree) {
            if (only != noNode)
                return noNode;
            only = node.id;
        }
    return only;
}

/// \pre the tree's result is there
LevelRequest LevelWatch::Private::request() const
{
    const Node& node = *document->scene().find(tree);
    EvaluatedScene now(document->scene());
    return {tree,
            options,
            document->result(tree)->tree,
            now.params(node),
            movesShape(node.animation),
            nodeScale(now, tree)};
}

/// Waits for a rest where something is another than what was looked at.
void LevelWatch::Private::look()
{
    if (!active) {
        if (tree != noNode && !document->scene().find(tree))
            forget(); // large meshes are not kept for nobody
        return;
    }
    if (const NodeId meant = treeMeant(); meant != tree) {
        tree = meant;
        levels.reset();
        looked.reset();
        made.reset();
        emit q->changed();
    }
    if (tree == noNode)
        return stopWith(State::None);
    if (const auto fine = checkLevels(options); !fine)
        return refuse(fine.error());
    if (const Error* problem = document->problem(tree))
        return refuse(*problem);
    if (!document->isCurrent(tree))
        return stopWith(State::Growing);
    LevelRequest now = request();
    if (levels && made && made->isLike(now)) {
        rest.stop();
        job.forget();
        return set(State::Done);
    }
    const bool isAsked = state == State::Waiting || state == State::Running || state == State::Cancelled ||
                         state == State::Failed;
    if (isAsked && looked && looked->isLike(now))
        return;
    looked = std::move(now);
    job.forget();
    rest.start();
    set(State::Waiting);
}

void LevelWatch::Private::forget()
{
    tree = noNode;
    looked.reset();
    made.reset();
    stopWith(State::None);
}

void LevelWatch::Private::launch()
{
    if (!looked)
        return;
    rest.stop();
    job.start(
        [of = *looked, make = function](const Progress& progress) { return madeLevels(of, make, progress); },
        [this](Expected<LevelsPointer>&& got) { take(std::move(got)); });
    set(State::Running);
}

void LevelWatch::Private::take(Expected<LevelsPointer>&& got)
{
    if (got) {
        levels = std::move(*got);
        made = looked;
        takeSwitches(); // they may have changed by now
        return set(State::Done);
    }
    levels.reset();
    error = std::move(got.error());
    set(State::Failed);
}

/// The meshes are the same, whenever they are shown.
void LevelWatch::Private::takeSwitches()
{
    if (levels->levels.size() != static_cast<std::size_t>(options.total()))
        return; // others are being made
    auto with = std::make_shared<TreeLevels>(*levels);
    with->switches = switchesOf(with->levels, options, with->scale);
    levels = std::move(with);
    if (state == State::Done)
        emit q->changed();
}

void LevelWatch::Private::stopWith(State next)
{
    rest.stop();
    job.forget();
    if (next == State::None)
        levels.reset();
    set(next);
}

/// What the options, or the tree, do not allow is not even begun.
void LevelWatch::Private::refuse(const Error& why)
{
    rest.stop();
    job.forget();
    looked.reset();
    levels.reset();
    const bool isNew = error.message() != why.message();
    error = why;
    if (state == State::Failed && isNew)
        emit q->changed();
    set(State::Failed);
}

void LevelWatch::Private::set(State next)
{
    if (std::exchange(state, next) != next)
        emit q->changed();
}

} // namespace ramure
