#include "core/surface/mesh/mesh_hash.h"

#include "core/math/random.h"
#include <array>
#include <bit>

namespace ramure {
namespace {

constexpr std::uint64_t oddA = 0x9E3779B97F4A7C15ull, oddB = 0xD1B54A32D192ED03ull;

/// Four lanes that do not wait for each other: the processor works on all of them at once.
class HashLanes
{
public:
    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        const std::size_t pair = m_count % 2 * 2;
        mix(pair, std::uint64_t(a) << 32 | b);
        mix(pair + 1, std::uint64_t(c) << 32 | (m_count & 0xFFFFFFFFu));
        ++m_count;
    }
    /// What came so far stays apart from what comes.
    void close(std::uint64_t size)
    {
        mix(2, size);
        for (std::size_t i = 0; i < m_lanes.size(); ++i)
            m_lanes[(i + 1) % m_lanes.size()] ^= mixBits(m_lanes[i] + oddB * (i + 1));
    }
    [[nodiscard]] MeshHash value() const
    {
        MeshHash hash;
        for (const std::uint64_t lane : m_lanes) {
            hash.high = mixBits(hash.high * oddA + lane);
            hash.low = mixBits((hash.low ^ lane) * oddB + 1);
        }
        return hash;
    }

private:
    void mix(std::size_t lane, std::uint64_t word)
    {
        m_lanes[lane] = std::rotl(m_lanes[lane] ^ word * oddA, 29) * oddB + oddA;
    }

    std::array<std::uint64_t, 4> m_lanes{oddA, oddB, ~oddA, ~oddB};
    std::uint64_t m_count = 0;
};

std::uint32_t bitsOf(float number)
{
    return std::bit_cast<std::uint32_t>(number == 0.0f ? 0.0f : number);
}

} // namespace

std::string MeshHash::text() const
{
    static constexpr char digits[] = "0123456789abcdef";
    std::string out;
    for (const std::uint64_t half : {high, low})
        for (int shift = 60; shift >= 0; shift -= 4)
            out += digits[half >> shift & 15u];
    return out;
}

MeshHash meshHash(const TriangleMesh& mesh)
{
    HashLanes lanes;
    for (const glm::vec3& p : mesh.positions)
        lanes.add(bitsOf(p.x), bitsOf(p.y), bitsOf(p.z));
    lanes.close(mesh.positions.size());
    for (const glm::uvec3& t : mesh.triangles)
        lanes.add(t.x, t.y, t.z);
    lanes.close(mesh.triangles.size());
    return lanes.value();
}

} // namespace ramure
