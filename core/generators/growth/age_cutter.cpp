#include "core/generators/growth/age_cutter.h"

#include "core/generators/growth/growing_tree.h"
#include "core/math/random.h"
#include "core/math/reproducible.h"
#include <algorithm>

namespace ramure::growth {

AgeCutter::AgeCutter(const GrowthHistory& history, double age)
    : m_history(history)
    , m_whole(std::clamp(int(age), 0, history.grownYears()))
    , m_part(m_whole < history.grownYears() ? std::clamp(age - double(m_whole), 0.0, 1.0) : 0.0)
    , m_isWholeLife(false)
{
    choose();
    reach();
    pose();
    smooth();
}

AgeCutter::AgeCutter(const GrowthHistory& history, const std::vector<bool>& axes)
    : m_history(history)
    , m_whole(history.grownYears())
    , m_part(0.0)
    , m_isWholeLife(true)
{
    chooseAll(axes);
    reach();
    pose();
    smooth();
}

Skeleton AgeCutter::draw(std::vector<Index>* ends)
{
    if (!m_isWholeLife)
        findStumps();
    m_branch.assign(m_pieces.size(), noIndex);
    m_out.assign(m_pieces.size(), false);
    m_skeleton.reserve(m_pieces.size());
    for (Index k = 0; k < m_pieces.size(); ++k)
        drawPiece(k);
    // Where a shoot took over, the end is hidden.
    std::erase_if(m_skeleton.sawn,
                  [this](Index branch) { return std::ranges::count(m_skeleton.parent, branch) > 0; });
    if (ends)
        *ends = std::move(m_ends);
    return std::move(m_skeleton);
}

/// What lives, with its radius between the rows of the two years.
void AgeCutter::choose()
{
    const GrowthHistory& h = m_history;
    const auto before = h.pipesAt(m_whole);
    const bool part = m_part > 0.0;
    const auto after = part ? h.pipesAt(m_whole + 1) : before;
    const auto bendBefore = h.bendsAt(m_whole);
    const auto bendAfter = part ? h.bendsAt(m_whole + 1) : bendBefore;
    const double power = 1.0 / h.params.pipeExponent;
    std::vector<Index> pieceOf(h.size(), noIndex);
    m_pieces.reserve(after.size());
    std::size_t b = 0, a = 0;
    for (Index i = 0; i < h.size() && int(h.birth[i]) <= m_whole; ++i) {
        const bool stood = int(h.birth[i])<m_whole&& int(h.death[i])> m_whole;
        const bool stands = part && int(h.death[i]) > m_whole + 1;
        if (!stood && !stands) {
            if (const Index below = h.parent[i]; below != noIndex && h.axis[below] == h.axis[i] &&
                                                 int(h.birth[i]) < m_whole && pieceOf[below] != noIndex)
                m_pieces[pieceOf[below]].isBroken = h.isDead(below, m_whole);
            continue;
        }
        const double from = stood ? double(pipesOf(before[b])) : 1.0;
        const double to = stands ? double(pipesOf(after[a])) : from;
        double bend = stood ? double(bendBefore[b]) : double(bendAfter[a]);
        if (stood && stands)
            bend += m_part * (double(bendAfter[a]) - bend);
        b += stood ? 1 : 0;
        a += stands ? 1 : 0;
        const double pipes = stood ? from + m_part * (to - from) : to;
        const double young = stood ? 1.0 : 0.5 + 0.5 * m_part;
        addPiece(i, pieceOf, young * h.params.tipRadius * maths::pow(pipes, power), bend,
                 stood ? 1.0 : m_part);
    }
}

void AgeCutter::addPiece(Index metamer, std::vector<Index>& pieceOf, double radius, double bend, double grown)
{
    const Index below = m_history.parent[metamer];
    const Index parent = below == noIndex ? noIndex : pieceOf[below];
    pieceOf[metamer] = Index(m_pieces.size());
    if (parent != noIndex && m_history.axis[metamer] == m_history.axis[below])
        m_pieces[parent].next = pieceOf[metamer];
    m_pieces.push_back({metamer, parent, noIndex, radius});
    m_bends.push_back(1e-4 * bend);
    m_grown.push_back(grown);
}

void AgeCutter::chooseAll(const std::vector<bool>& axes)
{
    const GrowthHistory& h = m_history;
    std::vector<std::uint16_t> pipes(h.size(), 0);
    std::vector<std::int16_t> bends(h.size(), 0);
    std::vector<bool> lived(h.size(), false);
    for (int age = 1; age <= m_whole; ++age) {
        auto p = h.pipesAt(age).begin();
        auto b = h.bendsAt(age).begin();
        for (Index i = 0; i < h.size() && int(h.birth[i]) < age; ++i)
            if (int(h.death[i]) > age) {
                pipes[i] = *p++;
                bends[i] = *b++;
                lived[i] = true;
            }
    }
    std::vector<Index> pieceOf(h.size(), noIndex);
    for (Index i = 0; i < h.size(); ++i) {
        const bool isRooted = h.parent[i] == noIndex || pieceOf[h.parent[i]] != noIndex;
        if (axes[h.axis[i]] && isRooted && lived[i])
            addPiece(i, pieceOf,
                     h.params.tipRadius * maths::pow(double(pipesOf(pipes[i])), 1.0 / h.params.pipeExponent),
                     double(bends[i]), 1.0);
    }
}

void AgeCutter::reach()
{
    for (std::size_t k = m_pieces.size(); k-- > 0;) {
        Piece& piece = m_pieces[k];
        piece.reach += m_grown[k] * double(m_history.length[piece.metamer]);
        m_farthest = std::max(m_farthest, piece.reach);
        if (piece.parent == noIndex)
            continue;
        Piece& below = m_pieces[piece.parent];
        below.reach = std::max(below.reach, piece.reach);
        if (below.next == Index(k)) {
            below.heir = Index(k);
            continue;
        }
        below.sides += piece.radius * piece.radius;
        if (piece.radius > below.side) {
            below.side = piece.radius;
            below.heir = below.next == noIndex ? Index(k) : below.heir;
        }
    }
}

void AgeCutter::pose()
{
    std::vector<glm::dquat> frames(m_pieces.size());
    for (std::size_t k = 0; k < m_pieces.size(); ++k) {
        Piece& piece = m_pieces[k];
        const glm::dvec3 rest(m_history.direction[piece.metamer]);
        const glm::dquat own = bendOf(rest, m_bends[k]);
        const bool root = piece.parent == noIndex;
        frames[k] = root ? own : frames[piece.parent] * own;
        const double off = standOff(piece);
        piece.reach += off;
        piece.at = (root ? m_history.footOf(piece.metamer) : m_pieces[piece.parent].at) +
                   frames[k] * rest * (m_grown[k] * double(m_history.length[piece.metamer]) + off);
    }
}

/// m, by which a limb is moved out to the bark of its stem.
double AgeCutter::standOff(const Piece& piece) const
{
    constexpr double clear = 1.6, nearby = 2.5; // radii of the stem
    if (!m_isWholeLife || piece.parent == noIndex || m_pieces[piece.parent].next == noIndex)
        return 0.0;
    const Piece& stem = m_pieces[piece.parent];
    const bool isSide = m_history.axis[piece.metamer] != m_history.axis[stem.metamer];
    const bool isGone = int(m_history.death[piece.metamer]) <= m_whole;
    return isSide && (isGone || piece.reach < nearby * stem.radius) ? clear * stem.radius : 0.0;
}

/// Rings fill what is hollow and lie thin on what stands out: the thicker, the straighter. So does the
/// kink go where a side shoot took the place of a dead end.
void AgeCutter::smooth()
{
    constexpr int rounds = 4;
    std::vector<glm::dvec3> moved(m_pieces.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t k = 0; k < m_pieces.size(); ++k) {
            const Piece& piece = m_pieces[k];
            moved[k] = piece.at;
            if (piece.heir == noIndex || stood(piece)) // a hand may have drawn it
                continue;
            const glm::dvec3 foot = piece.parent == noIndex ? glm::dvec3(0.0) : m_pieces[piece.parent].at;
            const glm::dvec3& next = m_pieces[piece.heir].at;
            const double step = 0.5 * glm::length(next - foot);
            const double share = std::clamp(1.5 * piece.radius / std::max(step, 1e-6), 0.1, 0.9);
            moved[k] += share * (0.5 * (foot + next) - piece.at);
        }
        for (std::size_t k = 0; k < m_pieces.size(); ++k)
            m_pieces[k].at = moved[k];
    }
}

