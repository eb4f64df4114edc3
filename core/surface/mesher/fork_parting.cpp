#include "core/surface/mesher/fork_spread.h"

#include "core/surface/mesher/fork_layout.h"
#include "core/surface/mesher/stem_limbs.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

constexpr std::size_t mostChildren = 8; ///< the fronds of a palm leave together
constexpr std::size_t mostLevels = 3;
constexpr double leastSine = 0.34;  ///< of the angle between a limb and the branch it leaves
constexpr double leastAside = 1.05; ///< of the branch's radius: else a limb ends inside it
constexpr double mostOfBranch = 0.7;
/// Of the limb's radius over that sine, along the branch: its foot and what is free above.
constexpr double limbHeight = 2.8;
constexpr double freeOfSiblings = 1.15; ///< of the added radii
constexpr int placesOnLimb = 8;

/// Limbs that leave a branch in one place, and where each starts.
struct Level
{
    double below = 0.0, height = 0.0; ///< m, along the branch: from here to its end, and to the next level
    std::vector<std::pair<Index, glm::dvec3>> limbs;
};

/// Where a branch is divided, the lowest level last.
struct Parting
{
    Index branch = noIndex;
    std::vector<Level> levels;
};

double toSegment(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to)
{
    const glm::dvec3 way = to - from;
    const double square = glm::dot(way, way);
    const double share = square > 0.0 ? std::clamp(glm::dot(point - from, way) / square, 0.0, 1.0) : 0.0;
    return glm::distance(point, from + share * way);
}

class ForkParter
{
public:
    explicit ForkParter(NormalSkeleton& skeleton)
        : m_skeleton(skeleton)
    {
    }
    void run();

private:
    [[nodiscard]] const MeshBranch& at(Index branch) const { return m_skeleton.branches[branch]; }
    [[nodiscard]] bool isStar(std::span<const Index> children);
    [[nodiscard]] bool isStar(const Level& level);
    [[nodiscard]] double room(Index branch) const;
    [[nodiscard]] StemLimb limbFrom(Index child, const glm::dvec3& start) const;
    [[nodiscard]] double heightOf(Index child, double below) const;
    [[nodiscard]] bool isFree(Index child, const glm::dvec3& start) const;
    void choose(Index branch);
    bool lower(Index child, double most, std::vector<Level>& levels);
    void rebuild();
    Index addPiece(Index below, const glm::dvec3& end, double radius);

    NormalSkeleton& m_skeleton;
    ForkPlanner m_planner;
    Frame m_frame{}; ///< at the end of the branch at hand
    Index m_branch = noIndex;
    std::vector<Index> m_stays, m_others; ///< children at the end of the branch, and those but a stem
    std::vector<Parting> m_partings;      ///< by ascending branch
    std::vector<MeshBranch> m_out;
};

StemLimb ForkParter::limbFrom(Index child, const glm::dvec3& start) const
{
    const MeshBranch& own = at(child);
    const glm::dvec3 way = own.p1 - start;
    const double length = glm::length(way);
    return {way / std::max(length, 1e-12), length, own.a0, own.childCount > 0};
}

/// Do these leave one of them to its sides? One among limbs comes to begin as wide as the end that it stands
/// on (fork_spread.h).
bool ForkParter::isStar(std::span<const Index> children)
{
    const MeshBranch& own = at(m_branch);
    double thickest = 0.0;
    for (const Index child : children)
        thickest = std::max(thickest, at(child).a0);
    const auto isStem = [this](Index child) { return !at(child).isLimb; };
    const double widest = std::ranges::count_if(children, isStem) > 1
                              ? own.a1
                              : std::max(thickest, own.a1 / (1.0 + mostSpread));
    m_planner.begin(thickest >= leastStem * own.a1);
    for (const Index child : children) {
        const glm::dvec3 way = glm::normalize(at(child).p1 - at(child).p0);
        m_planner.addChild(m_frame, way, way, at(child).a0 / (isStem(child) ? widest : own.a1));
    }
    return m_planner.findStem() != noIndex;
}

/// Do limbs stand beside each other around the branch?
bool ForkParter::isStar(const Level& level)
{
    m_planner.begin(true);
    m_planner.addChild(m_frame, m_frame.tangent, m_frame.tangent, 1.0);
    for (const auto& [child, start] : level.limbs) {
        const glm::dvec3 way = glm::normalize(at(child).p1 - start);
        m_planner.addChild(m_frame, way, way, at(child).a0 / at(m_branch).a1);
    }
    return m_planner.findStem() != noIndex;
}

