#include "core/rig/tracks/handles.h"

#include "core/math/reproducible.h"
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

/// dx of Blender's round handles: with it four of them make the best circle.
constexpr double roundLength = 2.5614;

struct Sides
{
    double before = 0.0, behind = 0.0;           ///< seconds to the neighbours, 0 at an end
    double slopeBefore = 0.0, slopeBehind = 0.0; ///< of the secants; at an end 0
    [[nodiscard]] bool isEnd() const { return before == 0.0 || behind == 0.0; }
};

template <class Keys> Sides sidesOf(const Keys& keys, std::size_t i)
{
    Sides sides;
    if (i > 0) {
        sides.before = secondsOf(keys[i].time - keys[i - 1].time);
        sides.slopeBefore = (keys[i].value - keys[i - 1].value) / sides.before;
    }
    if (i + 1 < keys.size()) {
        sides.behind = secondsOf(keys[i + 1].time - keys[i].time);
        sides.slopeBehind = (keys[i + 1].value - keys[i].value) / sides.behind;
    }
    return sides;
}

void settleSimple(Key& key, const Sides& sides)
{
    const double slope = sides.isEnd() ? 0.0 : 0.5 * (sides.slopeBefore + sides.slopeBehind);
    if (key.before == HandleType::Vector)
        key.in = {-sides.before / 3.0, -sides.before / 3.0 * sides.slopeBefore};
    else if (key.before == HandleType::Auto)
        key.in = {-sides.before / roundLength, -sides.before / roundLength * slope};
    if (key.behind == HandleType::Vector)
        key.out = {sides.behind / 3.0, sides.behind / 3.0 * sides.slopeBehind};
    else if (key.behind == HandleType::Auto)
        key.out = {sides.behind / roundLength, sides.behind / roundLength * slope};
}

/// Puts \p handle opposite \p other, which tells the direction.
void align(Handle& handle, const Handle& other)
{
    const double from = maths::hypot(other.dt, other.dv), length = maths::hypot(handle.dt, handle.dv);
    // What stands in line already stays to the last digit: settling twice changes nothing.
    constexpr double rounding = 1e-14;
    if (std::abs(handle.dt * other.dv - handle.dv * other.dt) <= rounding * from * length &&
        handle.dt * other.dt + handle.dv * other.dv <= 0.0)
        return;
    if (from > 0.0)
        handle = {-other.dt * length / from, -other.dv * length / from};
}

/// The slopes of a run of clamped keys: a tridiagonal system for a curve without jumps of its second
/// derivative, within a box for each slope. Who leaves the box is held at its wall, and let go once if then
/// it wants to come back in.
class ClampedSlopes
{
public:
    struct Row
    {
        double a = 0.0, b = 1.0, c = 0.0, d = 0.0;
        double least = 0.0, most = 0.0;
        bool given = false; ///< not to be solved for
        bool held = false;
        bool letGo = false;
        double slope = 0.0;
    };

    std::vector<Row>& rows() { return m_rows; }
    void solve()
    {
        // Each round holds or lets go at least one row, each row at most twice.
        for (std::size_t round = 0; round < 3 * m_rows.size() + 1; ++round) {
            solveOnce();
            if (!hold() && !release())
                break;
        }
    }

private:
    void solveOnce()
    {
        const std::size_t n = m_rows.size();
        m_c.assign(n, 0.0);
        m_d.assign(n, 0.0);
        for (std::size_t i = 0; i < n; ++i) {
            const Row& row = m_rows[i];
            const bool fixed = row.given || row.held;
            const double a = fixed ? 0.0 : row.a, c = fixed ? 0.0 : row.c;
            const double pivot = fixed ? 1.0 : row.b - (i > 0 ? a * m_c[i - 1] : 0.0);
            m_c[i] = c / pivot;
            m_d[i] = ((fixed ? row.slope : row.d) - (i > 0 ? a * m_d[i - 1] : 0.0)) / pivot;
        }
        for (std::size_t i = n; i-- > 0;)
            m_rows[i].slope = m_d[i] - (i + 1 < n ? m_c[i] * m_rows[i + 1].slope : 0.0);
    }
    /// Walls that are not flat first: often the others come back by themselves then.
    bool hold()
    {
        for (const bool all : {false, true}) {
            bool any = false;
            for (Row& row : m_rows) {
                if (row.given || row.held || (row.slope >= row.least && row.slope <= row.most))
                    continue;
                const double wall = row.slope > row.most ? row.most : row.least;
                if (wall == 0.0 && !all)
                    continue;
                row.held = any = true;
                row.slope = wall;
            }
            if (any)
                return true;
        }
        return false;
    }
    bool release()
    {
        bool any = false;
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            Row& row = m_rows[i];
            if (!row.held || row.letGo)
                continue;
            const double wish = row.d - row.b * row.slope - (i > 0 ? row.a * m_rows[i - 1].slope : 0.0) -
                                (i + 1 < m_rows.size() ? row.c * m_rows[i + 1].slope : 0.0);
            if ((wish > 0.0 && row.slope < row.most) || (wish < 0.0 && row.slope > row.least)) {
                row.held = false;
                row.letGo = any = true;
            }
        }
        return any;
    }

    std::vector<Row> m_rows;
    std::vector<double> m_c, m_d;
};

