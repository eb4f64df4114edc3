#include "core/surface/mesher/fork_fairing.h"

#include "core/base/parallel.h"
#include "core/math/box_pairs.h"
#include "core/math/exact_predicates.h"
#include "core/math/triangle_pairs.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace ramure {

namespace {

constexpr double leastFaired = 0.025;      ///< m, radius of the thinner tube beside a wall
constexpr double leastFairedOfTrunk = 0.1; ///< the same of small trees: a share of the thickest radius
constexpr int fillRounds = 6, fairRounds = 2;
constexpr double fillStep =
    0.5; ///< of the way to the middle of the neighbours, where that is out of a valley
/// Steps of a low-pass filter that keeps volume: first the one way, then the other (Taubin, "A signal
/// processing approach to fair surface design", 1995).
constexpr double inStep = 0.5, outStep = -0.53;
/// How far vertices follow, by the edges between them and a wall. What is further away stays.
constexpr std::array<double, 2> followShares{1.0, 0.7};
constexpr auto farthestLevel = static_cast<std::uint8_t>(followShares.size());
constexpr std::uint8_t awayLevel = 254, fixedLevel = 255;
constexpr double leastFacing = 0.3;      ///< cosine, of a triangle and the normals at its corners
constexpr double leastAreaLeft = 0.2;    ///< of a triangle, of what it had
constexpr std::uint8_t mostHalvings = 3; ///< of what is too far
constexpr std::size_t fairGrain = 1024;  ///< vertices
// Ridges.
constexpr double fullRidge = 0.25;    ///< of the stem's radius: thinner limbs have lower ones
constexpr double twinShare = 0.8;     ///< of the thicker one's radius: twins of equal size
constexpr double creaseAngle = 0.866; ///< cosine of 30 degrees: narrower twins have a crease
constexpr double leastRidge = 0.003;  ///< m: lower ones are not seen
constexpr double ridgeRoom = 0.4;     ///< of the edges from a wall's vertex to the tubes beside it
constexpr double creaseDepth = 0.5;   ///< of the height of a ridge

double easeRidge(double x)
{
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

glm::dvec3 spanOf(const std::array<glm::dvec3, 3>& corners)
{
    return glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
}

std::array<glm::dvec3, 3> cornersIn(const std::vector<glm::dvec3>& places, const glm::uvec3& face)
{
    return {places[face.x], places[face.y], places[face.z]};
}

bool haveCorner(const glm::uvec3& one, const glm::uvec3& other)
{
    for (int k = 0; k < 3; ++k)
        if (one[k] == other.x || one[k] == other.y || one[k] == other.z)
            return true;
    return false;
}

glm::dvec3 unitOf(const glm::dvec3& way)
{
    const double length = glm::length(way);
    return length > 0.0 ? way / length : glm::dvec3(0.0);
}

class ForkFinish
{
public:
    explicit ForkFinish(BranchMesh& mesh)
        : m_mesh(mesh)
        , m_level(mesh.mesh.positions.size(), awayLevel)
    {
    }
    /// False where there is no fork of thick wood.
    bool gather();
    void fair(double strength);
    void raiseRidges(double ridge);
    void write();

private:
    /// A wall's vertex, and the tubes beside it.
    struct WallVertex
    {
        std::size_t fork; ///< in the list of fork vertices
        Index thick, thin;
    };
    void linkTubes();
    [[nodiscard]] Index tubeAt(Index branch, Index parent, const glm::vec3& place) const;
    [[nodiscard]] std::size_t endOf(std::size_t tube) const
    {
        return tube + 1 < m_mesh.tubes.size() ? m_mesh.tubes[tube + 1].firstTriangle
                                              : m_mesh.mesh.triangles.size();
    }
    void findWalls();
    void addWall(std::size_t number, double least);
    void findRings();
    void fixEnds();
    void fixStart(std::size_t tube);
    void fixTip(std::size_t tube);
    void spreadLevels();
    void collect();
    void linkNeighbours();
    enum class Moves { All, Outward };
    void step(double way, Moves moves);
    void computeNormals();
    enum : std::uint8_t { Stays, Spoilt, Changed };
    void takeBackFolds(std::vector<std::uint8_t> state);
    [[nodiscard]] bool turnedOver(std::size_t face) const;
    [[nodiscard]] bool moves(Index slot) const { return slot < m_moving; }
    [[nodiscard]] Index slotOf(const WallVertex& wall) const
    {
        return m_slot[m_mesh.forkVertices[wall.fork].vertex];
    }
    void findHighest();
    [[nodiscard]] std::vector<double> roomForRidges() const;
    void takeBackCrossings(const std::vector<glm::dvec3>& flat);
    [[nodiscard]] double ridgeAt(const WallVertex& wall) const;
    [[nodiscard]] double upTheStem(const WallVertex& wall) const;

    BranchMesh& m_mesh;
    std::vector<std::uint8_t> m_level; ///< per vertex: edges from a wall, or awayLevel, or fixedLevel
    std::vector<Index> m_firstTube, m_nextTube; ///< tubes by branch
    std::vector<WallVertex> m_walls;
    std::vector<float> m_highest; ///< per wall: m, of its fork's walls between the same tubes
    // Vertices have slots: first those that may move, then the others of their triangles.
    Index m_moving = 0;            ///< slots of vertices that may move
    std::vector<Index> m_vertices; ///< per slot
    std::vector<Index> m_slot;     ///< per vertex; noIndex if it has none
    std::vector<glm::uvec3>
        m_faces; ///< slots of those that have a vertex which may move, in the mesh's order
    std::vector<glm::dvec3> m_place, m_next, m_normals;   ///< per slot
    std::vector<glm::dvec3> m_firstPlace, m_firstNormals; ///< the same before anything moved
    std::vector<Index> m_first; ///< per slot of one that may move: of its neighbours, and one more
    std::vector<Index> m_neighbours;
    std::vector<double> m_weights;
};

void ForkFinish::linkTubes()
{
    Index most = 0;
    for (const TubeRange& tube : m_mesh.tubes)
        most = std::max(most, tube.branch);
    m_firstTube.assign(std::size_t(most) + 1, noIndex);
    m_nextTube.assign(m_mesh.tubes.size(), noIndex);
    for (std::size_t t = m_mesh.tubes.size(); t-- > 0;) {
        m_nextTube[t] = m_firstTube[m_mesh.tubes[t].branch];
        m_firstTube[m_mesh.tubes[t].branch] = static_cast<Index>(t);
    }
}

/// Of a branch in several pieces the one that starts nearest.
Index ForkFinish::tubeAt(Index branch, Index parent, const glm::vec3& place) const
{
    Index found = noIndex;
    double least = 0.0;
    if (branch >= m_firstTube.size())
        return noIndex;
    for (Index tube = m_firstTube[branch]; tube != noIndex; tube = m_nextTube[tube]) {
        const glm::dvec3 way = m_mesh.axes[tube].curve.h0 - glm::dvec3(place);
        const double square = glm::dot(way, way);
        if (m_mesh.tubes[tube].parent == parent && (found == noIndex || square < least)) {
            found = tube;
            least = square;
        }
    }
    return found;
}

void ForkFinish::findWalls()
{
    double thickest = 0.0;
    for (const TubeAxis& axis : m_mesh.axes)
        thickest = std::max(thickest, axis.a0);
    const double least = std::min(leastFaired, leastFairedOfTrunk * thickest);
    for (std::size_t f = 0; f < m_mesh.forkVertices.size(); ++f)
        addWall(f, least);
}

void ForkFinish::addWall(std::size_t number, double least)
{
    const ForkVertex& fork = m_mesh.forkVertices[number];
    if (fork.branch[1] == noIndex)
        return;
    const glm::vec3& place = m_mesh.mesh.positions[fork.vertex];
    Index thin = tubeAt(fork.branch[0], fork.parent, place);
    Index thick = tubeAt(fork.branch[1], fork.parent, place);
    if (thin == noIndex || thick == noIndex)
        return;
    if (m_mesh.axes[thin].a0 > m_mesh.axes[thick].a0)
        std::swap(thin, thick);
    if (m_mesh.axes[thin].a0 < least)
        return;
    m_walls.push_back({number, thick, thin});
    m_level[fork.vertex] = 0;
}

/// Where the tubes of a fork stand on the last cross-section of what carries them: a limb is all around it.
void ForkFinish::findRings()
{
    std::vector<std::uint8_t> hasWall(m_mesh.tubes.size(), 0);
    for (const WallVertex& wall : m_walls)
        hasWall[wall.thin] = 1;
    for (std::size_t tube = 0; tube < m_mesh.tubes.size(); ++tube)
        for (std::size_t t = m_mesh.tubes[tube].firstTriangle; hasWall[tube] != 0 && t < endOf(tube); ++t)
            for (int k = 0; k < 3; ++k)
                if (const Index v = m_mesh.mesh.triangles[t][k];
                    m_mesh.mesh.branch[v] != m_mesh.tubes[tube].branch && m_level[v] == awayLevel)
                    m_level[v] = 0;
}

/// The flat end of a root, or the whole foot of a trunk.
void ForkFinish::fixStart(std::size_t tube)
{
    const std::vector<glm::uvec3>& triangles = m_mesh.mesh.triangles;
    Index pole = noIndex;
    for (std::size_t t = m_mesh.tubes[tube].firstTriangle; t < endOf(tube); ++t)
        pole = std::min({pole, triangles[t].x, triangles[t].y, triangles[t].z});
    const FootSize& foot = m_mesh.axes[tube].foot;
    const Index after = pole + 1 + foot.rings * foot.points;
    for (std::size_t t = m_mesh.tubes[tube].firstTriangle; t < endOf(tube); ++t)
        for (int k = 0; k < 3; ++k)
            if (const Index v = triangles[t][k];
                v < after || triangles[t].x == pole || triangles[t].y == pole || triangles[t].z == pole)
                m_level[v] = fixedLevel;
}

/// The cap of a tip or a cut, and the ring below it.
void ForkFinish::fixTip(std::size_t tube)
{
    const std::vector<glm::uvec3>& triangles = m_mesh.mesh.triangles;
    const std::size_t first = m_mesh.tubes[tube].firstTriangle, end = endOf(tube);
    if (end == first)
        return;
    const glm::uvec3& last = triangles[end - 1];
    Index least = std::max({last.x, last.y, last.z}); // the pole
    std::size_t t = end;
    for (int round = 0; round < 2; ++round) {
        Index lower = least;
        for (; t > first; --t) {
            const glm::uvec3& face = triangles[t - 1];
            if (std::max({face.x, face.y, face.z}) < least)
                break;
            lower = std::min({lower, face.x, face.y, face.z});
            for (int k = 0; k < 3; ++k)
                m_level[face[k]] = fixedLevel;
        }
        least = lower;
    }
}

void ForkFinish::fixEnds()
{
    std::vector<std::uint8_t> hasWall(m_mesh.tubes.size(), 0);
    std::vector<std::uint8_t> goesOn(m_firstTube.size(), 0);
    for (const WallVertex& wall : m_walls)
        hasWall[wall.thick] = hasWall[wall.thin] = 1;
    for (const TubeRange& tube : m_mesh.tubes)
        if (tube.parent != noIndex && tube.parent < goesOn.size())
            goesOn[tube.parent] = 1;
    for (std::size_t t = 0; t < m_mesh.tubes.size(); ++t) {
        if (m_mesh.tubes[t].parent == noIndex)
            fixStart(t);
        if (hasWall[t] != 0 && goesOn[m_mesh.tubes[t].branch] == 0)
            fixTip(t);
    }
}

void ForkFinish::spreadLevels()
{
    for (std::uint8_t level = 0; level + 1 < farthestLevel; ++level)
        for (const glm::uvec3& t : m_mesh.mesh.triangles)
            if (m_level[t.x] == level || m_level[t.y] == level || m_level[t.z] == level)
                for (int k = 0; k < 3; ++k)
                    if (std::uint8_t& at = m_level[t[k]]; at == awayLevel)
                        at = static_cast<std::uint8_t>(level + 1);
}

void ForkFinish::collect()
{
    const std::vector<glm::vec3>& positions = m_mesh.mesh.positions;
    m_slot.assign(positions.size(), noIndex);
    const auto add = [&](Index vertex) {
        m_slot[vertex] = static_cast<Index>(m_vertices.size());
        m_vertices.push_back(vertex);
        m_place.emplace_back(positions[vertex]);
    };
    for (Index v = 0; v < m_level.size(); ++v)
        if (m_level[v] < farthestLevel)
            add(v);
    m_moving = static_cast<Index>(m_vertices.size());
    for (const glm::uvec3& t : m_mesh.mesh.triangles) {
        if (!moves(m_slot[t.x]) && !moves(m_slot[t.y]) && !moves(m_slot[t.z]))
            continue;
        for (int k = 0; k < 3; ++k)
            if (m_slot[t[k]] == noIndex)
                add(t[k]);
        m_faces.emplace_back(m_slot[t.x], m_slot[t.y], m_slot[t.z]);
    }
    m_firstPlace = m_next = m_place;
}

/// In a closed mesh each neighbour is where one edge leads that leaves a vertex. Near ones count more, which
/// keeps vertices from wandering along tubes.
void ForkFinish::linkNeighbours()
{
    m_first.assign(m_moving + 1, 0);
    for (const glm::uvec3& t : m_faces)
        for (int k = 0; k < 3; ++k)
            if (moves(t[k]))
                ++m_first[t[k] + 1];
    for (std::size_t i = 1; i < m_first.size(); ++i)
        m_first[i] += m_first[i - 1];
    m_neighbours.resize(m_first.back());
    m_weights.resize(m_first.back());
    std::vector<Index> at(m_first.begin(), m_first.end() - 1);
    for (const glm::uvec3& t : m_faces)
        for (int k = 0; k < 3; ++k)
            if (moves(t[k]))
                m_neighbours[at[t[k]]++] = t[(k + 1) % 3];
    parallelFor(m_moving, fairGrain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            double sum = 0.0;
            for (Index n = m_first[i]; n < m_first[i + 1]; ++n)
                sum += m_weights[n] =
                    1.0 / std::sqrt(std::max(glm::distance(m_place[m_neighbours[n]], m_place[i]), 1e-12));
            for (Index n = m_first[i]; n < m_first[i + 1]; ++n)
                m_weights[n] /= sum;
        }
    });
}

