#include "core/recipe/edit_tree.h"

#include "core/math/stage_hash.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

/// As a share of the axis' length: nearer to a node it is the node.
constexpr double sameSpot = 1e-3;
/// Likewise: so near it is that node, even where another one is nearer than sameSpot, too.
constexpr double exactSpot = 1e-9;

} // namespace

PieceTree::PieceTree(const Skeleton& grown, const TreeAxes& axes, std::uint64_t seed)
    : m_axes(axes.axes.size())
    , m_lived(grown.lived)
    , m_grownAxes(static_cast<Index>(axes.axes.size()))
    , m_hasOwnAddresses(!grown.axisStarts.empty())
    , m_seed(seed)
{
}

EditTree::EditTree(const Skeleton& grown, const TreeAxes& axes, std::uint64_t seed)
    : PieceTree(grown, axes, seed)
{
    takePieces(grown);
    for (Index a = 0; a < m_grownAxes; ++a) {
        m_axes[a] = {axes.axes[a].address, noIndex};
        takeAxis(a, axes.nodesOf(a));
    }
}

void EditTree::takePieces(const Skeleton& tree)
{
    m_size = tree.size();
    m_pieces.assign(tree.size(), {});
    for (Index i = 0; i < tree.size(); ++i) {
        EditPiece& piece = m_pieces[i];
        piece.p0 = tree.p0[i];
        piece.p1 = tree.p1[i];
        piece.a0 = tree.a0[i];
        piece.a1 = tree.a1[i];
        piece.key = tree.key[i];
        piece.parent = tree.parent[i];
        piece.level = tree.level[i];
        piece.before = i > 0 ? i - 1 : noIndex;
        piece.after = i + 1 < tree.size() ? i + 1 : noIndex;
    }
    m_organs.clear();
    for (const Organ& organ : tree.organs)
        m_organs.push_back({organ, false});
    for (const Index i : tree.sawn)
        m_pieces[i].sawn = true;
    for (const auto& [i, roll] : tree.rolls)
        m_pieces[i].roll = roll;
    for (const Index i : tree.bare)
        m_pieces[i].bare = true;
    for (const LooseLimb& limb : tree.loose) {
        m_pieces[limb.first].loose = true;
        m_pieces[limb.first].stump = limb.stump;
        m_pieces[limb.first].fallsAt = limb.seconds;
    }
    m_head = m_pieces.empty() ? noIndex : 0;
    m_tail = m_pieces.empty() ? noIndex : m_size - 1;
}

void EditTree::takeAxis(Index axis, std::span<const Index> nodes)
{
    m_axes[axis].first = nodes.front();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        m_pieces[nodes[i]].axis = axis;
        m_pieces[nodes[i]].next = i + 1 < nodes.size() ? nodes[i + 1] : noIndex;
    }
}

void EditTree::become(const Skeleton& tree, const TreeAxes& axes, std::uint64_t maker)
{
    takePieces(tree);
    // What axes that are gone begin with.
    const auto none = static_cast<Index>(m_pieces.size());
    m_pieces.push_back({});
    m_pieces.back().gone = true;
    std::unordered_map<std::uint64_t, Index> known;
    for (Index a = 0; a < axisCount(); ++a) {
        known.emplace(m_axes[a].address, a);
        m_axes[a].first = none;
    }
    for (Index a = 0; a < axes.axes.size(); ++a) {
        const std::uint64_t address = axes.axes[a].address;
        const auto [found, isNew] = known.emplace(address, axisCount());
        if (isNew) {
            m_axes.push_back({address, noIndex, maker});
            m_made.emplace(address, found->second);
        }
        takeAxis(found->second, axes.nodesOf(a));
    }
    m_meant.clear();
}

std::vector<Index> PieceTree::axesInOrder() const
{
    std::unordered_map<std::uint64_t, Index> known;
    for (Index a = 0; a < axisCount(); ++a)
        if (!isGone(a))
            known.emplace(m_axes[a].address, a);
    std::vector<Index> order;
    for (const Axis& axis : axesOf(skeleton()).axes)
        if (const auto found = known.find(axis.address); found != known.end())
            order.push_back(found->second);
    return order;
}

const LivedEdit* PieceTree::livedWith(std::uint64_t edit) const
{
    const auto found = std::ranges::find(m_lived, edit, &LivedEdit::edit);
    return found == m_lived.end() ? nullptr : &*found;
}

Index PieceTree::axisAt(std::uint64_t address) const
{
    for (Index a = 0; a < m_grownAxes; ++a)
        if (m_axes[a].address == address)
            return a;
    return madeAxisAt(address);
}

Index PieceTree::madeAxisAt(std::uint64_t address) const
{
    const auto found = m_made.find(address);
    return found == m_made.end() ? noIndex : found->second;
}