/// Axes that were cut so lately that the wound is open.
void AgeCutter::findStumps()
{
    constexpr int years = 5;
    for (std::size_t c = 0; c < m_history.cuts.size(); ++c) {
        const GrowthCut& cut = m_history.cuts[c];
        if (m_history.isMade[c] && cut.share < 1.0 && cut.age <= m_whole && m_whole < cut.age + years)
            m_stumps.push_back(
                Index(std::ranges::find(m_history.axisAddress, cut.axis) - m_history.axisAddress.begin()));
    }
}

/// A branch from the last node that was kept to this one; what starts at nodes that are left out starts at
/// the one before. Near the ground, or where its stem is inside thicker wood, there is none yet: what is
/// large starts at the first one.
void AgeCutter::drawPiece(Index k)
{
    const Piece& piece = m_pieces[k];
    const bool root = piece.parent == noIndex;
    const bool goesOn = root || m_pieces[piece.parent].next == k;
    if (m_branch[k] != noIndex)
        return;
    Index below = root ? noIndex : m_branch[piece.parent];
    const bool atFoot = below == noIndex;
    if (!goesOn && !m_out[piece.parent] && isLarge(piece) && !isOnStem(piece, below))
        below = makeRoom(piece, firstNode(piece.parent));
    const bool stands = goesOn || stood(piece) ||
                        (below != noIndex && leavesTheWood(piece) && (atFoot || hasRoom(piece, below)));
    if (!root && (m_out[piece.parent] || !stands)) {
        m_out[k] = true;
        return;
    }
    const glm::dvec3 from = below == noIndex ? footOf(piece) : m_skeleton.p1[below];
    if (isKept(piece, piece.at - from, below))
        add(k, below, from);
    else
        m_branch[k] = below;
}