bool ForkFinish::gather()
{
    if (m_mesh.forkVertices.empty())
        return false;
    linkTubes();
    findWalls();
    if (m_walls.empty())
        return false;
    findRings();
    fixEnds();
    spreadLevels();
    collect();
    computeNormals();
    m_firstNormals = m_normals;
    return true;
}

/// Every vertex part of the way to the middle of its neighbours.
void ForkFinish::step(double way, Moves moves)
{
    parallelFor(m_moving, fairGrain, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            glm::dvec3 middle(0.0);
            for (Index n = m_first[i]; n < m_first[i + 1]; ++n)
                middle += m_weights[n] * m_place[m_neighbours[n]];
            const glm::dvec3 aside = middle - m_place[i];
            const bool goes = moves == Moves::All || glm::dot(aside, m_normals[i]) > 0.0;
            m_next[i] = m_place[i] + (goes ? way * followShares[m_level[m_vertices[i]]] : 0.0) * aside;
        }
    });
    m_place.swap(m_next);
}

/// A triangle may turn far where a valley is filled, as long as it faces the way of the surface around it, or
/// did so no more before.
bool ForkFinish::turnedOver(std::size_t face) const
{
    const glm::uvec3& corners = m_faces[face];
    const glm::dvec3 was = spanOf(cornersIn(m_firstPlace, corners)), is = spanOf(cornersIn(m_place, corners));
    const double old = glm::dot(was, was), area = glm::dot(is, is), turn = glm::dot(was, is);
    if (area < leastAreaLeft * leastAreaLeft * old)
        return true;
    if (turn > 0.0 && turn * turn > 0.25 * old * area)
        return false;
    glm::dvec3 aroundBefore(0.0), aroundNow(0.0);
    for (int k = 0; k < 3; ++k)
        if (moves(corners[k])) {
            aroundBefore += unitOf(m_firstNormals[corners[k]]);
            aroundNow += unitOf(m_normals[corners[k]]);
        }
    const double facing = glm::dot(unitOf(is), unitOf(aroundNow));
    return facing < leastFacing && facing < glm::dot(unitOf(was), unitOf(aroundBefore));
}

