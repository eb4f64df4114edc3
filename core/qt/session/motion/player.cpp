#include "core/qt/session/motion/player.h"

#include "core/qt/session/jobs/job.h"
#include "core/qt/session/motion/baker.h"
#include "core/qt/session/motion/motion_worker.h"
#include "core/rig/physics/animated_physics.h"

#include <QDeadlineTimer>
#include <QElapsedTimer>
#include <QFile>
#include <QPointer>
#include <QTimer>
#include <algorithm>

namespace ramure {

struct Player::Private
{
    Private(Player* player, Document* doc)
        : q(player)
        , document(doc)
    {
        worker = std::make_shared<MotionWorker>(listener());
    }

    MotionWorker::Listener listener();
    void documentChanged(const Change& change);
    void tick();
    void setFrame(std::int64_t next);
    void request(bool interrupt);
    void take(std::shared_ptr<const MotionFrame> made);
    void rewindClock();
    void worked(const Expected<void>& done);
    void stopWork();
    void setBusy(bool now);
    void findBakes();
    [[nodiscard]] bool isAtRest() const
    {
        return frame <= 0 && motion->nodes.empty() && !playing && bakes.isEmpty();
    }
    [[nodiscard]] const TimelineSettings& timeline() const { return document->scene().timeline(); }
    [[nodiscard]] std::vector<MotionTree> trees(const Scene& scene);
    [[nodiscard]] bool movesAsAsked(NodeId tree) const;