bool AgeCutter::isOnStem(const Piece& piece, Index below) const
{
    return below != noIndex && axisOf(below) == m_history.axis[m_pieces[piece.parent].metamer];
}

/// The first node above a piece of a stem of which none is drawn, which is drawn now, or that piece's.
Index AgeCutter::firstNode(Index stem)
{
    const Index axis = m_history.axis[m_pieces[stem].metamer];
    for (Index k = stem; k != noIndex; k = m_pieces[k].next) {
        drawPiece(k);
        if (m_branch[k] != noIndex && axisOf(m_branch[k]) == axis)
            return m_branch[k];
    }
    return m_branch[stem];
}

/// The wood below is as thick as it was where the limb left it. Returns it.
Index AgeCutter::makeRoom(const Piece& piece, Index below)
{
    if (below != noIndex) {
        double& end = m_skeleton.a1[below];
        end = std::clamp(std::sqrt(end * end + piece.radius * piece.radius), end, m_skeleton.a0[below]);
    }
    return below;
}

/// A limb that everybody would miss.
bool AgeCutter::isLarge(const Piece& piece) const
{
    constexpr double share = 0.25; // of the tree
    return piece.reach >= share * m_farthest;
}

glm::dvec3 AgeCutter::footOf(const Piece& piece) const
{
    const Piece* root = &piece;
    while (root->parent != noIndex)
        root = &m_pieces[root->parent];
    return m_history.footOf(root->metamer);
}

bool AgeCutter::leavesTheWood(const Piece& piece) const
{
    return piece.reach >= std::max(0.02, 1.6 * m_pieces[piece.parent].radius);
}