/// Where a triangle turned over, its corners go half of the way back to where they were, in the end all of
/// it. Then it is as it was.
void ForkFinish::takeBackFolds(std::vector<std::uint8_t> state)
{
    std::vector<std::uint8_t> back(m_moving, 0), isSpoilt(m_faces.size());
    for (bool again = true; again;) {
        again = false;
        const auto isChanged = [&](Index slot) { return moves(slot) && state[slot] == Changed; };
        parallelFor(m_faces.size(), fairGrain, [&](std::size_t from, std::size_t to) {
            for (std::size_t f = from; f < to; ++f) {
                const glm::uvec3& t = m_faces[f];
                isSpoilt[f] = (isChanged(t.x) || isChanged(t.y) || isChanged(t.z)) && turnedOver(f) ? 1 : 0;
            }
        });
        std::ranges::fill(state, std::uint8_t(Stays));
        for (std::size_t f = 0; f < m_faces.size(); ++f)
            for (int k = 0; k < 3 && isSpoilt[f] != 0; ++k)
                if (const Index slot = m_faces[f][k]; moves(slot))
                    state[slot] = Spoilt;
        for (Index i = 0; i < m_moving; ++i)
            if (state[i] == Spoilt && back[i] <= mostHalvings) {
                m_place[i] = back[i] < mostHalvings ? 0.5 * (m_firstPlace[i] + m_place[i]) : m_firstPlace[i];
                ++back[i];
                state[i] = Changed;
                again = true;
            }
    }
}

