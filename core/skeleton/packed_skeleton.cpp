#include "core/skeleton/packed_skeleton.h"

#include "core/math/finite.h"
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>
#include <span>
#include <type_traits>

namespace ramure {
namespace {

static_assert(std::endian::native == std::endian::little, "the numbers in files are little-endian");

constexpr std::uint32_t mark = 0x314b5352;       // "RSK1"
constexpr std::uint32_t rolledMark = 0x324b5352; // "RSK2": with rolls, which few trees have

/// Writes and reads the same fields in the same order.
class Packer
{
public:
    template <class T> void operator()(const T& value)
    {
        static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, double> ||
                      std::is_same_v<T, glm::dvec3>);
        m_bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
    }
    template <class T> void rows(const std::vector<T>& list)
    {
        for (const T& value : list)
            (*this)(value);
    }
    std::string take() { return std::move(m_bytes); }

private:
    std::string m_bytes;
};

class Unpacker
{
public:
    explicit Unpacker(std::string_view bytes)
        : m_rest(bytes)
    {
    }
    template <class T> void operator()(T& value)
    {
        m_isGood = m_isGood && m_rest.size() >= sizeof(T);
        if (!m_isGood)
            return;
        std::memcpy(&value, m_rest.data(), sizeof(T));
        m_rest.remove_prefix(sizeof(T));
    }
    template <class T> void rows(std::vector<T>& list)
    {
        for (T& value : list)
            (*this)(value);
    }
    /// A list of that many entries, each of at least so many bytes.
    template <class T> void resize(std::vector<T>& list, std::uint32_t count, std::size_t least)
    {
        m_isGood = m_isGood && count <= m_rest.size() / least;
        list.resize(m_isGood ? count : 0);
    }
    [[nodiscard]] bool isAtEnd() const { return m_isGood && m_rest.empty(); }

private:
    std::string_view m_rest;
    bool m_isGood = true;
};

/// The fields of everything but the branches' arrays.
void organ(auto& io, auto& o)
{
    auto kind = static_cast<std::uint32_t>(o.kind);
    io(o.branch);
    io(kind);
    io(o.share);
    for (auto* v : {&o.offset, &o.axis, &o.heading, &o.up})
        io(*v);
    io(o.size);
    if constexpr (!std::is_const_v<std::remove_reference_t<decltype(o)>>)
        o.kind = static_cast<OrganKind>(kind);
    if (isMark(static_cast<OrganKind>(kind))) // files from before there were any have none
        io(o.healed);
}

void branches(auto& io, auto& s)
{
    io.rows(s.parent);
    io.rows(s.p0);
    io.rows(s.p1);
    io.rows(s.a0);
    io.rows(s.a1);
    io.rows(s.level);
    io.rows(s.key);
}

void lists(auto& io, auto& s)
{
    for (auto& o : s.organs)
        organ(io, o);
    for (auto& [branch, address] : s.axisStarts) {
        io(branch);
        io(address);
    }
    io.rows(s.bare);
    io.rows(s.sawn);
    for (auto& limb : s.loose) {
        io(limb.first);
        io(limb.stump);
        io(limb.seconds);
    }
    for (auto& [branch, roll] : s.rolls) {
        io(branch);
        io(roll);
    }
}

bool rises(const std::vector<Index>& list, Index count)
{
    return std::ranges::adjacent_find(list, std::greater_equal()) == list.end() &&
           (list.empty() || list.back() < count);
}

bool isOrgan(const Organ& o, Index count)
{
    return o.branch < count && o.kind <= OrganKind::Burr && o.share >= 0.0 && o.share <= 1.0 &&
           isFinite(o.offset) && isFinite(o.axis) && isFinite(o.heading) && isFinite(o.up) &&
           std::isfinite(o.size) && std::isfinite(o.healed);
}

bool isSound(const Skeleton& s)
{
    for (Index i = 0; i < s.size(); ++i) {
        if (s.parent[i] != noIndex && s.parent[i] >= i)
            return false;
        if (!isFinite(s.p0[i]) || !isFinite(s.p1[i]) || !(s.a0[i] >= 0.0) || !(s.a1[i] >= 0.0) ||
            !std::isfinite(s.a0[i]) || !std::isfinite(s.a1[i]))
            return false;
    }
    std::vector<Index> starts, loose, rolls;
    for (const auto& [branch, address] : s.axisStarts)
        starts.push_back(branch);
    for (const auto& [branch, roll] : s.rolls) {
        rolls.push_back(branch);
        if (!std::isfinite(roll))
            return false;
    }
    for (const LooseLimb& limb : s.loose) {
        loose.push_back(limb.first);
        if (!(limb.stump == noIndex || limb.stump < s.size()) || !std::isfinite(limb.seconds))
            return false;
    }
    return rises(starts, s.size()) && rises(loose, s.size()) && rises(s.bare, s.size()) &&
           rises(s.sawn, s.size()) && rises(rolls, s.size()) &&
           std::ranges::all_of(s.organs, [&s](const Organ& o) { return isOrgan(o, s.size()); });
}

} // namespace

std::string packSkeleton(const Skeleton& s)
{
    Packer io;
    io(s.rolls.empty() ? mark : rolledMark);
    for (const std::size_t count : {s.parent.size(), s.organs.size(), s.axisStarts.size(), s.bare.size(),
                                    s.sawn.size(), s.loose.size()})
        io(static_cast<std::uint32_t>(count));
    if (!s.rolls.empty())
        io(static_cast<std::uint32_t>(s.rolls.size()));
    branches(io, s);
    lists(io, s);
    return io.take();
}

Expected<Skeleton> unpackSkeleton(std::string_view bytes)
{
    Unpacker io(bytes);
    std::uint32_t found = 0;
    std::array<std::uint32_t, 7> counts{};
    io(found);
    for (std::uint32_t& count : std::span(counts).first(found == rolledMark ? 7 : 6))
        io(count);
    constexpr std::size_t branchBytes = 80, organBytes = 120;
    Skeleton s;
    io.resize(s.parent, counts[0], branchBytes);
    s.resize(s.parent.size());
    io.resize(s.organs, counts[1], organBytes);
    io.resize(s.axisStarts, counts[2], sizeof(Index) + sizeof(std::uint64_t));
    io.resize(s.bare, counts[3], sizeof(Index));
    io.resize(s.sawn, counts[4], sizeof(Index));
    io.resize(s.loose, counts[5], 2 * sizeof(Index) + sizeof(double));
    io.resize(s.rolls, counts[6], sizeof(Index) + sizeof(double));
    branches(io, s);
    lists(io, s);
    std::iota(s.source.begin(), s.source.end(), Index(0));
    if ((found != mark && found != rolledMark) || !io.isAtEnd() || !isSound(s))
        return fail(ErrorCode::Invalid, RAMURE_NOOP("these are not the bytes of a tree"));
    return s;
}

} // namespace ramure