/// Whether a side shoot has a node of its own, or is thick enough to share one with others: a thin one would
/// take too much of thick wood's end. What grows on a limb while this is still inside the wood of its stem
/// would grow on the stem.
bool AgeCutter::hasRoom(const Piece& piece, Index below) const
{
    constexpr double thinnest = 0.3;
    constexpr Index mostLimbs = 5; // of a whole life, where wood that is thick at last was thin once
    const Piece& stem = m_pieces[piece.parent];
    if (m_skeleton.p1[below] == stem.at)
        return true;
    return isOnStem(piece, below) &&
           (piece.radius >= thinnest * stem.radius || (m_isWholeLife && m_limbs[below] < mostLimbs));
}

/// \param way m, from the end of the branch below
bool AgeCutter::isKept(const Piece& piece, const glm::dvec3& way, Index below) const
{
    constexpr double least = 0.0005; // m
    const double length = glm::length(way);
    const double room = length < least ? 0.0 : roomBeside(piece, way / length, below);
    const double closest = (piece.side > 0.0 ? 0.1 : 0.45) * m_history.params.internode;
    const bool isTip = piece.next == noIndex;
    if (stood(piece) && piece.side > 0.0) // what stood on it goes on to stand there
        return length >= least;
    return length >= least && (isTip || length >= std::max({room, 1.2 * piece.radius, closest}));
}

/// m, the length that a limb needs until it is out of the wood of the stem that it leaves.
double AgeCutter::roomBeside(const Piece& piece, const glm::dvec3& direction, Index below) const
{
    if (below == noIndex || axisOf(below) == m_history.axis[piece.metamer] || m_above[below] == 0.0)
        return 0.0;
    const glm::dvec3 along = glm::normalize(m_skeleton.p1[below] - m_skeleton.p0[below]);
    const double sine = glm::length(glm::cross(direction, along));
    return m_above[below] * std::max(1.5, 1.2 / std::max(sine, 0.5));
}

void AgeCutter::add(Index k, Index below, const glm::dvec3& from)
{
    const GrowthHistory& h = m_history;
    const Piece& piece = m_pieces[k];
    const Index axis = h.axis[piece.metamer];
    const bool goesOn = below != noIndex && axisOf(below) == axis;
    double start = goesOn && m_above[below] > 0.0 ? m_above[below] : footRadius(piece);
    if (below != noIndex)
        start = std::min(start, m_skeleton.a1[below]);
    // Wood ends as thick as all that starts there together, so that nothing is lost below a fork.
    const double next = piece.next == noIndex ? 0.0 : m_pieces[piece.next].radius;
    double end = std::max(std::sqrt(next * next + piece.sides), 0.6 * piece.radius);
    const bool isStump =
        piece.next == noIndex && (piece.isBroken || (stood(piece) && h.flatWood[piece.metamer]) ||
                                  std::ranges::count(m_stumps, axis) > 0);
    end = std::min(isStump ? piece.radius : end, start);
    const Index branch = m_skeleton.add(below, from, piece.at, start, end, h.axisOrder[axis]);
    m_ends.push_back(piece.metamer);
    m_limbs.push_back(0);
    m_above.push_back(next);
    m_skeleton.key[branch] = mixBits(h.axisAddress[axis] + 0x9E3779B97F4A7C15ull * (piece.metamer + 1));
    if (!goesOn && below != noIndex)
        ++m_limbs[below];
    if (!goesOn)
        m_skeleton.axisStarts.emplace_back(branch, h.axisAddress[axis]);
    if (isStump)
        m_skeleton.sawn.push_back(branch);
    if ((stood(piece) && h.bareWood[piece.metamer]) || h.isDead(piece.metamer, m_whole))
        m_skeleton.bare.push_back(branch);
    m_branch[k] = branch;
}

/// Of what stood the foot flares, also where the first nodes are left out.
double AgeCutter::footRadius(const Piece& piece) const
{
    const Piece* first = &piece;
    while (stood(*first) && first->parent != noIndex &&
           m_pieces[first->parent].next == Index(first - m_pieces.data()))
        first = &m_pieces[first->parent];
    return first->radius;
}

} // namespace ramure::growth