/// Not of unit length: triangles count by their areas.
void ForkFinish::computeNormals()
{
    m_normals.assign(m_place.size(), glm::dvec3(0.0));
    for (const glm::uvec3& t : m_faces) {
        const glm::dvec3 normal = spanOf(cornersIn(m_place, t));
        for (int k = 0; k < 3; ++k)
            m_normals[t[k]] += normal;
    }
}

void ForkFinish::fair(double strength)
{
    linkNeighbours();
    for (int round = 0; round < fillRounds; ++round) {
        if (round == fillRounds / 2) // those of gather() do for the first half
            computeNormals();
        step(fillStep * strength, Moves::Outward);
    }
    for (int round = 0; round < fairRounds; ++round) {
        step(inStep * strength, Moves::All);
        step(outStep * strength, Moves::All);
    }
    computeNormals();
    takeBackFolds(std::vector<std::uint8_t>(m_moving, Changed));
}

/// -1..1: does a wall's vertex lie above its limb, seen along the stem?
double ForkFinish::upTheStem(const WallVertex& wall) const
{
    const TubeAxis &limb = m_mesh.axes[wall.thin], &stem = m_mesh.axes[wall.thick];
    const glm::dvec3 up = glm::normalize(stem.curve.h1 - stem.curve.h0);
    const glm::dvec3 along = glm::normalize(limb.curve.h1 - limb.curve.h0);
    glm::dvec3 out = m_place[slotOf(wall)] - limb.curve.h0;
    out -= glm::dot(out, along) * along;
    const glm::dvec3 above = up - glm::dot(up, along) * along;
    const double lengths = glm::length(out) * glm::length(above);
    return lengths > 0.0 ? glm::dot(out, above) / lengths : 0.0;
}

