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

constexpr double leastAround = 6.0; ///< tiles around the thinnest branch, where the size is chosen for it
constexpr double mostAround = 1e6;  ///< more of them than floats tell apart
constexpr std::size_t tubesInPiece = 16; ///< about half a millisecond of work
constexpr std::size_t pollEvery = 512;   ///< tubes
/// Most trees are done at the first attempt; one that falls a little short is done again at the next, with
/// more care for its worst tubes.
struct Attempt
{
    TubeTexture::Care care;
    double part;     ///< of the time, when it is done
    double hopeless; ///< of the triangles are stretched: the next is not worth it
};
constexpr std::array<Attempt, 3> attempts{
    {{{15, 0}, 0.1, 0.08}, {{50, 1}, 0.4, 0.065}, {{200, 4}, 1.0, 0.0}}};
constexpr double goal = 0.042, gain = 0.2; ///< for which tubes are chosen; of their stretched triangles
constexpr double fewStretched = 0.049;     ///< of the triangles
constexpr double worthIt = 0.9;            ///< of them, after an attempt, and the next is made
constexpr Index mostThorough = 100'000;    ///< triangles: some seconds of work

/// What tubes hand on to those that grow on them.
struct Shared
{
    const BranchMesh& mesh;
    std::vector<std::uint8_t> isWall;      ///< per vertex
    std::vector<std::uint8_t> isLimb;      ///< per tube: see gather
    std::vector<std::uint8_t> isKnown;     ///< per vertex that is no wall: a tube has given it coordinates
    std::vector<glm::vec2> uv;             ///< per vertex that is known: on the tube that made it
    std::vector<TubeTextureEnd> ends;      ///< per tube
    std::vector<Index> stretched;          ///< per tube: triangles
    std::vector<Index> parent;             ///< per tube: the one it starts from, or noIndex
    std::vector<std::vector<Index>> waves; ///< tubes whose parents are in the waves before
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
    std::vector<Tube> tubes;
    Index open = 0, apart = 0;
};

/// Unrolls tubes; one per thread.
class TubeUnroller
{
public:
    TubeUnroller(const Shared& shared, const TubeTexture::Options& options)
        : m_tube(options)
        , m_slot(shared.mesh.mesh.positions.size(), 0)
    {
    }
    /// Corners of the tube's triangles go to their place in \p corners, counted from its own first one.
    void unroll(Shared& shared, Index tube, const TubeTexture::Care& care, Piece& piece,
                std::vector<glm::uvec3>& corners);

private:
    /// \param isLimb it leaves a thicker tube to its side: the bark does not go on from there.
    void gather(const Shared& shared, Index first, Index end, bool isLimb);
    void write(Shared& shared, glm::uvec3* corners);
    glm::uvec3 place(const BranchMesh& mesh, const glm::uvec3& triangle);
    Index add(Index vertex, const glm::dvec2& uv);

    TubeTexture m_tube;
    Piece* m_piece = nullptr;
    Index m_begin = 0;                             ///< of the tube's coordinates in the piece
    std::vector<Index> m_slot;                     ///< per vertex: its place in the tube at hand, if any
    std::vector<Index> m_plain, m_shifted, m_flat; ///< per vertex of the tube: its coordinates
};

void TubeUnroller::gather(const Shared& shared, Index first, Index end, bool isLimb)
{
    m_tube.begin();
    for (Index t = first; t < end; ++t) {
        glm::uvec3 corners;
        for (int c = 0; c < 3; ++c) {
            const Index vertex = shared.mesh.mesh.triangles[t][c];
            const std::span<const TubeTextureVertex> known = m_tube.vertices();
            Index& slot = m_slot[vertex];
            if (slot >= known.size() || known[slot].vertex != vertex) {
                const bool isKnown = shared.isKnown[vertex] != 0;
                const bool onWall = shared.isWall[vertex] != 0 || (isLimb && isKnown);
                const bool onParent = !onWall && isKnown;
                slot = m_tube.addVertex(vertex, shared.mesh.mesh.positions[vertex], onParent, onWall,
                                        onParent ? shared.uv[vertex] : glm::vec2(0.0f));
            }
            corners[c] = slot;
        }
        m_tube.addTriangle(corners);
    }
}

Index TubeUnroller::add(Index vertex, const glm::dvec2& uv)
{
    const auto index = static_cast<Index>(m_piece->uv.size()) - m_begin;
    m_piece->uv.emplace_back(uv);
    m_piece->vertex.push_back(vertex);
    return index;
}