bool isClamped(const Key& key)
{
    return key.before == HandleType::AutoClamped || key.behind == HandleType::AutoClamped;
}

double slopeOf(const Handle& handle)
{
    return handle.dt != 0.0 ? handle.dv / handle.dt : 0.0;
}

/// Nothing is to be solved for: it rests, or others say where its handles stand.
bool isGiven(const Key& key, const Sides& sides)
{
    return !isClamped(key) || sides.isEnd() || sides.slopeBefore * sides.slopeBehind <= 0.0;
}

ClampedSlopes::Row clampedRow(const Key& key, const Sides& sides)
{
    ClampedSlopes::Row row;
    const double low = sides.slopeBefore, high = sides.slopeBehind;
    if (isGiven(key, sides)) {
        row.given = true; // the neighbours only see the side that faces them; both agree where it is smooth
        if (!isClamped(key))
            row.slope = slopeOf(key.before == HandleType::Vector ? key.out : key.in);
        return row;
    }
    row.a = sides.behind;
    row.b = 2.0 * (sides.before + sides.behind);
    row.c = sides.before;
    row.d = 3.0 * (sides.behind * low + sides.before * high);
    const double wall = 3.0 * std::min(std::abs(low), std::abs(high));
    (low > 0.0 ? row.most : row.least) = low > 0.0 ? wall : -wall;
    return row;
}

/// Keys first .. last, of which the two at the ends are given or have no neighbour beyond.
void settleRun(std::vector<Key>& keys, std::size_t first, std::size_t last, ClampedSlopes& slopes)
{
    std::vector<ClampedSlopes::Row>& rows = slopes.rows();
    rows.clear();
    for (std::size_t i = first; i <= last; ++i)
        rows.push_back(clampedRow(keys[i], sidesOf(keys, i)));
    slopes.solve();
    for (std::size_t i = first; i <= last; ++i) {
        const Sides sides = sidesOf(keys, i);
        const double slope = rows[i - first].slope;
        if (keys[i].before == HandleType::AutoClamped)
            keys[i].in = {-sides.before / 3.0, -sides.before / 3.0 * slope};
        if (keys[i].behind == HandleType::AutoClamped)
            keys[i].out = {sides.behind / 3.0, sides.behind / 3.0 * slope};
    }
}

/// Runs of keys whose slopes depend on each other, one after the other: given ones lie between.
/// \param from, to are widened to whole runs
void settleClamped(std::vector<Key>& keys, std::size_t& from, std::size_t& to)
{
    ClampedSlopes slopes;
    std::size_t first = from;
    while (first > 0 && !isGiven(keys[first], sidesOf(keys, first)))
        --first;
    from = first;
    do {
        std::size_t last = std::min(first + 1, keys.size() - 1);
        while (last + 1 < keys.size() && !isGiven(keys[last], sidesOf(keys, last)))
            ++last;
        settleRun(keys, first, last, slopes);
        first = last;
    } while (first < to);
    to = first;
}

/// Secants to both neighbours, and what hangs on the slopes of those.
std::pair<std::size_t, std::size_t> widened(std::size_t first, std::size_t last, std::size_t size)
{
    return {first > 1 ? first - 2 : 0, std::min(last + 2, size - 1)};
}

/// One component of every key, as keys of numbers.
struct ComponentKeys
{
    const KeyList<OrientationKey>& keys;
    std::size_t component;
    [[nodiscard]] std::size_t size() const { return keys.size(); }
    Key operator[](std::size_t i) const { return componentKey(keys[i], component); }
};