/// m, of the branch before its end: what its foot, its siblings and their limbs leave free.
double ForkParter::room(Index branch) const
{
    const MeshBranch& own = at(branch);
    const glm::dvec3 way = own.p1 - own.p0;
    const double length = glm::length(way);
    double most = mostOfBranch * length;
    if (own.foot != noIndex || own.isPlate || own.parent == noIndex || at(own.parent).isPlate)
        most *= 0.4;
    if (own.isLimb) // what lies in the stem does not show
        most = std::min(most, 0.4 * length);
    if (own.parent == noIndex)
        return most;
    for (const Index other : m_skeleton.childrenOf(own.parent)) {
        if (other == branch)
            continue;
        const MeshBranch& beside = at(other);
        if (beside.isLimb && !own.isLimb) {
            const StemLimb limb = limbFrom(other, own.p0);
            const double cosine = glm::dot(limb.direction, way) / length;
            const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.01));
            most = std::min(most, length - limbHeight * limb.radius / sine);
            continue;
        }
        const double apart = freeOfSiblings * (own.a0 + beside.a0);
        while (most > 0.05 * length && toSegment(own.p1 - most / length * way, beside.p0, beside.p1) < apart)
            most -= 0.1 * length;
    }
    return most;
}

/// m, that a limb takes on the branch at hand if it leaves it so far below its end; 0: it cannot.
double ForkParter::heightOf(Index child, double below) const
{
    const StemLimb limb = limbFrom(child, at(m_branch).p1 - below * m_frame.tangent);
    const double cosine = glm::dot(limb.direction, m_frame.tangent);
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    if (sine < leastSine || limb.length * sine < leastAside * at(m_branch).a1)
        return 0.0;
    return limbHeight * limb.radius / sine;
}

/// Does it cross none that stay, on its way from the wood to its end?
bool ForkParter::isFree(Index child, const glm::dvec3& start) const
{
    const MeshBranch &own = at(child), &from = at(m_branch);
    for (int k = 1; k <= placesOnLimb; ++k) {
        const glm::dvec3 place = start + double(k) / placesOnLimb * (own.p1 - start);
        const glm::dvec3 away = place - from.p1;
        if (glm::length(away - glm::dot(away, m_frame.tangent) * m_frame.tangent) < from.a1)
            continue;
        for (const Index other : m_others)
            if (toSegment(place, at(other).p0, at(other).p1) < freeOfSiblings * (own.a0 + at(other).a0))
                return false;
    }
    return true;
}

/// To a level that has room around it, or to a new one below them all.
bool ForkParter::lower(Index child, double most, std::vector<Level>& levels)
{
    const MeshBranch& own = at(m_branch);
    const auto fits = [&](Level& level) {
        const glm::dvec3 place = own.p1 - level.below * m_frame.tangent;
        const StemLimb stem{m_frame.tangent, level.height, std::min(own.a0, own.a1), true};
        const StemLimb limb = limbFrom(child, place);
        level.limbs.emplace_back(child, place + limbStart(limb, stem) * m_frame.tangent);
        if (heightOf(child, level.below) > 0.0 && isFree(child, level.limbs.back().second) && isStar(level))
            return true;
        level.limbs.pop_back();
        return false;
    };
    double above = 0.0;
    for (Level& level : levels) {
        if (level.height >= heightOf(child, level.below) && fits(level))
            return true;
        above = level.below;
    }
    if (levels.size() == mostLevels)
        return false;
    const double height = heightOf(child, above + heightOf(child, above));
    for (const double share : {1.0, 1.5, 2.2, 3.0}) {
        Level level{above + share * height, share * height, {}};
        if (!(height > 0.0) || level.below > most)
            return false;
        if (fits(level)) {
            levels.push_back(std::move(level));
            return true;
        }
    }
    return false;
}

void ForkParter::choose(Index branch)
{
    const std::span<const Index> children = m_skeleton.childrenOf(branch);
    const MeshBranch& own = at(branch);
    if (own.isPlate || children.size() < 2 || children.size() > mostChildren)
        return;
    std::vector<Index> order(children.begin(), children.end());
    std::ranges::stable_sort(order, std::greater{}, [this](Index child) { return at(child).a0; });
    const double thickest = at(order.front()).a0;
    const double stem = std::min({thickest, own.a0, own.a1});
    const auto firstThin = std::ranges::find_if(
        order, [&](Index child) { return at(child).a0 <= stem && areStemAndLimb(at(child).a0, stem); });
    if (firstThin == order.end())
        return;
    m_branch = branch;
    m_frame = frameFromTangent(glm::normalize(own.p1 - own.p0));
    if (isStar(order))
        return;
    m_stays.assign(order.begin(), firstThin);
    std::vector<Index> goes;
    for (auto child = firstThin; child != order.end(); ++child) {
        m_stays.push_back(*child);
        if (isStar(m_stays))
            continue;
        m_stays.pop_back();
        goes.push_back(*child);
    }
    m_others.assign(m_stays.begin() + (firstThin - order.begin() == 1 ? 1 : 0), m_stays.end());
    const double most = room(branch);
    Parting parting{branch, {}};
    for (const Index child : goes)
        lower(child, most, parting.levels);
    if (!parting.levels.empty())
        m_partings.push_back(std::move(parting));
}