/// Of a stem's diameter, with a sign: below 0 is a crease.
double ForkFinish::ridgeAt(const WallVertex& wall) const
{
    const TubeAxis &limb = m_mesh.axes[wall.thin], &stem = m_mesh.axes[wall.thick];
    const ForkVertex& fork = m_mesh.forkVertices[wall.fork];
    const double ratio = limb.a0 / stem.a0;
    if (fork.weight[0] == 0.0F)
        return easeRidge(upTheStem(wall)) * std::min(1.0, ratio / fullRidge);
    const glm::dvec3 one = limb.curve.h1 - limb.curve.h0, other = stem.curve.h1 - stem.curve.h0;
    const bool isNarrow = glm::dot(one, other) > creaseAngle * glm::length(one) * glm::length(other);
    const double highest = m_highest[wall.fork];
    const double height = highest > 0.0F ? easeRidge(double(fork.along) / highest) : 0.0;
    return isNarrow && ratio > twinShare ? -creaseDepth * height : height * std::min(1.0, ratio / fullRidge);
}

/// The walls of one fork between the same tubes stand together.
void ForkFinish::findHighest()
{
    m_highest.assign(m_mesh.forkVertices.size(), 0.0F);
    for (std::size_t first = 0; first < m_walls.size();) {
        std::size_t end = first;
        float highest = 0.0F;
        for (; end < m_walls.size() && m_walls[end].thick == m_walls[first].thick &&
               m_walls[end].thin == m_walls[first].thin;
             ++end)
            highest = std::max(highest, m_mesh.forkVertices[m_walls[end].fork].along);
        for (; first < end; ++first)
            m_highest[m_walls[first].fork] = highest;
    }
}

