#include "widgets/view/gizmo_trail.h"

#include "core/scene/world_transforms.h"
#include "widgets/view/tools/gizmo/gizmo_handles.h"
#include <QPainter>
#include <algorithm>
#include <set>

namespace ramure {
namespace {

constexpr glm::u8vec4 shade{18, 24, 30, 130}; ///< under the line: it is seen on any ground
constexpr glm::u8vec4 ink{255, 224, 130, 255};
constexpr glm::u8vec4 keyInk{255, 170, 40, 255};
constexpr std::size_t mostDots = 2000;

/// Colder the further before, warmer the further behind; fainter with the distance.
glm::u8vec4 ghostColour(int place, int count)
{
    const double far = count > 1 ? double(std::abs(place) - 1) / (count - 1) : 0.0;
    const glm::dvec3 cold = glm::mix(glm::dvec3(120, 190, 255), glm::dvec3(40, 70, 230), far);
    const glm::dvec3 warm = glm::mix(glm::dvec3(255, 200, 110), glm::dvec3(235, 60, 30), far);
    const glm::dvec3 colour = place < 0 ? cold : warm;
    return {glm::u8vec3(colour), static_cast<std::uint8_t>(190.0 - 110.0 * far)};
}

/// Lines are thin: they are seen where a surface would be.
glm::u8vec4 lineColour(glm::u8vec4 colour)
{
    colour.a = static_cast<std::uint8_t>(std::min(255, colour.a + 70));
    return colour;
}

std::shared_ptr<const LineSet> linesOf(const MotionPath& path)
{
    auto lines = std::make_shared<LineSet>();
    lines->segments.reserve(2 * path.points.size());
    for (const auto& [colour, width] : {std::pair{shade, 4.2f}, std::pair{ink, 1.8f}})
        for (std::size_t i = 1; i < path.points.size(); ++i)
            lines->segments.push_back(
                {glm::vec3(path.points[i - 1]), glm::vec3(path.points[i]), width, width, colour, noIndex});
    for (const glm::dvec3& point : path.points)
        lines->box.add(point);
    return lines;
}

std::shared_ptr<const PointSet> pointsOf(const MotionPath& path)
{
    auto points = std::make_shared<PointSet>();
    const std::size_t step = std::max<std::size_t>(1, path.points.size() / mostDots);
    for (std::size_t i = 0; i < path.points.size(); i += step)
        points->points.push_back({glm::vec3(path.points[i]), 4.5f, ink, noIndex});
    for (const glm::dvec3& key : path.keys)
        for (const auto& [colour, size] : {std::pair{shade, 13.0f}, std::pair{keyInk, 10.0f}})
            points->points.push_back({glm::vec3(key), size, colour, noIndex});
    for (const PointMark& mark : points->points)
        points->box.add(glm::dvec3(mark.position));
    return points;
}

/// Its joints stand otherwise at other times.
bool turns(const Node& node)
{
    return node.kind == NodeKind::Arm && (node.animation.movesParams() || node.params.arm.follows);
}

/// The nodes and what is below them, where tracks move it.
std::vector<const Node*> copiedNodes(const Scene& scene, const std::vector<NodeId>& nodes)
{
    const std::set<NodeId> asked(nodes.begin(), nodes.end());
    std::set<NodeId> moving;
    std::vector<const Node*> copied;
    std::set<NodeId> below;
    for (const Node& node : scene.nodes()) {
        if (node.animation.movesNode() || moving.contains(node.parent))
            moving.insert(node.id);
        if (asked.contains(node.id) || below.contains(node.parent))
            below.insert(node.id);
        if (below.contains(node.id) && (moving.contains(node.id) || turns(node)) &&
            node.kind != NodeKind::Group && scene.isShown(node.id))
            copied.push_back(&node);
    }
    return copied;
}

/// Frames before and behind, those furthest away in time first: the nearer ones are drawn over them.
std::vector<int> ghostOrder(const GhostFrames& frames)
{
    std::vector<int> order;
    for (int far = std::max(frames.before, frames.after); far > 0; --far)
        for (const int place : {-far, far})
            if (place < 0 ? far <= frames.before : far <= frames.after)
                order.push_back(place);
    return order;
}

} // namespace

GizmoTrail::GizmoTrail(QObject* parent)
    : QObject(parent)
{
    connect(&m_arms, &ArmGhostMaker::changed, this, [this] {
        ++m_revision;
        emit changed();
    });
}

GizmoTrail::~GizmoTrail() = default;

void GizmoTrail::show(const Scene& scene, const std::vector<NodeId>& nodes, const GizmoSettings& how,
                      std::int64_t frame, bool still)
{
    showPaths(scene, nodes, how.showsPath());
    const bool had = !m_ghosts.empty();
    m_ghosts.clear();
    if (how.showsGhosts() && still)
        showGhosts(scene, nodes, how.ghostFrames(), frame);
    else
        m_arms.show({});
    if (had || !m_ghosts.empty()) {
        ++m_revision;
        emit changed();
    }
}

void GizmoTrail::clearPaths()
{
    m_work.forget();
    m_chains.clear();
    if (m_paths.empty())
        return;
    m_paths.clear();
    m_lines.clear();
    m_points.clear();
    ++m_revision;
    emit changed();
}

void GizmoTrail::showPaths(const Scene& scene, const std::vector<NodeId>& nodes, bool on)
{
    if (!on && m_chains.empty())
        return;
    std::vector<MotionChain> chains;
    for (std::size_t i = nodes.size(); on && i > 0 && chains.size() < mostPaths; --i)
        if (MotionChain chain = motionChain(scene, nodes[i - 1]); chain.moves())
            chains.push_back(std::move(chain));
    if (chains.empty())
        return clearPaths();
    if (chains == m_chains && scene.timeline() == m_timeline)
        return;
    m_chains = chains;
    m_timeline = scene.timeline();
    m_work.start([chains = std::move(chains), timeline = m_timeline](
                     const Progress& progress) -> Expected<Made> { return made(chains, timeline, progress); },
                 [this](Expected<Made>&& done) {
                     Made made = std::move(done).value_or(Made());
                     m_paths = std::move(made.paths);
                     m_lines = std::move(made.lines);
                     m_points = std::move(made.points);
                     ++m_revision;
                     emit changed();
                 });
}

GizmoTrail::Made GizmoTrail::made(const std::vector<MotionChain>& chains, const TimelineSettings& timeline,
                                  const Progress& progress)
{
    Made made;
    for (const MotionChain& chain : chains) {
        auto path = motionPath(chain, timeline, progress);
        if (!path)
            break; // stopped
        made.lines.push_back(linesOf(*path));
        made.points.push_back(pointsOf(*path));
        made.paths.push_back(std::make_shared<const MotionPath>(std::move(*path)));
    }
    return made;
}

void GizmoTrail::showGhosts(const Scene& scene, const std::vector<NodeId>& nodes, const GhostFrames& frames,
                            std::int64_t frame)
{
    std::vector<const Node*> copied = copiedNodes(scene, nodes);
    const auto count = std::size_t(frames.before + frames.after);
    if (copied.empty() || count == 0)
        return m_arms.show({});
    copied.resize(std::min(copied.size(), std::max<std::size_t>(1, mostCopies / count)));
    const TimelineSettings& timeline = scene.timeline();
    const auto geometries = [&](double seconds) {
        std::map<NodeId, glm::dmat4> worlds; // of parents: many nodes share them
        const std::function<glm::dmat4(NodeId)> worldOf = [&](NodeId id) -> glm::dmat4 {
            const Node* node = scene.find(id);
            if (!node)
                return glm::dmat4(1.0);
            if (const auto known = worlds.find(id); known != worlds.end())
                return known->second;
            return worlds[id] = worldUnder(worldOf(node->parent), *node, seconds);
        };
        std::vector<glm::dmat4> places;
        for (const Node* node : copied)
            places.push_back(geometryUnder(worldOf(node->id), *node, seconds));
        return places;
    };
    const auto now = geometries(timeline.timeOf(frame));
    std::map<NodeId, ArmGhosts> arms;
    for (std::size_t i = 0; i < copied.size(); ++i)
        if (copied[i]->kind == NodeKind::Arm)
            arms[copied[i]->id] = {*copied[i], timeline.timeOf(frame), now[i], {}};
    for (const int place : ghostOrder(frames)) {
        const std::int64_t at = frame + std::int64_t(place) * frames.step;
        if (at < timeline.firstFrame || at > timeline.lastFrame)
            continue;
        const auto then = geometries(timeline.timeOf(at));
        const auto colour = ghostColour(place, place < 0 ? frames.before : frames.after);
        for (std::size_t i = 0; i < copied.size(); ++i)
            if (copied[i]->kind == NodeKind::Arm)
                arms[copied[i]->id].copies.push_back({timeline.timeOf(at), then[i], lineColour(colour)});
            else if (!ArmGhostMaker::isNear(then[i], now[i]))
                m_ghosts.push_back({copied[i]->id, then[i], colour});
    }
    std::vector<ArmGhosts> wanted;
    for (auto& [id, ghosts] : arms)
        wanted.push_back(std::move(ghosts));
    m_arms.show(std::move(wanted));
}

void GizmoTrail::forgetSkeletons()
{
    if (m_ghosts.empty() || m_twigs.empty())
        return;
    ++m_revision;
    emit changed();
}

std::shared_ptr<const LineSet> GizmoTrail::twigs(const std::shared_ptr<const SimplifiedSkeleton>& of,
                                                 const glm::u8vec4& colour)
{
    for (Twigs& known : m_twigs)
        if (known.of == of && known.colour == colour) {
            known.used = true;
            return known.lines;
        }
    const Skeleton& skeleton = of->skeleton;
    double least = 0.0;
    if (skeleton.size() > mostTwigs) {
        std::vector<double> radii(skeleton.a0.begin(), skeleton.a0.end());
        const auto at = radii.begin() + std::ptrdiff_t(mostTwigs);
        std::nth_element(radii.begin(), at, radii.end(), std::greater<>());
        least = *at;
    }
    auto lines = std::make_shared<LineSet>();
    for (Index b = 0; b < skeleton.size() && lines->segments.size() < mostTwigs; ++b) {
        if (skeleton.a0[b] < least)
            continue;
        lines->segments.push_back(
            {glm::vec3(skeleton.p0[b]), glm::vec3(skeleton.p1[b]), 1.8f, 1.4f, colour, noIndex});
        lines->box.add(skeleton.p1[b]);
    }
    m_twigs.push_back({of, colour, lines, true});
    return lines;
}

void GizmoTrail::addTo(RenderScene& scene, const TreeOf& trees)
{
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        scene.lines.push_back({m_lines[i], glm::dmat4(1.0), noNode, true, false, {}});
        scene.points.push_back({m_points[i], glm::dmat4(1.0), noNode, true, {}});
        scene.trailBox.add(m_lines[i]->box);
    }
    for (Twigs& known : m_twigs)
        known.used = false;
    std::multimap<NodeId, const MeshItem*> meshes;
    for (const MeshItem& item : scene.meshes)
        meshes.emplace(item.node, &item);
    for (const Ghost& ghost : m_ghosts) {
        const TreeResult* tree = trees(ghost.node);
        if (tree && tree->simplified) {
            const auto lines = twigs(tree->simplified, lineColour(ghost.colour));
            scene.lines.push_back({lines, ghost.geometry, noNode, false, false, {}});
            scene.trailBox.add(lines->box.transformed(ghost.geometry));
            continue;
        }
        const auto [first, last] = meshes.equal_range(ghost.node);
        for (auto item = first; item != last; ++item) {
            scene.ghosts.push_back({item->second->mesh, ghost.geometry, ghost.colour});
            scene.trailBox.add(item->second->box.transformed(ghost.geometry));
        }
    }
    m_arms.addTo(scene);
    std::erase_if(m_twigs, [](const Twigs& known) { return !known.used; });
}

void GizmoTrail::paintPlayhead(QPainter& painter, const PickView& view, double seconds) const
{
    if (m_paths.empty())
        return;
    for (const MotionChain& chain : m_chains) {
        const auto at = gizmoPixel(view, glm::dvec3(chain.worldAt(seconds)[3]));
        if (!at)
            continue;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(18, 24, 30, 170), 4.5));
        painter.drawEllipse(*at, 8.0, 8.0);
        painter.setPen(QPen(Qt::white, 2.0));
        painter.drawEllipse(*at, 8.0, 8.0);
    }
}

} // namespace ramure
