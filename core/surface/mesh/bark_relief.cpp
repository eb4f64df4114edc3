#include "core/surface/mesh/bark_relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

namespace ramure {
namespace {

constexpr int mostHalvings = 24;              ///< in which edges are halved
constexpr std::size_t mostReliefFaces = 4000; ///< of one relief
constexpr float mostBend = 0.25F;             ///< cosine between the direction and the surface's normals
constexpr float mostOfWood = 0.55F;           ///< of the wood's radius

float smooth(float from, float to, float x)
{
    const float t = glm::clamp((x - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

/// 1 in the middle, 0 from there on in distances of \p width.
float hump(float x, float width)
{
    const float t = std::max(0.0F, 1.0F - x * x / (width * width));
    return t * t;
}

/// Of a scar the length of an edge that shows it, in radii.
constexpr float fineness = 0.45F;

/// m, at a distance from the middle, in radii. \param wood radius of the wood, m
float heightOf(const Relief& relief, float at, float wood)
{
    switch (relief.form) {
    case Relief::Form::Burr:
        return 0.55F * relief.radius * hump(at, reliefReach);
    case Relief::Form::Hollow:
        return 0.18F * relief.radius * hump(at - 1.15F, 0.5F) -
               std::min(1.5F * relief.radius, 0.75F * wood) * smooth(1.0F, 0.55F, at);
    case Relief::Form::Scar:
        break;
    }
    // The roll closes in on the wound; once it is closed, all flattens.
    const float open = glm::clamp(1.0F - relief.healed, 0.0F, 1.0F);
    const float left = glm::clamp(1.0F - 0.5F * (relief.healed - 1.0F), 0.0F, 1.0F);
    const float roll = 0.2F * hump(at - (0.45F + 0.6F * open), 0.6F);
    const float wound = (0.12F + 0.25F * open) * hump(at, 0.35F + 0.5F * open);
    return relief.radius * left * (roll - wound);
}

using Edge = std::uint64_t;

Edge edgeOf(Index a, Index b)
{
    return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

/// How far the origin lies from the way between two points.
float distanceTo(const glm::vec2& a, const glm::vec2& b)
{
    const glm::vec2 way = b - a;
    const float squared = glm::dot(way, way);
    const float t = squared > 0.0F ? glm::clamp(-glm::dot(a, way) / squared, 0.0F, 1.0F) : 0.0F;
    return glm::length(a + t * way);
}

struct Face
{
    glm::uvec3 corners;
    Index home; ///< the old triangle
};

/// The parts of a face whose edges are halved where \p middles says.
void addParts(const Face& face, const std::unordered_map<Edge, Index>& middles, std::vector<Face>& finer)
{
    std::array<Index, 3> middle{noIndex, noIndex, noIndex};
    int halved = 0;
    for (int c = 0; c < 3; ++c)
        if (const auto found = middles.find(edgeOf(face.corners[c], face.corners[(c + 1) % 3]));
            found != middles.end()) {
            middle[std::size_t(c)] = found->second;
            ++halved;
        }
    // Turned so that the first edge is halved, and of two the second, too.
    int turn = 0;
    while (halved > 0 && halved < 3 &&
           (middle[std::size_t(turn)] == noIndex ||
            (halved == 2 && middle[std::size_t((turn + 1) % 3)] == noIndex)))
        ++turn;
    const Index a = face.corners[turn], b = face.corners[(turn + 1) % 3], c = face.corners[(turn + 2) % 3];
    const Index ab = middle[std::size_t(turn)], bc = middle[std::size_t((turn + 1) % 3)],
                ca = middle[std::size_t((turn + 2) % 3)];
    const auto add = [&](Index x, Index y, Index z) { finer.push_back({{x, y, z}, face.home}); };
    if (halved == 0)
        add(a, b, c);
    else if (halved == 1) {
        add(a, ab, c);
        add(ab, b, c);
    } else if (halved == 2) {
        add(ab, b, bc);
        add(a, ab, bc);
        add(a, bc, c);
    } else {
        add(a, ab, ca);
        add(ab, b, bc);
        add(ca, bc, c);
        add(ab, bc, ca);
    }
}

/// Where a relief lies: across it, and along it.
struct Seat
{
    glm::vec3 centre, u, v, n;
    float wood; ///< m, how deep it lies in front of the place within

    [[nodiscard]] glm::vec2 flat(const glm::vec3& at) const
    {
        return {glm::dot(at - centre, u), glm::dot(at - centre, v)};
    }
};

class ReliefDrawer
{
public:
    ReliefDrawer(TriangleMesh& mesh, const std::vector<ReliefHold>& held, std::span<const Relief> reliefs);
    void draw(const Relief& relief);
    std::vector<Index> finish();

private:
    [[nodiscard]] std::optional<std::pair<Index, Seat>> seatOf(const Relief& relief) const;
    [[nodiscard]] bool reaches(Index triangle, const Seat& seat, float reach) const;
    [[nodiscard]] bool gather(Index from, const Seat& seat, float reach, std::vector<Face>& faces);
    bool refine(const Seat& seat, float reach, float longest, std::vector<Face>& faces);
    [[nodiscard]] std::span<const Index> fan(Index vertex) const
    {
        return {m_fans.data() + m_first[vertex], m_fans.data() + m_first[vertex + 1]};
    }

    TriangleMesh& m_mesh;
    const std::vector<ReliefHold>& m_held;
    std::vector<Index> m_first, m_fans; ///< by old vertex: its triangles
    std::map<Index, std::vector<Index>>
        m_faces; ///< by branch that has reliefs: triangles with a corner on it
    std::vector<bool> m_isTaken;
    std::vector<Index> m_seen; ///< by old triangle: the round that has seen it
    Index m_round = 0;
    std::vector<Face> m_made;
};

ReliefDrawer::ReliefDrawer(TriangleMesh& mesh, const std::vector<ReliefHold>& held,
                           std::span<const Relief> reliefs)
    : m_mesh(mesh)
    , m_held(held)
    , m_first(mesh.positions.size() + 1, 0)
    , m_fans(3 * mesh.triangles.size())
    , m_isTaken(mesh.triangles.size(), false)
    , m_seen(mesh.triangles.size(), 0)
{
    for (const glm::uvec3& t : mesh.triangles)
        for (int c = 0; c < 3; ++c)
            ++m_first[t[c]];
    Index sum = 0;
    for (Index& first : m_first)
        first = std::exchange(sum, sum + first);
    std::vector<Index> next(m_first.begin(), m_first.end() - 1);
    for (Index i = 0; i < mesh.triangles.size(); ++i)
        for (int c = 0; c < 3; ++c)
            m_fans[next[mesh.triangles[i][c]]++] = i;
    for (const Relief& relief : reliefs)
        m_faces[relief.branch];
    for (Index v = 0; v < mesh.branch.size(); ++v)
        if (const auto faces = m_faces.find(mesh.branch[v]); faces != m_faces.end())
            faces->second.insert(faces->second.end(), fan(v).begin(), fan(v).end());
}

/// The surface that the way out meets first.
std::optional<std::pair<Index, Seat>> ReliefDrawer::seatOf(const Relief& relief) const
{
    const auto faces = m_faces.find(relief.branch);
    if (faces == m_faces.end())
        return {};
    const glm::vec3 u = glm::normalize(
        glm::cross(relief.out, std::abs(relief.out.y) < 0.7F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
    Seat seat{relief.from, u, glm::cross(relief.out, u), relief.out, 0.0F};
    std::optional<std::pair<Index, Seat>> found;
    for (const Index i : faces->second) {
        const glm::uvec3& t = m_mesh.triangles[i];
        const glm::vec3 &p = m_mesh.positions[t.x], &q = m_mesh.positions[t.y], &r = m_mesh.positions[t.z];
        const glm::vec2 a = seat.flat(p), b = seat.flat(q), c = seat.flat(r);
        const float bc = b.x * c.y - b.y * c.x, ca = c.x * a.y - c.y * a.x, ab = a.x * b.y - a.y * b.x;
        const float area = bc + ca + ab;
        if (!(area > 0.0F) || bc < 0.0F || ca < 0.0F || ab < 0.0F) // seen from outside, around the way
            continue;
        const float away = glm::dot((bc * p + ca * q + ab * r) / area - relief.from, relief.out);
        if (away > 0.0F && (!found || away < found->second.wood)) {
            found.emplace(i, seat);
            found->second.wood = away;
            found->second.centre = relief.from + away * relief.out;
        }
    }
    return found;
}

bool ReliefDrawer::reaches(Index triangle, const Seat& seat, float reach) const
{
    std::array<glm::vec2, 3> at;
    for (int c = 0; c < 3; ++c)
        at[std::size_t(c)] = seat.flat(m_mesh.positions[m_mesh.triangles[triangle][c]]);
    float nearest = reach;
    bool isWithin = true;
    for (std::size_t c = 0; c < 3; ++c) {
        const glm::vec2 &a = at[c], &b = at[(c + 1) % 3];
        nearest = std::min(nearest, distanceTo(a, b));
        isWithin = isWithin && a.x * b.y - a.y * b.x >= 0.0F;
    }
    return isWithin || nearest < reach;
}

/// The triangles around a place as far as the relief reaches, then those that share an edge with them.
/// \return whether they can be moved
bool ReliefDrawer::gather(Index from, const Seat& seat, float reach, std::vector<Face>& faces)
{
    std::vector<Index> inside{from}, around;
    m_seen[from] = ++m_round;
    const auto isNew = [this](Index i) { return std::exchange(m_seen[i], m_round) != m_round; };
    for (std::size_t k = 0; k < inside.size(); ++k) {
        const glm::uvec3 t = m_mesh.triangles[inside[k]];
        const glm::vec3 a = m_mesh.positions[t.x];
        const glm::vec3 normal = glm::cross(m_mesh.positions[t.y] - a, m_mesh.positions[t.z] - a);
        if (m_isTaken[inside[k]] || inside.size() > mostReliefFaces ||
            !(glm::dot(normal, seat.n) > mostBend * glm::length(normal)))
            return false;
        for (int c = 0; c < 3; ++c) {
            if (m_held[t[c]] != ReliefHold::None && glm::length(seat.flat(m_mesh.positions[t[c]])) < reach)
                return false;
            for (const Index i : fan(t[c]))
                if (reaches(i, seat, reach) &&
                    std::abs(glm::dot(m_mesh.positions[m_mesh.triangles[i].x] - seat.centre, seat.n)) <
                        8.0F * seat.wood &&
                    isNew(i))
                    inside.push_back(i);
        }
    }
    for (const Index i : inside)
        for (int c = 0; c < 3; ++c) {
            const Index a = m_mesh.triangles[i][c], b = m_mesh.triangles[i][(c + 1) % 3];
            for (const Index other : fan(a))
                if (const std::span<const Index> second = fan(b);
                    std::ranges::find(second, other) != second.end() && isNew(other))
                    around.push_back(other);
        }
    for (const std::vector<Index>* list : {&inside, &around})
        for (const Index i : *list) {
            const glm::uvec3& t = m_mesh.triangles[i];
            for (int c = 0; c < 3; ++c)
                if (m_isTaken[i] || m_held[t[c]] == ReliefHold::Triangles)
                    return false;
            faces.push_back({t, i});
        }
    return true;
}

/// One round: of each face the longest edge within the reach is halved if it is too long and two faces share
/// it, so that slivers become compact; all faces follow. \return whether there were any
bool ReliefDrawer::refine(const Seat& seat, float reach, float longest, std::vector<Face>& faces)
{
    std::unordered_map<Edge, int> edges;
    edges.reserve(2 * faces.size());
    for (const Face& face : faces)
        for (int c = 0; c < 3; ++c)
            ++edges[edgeOf(face.corners[c], face.corners[(c + 1) % 3])];
    std::unordered_map<Edge, Index> middles;
    for (const Face& face : faces) {
        float most = longest;
        int halved = -1;
        for (int c = 0; c < 3; ++c) {
            const Index a = face.corners[c], b = face.corners[(c + 1) % 3];
            const glm::vec3 &p = m_mesh.positions[a], &q = m_mesh.positions[b];
            if (const float length = glm::distance(p, q);
                length > most && edges[edgeOf(a, b)] == 2 && distanceTo(seat.flat(p), seat.flat(q)) < reach) {
                most = length;
                halved = c;
            }
        }
        if (halved < 0)
            continue;
        const Index a = face.corners[halved], b = face.corners[(halved + 1) % 3];
        if (middles.emplace(edgeOf(a, b), m_mesh.vertexCount()).second) {
            m_mesh.positions.push_back(0.5F * (m_mesh.positions[a] + m_mesh.positions[b]));
            m_mesh.branch.push_back(m_mesh.branch[std::max(a, b)]);
        }
    }
    std::vector<Face> finer;
    for (const Face& face : faces)
        addParts(face, middles, finer);
    faces = std::move(finer);
    return !middles.empty();
}

void ReliefDrawer::draw(const Relief& relief)
{
    const auto found = seatOf(relief);
    if (!found || relief.radius > mostOfWood * found->second.wood)
        return;
    const Seat& seat = found->second;
    const float reach = reliefReach * relief.radius;
    std::vector<Face> faces;
    if (!gather(found->first, seat, reach, faces))
        return;
    for (const Face& face : faces)
        m_isTaken[face.home] = true;
    for (int round = 0; round < mostHalvings && faces.size() < mostReliefFaces; ++round)
        if (!refine(seat, reach, fineness * relief.radius, faces))
            break;
    std::vector<Index> vertices;
    for (const Face& face : faces)
        for (int c = 0; c < 3; ++c)
            vertices.push_back(face.corners[c]);
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (const Index v : vertices)
        if (const float at = glm::length(seat.flat(m_mesh.positions[v])); at < reach)
            m_mesh.positions[v] += heightOf(relief, at / relief.radius, seat.wood) * seat.n;
    m_made.insert(m_made.end(), faces.begin(), faces.end());
}

std::vector<Index> ReliefDrawer::finish()
{
    if (m_made.empty())
        return {};
    std::ranges::stable_sort(m_made, {}, &Face::home);
    std::vector<glm::uvec3> triangles;
    std::vector<Index> first;
    first.reserve(m_mesh.triangles.size() + 1);
    auto made = m_made.begin();
    for (Index i = 0; i < m_mesh.triangles.size(); ++i) {
        first.push_back(Index(triangles.size()));
        if (!m_isTaken[i])
            triangles.push_back(m_mesh.triangles[i]);
        for (; made != m_made.end() && made->home == i; ++made)
            triangles.push_back(made->corners);
    }
    first.push_back(Index(triangles.size()));
    m_mesh.triangles = std::move(triangles);
    return first;
}

bool isDrawable(const Relief& relief)
{
    const glm::vec3 sum = relief.from + relief.out;
    const float length = glm::length(relief.out);
    return std::isfinite(sum.x + sum.y + sum.z) && std::isfinite(relief.healed) && relief.radius > 0.0F &&
           std::isfinite(relief.radius) && std::abs(length - 1.0F) < 1e-3F;
}

} // namespace

std::vector<Index> drawReliefs(TriangleMesh& mesh, std::span<const Relief> reliefs,
                               const std::vector<ReliefHold>& held)
{
    std::vector<Relief> drawable;
    for (const Relief& relief : reliefs)
        if (isDrawable(relief) && relief.branch != noIndex)
            drawable.push_back(relief);
    if (drawable.empty())
        return {};
    ReliefDrawer drawer(mesh, held, drawable);
    for (const Relief& relief : drawable)
        drawer.draw(relief);
    return drawer.finish();
}

} // namespace ramure