double PieceTree::length(Index i) const
{
    return glm::length(m_pieces[i].p1 - m_pieces[i].p0);
}

double PieceTree::axisLength(Index axis) const
{
    double sum = 0.0;
    for (Index i = m_axes[axis].first; i != noIndex; i = m_pieces[i].next)
        sum += length(i);
    return sum;
}

Index PieceTree::tipOf(Index axis) const
{
    Index i = m_axes[axis].first;
    while (m_pieces[i].next != noIndex)
        i = m_pieces[i].next;
    return i;
}

AxisSpot PieceTree::spotOn(Index axis, double share) const
{
    const double whole = axisLength(axis), wanted = share * whole;
    double start = 0.0;
    for (Index i = m_axes[axis].first; i != noIndex; i = m_pieces[i].next) {
        const double own = length(i);
        if (wanted < start + own - sameSpot * whole)
            return {i, std::clamp((wanted - start) / own, 0.0, 1.0)};
        start += own;
        if (wanted > start + sameSpot * whole && m_pieces[i].next != noIndex)
            continue;
        for (Index k = i; k != noIndex && start < wanted + exactSpot * whole; k = m_pieces[k].next) {
            if (std::abs(wanted - start) <= exactSpot * whole)
                return {k, 1.0};
            start += m_pieces[k].next == noIndex ? 0.0 : length(m_pieces[k].next);
        }
        return {i, 1.0};
    }
    return {tipOf(axis), 1.0};
}

glm::dvec3 PieceTree::pointAt(const AxisSpot& spot) const
{
    const EditPiece& p = m_pieces[spot.piece];
    return spot.t >= 1.0 ? p.p1 : p.p0 + spot.t * (p.p1 - p.p0);
}

double PieceTree::radiusAt(const AxisSpot& spot) const
{
    const EditPiece& p = m_pieces[spot.piece];
    return p.a0 + spot.t * (p.a1 - p.a0);
}

Frame PieceTree::frameAfter(Index i) const
{
    std::vector<Index> way;
    for (; i != noIndex; i = m_pieces[i].parent)
        way.push_back(i);
    Frame frame;
    for (std::size_t k = way.size(); k-- > 0;) {
        const glm::dvec3 along = m_pieces[way[k]].p1 - m_pieces[way[k]].p0;
        if (const double own = glm::length(along); own > 0.0)
            frame = transported(frame, along / own);
    }
    return frame;
}

Frame PieceTree::frameBelow(Index axis) const
{
    return frameAfter(m_pieces[m_axes[axis].first].parent);
}

EditMarks PieceTree::marked(Index piece) const
{
    return markedFrom({piece});
}

EditMarks PieceTree::markedFrom(const std::vector<Index>& starts) const
{
    EditMarks marks(m_pieces.size(), false);
    for (const Index i : starts)
        marks[i] = true;
    for (Index i = m_head; i != noIndex; i = m_pieces[i].after)
        if (const Index parent = m_pieces[i].parent; parent != noIndex && marks[parent])
            marks[i] = true;
    return marks;
}

bool PieceTree::isOn(Index piece, Index limb) const
{
    for (; piece != noIndex; piece = m_pieces[piece].parent)
        if (piece == limb)
            return true;
    return false;
}

void EditTree::setMaker(std::uint64_t id)
{
    m_maker = id;
    m_keysMade = 0;
}

std::uint64_t EditTree::newKey(std::uint64_t from)
{
    return StageHash(m_maker).add(from).add(++m_keysMade).value();
}

void EditTree::insertAfter(Index before, Index i)
{
    EditPiece& piece = m_pieces[i];
    piece.before = before;
    piece.after = before == noIndex ? m_head : m_pieces[before].after;
    (before == noIndex ? m_head : m_pieces[before].after) = i;
    (piece.after == noIndex ? m_tail : m_pieces[piece.after].before) = i;
}

void EditTree::unlink(Index i)
{
    const EditPiece& piece = m_pieces[i];
    (piece.before == noIndex ? m_head : m_pieces[piece.before].after) = piece.after;
    (piece.after == noIndex ? m_tail : m_pieces[piece.after].before) = piece.before;
}

Index EditTree::splitAt(Index axis, double share)
{
    return splitAt(spotOn(axis, share));
}

Index EditTree::splitAt(const AxisSpot& spot)
{
    return splitAt(std::span(&spot, 1)).front();
}

