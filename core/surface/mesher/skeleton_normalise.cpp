#include "core/surface/mesher/skeleton_normalise.h"

#include "core/skeleton/skeleton_check.h"
#include "core/surface/mesher/fork_spread.h"
#include "core/surface/mesher/mesh_divisions.h"
#include "core/surface/mesher/stem_limbs.h"
#include "core/surface/mesher/trunk_foot.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace ramure {

namespace {

constexpr double tinyLengthOfScene = 1e-6;
constexpr double tinyLengthOfRadius = 1e-3;
constexpr double discOfRadius = 0.6;
constexpr std::size_t smallFork =
    6; ///< children: heads of palms, whose pieces of trunk carry fronds, are larger
constexpr std::size_t mostAtEquals = 4; ///< children: the same
constexpr double tinyRadiusOfScene = 1e-4;
constexpr double mostLeastRadiusOfScene = 5e-4;
constexpr double mostGapOfRadius = 0.48;
constexpr double twinAngle = 1e-3;
constexpr double footRoom = 1.5; ///< of the height of a foot: the trunk's first branch
constexpr double smallestScene = 1e-12;

struct Sibling
{
    Index id;
    glm::dvec3 direction; ///< unit, from the fork
    double length;
};

class Normaliser
{
public:
    Normaliser(const Skeleton& skeleton, const BranchMeshOptions& options, NormalSkeleton& result)
        : m_in(skeleton)
        , m_options(options)
        , m_out(result)
    {
    }

    Expected<void> run(const Progress& progress);

private:
    void measure();
    void prepare();
    void emit(Index branch, Index parentOut, const glm::dvec3& start);
    void groupRoots();
    void settleChildren(Index branch);
    void settleSiblings(Index branch);
    void emitPlate(Index root);
    bool contract(Index branch);
    bool clearStem(Index branch);
    bool clearEquals(Index branch);
    void moveTo(Index head, std::vector<Sibling>::iterator sibling);
    [[nodiscard]] StemLimb limb(const Sibling& sibling) const
    {
        return {sibling.direction, sibling.length, m_a0[sibling.id], m_firstChild[sibling.id] != noIndex};
    }
    void putOffChildren(Index parentOut);
    [[nodiscard]] bool canLift(const Sibling& stem) const;
    void replaceByChildren(std::vector<Sibling>::iterator sibling, Index branch);
    bool joinTwins();
    bool joinPair(std::size_t first, std::size_t second);
    void appendChildren(Index from, Index to);
    [[nodiscard]] bool standsOn(Index root) const;
    [[nodiscard]] Index endOfFoot(Index root) const;
    void makeStub(Index root);
    Sibling sibling(Index id, const glm::dvec3& start) const;
    glm::dvec3 local(const glm::dvec3& p) const { return p - m_out.origin; }
    double radiusAt(Index id, double fraction) const { return m_a0[id] + (m_a1[id] - m_a0[id]) * fraction; }

