#include "core/surface/texture/texture_coordinates.h"

#include "core/base/parallel.h"
#include "core/math/angle.h"
#include "core/params/param_def.h"
#include "core/surface/texture/texture_tube.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>

namespace ramure {

namespace {

constexpr double usualAround = 4.0;      ///< tiles around the thickest root, where no size is given
constexpr double mostAround = 1e6;       ///< more of them than floats tell apart
constexpr std::size_t tubesInPiece = 16; ///< about a tenth of a millisecond of work
constexpr std::size_t pollEvery = 512;   ///< tubes

/// What tubes hand on to those that grow on them.
struct Shared
{
    const BranchMesh& mesh;
    std::vector<std::uint8_t> isWall;      ///< per vertex
    std::vector<std::uint8_t> isLimb;      ///< per tube: see gather
    std::vector<std::uint8_t> isKnown;     ///< per vertex that is no wall: a tube has given it coordinates
    std::vector<glm::vec2> uv;             ///< per vertex that is known: on the tube that made it
    std::vector<TubeTextureEnd> ends;      ///< per tube
    std::vector<Index> parent;             ///< per tube: the one it starts from, or noIndex
    std::vector<std::vector<Index>> waves; ///< tubes whose parents are in the waves before
    std::vector<Index> wave;               ///< per tube
    std::vector<Index> owner;              ///< per vertex that is no wall: the first tube that has it
};

/// The coordinates of some tubes, one after the other.
struct Piece
{
    struct Tube
    {
        Index tube, first, count; ///< its coordinates in this piece
    };
    std::vector<glm::vec2> uv;
    std::vector<Index> vertex;
    std::vector<float> radius;
    std::vector<Tube> tubes;
    Index apart = 0;
};

/// Unrolls tubes; one per thread.
class TubeUnroller
{
public:
    TubeUnroller(const Shared& shared, const TileScale& scale)
        : m_tube(scale)
        , m_slot(shared.mesh.mesh.positions.size(), 0)
    {
    }
    /// Corners of the tube's triangles go to their place in \p corners, counted from its own first one.
    void unroll(Shared& shared, Index tube, Piece& piece, std::vector<glm::uvec3>& corners);

private:
    /// \param isLimb it leaves a thicker tube to its side: the bark does not go on from there.
    void gather(const Shared& shared, Index tube, Index first, Index end, bool isLimb);
    void gatherFoot(const BranchMesh& mesh, const FootSize& foot, Index first, Index end);
    void write(Shared& shared, Index tube, std::span<glm::uvec3> corners);
    glm::uvec3 place(const BranchMesh& mesh, const glm::uvec3& triangle);
    Index add(const TubeTextureVertex& vertex, const glm::dvec2& uv);