    Player* q;
    Document* document;
    QTimer ticks;
    QTimer busyRest;
    QElapsedTimer clock;
    bool playing = false, busy = false;
    double travelled = 0.0; ///< frames since the first one, while playing
    std::int64_t frame = 0, dropped = 0;
    double speed = 1.0;
    PlayPace pace = PlayPace::RealTime;
    std::size_t memoryBytes = std::size_t(1) << 30;
    bool forgetHand = false;
    bool wanted = false; ///< another frame was asked for while one was computed
    std::map<NodeId, std::optional<Pull>> pulls;
    std::map<NodeId, std::vector<Index>> shaken;
    std::shared_ptr<const Scene> scene; ///< the document's, copied once per change; null: it is another one
    std::shared_ptr<const MotionFrame> motion = std::make_shared<const MotionFrame>();
    std::vector<FrameRange> band;
    QString project;   ///< the file beside which was looked for baked motion
    QStringList bakes; ///< what was found there
    int bakeVersion = 0;
    int documents = 0; ///< opened so far
    BakeState bakeState = BakeState::None;
    std::shared_ptr<MotionWorker> worker;       ///< only the thread uses it
    std::shared_ptr<const MotionRequest> asked; ///< last; null: nothing yet of this document
    Job job;
};

/// From the worker's thread into the interface's.
MotionWorker::Listener Player::Private::listener()
{
    const Job::Mailbox post = job.mailbox();
    return {
        [this, post](std::shared_ptr<const MotionFrame> made) { post([this, made] { take(made); }); },
        [this, post](int of, std::vector<FrameRange> made) {
            post([this, of, kept = std::move(made)] {
                if (of != documents || band == kept)
                    return;
                band = kept;
                emit q->bandChanged();
            });
        },
        [this, post](const Error& error) { post([this, error] { emit q->failed(error); }); },
        [this, post](const Error& error) { post([this, error] { emit q->bakeRefused(error); }); },
        [this, post](BakeState state) {
            post([this, state] {
                if (std::exchange(bakeState, state) != state)
                    emit q->bakeStateChanged(state);
            });
        },
    };
}

Player::Player(Document* document, QObject* parent)
    : QObject(parent)
    , d(std::make_unique<Private>(this, document))
{
    d->frame = document->scene().timeline().firstFrame;
    d->ticks.setTimerType(Qt::PreciseTimer);
    connect(&d->ticks, &QTimer::timeout, this, [this] { d->tick(); });
    connect(&d->job, &Job::progress, this, &Player::progress);
    d->busyRest.setSingleShot(true);
    d->busyRest.setInterval(150);
    connect(&d->busyRest, &QTimer::timeout, this, [this] { d->setBusy(d->job.isRunning()); });
    connect(document, &Document::changed, this, [this](const Change& change) { d->documentChanged(change); });
    if (hasTracks(document->scene()))
        d->request(true);
}

Player::~Player() = default;

bool Player::isPlaying() const
{
    return d->playing;
}

std::int64_t Player::frame() const
{
    return d->frame;
}

double Player::timeSeconds() const
{
    return d->timeline().timeOf(d->frame);
}

std::shared_ptr<const MotionFrame> Player::motion() const
{
    return d->motion;
}

const std::vector<FrameRange>& Player::band() const
{
    return d->band;
}

bool Player::isBusy() const
{
    return d->job.isRunning();
}

double Player::speed() const
{
    return d->speed;
}

PlayPace Player::pace() const
{
    return d->pace;
}

std::int64_t Player::droppedFrames() const
{
    return d->dropped;
}

void Player::setSpeed(double factor)
{
    const double next = factor >= leastSpeed ? std::min(factor, mostSpeed) : leastSpeed;
    if (next == d->speed)
        return;
    d->speed = next;
    emit settingsChanged();
}

void Player::setPace(PlayPace pace)
{
    if (pace == d->pace)
        return;
    d->pace = pace;
    emit settingsChanged();
}

void Player::setMemoryLimit(std::size_t bytes)
{
    if (std::exchange(d->memoryBytes, bytes) != bytes && !d->isAtRest())
        d->request(false);
}

std::size_t Player::memoryLimit() const
{
    return d->memoryBytes;
}

BakeState Player::bakeState() const
{
    return d->bakeState;
}

void Player::reloadBakes()
{
    const bool had = !d->bakes.isEmpty();
    d->findBakes();
    if (had || !d->bakes.isEmpty())
        d->request(false);
}

void Player::setPull(NodeId node, const std::optional<Pull>& pull)
{
    if (pull)
        d->pulls[node] = pull;
    else
        d->pulls.erase(node);
}

void Player::shakeOff(NodeId node, Index apple)
{
    if (d->playing)
        d->shaken[node].push_back(apple);
}

bool Player::waitForIdle(int timeoutMs)
{
    const QDeadlineTimer end(timeoutMs);
    while (isBusy() && d->job.wait(std::chrono::milliseconds(end.remainingTime())))
        continue; // another frame was wanted meanwhile
    return !isBusy();
}

void Player::play()
{
    if (d->playing)
        return;
    const TimelineSettings& timeline = d->timeline();
    const bool outside = d->frame < timeline.firstFrame || d->frame > timeline.lastFrame;
    const bool atEnd = timeline.loop == PlayLoop::Once && d->frame == timeline.lastFrame;
    if (outside || atEnd)
        d->setFrame(timeline.firstFrame);
    d->playing = true;
    d->dropped = 0;
    d->rewindClock();
    d->ticks.start(4);
    emit playingChanged(true);
}

void Player::pause()
{
    if (!d->playing)
        return;
    d->ticks.stop();
    d->playing = false;
    d->pulls.clear();
    emit playingChanged(false);
}

void Player::stop()
{
    pause();
    d->forgetHand = true;
    d->shaken.clear();
    d->setFrame(d->timeline().firstFrame);
    d->request(true);
}

void Player::seek(qint64 frame)
{
    const auto next = std::clamp<std::int64_t>(frame, leastFrame, mostFrame);
    if (next == d->frame)
        return;
    d->setFrame(next);
    d->request(!d->playing);
    d->rewindClock();
}

void Player::cancel()
{
    pause();
    d->stopWork();
}

void Player::Private::findBakes()
{
    project = document->filePath();
    bakes = bakeFiles(project);
    ++bakeVersion;
}

void Player::Private::rewindClock()
{
    travelled = double(frame - timeline().firstFrame);
    clock.restart();
}

void Player::Private::setFrame(std::int64_t next)
{
    if (next == frame)
        return;
    frame = next;
    emit q->frameChanged(frame);
}

/// The clock adds up seconds, never counts ticks (ANIMATION 4.9).
void Player::Private::tick()
{
    if (pace == PlayPace::EveryFrame && job.isRunning())
        return; // the next frame's time begins when this one is there
    const double seconds = std::min(double(clock.nsecsElapsed()) * 1e-9, mostSecondsAtOnce);
    const double ahead = seconds * timeline().framesPerSecond * speed;
    if (pace == PlayPace::EveryFrame && ahead < 1.0)
        return;
    clock.restart();
    travelled += pace == PlayPace::EveryFrame ? 1.0 : ahead;
    const PlayPlace place = playedFrame(timeline(), travelled);
    if (place.frame != frame) {
        if (pace == PlayPace::RealTime && place.frame > frame)
            dropped += place.frame - frame - 1;
        setFrame(place.frame);
        // The sketch of a later frame comes before the whole tree of this one.
        request(pace == PlayPace::RealTime && isSketch(*motion) && asked && motion->frame == asked->frame);
    }
    if (place.ended)
        q->pause();
}

/// Trees without a mesh, and hidden ones, have nothing to move.
std::vector<MotionTree> Player::Private::trees(const Scene& of)
{
    std::vector<MotionTree> list;
    for (const Node& node : of.nodes()) {
        const NodeResult* result = node.kind == NodeKind::Tree ? document->result(node.id) : nullptr;
        if (!result || !result->tree.branches || !result->tree.simplified || !of.isShown(node.id))
            continue;
        MotionTree tree;
        tree.node = &node;
        tree.tree = result->tree;
        if (const QString file = bakeFile(document->filePath(), node.id); bakes.contains(file)) {
            tree.bakeFile = QFile::encodeName(file).toStdString();
            tree.bakeVersion = bakeVersion;
        }
        if (const auto pull = pulls.find(node.id); pull != pulls.end())
            tree.pull = pull->second;
        if (const auto apples = shaken.find(node.id); apples != shaken.end())
            tree.shaken = std::move(apples->second);
        list.push_back(std::move(tree));
    }
    shaken.clear();
    return list;
}

static std::vector<const Node*> armsOf(const Scene& scene)
{
    std::vector<const Node*> list;
    for (const Node& node : scene.nodes())
        if (node.kind == NodeKind::Arm && scene.isShown(node.id))
            list.push_back(&node);
    return list;
}

/// A check that is through has changed the report of a tree, not how it moves.
bool Player::Private::movesAsAsked(NodeId tree) const
{
    const NodeResult* result = document->result(tree);
    const auto isSame = [&](const MotionTree& one) {
        const TreeResult &before = one.tree, &now = result->tree;
        return one.node->id == tree && before.simplified == now.simplified &&
               before.branches == now.branches && before.foliage == now.foliage &&
               before.leaves == now.leaves && before.apples == now.apples;
    };
    return asked && result && std::ranges::any_of(asked->trees, isSame);
}

/// One frame at a time: while one is computed, the newest wish waits here, where the hand may still change
/// it.
void Player::Private::request(bool interrupt)
{
    if (job.isRunning() && !interrupt) {
        wanted = true;
        return;
    }
    wanted = false;
    MotionRequest next;
    next.frame = frame;
    next.document = documents;
    next.timeline = timeline();
    if (!scene)
        scene = std::make_shared<const Scene>(document->scene());
    next.scene = scene;
    next.trees = trees(*scene);
    next.arms = armsOf(*scene);
    next.memoryBytes = memoryBytes;
    next.live = playing;
    next.sketches = !playing || pace == PlayPace::RealTime;
    next.forgetHand = std::exchange(forgetHand, false);
    if (!busyRest.isActive())
        busyRest.start();
    if (job.withdraw())
        takeOverHand(next, *asked);
    if (interrupt)
        job.cancel(); // what it computed is kept
    asked = std::make_shared<const MotionRequest>(std::move(next));
    job.start(
        [with = worker, what = asked](const Progress& progress) {
            with->run(*what, progress);
            return Expected<void>();
        },
        [this](const Expected<void>& done) { worked(done); }, Job::Running::GoesOn);
}

void Player::Private::take(std::shared_ptr<const MotionFrame> made)
{
    if (made->document != documents)
        return;
    motion = std::move(made);
    emit q->motionChanged();
}

/// A request is through; the frame it made has come before.
void Player::Private::worked(const Expected<void>& done)
{
    if (!done) // out of memory
        emit q->failed(done.error());
    if (job.isRunning())
        return; // a later one
    setBusy(false);
    if (wanted)
        request(false);
}

/// What waited is gone and nobody will tell of it; what still runs says when it ends.
void Player::Private::stopWork()
{
    wanted = false;
    job.withdraw();
    job.cancel();
    if (!job.isRunning())
        setBusy(false);
}

void Player::Private::setBusy(bool now)
{
    if (!now)
        busyRest.stop();
    if (now == busy)
        return;
    busy = now;
    emit q->busyChanged(busy);
}

/// What the document says about shapes and physics is of use only where something moves.
void Player::Private::documentChanged(const Change& change)
{
    if (change.has(~(changeSelection | changeResults | changeFile)))
        scene.reset();
    if (change.has(changeReset)) {
        q->pause();
        stopWork();
        ++documents;
        asked.reset();
        pulls.clear();
        shaken.clear();
        forgetHand = true;
        motion = std::make_shared<const MotionFrame>();
        band.clear();
        setFrame(timeline().firstFrame);
        findBakes();
        emit q->motionChanged();
        emit q->bandChanged();
        if (std::exchange(bakeState, BakeState::None) != BakeState::None)
            emit q->bakeStateChanged(bakeState);
        if (hasTracks(document->scene()))
            request(true);
        return;
    }
    if (change.has(changeFile) && project != document->filePath())
        q->reloadBakes();
    if (change.has(changeTimeline) && playing)
        rewindClock();
    const bool physics = change.has(changeParams) && change.firstStale == Stage::Motion;
    const bool placed = change.has(changeParams | changeTracks | changeStructure) &&
                        (!motion->transforms.empty() || hasTracks(document->scene()));
    if (placed)
        return request(!playing);
    const bool shapes = change.has(changeResults) && !std::ranges::all_of(change.nodes, [this](NodeId tree) {
                            return movesAsAsked(tree);
                        });
    // Tracks that shape a tree do so at the first frame as well.
    const bool isShaped = shapes && std::ranges::any_of(document->scene().nodes(), [](const Node& node) {
                              return node.kind == NodeKind::Tree && movesShape(node.animation);
                          });
    if ((!isAtRest() || isShaped) &&
        (physics || shapes ||
         change.has(changeStructure | changeNodeState | changeTimeline | changeJoints | changeTracks)))
        request(!playing);
}

} // namespace ramure

#include "moc_player.cpp"