/// The part of a piece above t becomes a piece of its own. \param from where, on the piece that it once was,
/// it starts by now
Index EditTree::splitPiece(Index i, double from, double t)
{
    const AxisSpot spot{i, (t - from) / (1.0 - from)};
    const glm::dvec3 point = pointAt(spot);
    const double radius = radiusAt(spot);
    const auto upper = static_cast<Index>(m_pieces.size());
    EditPiece above = m_pieces[i];
    above.key = newKey(above.key);
    above.p0 = point;
    above.a0 = radius;
    above.parent = i;
    above.loose = false;
    above.roll = 0.0;
    m_pieces.push_back(above);
    EditPiece& below = m_pieces[i];
    below.p1 = point;
    below.a1 = radius;
    below.next = upper;
    below.sawn = false;
    insertAfter(i, upper);
    ++m_size;
    return upper;
}

std::vector<Index> EditTree::splitAt(std::span<const AxisSpot> spots)
{
    std::vector<Index> ends;
    std::vector<Index> upperOf(m_pieces.size(), noIndex); // the highest part of a piece that was split
    std::unordered_map<Index, std::vector<std::pair<double, Index>>> parts; // by piece: where each begins
    for (const AxisSpot& spot : spots) {
        Index below = upperOf[spot.piece] == noIndex ? spot.piece : upperOf[spot.piece];
        if (spot.t < 1.0) {
            auto& own = parts[spot.piece];
            if (own.empty())
                own.emplace_back(0.0, spot.piece);
            if (const double from = own.back().first; own.size() == 1 || from < spot.t) {
                upperOf[spot.piece] = splitPiece(below, from, spot.t);
                own.emplace_back(spot.t, upperOf[spot.piece]);
            } else { // the same spot once more
                below = own[own.size() - 2].second;
            }
        }
        ends.push_back(below);
    }
    if (parts.empty())
        return ends;
    // What stands on the end of a piece now stands on its highest part.
    for (Index i = 0; i < upperOf.size(); ++i)
        for (Index* below : {&m_pieces[i].parent, &m_pieces[i].stump})
            if (*below < upperOf.size() && upperOf[*below] != noIndex)
                *below = upperOf[*below];
    for (EditOrganSeat& organ : m_organs) {
        const auto found = parts.find(organ.branch);
        if (found == parts.end())
            continue;
        const auto& own = found->second;
        std::size_t k = own.size() - 1;
        while (k > 0 && organ.share <= own[k].first)
            --k;
        const double from = own[k].first, to = k + 1 < own.size() ? own[k + 1].first : 1.0;
        organ.share = (organ.share - from) / (to - from);
        organ.branch = own[k].second;
    }
    return ends;
}

void EditTree::shorten(Index i, double share)
{
    EditPiece& piece = m_pieces[i];
    piece.p1 = piece.p0 + share * (piece.p1 - piece.p0);
    piece.a1 = piece.a0 + share * (piece.a1 - piece.a0);
    piece.sawn = true;
    std::erase_if(m_organs, [&](const Organ& organ) { return organ.branch == i && organ.share > share; });
    for (EditOrganSeat& organ : m_organs)
        if (organ.branch == i)
            organ.share /= share;
}

void EditTree::setBare(Index i, bool bare)
{
    m_pieces[i].bare = bare;
    for (EditOrganSeat& organ : m_organs)
        if (organ.branch == i && bare)
            organ.stays = false;
}

void EditTree::setBare(const EditMarks& pieces)
{
    for (Index i = 0; i < m_pieces.size(); ++i)
        m_pieces[i].bare = m_pieces[i].bare || pieces[i];
    for (EditOrganSeat& organ : m_organs)
        organ.stays = organ.stays && !pieces[organ.branch];
}

void EditTree::copyOrgans(Index from, Index to, double size)
{
    for (std::size_t i = 0, count = m_organs.size(); i < count; ++i) {
        EditOrganSeat organ = m_organs[i];
        if (organ.branch != from)
            continue;
        organ.branch = to;
        organ.offset *= size;
        organ.size *= organ.size > 0.0 ? size : 1.0;
        m_organs.push_back(organ);
    }
}

void EditTree::remove(const EditMarks& marks)
{
    for (Index i = m_head; i != noIndex; i = m_pieces[i].after) {
        EditPiece& piece = m_pieces[i];
        if (!marks[i]) {
            if (piece.next != noIndex && marks[piece.next])
                piece.next = noIndex;
            continue;
        }
        piece.gone = true;
        unlink(i);
        --m_size;
    }
}

Index EditTree::addAxis(std::uint64_t address, std::uint64_t maker, Index original)
{
    const auto axis = static_cast<Index>(m_axes.size());
    m_axes.push_back({address, noIndex, maker, original});
    m_made.emplace(address, axis);
    return axis;
}

