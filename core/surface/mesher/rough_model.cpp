#include "core/surface/mesher/rough_model.h"

#include "core/base/float4.h"
#include "core/base/large_buffer.h"
#include "core/base/stream_copy.h"
#include "core/math/frame.h"
#include "core/math/ring.h"
#include <algorithm>
#include <cmath>
#include <cstring>

namespace ramure {
namespace {

/// Four points as they stand in memory: x y z x, y z x y, z x y z.
constexpr std::size_t together = 12;
struct Four
{
    Float4 at[3];

    static Four same(const glm::dvec3& v)
    {
        const glm::vec3 p(v);
        return {{Float4{p.x, p.y, p.z, p.x}, Float4{p.y, p.z, p.x, p.y}, Float4{p.z, p.x, p.y, p.z}}};
    }
    static Four load(const float* from)
    {
        return {{loadFloat4(from), loadFloat4(from + 4), loadFloat4(from + 8)}};
    }
    /// \param count floats to write, at most 12
    void store(float* to, std::size_t count) const
    {
        if (count < together) {
            std::memcpy(to, at, count * sizeof(float));
            return;
        }
        for (int i = 0; i < 3; ++i)
            storeFloat4(to + 4 * i, at[i]);
    }
};

/// base + size * outward
Four offset(const Four& base, float size, const Four& outward)
{
    return {{base.at[0] + size * outward.at[0], base.at[1] + size * outward.at[1],
             base.at[2] + size * outward.at[2]}};
}

/// Meshes from this size on do not stay in any cache.
constexpr std::size_t largeBytes = std::size_t(64) << 20;

/// Writes cones into a small mesh that stays in the processor's cache, and puts it into the large one when it
/// is full: at the end of arrays that have only room, so that they are written once and not first with zeros;
/// into the place of what was there where they have their size from before.
class ConeWriter
{
public:
    /// \param most vertices, and as many faces, at most
    ConeWriter(const Skeleton& skeleton, Index sides, std::size_t most, TriangleMesh& mesh)
        : m_skeleton(skeleton)
        , m_mesh(mesh)
        , m_sides(sides)
        , m_isLarge(most * (3 * sizeof(glm::vec3) + 2 * sizeof(Index)) >= largeBytes)
    {
        const std::size_t padded = (3 * std::size_t(sides) + together - 1) / together * together;
        for (std::size_t i = 0; i < padded; ++i) {
            const glm::vec2 on(ringDirection(static_cast<int>(i / 3), static_cast<int>(sides)));
            m_cosines.push_back(on.x);
            m_sines.push_back(on.y);
        }
        for (Index k = 0; k < sides; ++k) {
            const Index next = k + 1 == sides ? 0 : k + 1;
            for (const Index corner : {k, next, next + sides, k, next + sides, k + sides})
                m_corners.push_back(corner);
        }
        const std::size_t size = std::size_t(2) * sides * conesPerPart;
        m_part.positions.resize(size);
        m_part.normals.resize(size);
        m_part.triangles.resize(size);
        m_part.branch.resize(size);
        m_part.level.resize(size);
    }

