#include "core/qt/session/jobs/scatter_watch.h"

#include <algorithm>

namespace ramure {

ScatterWatch::ScatterWatch(Document* document, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_job(nullptr, Job::Manner::Polite)
{
    connect(document, &Document::changed, this, &ScatterWatch::follow);
    follow({});
}

std::optional<std::size_t> ScatterWatch::count(NodeId scatter) const
{
    const auto known = m_known.find(scatter);
    return known == m_known.end() ? std::nullopt : known->second.count;
}

void ScatterWatch::follow(const Change& change)
{
    constexpr auto news = changeSelection | changeResults; // they move nothing
    if (change.kinds != 0 && (change.kinds & ~news) == 0)
        return;
    const Scene& scene = m_document->scene();
    std::map<NodeId, Known> known;
    bool isNew = false;
    for (const Node& node : scene.nodes()) {
        if (node.kind != NodeKind::Scatter)
            continue;
        const std::uint64_t hash = scatterHash(scene, node);
        const auto before = m_known.find(node.id);
        const bool isSame = before != m_known.end() && before->second.hash == hash;
        known[node.id] = isSame ? before->second : Known{hash, std::nullopt};
        isNew = isNew || !isSame;
    }
    m_known = std::move(known);
    if (!isNew)
        return;
    m_job.start(
        [scene, memory = m_memory](const Progress& progress) -> Expected<Found> {
            Found found;
            for (const Node& node : scene.nodes())
                if (node.kind == NodeKind::Scatter)
                    found.emplace_back(node.id, memory->places(scene, node, progress));
            return found;
        },
        [this, revision = m_document->revision()](const Expected<Found>& found) {
            if (found)
                take(*found, revision);
        });
}

void ScatterWatch::take(const Found& found, quint64 revision)
{
    for (const auto& [id, places] : found) {
        const auto known = m_known.find(id);
        if (known == m_known.end() || (!places && places.error().code == ErrorCode::Cancelled))
            continue;
        NodeResult result;
        result.revision = revision;
        if (!places)
            result.error = places.error();
        else if (prototypesOf(m_document->scene(), id).empty())
            result.error =
                fail(ErrorCode::Invalid,
                     RAMURE_NOOP("there is nothing to copy yet: drag trees or shapes below the scatter"))
                    .value();
        known->second.count = places ? std::optional((*places)->size()) : std::nullopt;
        m_document->setResult(id, std::move(result));
        emit counted(id);
    }
}

} // namespace ramure

#include "moc_scatter_watch.cpp"