/// m, per slot: in a narrow valley there is room for a low ridge.
std::vector<double> ForkFinish::roomForRidges() const
{
    std::vector<double> room(m_place.size(), std::numeric_limits<double>::max());
    for (const glm::uvec3& t : m_faces)
        for (int k = 0; k < 3; ++k) {
            const Index a = t[k], b = t[(k + 1) % 3];
            if (m_level[m_vertices[a]] == m_level[m_vertices[b]])
                continue;
            const double length = ridgeRoom * glm::distance(m_place[a], m_place[b]);
            room[a] = std::min(room[a], length);
            room[b] = std::min(room[b], length);
        }
    return room;
}

void ForkFinish::raiseRidges(double ridge)
{
    findHighest();
    const std::vector<double> room = roomForRidges();
    const std::vector<glm::dvec3> flat = m_place;
    std::vector<std::uint8_t> state(m_moving, Stays);
    for (const WallVertex& wall : m_walls) {
        const Index slot = slotOf(wall);
        const double length = moves(slot) ? glm::length(m_normals[slot]) : 0.0;
        if (!(length > 0.0))
            continue;
        const double height = ridge * 2.0 * m_mesh.axes[wall.thick].radiusAt(0.0) * ridgeAt(wall);
        if (std::abs(height) < leastRidge)
            continue;
        m_place[slot] += (std::clamp(height, -room[slot], room[slot]) / length) * m_normals[slot];
        state[slot] = Changed;
    }
    takeBackFolds(std::move(state));
    takeBackCrossings(flat);
}

/// Where a ridge runs through what is beside it, there is none.
void ForkFinish::takeBackCrossings(const std::vector<glm::dvec3>& flat)
{
    const std::vector<glm::vec3> positions(m_place.begin(), m_place.end());
    const auto isRaised = [&](Index slot) { return m_place[slot] != flat[slot]; };
    std::vector<PrimitiveBounds> boxes;
    for (Index i = 0; i < m_faces.size(); ++i) {
        const glm::uvec3& t = m_faces[i];
        const glm::vec3 &a = positions[t.x], &b = positions[t.y], &c = positions[t.z];
        if ((isRaised(t.x) || isRaised(t.y) || isRaised(t.z)) && viewOf(a, b, c) >= 0)
            boxes.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), i});
    }
    if (boxes.empty())
        return;
    const BoxPairs pairs(std::move(boxes));
    std::vector<Index> crossing;
    for (std::size_t chunk = 0; chunk < pairs.chunkCount(); ++chunk)
        pairs.inChunk(chunk, [&](Index i, Index j) {
            if (!haveCorner(m_faces[i], m_faces[j]) && facesMeet(positions, m_faces[i], m_faces[j]))
                crossing.insert(crossing.end(), {i, j});
        });
    for (const Index face : crossing)
        for (int k = 0; k < 3; ++k)
            m_place[m_faces[face][k]] = flat[m_faces[face][k]];
}

void ForkFinish::write()
{
    for (Index i = 0; i < m_moving; ++i)
        m_mesh.mesh.positions[m_vertices[i]] = glm::vec3(m_place[i]);
}

} // namespace

void finishForks(BranchMesh& mesh, const MeshParams& params)
{
    if (!(params.fairing > 0.0) && !(params.ridge > 0.0))
        return;
    ForkFinish forks(mesh);
    if (!forks.gather())
        return;
    if (params.fairing > 0.0)
        forks.fair(params.fairing);
    if (params.ridge > 0.0)
        forks.raiseRidges(params.ridge);
    forks.write();
}

} // namespace ramure
