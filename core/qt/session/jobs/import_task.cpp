#include "core/qt/session/jobs/import_task.h"

#include "core/qt/document/commands.h"
#include "core/qt/session/jobs/planting.h"
#include "core/scene/world_transforms.h"

#include <QFile>
#include <algorithm>
#include <optional>

namespace ramure {

ImportTask::ImportTask(Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&m_job, &Job::progress, this, &ImportTask::progress);
}

void ImportTask::start(const QString& path)
{
    if (isRunning())
        return;
    m_isScene = false;
    read(path);
}

void ImportTask::startScene(const QString& path)
{
    if (isRunning())
        return;
    m_isScene = true;
    read(path);
}

void ImportTask::read(const QString& path)
{
    m_job.start([file = QFile::encodeName(path).toStdString()](
                    const Progress& progress) { return importObjects(file, {}, progress); },
                [this](Expected<BlenderImport>&& result) { finish(std::move(result)); });
}

void ImportTask::finish(Expected<BlenderImport>&& result)
{
    Expected<NodeId> top = noNode;
    m_movedBy = 0.0;
    if (!result)
        top = fail(result.error());
    else
        top = m_isScene ? keep(*result) : apply(*result);
    if (top)
        m_notes = std::move(result->notes);
    emit finished(top ? *top : noNode, top ? std::nullopt : std::optional(top.error()));
}

/// The frames grow so that all keys can be played; the rate becomes that of the keys where nothing else has
/// any.
static TimelineSettings timelineFor(const Scene& scene, const TimelineSettings& wanted)
{
    TimelineSettings timeline = scene.timeline();
    const double seconds = wanted.timeOf(wanted.lastFrame);
    if (!hasTracks(scene))
        timeline.framesPerSecond = wanted.framesPerSecond;
    timeline.firstFrame = std::min(timeline.firstFrame, wanted.firstFrame);
    timeline.lastFrame = std::max(timeline.lastFrame, timeline.frameAt(seconds));
    return timeline;
}

Expected<NodeId> ImportTask::apply(const BlenderImport& result)
{
    const TimelineSettings timeline = timelineFor(m_document->scene(), result.timeline);
    const std::vector<NodeId> before = m_document->scene().children(noNode);
    std::optional<OneStep> step(std::in_place, *m_document,
                                tr("Import %1").arg(QString::fromStdString(result.nodes.front().name)));
    auto top = edit::insertNodes(*m_document, result.nodes, noNode,
                                 static_cast<int>(m_document->scene().children(noNode).size()));
    if (top && result.keyCount > 0)
        if (auto set = edit::setTimeline(*m_document, timeline); !set)
            top = fail(std::move(set.error()));
    step.reset();
    if (!top || m_stays)
        return top;
    std::vector<NodeId> added = m_document->scene().children(noNode);
    std::erase_if(added, [&](NodeId id) { return std::ranges::find(before, id) != before.end(); });
    const auto moved = edit::moveBeside(*m_document, added);
    m_movedBy = moved.value_or(0.0);
    return top;
}

Expected<NodeId> ImportTask::keep(const BlenderImport& result)
{
    auto scene = Scene::fromNodes(result.nodes);
    RAMURE_TRY(scene);
    if (result.keyCount > 0)
        scene->setTimeline(result.timeline);
    m_scene = std::move(*scene);
    return m_scene.nodes().front().id;
}

} // namespace ramure

#include "moc_import_task.cpp"