void TubeUnroller::write(Shared& shared, glm::uvec3* corners)
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
        m_plain[i] = add(vertex.vertex, {vertex.u, vertex.v});
        if (!vertex.onWall && shared.isKnown[vertex.vertex] == 0) {
            shared.isKnown[vertex.vertex] = 1;
            shared.uv[vertex.vertex] = glm::vec2(vertex.u, vertex.v);
        }
    }
    for (const glm::uvec3& triangle : m_tube.triangles())
        *corners++ = place(shared.mesh, triangle);
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
                         : glm::vec2(vertex.u + (beyond[corner] ? vertex.around : 0.0), vertex.v);
    }
    const glm::dvec2 a(uv[0]), ab = glm::dvec2(uv[1]) - a, ac = glm::dvec2(uv[2]) - a;
    const bool folded = !(ab.x * ac.y - ab.y * ac.x > 0.0);
    const std::array<glm::dvec2, 3> apart = folded ? m_tube.apart(triangle) : std::array<glm::dvec2, 3>{};
    m_piece->apart += folded ? 1 : 0;
    glm::uvec3 out;
    for (int c = 0; c < 3; ++c) {
        const auto corner = static_cast<std::size_t>(c);
        const Index vertex = vertices[triangle[c]].vertex;
        if (folded)
            out[c] = add(vertex, apart[corner]);
        else if (*slot[corner] == noIndex)
            out[c] = *slot[corner] = add(vertex, uv[corner]);
        else
            out[c] = *slot[corner];
    }
    return out;
}

void TubeUnroller::unroll(Shared& shared, Index index, const TubeTexture::Care& care, Piece& piece,
                          std::vector<glm::uvec3>& corners)
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
    if (isLimb)
        below.around = 0.0;
    gather(shared, first, end, isLimb);
    m_tube.setCare(care);
    m_tube.unroll(shared.mesh.axes[index], below);
    shared.ends[index] = m_tube.end();
    write(shared, corners.data() + first);
    piece.open += m_tube.isOpen() ? 1 : 0;
    shared.stretched[index] = m_tube.stretchedTriangles();
    piece.tubes.push_back({index, m_begin, static_cast<Index>(piece.uv.size()) - m_begin});
}

Shared shareOf(const BranchMesh& mesh)
{
    const std::size_t vertices = mesh.mesh.positions.size(), tubes = mesh.tubes.size();
    Shared shared{mesh, {}, {}, {}, {}, {}, {}, {}, {}};
    shared.isWall.assign(vertices, 0);
    for (const ForkVertex& fork : mesh.forkVertices)
        shared.isWall[fork.vertex] = 1;
    shared.isKnown.assign(vertices, 0);
    shared.uv.resize(vertices);
    shared.ends.resize(tubes);
    shared.stretched.assign(tubes, 0);
    shared.parent.assign(tubes, noIndex);
    Index branches = 0;
    for (const TubeRange& tube : mesh.tubes)
        branches = std::max(branches, tube.branch + 1);
    std::vector<Index> tubeOf(branches, noIndex), wave(tubes, 0);
    for (Index t = 0; t < tubes; ++t) {
        const TubeRange& tube = mesh.tubes[t];
        if (tube.parent != noIndex && tube.parent < branches && tubeOf[tube.parent] != noIndex) {
            shared.parent[t] = tubeOf[tube.parent];
            wave[t] = wave[shared.parent[t]] + 1;
        }
        tubeOf[tube.branch] = t;
        if (wave[t] >= shared.waves.size())
            shared.waves.emplace_back();
        shared.waves[wave[t]].push_back(t);
    }
    // Walls that follow the stem alone are the arches over its limbs.
    shared.isLimb.assign(tubes, 0);
    for (const ForkVertex& fork : mesh.forkVertices)
        if (fork.branch[2] == noIndex && fork.weight[0] == 0.0F && fork.branch[0] < branches &&
            tubeOf[fork.branch[0]] != noIndex)
            shared.isLimb[tubeOf[fork.branch[0]]] = 1;
    return shared;
}

/// All tubes on as many threads as there are, parents first; the same on any number of them.
class CoordinateBuilder
{
public:
    /// \param attempt per tube
    CoordinateBuilder(const BranchMesh& mesh, const TubeTexture::Options& options,
                      const std::vector<std::uint8_t>& attempt)
        : m_shared(shareOf(mesh))
        , m_options(options)
        , m_attempt(attempt)
    {
        m_result.corners.resize(mesh.mesh.triangles.size());
        m_result.tileSize = options.tileSize;
    }
    bool run(const Progress& progress);
    [[nodiscard]] const std::vector<Index>& stretched() const { return m_shared.stretched; }
    TextureCoordinates join();

private:
    std::unique_ptr<TubeUnroller> borrow();
    void unroll(std::span<const Index> tubes);