    /// \param axis p1 - p0, not zero
    void add(Index branch, const glm::dvec3& axis, double length)
    {
        const Frame frame = frameFromTangent(axis / length);
        // The surface leans by the slope of the radius; its normal leans the other way.
        const double slope = (m_skeleton.a0[branch] - m_skeleton.a1[branch]) / length;
        const double across = 1.0 / std::sqrt(1.0 + slope * slope);
        writeRings(branch, frame, across, slope * across);
        writeFaces();
        const Index vertices = 2 * m_sides;
        std::fill_n(&m_part.branch[m_used], vertices, branch);
        std::fill_n(&m_part.level[m_used], vertices, m_skeleton.level[branch]);
        m_used += vertices;
        if (m_used == m_part.positions.size())
            flush();
    }
    void flush()
    {
        put(m_mesh.positions, m_part.positions);
        put(m_mesh.normals, m_part.normals);
        put(m_mesh.triangles, m_part.triangles);
        put(m_mesh.branch, m_part.branch);
        put(m_mesh.level, m_part.level);
        m_done += m_used;
        m_used = 0;
    }
    void finish()
    {
        flush();
        endStreamCopies();
        m_mesh.positions.resize(m_done);
        m_mesh.normals.resize(m_done);
        m_mesh.triangles.resize(m_done);
        m_mesh.branch.resize(m_done);
        m_mesh.level.resize(m_done);
    }

private:
    template <class T> void put(std::vector<T>& to, const std::vector<T>& part)
    {
        if (to.size() < std::size_t(m_done) + m_used)
            to.insert(to.end(), part.begin(), part.begin() + m_used);
        else if (m_isLarge)
            streamCopy(&to[m_done], part.data(), m_used * sizeof(T));
        else
            std::copy_n(part.begin(), m_used, to.begin() + m_done);
    }
    void writeRings(Index branch, const Frame& frame, double across, double along)
    {
        const Four u = Four::same(frame.normal), v = Four::same(frame.binormal);
        const Four p0 = Four::same(m_skeleton.p0[branch]), p1 = Four::same(m_skeleton.p1[branch]);
        const Four lean = Four::same(along * frame.tangent);
        const auto a0 = static_cast<float>(m_skeleton.a0[branch]),
                   a1 = static_cast<float>(m_skeleton.a1[branch]);
        float *low = &m_part.positions[m_used].x, *high = &m_part.positions[m_used + m_sides].x;
        float *lowNormal = &m_part.normals[m_used].x, *highNormal = &m_part.normals[m_used + m_sides].x;
        const std::size_t floats = 3 * std::size_t(m_sides);
        for (std::size_t from = 0; from < floats; from += together) {
            const Four c = Four::load(&m_cosines[from]), s = Four::load(&m_sines[from]);
            Four outward;
            for (int i = 0; i < 3; ++i)
                outward.at[i] = c.at[i] * u.at[i] + s.at[i] * v.at[i];
            const std::size_t count = std::min(together, floats - from);
            offset(p0, a0, outward).store(low + from, count);
            offset(p1, a1, outward).store(high + from, count);
            const Four normal = offset(lean, static_cast<float>(across), outward);
            normal.store(lowNormal + from, count);
            normal.store(highNormal + from, count);
        }
    }
    void writeFaces()
    {
        const Index first = m_done + m_used;
        Index* corner = &m_part.triangles[m_used].x;
        for (std::size_t i = 0; i < m_corners.size(); ++i)
            corner[i] = m_corners[i] + first;
    }

    static constexpr Index conesPerPart = 16;
    const Skeleton& m_skeleton;
    TriangleMesh& m_mesh;
    Index m_sides;
    std::vector<float> m_cosines, m_sines; ///< of each point around, three times; filled up to whole Fours
    std::vector<Index> m_corners;          ///< of the faces of one cone
    TriangleMesh m_part;
    bool m_isLarge;
    Index m_done = 0; ///< vertices in m_mesh
    Index m_used = 0; ///< vertices of m_part in use; a cone has as many faces as vertices
};

} // namespace

TriangleMesh buildRoughBranches(const Skeleton& skeleton, int radialDivisions, TriangleMesh used)
{
    const int sides = std::max(radialDivisions, 3);
    TriangleMesh mesh;
    const std::size_t vertices = std::size_t(skeleton.size()) * 2 * static_cast<std::size_t>(sides);
    const auto prepare = [vertices](auto& to, auto& from) {
        if (from.capacity() >= vertices && from.capacity() / 4 <= vertices)
            to = std::move(from);
        if (to.size() < vertices)
            to.clear();
        reserveHuge(to, vertices);
    };
    prepare(mesh.positions, used.positions);
    prepare(mesh.normals, used.normals);
    prepare(mesh.branch, used.branch);
    prepare(mesh.level, used.level);
    prepare(mesh.triangles, used.triangles);
    ConeWriter writer(skeleton, static_cast<Index>(sides), vertices, mesh);
    for (Index i = 0; i < skeleton.size(); ++i) {
        const glm::dvec3 axis = skeleton.p1[i] - skeleton.p0[i];
        if (const double length = glm::length(axis); length > 0.0)
            writer.add(i, axis, length);
    }
    writer.finish();
    return mesh;
}

} // namespace ramure