    TubeTexture m_tube;
    Piece* m_piece = nullptr;
    Index m_begin = 0;                             ///< of the tube's coordinates in the piece
    std::vector<glm::uvec3> m_triangles;           ///< of the tube: places in it
    std::vector<Index> m_footSlots;                ///< per place on a trunk's foot: its place in the tube
    std::vector<Index> m_slot;                     ///< per vertex: its place in the tube at hand, if any
    std::vector<Index> m_plain, m_shifted, m_flat; ///< per vertex of the tube: its coordinates
};

void TubeUnroller::gather(const Shared& shared, Index tube, Index first, Index end, bool isLimb)
{
    for (Index t = first; t < end; ++t) {
        glm::uvec3& corners = m_triangles.emplace_back();
        for (int c = 0; c < 3; ++c) {
            const Index vertex = shared.mesh.mesh.triangles[t][c];
            const std::span<const TubeTextureVertex> known = m_tube.vertices();
            Index& slot = m_slot[vertex];
            if (slot >= known.size() || known[slot].vertex != vertex) {
                // Tubes of one wave are unrolled at once: what they share is known to none of the others.
                const Index owner = shared.owner[vertex];
                const bool isKnown =
                    owner != noIndex && shared.wave[owner] < shared.wave[tube] && shared.isKnown[vertex] != 0;
                const bool onWall = shared.isWall[vertex] != 0 || (isLimb && isKnown);
                const bool onParent = !onWall && isKnown;
                slot = m_tube.addVertex(vertex, shared.mesh.mesh.positions[vertex], onParent, onWall,
                                        onParent ? shared.uv[vertex] : glm::vec2(0.0f));
            }
            corners[c] = slot;
        }
    }
}

/// A trunk with roots: triangles take the valleys' vertices as those of their own root.
void TubeUnroller::gatherFoot(const BranchMesh& mesh, const FootSize& foot, Index first, Index end)
{
    const std::span<const glm::uvec3> triangles(mesh.mesh.triangles.data() + first, end - first);
    Index pole = noIndex;
    for (const glm::uvec3& t : triangles)
        pole = std::min({pole, t.x, t.y, t.z});
    const Index points = foot.points, perRoot = points / foot.roots, across = perRoot + 1;
    const Index count = foot.rings * points, highest = count - points;
    m_footSlots.assign(std::size_t(foot.rings) * foot.roots * across, noIndex);
    for (const glm::uvec3& t : triangles) {
        Index root = noIndex;
        for (int c = 0; c < 3; ++c)
            if (const Index number = t[c] - pole - 1; number < count && number % perRoot + 1 < perRoot)
                root = number % points / perRoot;
        glm::uvec3& corners = m_triangles.emplace_back();
        for (int c = 0; c < 3; ++c) {
            const Index number = t[c] - pole - 1;
            const glm::vec3& position = mesh.mesh.positions[t[c]];
            if (number >= count) {
                const std::span<const TubeTextureVertex> known = m_tube.vertices();
                Index& slot = m_slot[t[c]];
                if (slot >= known.size() || known[slot].vertex != t[c])
                    slot = m_tube.addVertex(t[c], position, false, false, glm::vec2(0.0F));
                corners[c] = slot;
                continue;
            }
            const Index own = number % points / perRoot;
            const bool isBefore = number < highest && root != noIndex && root != own; // the valley before it
            const Index place = (number / points * foot.roots + (isBefore ? root : own)) * across +
                                (isBefore ? 0 : number % perRoot + 1);
            if (m_footSlots[place] == noIndex)
                m_footSlots[place] = m_tube.addFootVertex(t[c], position, place, foot);
            corners[c] = m_footSlots[place];
        }
    }
}

Index TubeUnroller::add(const TubeTextureVertex& vertex, const glm::dvec2& uv)
{
    const auto index = static_cast<Index>(m_piece->uv.size()) - m_begin;
    m_piece->uv.emplace_back(uv);
    m_piece->vertex.push_back(vertex.vertex);
    m_piece->radius.push_back(static_cast<float>(vertex.radius));
    return index;
}

void TubeUnroller::write(Shared& shared, Index tube, std::span<glm::uvec3> corners)
{
    const std::span<const TubeTextureVertex> vertices = m_tube.vertices();
    m_plain.assign(vertices.size(), noIndex);
    m_shifted.assign(vertices.size(), noIndex);
    m_flat.assign(vertices.size(), noIndex);
    // A ring's vertices get their place on the tube first: children go on from there, not from a cap.
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const TubeTextureVertex& vertex = vertices[i];
        if (vertex.isPole)
            continue;
        m_plain[i] = add(vertex, {vertex.u, vertex.v});
        if (!vertex.onWall && shared.owner[vertex.vertex] == tube) {
            shared.isKnown[vertex.vertex] = 1;
            shared.uv[vertex.vertex] = glm::vec2(vertex.u, vertex.v);
        }
    }
    std::ranges::transform(m_triangles, corners.begin(),
                           [&](const glm::uvec3& triangle) { return place(shared.mesh, triangle); });
}

/// The coordinates of a triangle's corners.
glm::uvec3 TubeUnroller::place(const BranchMesh& mesh, const glm::uvec3& triangle)
{
    const std::span<const TubeTextureVertex> vertices = m_tube.vertices();
    const bool cap = m_tube.isCap(triangle);
    const std::array<bool, 3> beyond = m_tube.beyondSeam(triangle);
    std::array<glm::vec2, 3> uv;
    std::array<Index*, 3> slot{};
    for (int c = 0; c < 3; ++c) {
        const TubeTextureVertex& vertex = vertices[triangle[c]];
        const auto corner = static_cast<std::size_t>(c);
        std::vector<Index>& kind = cap ? m_flat : beyond[corner] ? m_shifted : m_plain;
        slot[corner] = &kind[triangle[c]];
        uv[corner] = cap ? glm::vec2(m_tube.onDisc(vertex, mesh.mesh.positions[vertex.vertex]))
                         : glm::vec2(vertex.u + (beyond[corner] ? m_tube.around() : 0.0), vertex.v);
    }
    const glm::dvec2 a(uv[0]), ab = glm::dvec2(uv[1]) - a, ac = glm::dvec2(uv[2]) - a;
    const bool folded = !(ab.x * ac.y - ab.y * ac.x > 0.0);
    const std::array<glm::dvec2, 3> apart = folded ? m_tube.apart(triangle) : std::array<glm::dvec2, 3>{};
    m_piece->apart += folded ? 1 : 0;
    glm::uvec3 out;
    for (int c = 0; c < 3; ++c) {
        const auto corner = static_cast<std::size_t>(c);
        const TubeTextureVertex& vertex = vertices[triangle[c]];
        if (folded)
            out[c] = add(vertex, apart[corner]);
        else if (*slot[corner] == noIndex)
            out[c] = *slot[corner] = add(vertex, uv[corner]);
        else
            out[c] = *slot[corner];
    }
    return out;
}

void TubeUnroller::unroll(Shared& shared, Index index, Piece& piece, std::vector<glm::uvec3>& corners)
{
    const std::vector<TubeRange>& tubes = shared.mesh.tubes;
    const Index first = tubes[index].firstTriangle;
    const Index end =
        index + 1 < tubes.size() ? tubes[index + 1].firstTriangle : shared.mesh.mesh.faceCount();
    const Index parent = shared.parent[index];
    m_piece = &piece;
    m_begin = static_cast<Index>(piece.uv.size());
    TubeTextureEnd below = parent == noIndex ? TubeTextureEnd{} : shared.ends[parent];
    const bool isLimb = shared.isLimb[index] != 0;
    if (isLimb) {
        below.around = 0.0;
        below.bend = glm::dvec3(0.0);
    }
    m_tube.begin();
    m_triangles.clear();
    if (const FootSize& foot = shared.mesh.axes[index].foot; foot.rings > 0)
        gatherFoot(shared.mesh, foot, first, end);
    else
        gather(shared, index, first, end, isLimb);
    m_tube.unroll(shared.mesh.axes[index], below, m_triangles);
    shared.ends[index] = m_tube.end();
    write(shared, index, {corners.data() + first, end - first});
    piece.tubes.push_back({index, m_begin, static_cast<Index>(piece.uv.size()) - m_begin});
}

Shared shareOf(const BranchMesh& mesh)
{
    const std::size_t vertices = mesh.mesh.positions.size(), tubes = mesh.tubes.size();
    Shared shared{mesh, {}, {}, {}, {}, {}, {}, {}, {}, {}};
    shared.isWall.assign(vertices, 0);
    for (const ForkVertex& fork : mesh.forkVertices)
        shared.isWall[fork.vertex] = 1;
    shared.isKnown.assign(vertices, 0);
    shared.uv.resize(vertices);
    shared.ends.resize(tubes);
    shared.parent.assign(tubes, noIndex);
    Index branches = 0;
    for (const TubeRange& tube : mesh.tubes)
        branches = std::max(branches, tube.branch + 1);
    std::vector<Index> firstTubeOf(branches, noIndex), tubeOf(branches, noIndex);
    std::vector<Index>& wave = shared.wave;
    wave.assign(tubes, 0);
    for (Index t = 0; t < tubes; ++t) {
        const TubeRange& tube = mesh.tubes[t];
        if (tube.parent != noIndex && tube.parent < branches && tubeOf[tube.parent] != noIndex) {
            shared.parent[t] = tubeOf[tube.parent];
            wave[t] = wave[shared.parent[t]] + 1;
        }
        tubeOf[tube.branch] = t; // the upper part of a branch comes after all that leaves the lower one
        firstTubeOf[tube.branch] = std::min(firstTubeOf[tube.branch], t);
        if (wave[t] >= shared.waves.size())
            shared.waves.emplace_back();
        shared.waves[wave[t]].push_back(t);
    }
    shared.owner.assign(vertices, noIndex);
    for (const std::vector<Index>& tubesOfWave : shared.waves)
        for (const Index t : tubesOfWave) {
            const std::size_t end =
                t + 1 < tubes ? mesh.tubes[t + 1].firstTriangle : mesh.mesh.triangles.size();
            for (std::size_t f = mesh.tubes[t].firstTriangle; f < end; ++f)
                for (int c = 0; c < 3; ++c)
                    if (Index& owner = shared.owner[mesh.mesh.triangles[f][c]]; owner == noIndex)
                        owner = t;
        }
    // Walls that follow the stem alone are the arches over its limbs.
    shared.isLimb.assign(tubes, 0);
    for (const ForkVertex& fork : mesh.forkVertices)
        if (fork.branch[2] == noIndex && fork.weight[0] == 0.0F && fork.branch[0] < branches &&
            firstTubeOf[fork.branch[0]] != noIndex)
            shared.isLimb[firstTubeOf[fork.branch[0]]] = 1;
    return shared;
}

/// All tubes on as many threads as there are, parents first; the same on any number of them.
class CoordinateBuilder
{
public:
    CoordinateBuilder(const BranchMesh& mesh, const TileScale& scale)
        : m_shared(shareOf(mesh))
        , m_scale(scale)
    {
        m_result.corners.resize(mesh.mesh.triangles.size());
        m_result.tileSize = scale.tileSize;
    }
    bool run(const Progress& progress);
    TextureCoordinates join();

private:
    std::unique_ptr<TubeUnroller> borrow();
    void unroll(std::span<const Index> tubes);