template <class Keys>
std::pair<std::size_t, std::size_t> reachOf(const Keys& keys, std::size_t first, std::size_t last)
{
    auto [from, to] = widened(first, last, keys.size());
    while (from > 0 && !isGiven(keys[from], sidesOf(keys, from)))
        --from;
    while (to + 1 < keys.size() && !isGiven(keys[to], sidesOf(keys, to)))
        ++to;
    // The slopes at the ends of a run hang on one more neighbour.
    return {from > 0 ? from - 1 : 0, std::min(to + 1, keys.size() - 1)};
}

/// Handles never lie on the wrong side of their key.
void settleByHand(Key& key)
{
    key.in.dt = std::min(key.in.dt, 0.0);
    key.out.dt = std::max(key.out.dt, 0.0);
    if (key.behind == HandleType::Aligned)
        align(key.out, key.in);
    else if (key.before == HandleType::Aligned)
        align(key.in, key.out);
}

} // namespace

void settleHandles(std::vector<Key>& keys)
{
    if (!keys.empty())
        settleHandlesAround(keys, 0, keys.size() - 1);
}

void settleHandlesAround(std::vector<Key>& keys, std::size_t first, std::size_t last)
{
    auto [from, to] = widened(first, last, keys.size());
    for (std::size_t i = from; i <= to; ++i)
        settleSimple(keys[i], sidesOf(keys, i));
    // Those that the clamped ones look at come first, so that settling twice changes nothing.
    for (std::size_t i = from; i <= to; ++i)
        if (!isClamped(keys[i]))
            settleByHand(keys[i]);
    settleClamped(keys, from, to);
    for (std::size_t i = from; i <= to; ++i)
        if (isClamped(keys[i]))
            settleByHand(keys[i]);
}

Key componentKey(const OrientationKey& key, std::size_t component)
{
    Key one;
    static_cast<KeyShape&>(one) = key;
    one.value = component == 0   ? key.value.w
                : component == 1 ? key.value.x
                : component == 2 ? key.value.y
                                 : key.value.z;
    one.in = key.in[component];
    one.out = key.out[component];
    return one;
}

std::pair<std::size_t, std::size_t> handlesReach(const KeyList<Key>& keys, std::size_t first,
                                                 std::size_t last)
{
    return reachOf(keys, first, last);
}

std::pair<std::size_t, std::size_t> handlesReach(const KeyList<OrientationKey>& keys, std::size_t first,
                                                 std::size_t last)
{
    std::pair reach{first, last};
    for (std::size_t c = 0; c < 4; ++c) {
        const auto [from, to] = reachOf(ComponentKeys{keys, c}, first, last);
        reach = {std::min(reach.first, from), std::max(reach.second, to)};
    }
    return reach;
}

void settleHandlesOfLoop(std::vector<Key>& keys, double shift)
{
    // Rounds before and behind, as many as the slopes at the seam can tell.
    constexpr std::size_t reach = 40;
    const std::size_t round = keys.size() - 1, rounds = reach / round + 1;
    const Ticks period = keys.back().time - keys.front().time;
    std::vector<Key> wide;
    wide.reserve((2 * rounds + 1) * round + 1);
    for (std::size_t r = 0; r < 2 * rounds + 1; ++r) {
        const auto away = static_cast<Ticks>(r) - static_cast<Ticks>(rounds);
        for (std::size_t i = 0; i <= round; ++i) {
            if (i == round && r < 2 * rounds)
                continue; // the same as the first of the next round
            wide.push_back(keys[i]);
            wide.back().time += away * period;
            wide.back().value += double(away) * shift;
            if (i == 0) {
                wide.back().before = keys.back().before;
                wide.back().in = keys.back().in;
            }
        }
    }
    settleHandles(wide);
    const auto isByHand = [](HandleType type) {
        return type == HandleType::Free || type == HandleType::Aligned;
    };
    for (std::size_t i = 0; i <= round; ++i) {
        // Both ends get what the seam has, so that they stay alike to the last digit.
        const Key& settled = wide[rounds * round + (i == round ? 0 : i)];
        if (!isByHand(keys[i].before))
            keys[i].in = settled.in;
        if (!isByHand(keys[i].behind))
            keys[i].out = settled.out;
        settleByHand(keys[i]);
    }
}

} // namespace ramure