    const Skeleton& m_in;
    const BranchMeshOptions& m_options;
    NormalSkeleton& m_out;
    double m_tinyLength = 0.0, m_tinyRadius = 0.0;
    std::vector<double> m_a0, m_a1, m_roll;
    std::vector<Index> m_firstChild, m_lastChild, m_nextSibling; ///< linked lists over the input's branches
    struct Pending
    {
        Index id, parentOut;
        glm::dvec3 start{0.0}; ///< from the parent's end
        bool isLimb = false;
    };
    std::vector<Pending> m_stack;
    std::vector<Sibling> m_siblings;
    std::vector<Index> m_unsettled;
    std::vector<Index> m_firstMate, m_nextMate; ///< roots that start together: the first one, and the list
    glm::dvec3 m_fork{0.0};                     ///< where the siblings at hand start
};

void Normaliser::measure()
{
    glm::dvec3 low = m_in.p0[0], high = low;
    double radius = 0.0;
    for (Index i = 0; i < m_in.size(); ++i) {
        low = glm::min(low, glm::min(m_in.p0[i], m_in.p1[i]));
        high = glm::max(high, glm::max(m_in.p0[i], m_in.p1[i]));
        radius = std::max({radius, m_in.a0[i], m_in.a1[i]});
    }
    const double box = glm::length(high - low);
    const glm::dvec3 reach = glm::max(glm::abs(low), glm::abs(high));
    const double farthest = std::max({reach.x, reach.y, reach.z});
    m_out.scene = box + radius;
    // Far from the origin floats are coarse: nothing may be finer than a few of their steps.
    const double floatStep = farthest * 0x1.0p-23;
    const double leastRadius = std::min(m_options.leastRadius, mostLeastRadiusOfScene * m_out.scene);
    // A budget gives a branch no more sides than are so long.
    const auto sides =
        static_cast<double>(m_options.targetTriangles > 0 ? leastSides : m_options.radialDivisions);
    m_out.leastGap = leastRadius * std::min(mostGapOfRadius, sidesOfRadius / sides);
    m_tinyLength = std::max({tinyLengthOfScene * m_out.scene, 16.0 * floatStep, m_out.leastGap});
    m_tinyRadius = std::max(
        {tinyRadiusOfScene * m_out.scene, 4.0 * floatStep * double(m_options.radialDivisions), leastRadius});
    if (farthest > 4.0 * m_out.scene)
        m_out.origin = 0.5 * (low + high);
}

void Normaliser::prepare()
{
    const Index count = m_in.size();
    m_a0 = m_in.a0;
    m_a1 = m_in.a1;
    if (!m_options.rollRad.empty())
        m_roll.assign(m_options.rollRad.begin(), m_options.rollRad.end());
    m_firstChild.assign(count, noIndex);
    m_lastChild.assign(count, noIndex);
    m_nextSibling.assign(count, noIndex);
    for (Index i = 0; i < count; ++i) {
        if (m_a0[i] < m_tinyRadius || m_a1[i] < m_tinyRadius) {
            m_a0[i] = std::max(m_a0[i], m_tinyRadius);
            m_a1[i] = std::max(m_a1[i], m_tinyRadius);
            m_out.repairs.push_back({SkeletonRepair::RadiusClamped, i, noIndex});
        }
        const Index parent = m_in.parent[i];
        if (parent == noIndex)
            continue;
        if (m_firstChild[parent] == noIndex)
            m_firstChild[parent] = i;
        else
            m_nextSibling[m_lastChild[parent]] = i;
        m_lastChild[parent] = i;
    }
}

Sibling Normaliser::sibling(Index id, const glm::dvec3& start) const
{
    const glm::dvec3 way = local(m_in.p1[id]) - start;
    const double length = glm::length(way);
    return {id, length > 0.0 ? way / length : glm::dvec3(0.0, 1.0, 0.0), length};
}

/// Hands the children of a branch that goes away to the end of another one's list.
void Normaliser::appendChildren(Index from, Index to)
{
    if (m_firstChild[from] == noIndex)
        return;
    if (m_firstChild[to] == noIndex)
        m_firstChild[to] = m_firstChild[from];
    else
        m_nextSibling[m_lastChild[to]] = m_firstChild[from];
    m_lastChild[to] = m_lastChild[from];
    m_firstChild[from] = m_lastChild[from] = noIndex;
}

bool Normaliser::contract(Index branch)
{
    const bool isSmallFork =
        m_options.forkLength > 0.0 && m_siblings.size() > 1 && m_siblings.size() < smallFork;
    const auto tooShort = [this, isSmallFork](const Sibling& s) { // a disc would pinch the fork
        const double share = isSmallFork && m_firstChild[s.id] != noIndex ? discOfRadius : tinyLengthOfRadius;
        return s.length <= std::max(m_tinyLength, share * m_a0[s.id]);
    };
    if (std::none_of(m_siblings.begin(), m_siblings.end(), tooShort))
        return false;
    m_unsettled.clear();
    for (auto it = m_siblings.rbegin(); it != m_siblings.rend(); ++it)
        m_unsettled.push_back(it->id);
    m_siblings.clear();
    bool changed = false;
    while (!m_unsettled.empty()) {
        const Index id = m_unsettled.back();
        m_unsettled.pop_back();
        const Sibling candidate = sibling(id, m_fork);
        if (!tooShort(candidate)) {
            m_siblings.push_back(candidate);
            continue;
        }
        changed = true;
        m_out.repairs.push_back({SkeletonRepair::ZeroLengthContracted, id, branch});
        const std::size_t insertAt = m_unsettled.size();
        for (Index child = m_firstChild[id]; child != noIndex; child = m_nextSibling[child]) {
            m_unsettled.push_back(child);
            if (!m_roll.empty())
                m_roll[child] += m_roll[id];
        }
        std::reverse(m_unsettled.begin() + static_cast<std::ptrdiff_t>(insertAt), m_unsettled.end());
        m_firstChild[id] = m_lastChild[id] = noIndex;
    }
    return changed;
}

/// Joins two siblings if they are too close. Afterwards the second of them is no sibling any more, or the
/// first.
bool Normaliser::joinPair(std::size_t first, std::size_t second)
{
    const bool firstIsShorter = m_siblings[first].length <= m_siblings[second].length;
    const Sibling& shorter = m_siblings[firstIsShorter ? first : second];
    const Sibling& longer = m_siblings[firstIsShorter ? second : first];
    const double apart = glm::length(shorter.direction - longer.direction); // 2 sin(angle / 2)
    const double longerRadius = radiusAt(longer.id, shorter.length / longer.length);
    const double shorterRadius = m_a1[shorter.id];
    if (apart >= twinAngle && areStemAndLimb(m_a0[shorter.id], m_a0[longer.id])) // no twins: see clearStem
        return false;
    if (apart >= twinAngle &&
        shorter.length * apart >= m_options.nearTwinRatio * (shorterRadius + longerRadius))
        return false;

    const double difference = longer.length - shorter.length;
    const double slack = std::max({0.5 * shorterRadius, 0.02 * longer.length, m_tinyLength});
    if (difference <= slack) {
        const Index kept = m_siblings[first].id;
        const Index gone = m_siblings[second].id;
        m_a0[kept] = std::max(m_a0[kept], m_a0[gone]);
        m_a1[kept] = std::max(m_a1[kept], m_a1[gone]);
        appendChildren(gone, kept);
        m_out.repairs.push_back({SkeletonRepair::SiblingsMerged, gone, kept});
        m_siblings.erase(m_siblings.begin() + static_cast<std::ptrdiff_t>(second));
        return true;
    }
    const Index head = shorter.id;
    const Index tail = longer.id;
    m_a0[head] = std::max(m_a0[head], m_a0[tail]);
    m_a1[head] = std::max(m_a1[head], longerRadius);
    m_a0[tail] = longerRadius;
    moveTo(head, m_siblings.begin() + static_cast<std::ptrdiff_t>(firstIsShorter ? second : first));
    return true;
}

/// Would all limbs still stand beside each other around one stem if the children of the stem took its place?
bool Normaliser::canLift(const Sibling& stem) const
{
    std::vector<StemLimb> all;
    for (const Sibling& sibling : m_siblings)
        if (sibling.id != stem.id)
            all.push_back(limb(sibling));
    for (Index child = m_firstChild[stem.id]; child != noIndex; child = m_nextSibling[child])
        all.push_back(limb(sibling(child, m_fork)));
    return standAroundStem(all);
}

/// A limb that ends inside the stem shows nothing of itself: its children start with it. One that comes out
/// near the next fork starts there. And where the stem forks again before a limb is clear of it, both forks
/// become one.
bool Normaliser::clearStem(Index branch)
{
    const auto stem = std::ranges::max_element(
        m_siblings, {}, [this](const Sibling& s) { return std::pair(m_a0[s.id], s.length); });
    const bool forks = m_firstChild[stem->id] != noIndex;
    for (auto at = m_siblings.begin(); at != m_siblings.end(); ++at) {
        const LimbAtFork stands = limbAtFork(limb(*at), limb(*stem));
        if (stands == LimbAtFork::Inside && m_firstChild[at->id] != noIndex) {
            replaceByChildren(at, branch);
        } else if (stands == LimbAtFork::Inside) {
            m_out.repairs.push_back({SkeletonRepair::SiblingsMerged, at->id, stem->id});
            m_siblings.erase(at);
        } else if (stands == LimbAtFork::Beyond && forks) {
            moveTo(stem->id, at);
        } else if (stands == LimbAtFork::Crowded && forks && canLift(*stem)) {
            replaceByChildren(stem, branch);
        } else {
            continue;
        }
        return true;
    }
    return false;
}

/// A thin child of a fork of equals that ends in the wood of the fork takes wood that those need, and shows
/// nothing of itself: its children start with them.
bool Normaliser::clearEquals(Index branch)
{
    const glm::dvec3 way = m_fork - local(m_in.p0[branch]);
    const double length = glm::length(way);
    if (!(m_options.forkLength > 0.0) || m_siblings.size() < 3 || m_siblings.size() > mostAtEquals ||
        !(length > 0.0))
        return false;
    std::vector<StemLimb> all;
    for (const Sibling& sibling : m_siblings)
        all.push_back(limb(sibling));
    const StemLimb below{way / length, length, m_a1[branch], true};
    for (auto at = m_siblings.begin(); at != m_siblings.end(); ++at) {
        const auto number = static_cast<std::size_t>(at - m_siblings.begin());
        if (!endsInFork(all, number, below))
            continue;
        if (m_firstChild[at->id] != noIndex) {
            replaceByChildren(at, branch);
        } else {
            m_out.repairs.push_back(
                {SkeletonRepair::SiblingsMerged, at->id, m_siblings[number == 0 ? 1 : 0].id});
            m_siblings.erase(at);
        }
        return true;
    }
    return false;
}

/// A sibling goes on from the end of another one, the last of its children.
void Normaliser::moveTo(Index head, std::vector<Sibling>::iterator sibling)
{
    const Index tail = sibling->id;
    if (m_firstChild[head] == noIndex)
        m_firstChild[head] = tail;
    else
        m_nextSibling[m_lastChild[head]] = tail;
    m_lastChild[head] = tail;
    m_nextSibling[tail] = noIndex;
    m_out.repairs.push_back({SkeletonRepair::SiblingChained, tail, head});
    m_siblings.erase(sibling);
}

/// The children of a sibling take its place.
void Normaliser::replaceByChildren(std::vector<Sibling>::iterator sibling, Index branch)
{
    const Index gone = sibling->id;
    m_out.repairs.push_back({SkeletonRepair::ZeroLengthContracted, gone, branch});
    auto at = m_siblings.erase(sibling);
    for (Index child = m_firstChild[gone]; child != noIndex; child = m_nextSibling[child]) {
        at = std::next(m_siblings.insert(at, this->sibling(child, m_fork)));
        if (!m_roll.empty())
            m_roll[child] += m_roll[gone];
    }
    m_firstChild[gone] = m_lastChild[gone] = noIndex;
}

bool Normaliser::joinTwins()
{
    bool changed = false;
    for (std::size_t i = 0; i < m_siblings.size(); ++i)
        for (std::size_t j = i + 1; j < m_siblings.size();) {
            const std::size_t before = m_siblings.size();
            const Index firstId = m_siblings[i].id;
            if (!joinPair(i, j)) {
                ++j;
                continue;
            }
            changed = true;
            // Its radius grew, or another one took its place: compare it with everybody again.
            if (m_siblings.size() < before && i < m_siblings.size() && m_siblings[i].id != firstId)
                j = i + 1;
        }
    return changed;
}

/// Leaves in m_siblings the children the branch shall have, which all start at m_fork.
void Normaliser::settleChildren(Index branch)
{
    m_siblings.clear();
    for (Index child = m_firstChild[branch]; child != noIndex; child = m_nextSibling[child])
        m_siblings.push_back(sibling(child, m_fork));
    settleSiblings(branch);
}

void Normaliser::settleSiblings(Index branch)
{
    bool again = true;
    while (again) {
        again = contract(branch) || (m_siblings.size() > 1 && (clearStem(branch) || clearEquals(branch)));
        again = joinTwins() || again;
    }
}

void Normaliser::makeStub(Index root)
{
    m_fork = local(m_in.p1[root]);
    settleChildren(root);
    glm::dvec3 direction(0.0, 1.0, 0.0);
    if (!m_siblings.empty())
        direction = m_siblings.front().direction;
    const double length = std::max(0.5 * m_a0[root], 2.0 * m_tinyLength);
    m_out.branches.back().p0 = m_fork - length * direction;
    m_out.repairs.push_back({SkeletonRepair::RootStub, root, noIndex});
}

bool Normaliser::standsOn(Index root) const
{
    const glm::dvec3& start = m_in.p0[root];
    const auto& ground = m_options.ground;
    return std::abs(start.y) <= m_a0[root] || (ground && std::abs(ground->above(start)) <= m_a0[root]);
}

/// The branch whose end is far enough above the ground.
Index Normaliser::endOfFoot(Index root) const
{
    Index last = root;
    const glm::dvec3& start = m_in.p0[root];
    const auto height = [&](double radius) { return footHeight(m_options, radius, m_options.ground, start); };
    while (glm::length(m_in.p1[last] - start) < footRoom * height(m_a0[last])) {
        const Index child = m_firstChild[last];
        if (child == noIndex || m_nextSibling[child] != noIndex)
            break;
        last = child;
    }
    return last;
}

void Normaliser::emit(Index branch, Index parentOut, const glm::dvec3& start)
{
    MeshBranch out;
    out.p0 = start;
    out.p1 = local(m_in.p1[branch]);
    out.a0 = m_a0[branch];
    out.a1 = m_a1[branch];
    out.rollRad = m_roll.empty() ? 0.0 : m_roll[branch];
    out.parent = parentOut;
    out.source = branch;
    out.isSawn = std::ranges::binary_search(m_in.sawn, branch);
    if (out.isSawn && std::ranges::binary_search(m_in.bare, branch))
        out.torn = m_in.key[branch] | 1;
    m_out.branches.push_back(out);
    m_fork = out.p1;
    const bool rootWithoutLength =
        parentOut == noIndex &&
        glm::length(out.p1 - out.p0) <= std::max(m_tinyLength, tinyLengthOfRadius * m_a0[branch]);
    if (rootWithoutLength)
        makeStub(branch);
    else
        settleChildren(branch);
}

/// Roots within a radius of each other, and those within a radius of these: lists by their first ones. Limbs
/// that fall stand for themselves.
void Normaliser::groupRoots()
{
    std::vector<Index> roots;
    double reach = 0.0;
    for (Index i = 0; i < m_in.size(); ++i)
        if (m_in.parent[i] == noIndex) {
            roots.push_back(i);
            reach = std::max(reach, m_in.a0[i]);
        }
    m_firstMate.resize(m_in.size());
    m_nextMate.assign(m_in.size(), noIndex);
    for (const Index root : roots)
        m_firstMate[root] = root;
    const auto first = [this](Index root) {
        while (m_firstMate[root] != root)
            root = m_firstMate[root];
        return root;
    };
    std::vector<Index> along = roots;
    std::erase_if(along, [this](Index root) {
        return std::ranges::binary_search(m_in.loose, root, {}, &LooseLimb::first);
    });
    std::ranges::stable_sort(along, {}, [this](Index root) { return m_in.p0[root].x; });
    for (std::size_t i = 0; i < along.size(); ++i)
        for (std::size_t k = i + 1; k < along.size() && m_in.p0[along[k]].x - m_in.p0[along[i]].x <= reach;
             ++k)
            if (glm::length(m_in.p0[along[k]] - m_in.p0[along[i]]) <=
                std::max(m_in.a0[along[i]], m_in.a0[along[k]])) {
                const Index one = first(along[i]), other = first(along[k]);
                m_firstMate[std::max(one, other)] = std::min(one, other);
            }
    std::vector<Index> last(m_in.size(), noIndex);
    for (const Index root : roots) {
        const Index group = m_firstMate[root] = first(root);
        if (group != root)
            m_nextMate[last[group]] = root;
        last[group] = root;
    }
}

/// A stub on which all roots stand that start with \p root. It points to where it is farthest from all of
/// them.
void Normaliser::emitPlate(Index root)
{
    m_fork = local(m_in.p0[root]);
    m_siblings.clear();
    double radius = 0.0;
    for (Index mate = root; mate != noIndex; mate = m_nextMate[mate]) {
        m_siblings.push_back(sibling(mate, m_fork));
        radius = std::max(radius, m_a0[mate]);
    }
    const std::size_t notes = m_out.repairs.size();
    settleSiblings(root);
    Index first = root;
    for (std::size_t i = notes; i < m_out.repairs.size(); ++i)
        if (m_out.repairs[i].kind == SkeletonRepair::SiblingChained && m_out.repairs[i].branch == first)
            first = m_out.repairs[i].other; // it goes on from that one's end
    for (const Sibling& mate : m_siblings)
        if (m_in.parent[mate.id] == noIndex && mate.id != first)
            m_out.repairs.push_back({SkeletonRepair::RootsJoined, mate.id, first});
    if (m_siblings.size() == 1 && m_in.parent[m_siblings.front().id] == noIndex)
        return emit(m_siblings.front().id, noIndex, local(m_in.p0[m_siblings.front().id])); // all were one
    glm::dvec3 sum(0.0);
    for (const Sibling& mate : m_siblings)
        sum += mate.direction;
    const double whole = glm::length(sum);
    glm::dvec3 best(0.0, -1.0, 0.0);
    double least = 2.0;
    for (const glm::dvec3& way :
         {whole > 1e-6 ? -sum / whole : best, best, glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, 1.0),
          glm::dvec3(-1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.0, 1.0, 0.0)}) {
        double nearest = -1.0;
        for (const Sibling& mate : m_siblings)
            nearest = std::max(nearest, glm::dot(mate.direction, way));
        if (nearest < least - 1e-9) {
            least = nearest;
            best = way;
        }
    }
    MeshBranch plate;
    plate.p1 = m_fork;
    plate.p0 = m_fork + std::max(0.5 * radius, 2.0 * m_tinyLength) * best;
    plate.a0 = plate.a1 = radius;
    plate.source = root;
    plate.isPlate = true;
    m_out.branches.push_back(plate);
}