    Shared m_shared;
    TileScale m_scale;
    TextureCoordinates m_result;
    std::vector<Piece> m_pieces;
    std::mutex m_mutex;
    std::vector<std::unique_ptr<TubeUnroller>> m_idle;
};

std::unique_ptr<TubeUnroller> CoordinateBuilder::borrow()
{
    const std::scoped_lock lock(m_mutex);
    if (m_idle.empty())
        return std::make_unique<TubeUnroller>(m_shared, m_scale);
    std::unique_ptr<TubeUnroller> unroller = std::move(m_idle.back());
    m_idle.pop_back();
    return unroller;
}

void CoordinateBuilder::unroll(std::span<const Index> tubes)
{
    const std::size_t first = m_pieces.size();
    m_pieces.resize(first + (tubes.size() + tubesInPiece - 1) / tubesInPiece);
    parallelFor(tubes.size(), tubesInPiece, [&](std::size_t from, std::size_t to) {
        std::unique_ptr<TubeUnroller> unroller = borrow();
        Piece& piece = m_pieces[first + from / tubesInPiece];
        for (std::size_t i = from; i < to; ++i)
            unroller->unroll(m_shared, tubes[i], piece, m_result.corners);
        const std::scoped_lock lock(m_mutex);
        m_idle.push_back(std::move(unroller));
    });
}

/// False: cancelled.
bool CoordinateBuilder::run(const Progress& progress)
{
    std::size_t done = 0, told = 0;
    for (const std::vector<Index>& wave : m_shared.waves)
        for (std::size_t i = 0; i < wave.size(); i += pollEvery) {
            const std::size_t count = std::min(pollEvery, wave.size() - i);
            unroll({wave.data() + i, count});
            done += count;
            if (done - told < pollEvery && done < m_shared.ends.size())
                continue;
            told = done;
            if (progress.cancelled())
                return false;
            progress.report(double(done) / double(m_shared.ends.size()));
        }
    return true;
}

/// Puts the tubes' coordinates one after the other, in the order of the tubes.
TextureCoordinates CoordinateBuilder::join()
{
    struct Place
    {
        const Piece* piece;
        Index from, count, to;
    };
    const std::vector<TubeRange>& tubes = m_shared.mesh.tubes;
    std::vector<Place> places(tubes.size());
    for (const Piece& piece : m_pieces) {
        for (const Piece::Tube& tube : piece.tubes)
            places[tube.tube] = {&piece, tube.first, tube.count, 0};
        m_result.apart += piece.apart;
    }
    Index sum = 0;
    for (Place& place : places) {
        place.to = sum;
        sum += place.count;
    }
    m_result.uv.resize(sum);
    m_result.vertex.resize(sum);
    m_result.radius.resize(sum);
    parallelFor(places.size(), pollEvery, [&](std::size_t from, std::size_t to) {
        for (std::size_t t = from; t < to; ++t) {
            const Place& place = places[t];
            const auto copied = [&place](const auto& source, auto& target) {
                std::copy_n(source.data() + place.from, place.count, target.data() + place.to);
            };
            copied(place.piece->uv, m_result.uv);
            copied(place.piece->vertex, m_result.vertex);
            copied(place.piece->radius, m_result.radius);
            const std::size_t end =
                t + 1 < tubes.size() ? tubes[t + 1].firstTriangle : m_result.corners.size();
            for (std::size_t f = tubes[t].firstTriangle; f < end; ++f)
                m_result.corners[f] += place.to;
        }
    });
    return std::move(m_result);
}

/// The size of tiles on the thickest root.
TileScale scaleOf(const BranchMesh& mesh, double wanted)
{
    TileScale scale{wanted, 0.0};
    for (std::size_t t = 0; t < mesh.tubes.size(); ++t)
        if (mesh.tubes[t].parent == noIndex)
            scale.radius = std::max(scale.radius, mesh.axes[t].radiusAt(0.5));
    if (wanted == 0.0)
        scale.tileSize = fullTurn * scale.radius / usualAround;
    return scale;
}

Expected<void> check(const BranchMesh& mesh, const TextureParams& params)
{
    const bool usable = !mesh.tubes.empty() && mesh.axes.size() == mesh.tubes.size() &&
                        mesh.tubes.front().firstTriangle == 0 &&
                        mesh.tubes.back().firstTriangle <= mesh.mesh.faceCount();
    if (!usable)
        return fail(ErrorCode::Invalid,
                    RAMURE_NOOP("The mesh does not say which triangles belong to which tube"));
    if (auto checked = checkPart(&NodeParams::texture, params); !checked)
        return checked;
    double thickest = 0.0;
    for (const TubeAxis& axis : mesh.axes)
        thickest = std::max({thickest, axis.a0, axis.a1});
    if (params.tileSize == 0.0 || fullTurn * thickest <= mostAround * params.tileSize)
        return {};
    auto error = fail(ErrorCode::Invalid, RAMURE_NOOP("The texture tile is too small for the tree"));
    error.value().path = "texture.tileSize";
    return error;
}

} // namespace