/// The branch goes on from where it was divided.
Index ForkParter::addPiece(Index below, const glm::dvec3& end, double radius)
{
    const MeshBranch& from = m_out[below];
    MeshBranch piece;
    piece.p0 = from.p1;
    piece.p1 = end;
    piece.a0 = from.a1;
    piece.a1 = radius;
    piece.parent = below;
    piece.source = from.source;
    piece.isPiece = true;
    m_out.push_back(piece);
    return static_cast<Index>(m_out.size() - 1);
}

void ForkParter::rebuild()
{
    // What waits: an old branch with its children, or what is left of one above a level.
    struct Task
    {
        Index old, parent;
        std::size_t level; ///< the levels above it that are still to come
        bool isUpper;
    };
    std::vector<Task> stack;
    for (Index root = static_cast<Index>(m_skeleton.branches.size()); root-- > 0;)
        if (at(root).parent == noIndex)
            stack.push_back({root, noIndex, 0, false});
    const auto partingOf = [this](Index branch) {
        const auto found = std::ranges::lower_bound(m_partings, branch, {}, &Parting::branch);
        return found != m_partings.end() && found->branch == branch ? &*found : nullptr;
    };
    std::vector<glm::dvec3> start(m_skeleton.branches.size());
    std::vector<char> isLowered(m_skeleton.branches.size(), 0);
    while (!stack.empty()) {
        const Task task = stack.back();
        stack.pop_back();
        const MeshBranch& old = at(task.old);
        const Parting* parting = partingOf(task.old);
        const std::size_t levels = task.isUpper ? task.level : parting ? parting->levels.size() : 0;
        const glm::dvec3 way = old.p1 - old.p0;
        const double length = glm::length(way);
        const double below = levels > 0 ? parting->levels[levels - 1].below : 0.0;
        const glm::dvec3 end = old.p1 - below / std::max(length, 1e-12) * way;
        const double radius = levels > 0 ? old.a1 + (old.a0 - old.a1) * below / length : old.a1;
        Index made = 0;
        if (task.isUpper) {
            made = addPiece(task.parent, end, radius);
        } else {
            made = static_cast<Index>(m_out.size());
            MeshBranch& own = m_out.emplace_back(old);
            own.parent = task.parent;
            own.firstChild = own.childCount = 0;
            own.p1 = end;
            own.a1 = radius;
            if (isLowered[task.old]) {
                own.p0 = start[task.old];
                own.isLimb = true;
            }
        }
        if (levels > 0) { // limbs first, then what is left of the branch: see partForks
            const Level& level = parting->levels[levels - 1];
            stack.push_back({task.old, made, levels - 1, true});
            for (auto limb = level.limbs.rbegin(); limb != level.limbs.rend(); ++limb) {
                start[limb->first] = limb->second;
                isLowered[limb->first] = 1;
                stack.push_back({limb->first, made, 0, false});
            }
            continue;
        }
        const std::span<const Index> children = m_skeleton.childrenOf(task.old);
        for (std::size_t i = children.size(); i-- > 0;)
            if (!isLowered[children[i]])
                stack.push_back({children[i], made, 0, false});
    }
    m_skeleton.branches = std::move(m_out);
    linkChildren(m_skeleton);
}

void ForkParter::run()
{
    for (Index branch = 0; branch < m_skeleton.branches.size(); ++branch)
        choose(branch);
    if (!m_partings.empty())
        rebuild();
}

} // namespace

void linkChildren(NormalSkeleton& skeleton)
{
    std::vector<MeshBranch>& branches = skeleton.branches;
    for (const MeshBranch& branch : branches)
        if (branch.parent != noIndex)
            ++branches[branch.parent].childCount;
    Index next = 0;
    for (MeshBranch& branch : branches) {
        branch.firstChild = next;
        next += branch.childCount;
        branch.childCount = 0;
    }
    skeleton.children.resize(next);
    for (Index i = 0; i < branches.size(); ++i) {
        if (branches[i].parent == noIndex)
            continue;
        MeshBranch& parent = branches[branches[i].parent];
        skeleton.children[parent.firstChild + parent.childCount++] = i;
    }
}

void partForks(NormalSkeleton& skeleton)
{
    ForkParter(skeleton).run();
}

} // namespace ramure