Index EditTree::extend(Index axis, Index parent, const glm::dvec3& from, const glm::dvec3& to, double a0,
                       double a1, Index level)
{
    const auto i = static_cast<Index>(m_pieces.size());
    EditPiece piece;
    piece.parent = parent;
    piece.p0 = parent == noIndex ? from : m_pieces[parent].p1;
    piece.p1 = to;
    piece.a0 = a0;
    piece.a1 = a1;
    piece.axis = axis;
    piece.level = level;
    piece.key = newKey(m_axes[axis].address);
    piece.bare = parent != noIndex && m_pieces[parent].bare;
    if (m_axes[axis].first == noIndex)
        m_axes[axis].first = i;
    else
        m_pieces[parent].next = i;
    m_pieces.push_back(piece);
    insertAfter(m_tail, i);
    ++m_size;
    return i;
}

void EditTree::loosen(Index i, std::uint64_t address, double seconds)
{
    constexpr double kerf = 0.05, most = 0.5; // of the radius, of the piece
    EditPiece& piece = m_pieces[i];
    piece.loose = true;
    piece.fallsAt = seconds;
    piece.stump = piece.parent;
    piece.parent = noIndex;
    if (piece.stump == noIndex)
        return;
    EditPiece& below = m_pieces[piece.stump];
    const bool isWithin = below.next == i;
    const double gap = isWithin ? kerf * piece.a0 : below.a1, own = length(i);
    piece.p0 += std::min(own > 0.0 ? gap / own : 0.0, most) * (piece.p1 - piece.p0);
    if (!isWithin)
        return;
    below.next = noIndex;
    const Index axis = addAxis(address, m_maker, piece.axis);
    m_axes[axis].first = i;
    for (Index k = i; k != noIndex; k = m_pieces[k].next)
        m_pieces[k].axis = axis;
}

void EditTree::hang(Index axis, Index parent)
{
    const Index first = m_axes[axis].first;
    const EditMarks marks = marked(first);
    std::vector<Index> limb;
    for (Index i = m_head; i != noIndex; i = m_pieces[i].after)
        if (marks[i])
            limb.push_back(i);
    m_pieces[first].parent = parent;
    m_pieces[first].loose = false;
    for (const Index i : limb) {
        unlink(i);
        insertAfter(m_tail, i);
    }
}

Skeleton PieceTree::skeleton() const
{
    Skeleton out;
    out.reserve(m_size);
    std::vector<Index> indexOf(m_pieces.size(), noIndex);
    for (Index i = m_head; i != noIndex; i = m_pieces[i].after) {
        const EditPiece& piece = m_pieces[i];
        const Index at = out.size();
        indexOf[i] = at;
        out.parent.push_back(piece.parent == noIndex ? noIndex : indexOf[piece.parent]);
        out.p0.push_back(piece.p0);
        out.p1.push_back(piece.p1);
        out.a0.push_back(piece.a0);
        out.a1.push_back(piece.a1);
        out.level.push_back(piece.level);
        out.key.push_back(piece.key);
        out.source.push_back(at);
        if (m_axes[piece.axis].first == i)
            out.axisStarts.emplace_back(at, m_axes[piece.axis].address);
        if (piece.bare)
            out.bare.push_back(at);
        if (piece.roll != 0.0)
            out.rolls.emplace_back(at, piece.roll);
        if (piece.sawn && piece.next == noIndex)
            out.sawn.push_back(at);
    }
    for (Index i = m_head; i != noIndex; i = m_pieces[i].after)
        if (const EditPiece& piece = m_pieces[i]; piece.loose) {
            const bool hasStump = piece.stump != noIndex && !m_pieces[piece.stump].gone;
            out.loose.push_back({indexOf[i], hasStump ? indexOf[piece.stump] : noIndex, piece.fallsAt});
        }
    for (const EditOrganSeat& seat : m_organs) {
        Organ organ = seat;
        const EditPiece& piece = m_pieces[organ.branch];
        organ.branch = indexOf[organ.branch];
        if (!piece.gone && (!piece.bare || seat.stays || isMark(organ.kind)))
            out.organs.push_back(organ);
    }
    return out;
}

glm::dvec3 outOf(const Frame& frame, const glm::dvec3& v)
{
    return v.x * frame.normal + v.y * frame.binormal + v.z * frame.tangent;
}

glm::dvec3 into(const Frame& frame, const glm::dvec3& v)
{
    return {glm::dot(v, frame.normal), glm::dot(v, frame.binormal), glm::dot(v, frame.tangent)};
}

glm::dquat rotationBetween(const glm::dvec3& from, const glm::dvec3& to)
{
    const double cosine = glm::dot(from, to);
    if (cosine < -1.0 + 1e-12) {
        const Frame any = frameFromTangent(from);
        return glm::dquat(0.0, any.normal.x, any.normal.y, any.normal.z);
    }
    const glm::dvec3 axis = glm::cross(from, to);
    return glm::normalize(glm::dquat(1.0 + cosine, axis.x, axis.y, axis.z));
}

} // namespace ramure