/// The first one is the next to come.
void Normaliser::putOffChildren(Index parentOut)
{
    std::vector<StemLimb> all;
    for (const Sibling& sibling : m_siblings)
        all.push_back(limb(sibling));
    const Index stem = stemOf(all);
    for (std::size_t i = m_siblings.size(); i-- > 0;) {
        const bool isLimb = stem != noIndex && i != stem;
        glm::dvec3 start(0.0);
        if (isLimb)
            start = limbStart(all[i], all[stem]) * all[stem].direction;
        m_stack.push_back({m_siblings[i].id, parentOut, start, isLimb});
    }
}

Expected<void> Normaliser::run(const Progress& progress)
{
    measure();
    if (!(m_out.scene > 0.0))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("No branch of the skeleton has a length or a radius"));
    if (m_out.scene < smallestScene)
        return fail(ErrorCode::Invalid, RAMURE_NOOP("The skeleton is too small for a mesh"));
    prepare();
    groupRoots();
    m_out.branches.reserve(m_in.size());
    for (Index i = m_in.size(); i-- > 0;)
        if (m_in.parent[i] == noIndex && m_firstMate[i] == i) {
            m_stack.push_back({i, noIndex});
            ++m_out.roots;
        }
    std::size_t steps = 0;
    while (!m_stack.empty()) {
        if ((++steps & 0xFFF) == 0 && progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
        const Pending pending = m_stack.back();
        m_stack.pop_back();
        const Index index = static_cast<Index>(m_out.branches.size());
        const glm::dvec3 start = pending.parentOut == noIndex
                                     ? local(m_in.p0[pending.id])
                                     : m_out.branches[pending.parentOut].p1 + pending.start;
        if (pending.parentOut == noIndex && m_nextMate[pending.id] != noIndex)
            emitPlate(pending.id);
        else {
            const bool hasFoot = pending.parentOut == noIndex && m_options.roots > 0 && standsOn(pending.id);
            emit(hasFoot ? endOfFoot(pending.id) : pending.id, pending.parentOut, start);
            m_out.branches[index].foot = hasFoot ? pending.id : noIndex;
        }
        m_out.branches[index].isLimb = pending.isLimb;
        putOffChildren(index);
    }
    linkChildren(m_out);
    return {};
}

} // namespace

Expected<NormalSkeleton> normaliseSkeleton(const Skeleton& skeleton, const BranchMeshOptions& options,
                                           const Progress& progress)
{
    if (skeleton.empty())
        return fail(ErrorCode::Invalid, RAMURE_NOOP("The skeleton has no branch"));
    RAMURE_TRY(checkForMesh(skeleton));
    NormalSkeleton result;
    Normaliser normaliser(skeleton, options, result);
    RAMURE_TRY(normaliser.run(progress));
    if (options.forkLength > 0.0)
        partForks(result);
    makeCollars(result, options.collar);
    spreadAboveForks(result, options.forkLength);
    return result;
}

} // namespace ramure