Expected<TextureCoordinates> textureCoordinates(const BranchMesh& mesh, const TextureParams& params,
                                                const Progress& progress)
{
    RAMURE_TRY(check(mesh, params));
    if (progress.cancelled())
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
    CoordinateBuilder builder(mesh, scaleOf(mesh, params.tileSize));
    if (!builder.run(progress))
        return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
    return builder.join();
}

void wear(TriangleMesh& mesh, const TextureCoordinates& coordinates)
{
    mesh.uv = coordinates.uv;
    mesh.uvTriangles = coordinates.corners;
    mesh.radius.assign(mesh.positions.size(), 0.0F);
    for (std::size_t i = 0; i < coordinates.vertex.size(); ++i) {
        float& radius = mesh.radius[coordinates.vertex[i]];
        radius = std::max(radius, coordinates.radius[i]);
    }
}

TriangleMesh splitByTexture(const BranchMesh& mesh, const TextureCoordinates& coordinates)
{
    TriangleMesh split;
    const std::size_t count = coordinates.uv.size();
    split.triangles = coordinates.corners;
    split.uv = coordinates.uv;
    split.radius = coordinates.radius;
    split.positions.reserve(count);
    split.normals.reserve(count);
    split.branch.reserve(count);
    split.level.reserve(count);
    for (const Index vertex : coordinates.vertex) {
        split.positions.push_back(mesh.mesh.positions[vertex]);
        split.normals.push_back(mesh.mesh.normals[vertex]);
        split.branch.push_back(mesh.mesh.branch[vertex]);
        split.level.push_back(mesh.mesh.level[vertex]);
    }
    return split;
}

} // namespace ramure