    Shared m_shared;
    TubeTexture::Options m_options;
    const std::vector<std::uint8_t>& m_attempt;
    TextureCoordinates m_result;
    std::vector<Piece> m_pieces;
    std::mutex m_mutex;
    std::vector<std::unique_ptr<TubeUnroller>> m_idle;
};

std::unique_ptr<TubeUnroller> CoordinateBuilder::borrow()
{
    const std::scoped_lock lock(m_mutex);
    if (m_idle.empty())
        return std::make_unique<TubeUnroller>(m_shared, m_options);
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
            unroller->unroll(m_shared, tubes[i], attempts[m_attempt[tubes[i]]].care, piece, m_result.corners);
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
        m_result.open += piece.open;
        m_result.apart += piece.apart;
    }
    Index sum = 0;
    for (Place& place : places) {
        place.to = sum;
        sum += place.count;
    }
    m_result.uv.resize(sum);
    m_result.vertex.resize(sum);
    parallelFor(places.size(), pollEvery, [&](std::size_t from, std::size_t to) {
        for (std::size_t t = from; t < to; ++t) {
            const Place& place = places[t];
            std::copy_n(place.piece->uv.data() + place.from, place.count, m_result.uv.data() + place.to);
            std::copy_n(place.piece->vertex.data() + place.from, place.count,
                        m_result.vertex.data() + place.to);
            const std::size_t end =
                t + 1 < tubes.size() ? tubes[t + 1].firstTriangle : m_result.corners.size();
            for (std::size_t f = tubes[t].firstTriangle; f < end; ++f)
                m_result.corners[f] += place.to;
        }
    });
    return std::move(m_result);
}

/// The worst tubes, as many as may bring the whole to where it is good, are for the next attempt.
void chooseTubes(const std::vector<Index>& stretched, double triangles, std::uint8_t attempt,
                 std::vector<std::uint8_t>& attemptOf)
{
    std::vector<Index> order(stretched.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return stretched[a] > stretched[b]; });
    const Index sum = std::accumulate(stretched.begin(), stretched.end(), Index(0));
    double missing = (double(sum) - goal * triangles) / gain;
    for (const Index tube : order) {
        if (missing <= 0.0 || stretched[tube] == 0)
            return;
        attemptOf[tube] = attempt;
        missing -= double(stretched[tube]);
    }
}

double tileFor(const BranchMesh& mesh, double wanted)
{
    if (wanted > 0.0)
        return wanted;
    double thinnest = std::numeric_limits<double>::infinity();
    for (const TubeAxis& axis : mesh.axes)
        thinnest = std::min(thinnest, 0.5 * (axis.a0 + axis.a1));
    return fullTurn * thinnest / leastAround;
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
    if (fullTurn * thickest <= mostAround * tileFor(mesh, params.tileSize))
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
    const double tileSize = tileFor(mesh, params.tileSize), triangles = double(mesh.mesh.faceCount());
    const TubeTexture::Options options{tileSize, params.seamsAround};
    std::vector<std::uint8_t> attemptOf(mesh.tubes.size(), 0);
    double before = 0.0, last = 1.0;
    for (std::uint8_t attempt = 0; attempt < attempts.size(); ++attempt) {
        CoordinateBuilder builder(mesh, options, attemptOf);
        const double after = attempts[attempt].part;
        if (!builder.run(progress.part(before, after)))
            break;
        before = after;
        const std::vector<Index>& bad = builder.stretched();
        const double stretched = double(std::accumulate(bad.begin(), bad.end(), Index(0))) / triangles;
        const bool helps = stretched < attempts[attempt].hopeless && stretched < worthIt * last;
        last = stretched;
        if (stretched > fewStretched && helps && triangles <= double(mostThorough) && before < 1.0) {
            chooseTubes(bad, triangles, std::uint8_t(attempt + 1), attemptOf);
            continue;
        }
        progress.report(1.0);
        return builder.join();
    }
    return fail(ErrorCode::Cancelled, RAMURE_NOOP("Cancelled"));
}

TriangleMesh splitByTexture(const BranchMesh& mesh, const TextureCoordinates& coordinates)
{
    TriangleMesh split;
    const std::size_t count = coordinates.uv.size();
    split.triangles = coordinates.corners;
    split.uv = coordinates.uv;
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
