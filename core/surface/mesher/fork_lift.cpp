#include "core/surface/mesher/fork_lift.h"

#include <algorithm>
#include <cmath>

namespace ramure {

namespace {

/// Of the shortest child: where the search for a valley looks.
constexpr std::array<double, 7> searchShares{0.08, 0.16, 0.28, 0.44, 0.62, 0.8, 0.95};
constexpr double growth = 1.1; ///< of the first step away from a guess
constexpr int mostRefinements = 5;
constexpr double limbGrowth = 1.12; ///< of a step along a limb, until it leaves the stem
constexpr double leastOfLimb = 0.01;
constexpr double closeEnough = 0.04; ///< of the radius: a wall vertex needs no more room than that
constexpr double spacing = 1.42;     ///< of a guess's places: so many times as far from the fork as the last
/// Beyond the triangle of three axes the circle's centre is followed so far, in weights.
constexpr double leastWeight = -0.6, mostWeight = 1.5;

/// Where the search for a valley stands: inside the tubes below, outside above.
struct Stretch
{
    double inside, roomInside;
    double outside, roomOutside;

    /// The upper place is inside as well: a higher one takes its part.
    void rise(double higher)
    {
        inside = outside;
        roomInside = roomOutside;
        outside = higher;
    }
    /// Another place is known, which is no end yet.
    void learn(double along, double roomThere)
    {
        if (along < outside && roomThere < 0.0) {
            inside = along;
            roomInside = roomThere;
        } else if (along > outside && roomThere > 0.0 && roomOutside < 0.0) {
            rise(along);
            roomOutside = roomThere;
        }
    }
    void narrow(double middle, double roomThere)
    {
        (roomThere < 0.0 ? inside : outside) = middle;
        (roomThere < 0.0 ? roomInside : roomOutside) = roomThere;
    }
};

double square(const glm::dvec3& v)
{
    return glm::dot(v, v);
}

/// Barycentric weights of the centre of the circle through three points, limited.
std::array<double, 3> circumcentreWeights(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const double aa = square(b - c), bb = square(c - a), cc = square(a - b);
    std::array<double, 3> weight{aa * (bb + cc - aa), bb * (cc + aa - bb), cc * (aa + bb - cc)};
    const double sum = weight[0] + weight[1] + weight[2];
    if (!(sum > 0.0))
        return {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
    double kept = 0.0;
    for (double& w : weight) {
        w = std::clamp(w / sum, leastWeight, mostWeight);
        kept += w;
    }
    for (double& w : weight)
        w /= kept;
    return weight;
}

/// Across the way from one axis to the other, as far from both: the given direction without its part along
/// that way.
glm::dvec3 across(const glm::dvec3& aside, const glm::dvec3& way)
{
    const double squared = square(way);
    if (!(squared > 0.0))
        return aside;
    const glm::dvec3 straight = aside - way * (glm::dot(aside, way) / squared);
    const double length = square(straight);
    return length > 0.05 ? straight * (1.0 / std::sqrt(length)) : aside;
}

glm::dvec3 offsetOf(const WallPath& path, const glm::dvec3& way, double along)
{
    glm::dvec3 direction = across(path.aside, way);
    if (along < path.leansUpTo) {
        const double share = 1.0 - along / path.leansUpTo;
        direction += (path.atRing - direction) * (share * share);
        direction *= 1.0 / std::sqrt(std::max(square(direction), 1e-6));
    }
    return path.out * direction;
}

} // namespace

void ValleyGuess::begin(std::span<const ForkChild> children)
{
    double along = std::numeric_limits<double>::max();
    for (const ForkChild& child : children)
        along = std::min(along, child.table.length());
    m_axes.resize(std::max(m_axes.size(), children.size()));
    for (std::size_t k = places; k-- > 0; along /= spacing) {
        m_along[k] = along;
        for (std::size_t i = 0; i < children.size(); ++i)
            m_axes[i][k] = children[i].table.at(along);
    }
}

void ValleyGuess::build(const WallPath& path)
{
    const auto &first = m_axes[path.child[0]], &second = m_axes[path.child[1]];
    for (std::size_t k = 0; k < places; ++k) {
        const std::array<AxisTable::Place, 2> axis{first[k], second[k]};
        const glm::dvec3 half = 0.5 * (axis[1].point - axis[0].point);
        const glm::dvec3 aside = across(path.aside, half);
        for (std::size_t i = 0; i < 2; ++i) {
            const glm::dvec3 away = i == 0 ? half : -half;
            const double ahead = glm::dot(away, axis[i].tangent), lean = glm::dot(aside, axis[i].tangent);
            const double radius = (1.0 + ForkLift::margin) * axis[i].radius;
            m_sides[k][i] = {square(away) - ahead * ahead - radius * radius,
                             glm::dot(away, aside) - ahead * lean, 1.0 - lean * lean};
        }
    }
}

double ValleyGuess::exitAt(double out) const
{
    double before = 0.0, inside = 0.0;
    for (std::size_t k = 0; k < places; ++k) {
        const double room = std::min(m_sides[k][0].at(out), m_sides[k][1].at(out));
        if (room >= 0.0) {
            if (k == 0)
                return m_along[0];
            // Between two places the squared distance grows like the square of the way.
            const double low = before * before, high = m_along[k] * m_along[k];
            return std::sqrt(low + (high - low) * (inside / (inside - room)));
        }
        before = m_along[k];
        inside = room;
    }
    return m_along[places - 1];
}

double ForkLift::meanRadius(const WallPath& path) const
{
    return 0.5 * (m_children[path.child[0]].sections.front().radius +
                  m_children[path.child[1]].sections.front().radius);
}

std::array<double, 3> ForkLift::weightsAt(const WallPath& path, double along) const
{
    if (path.onLimb) // it is a place on the stem
        return {0.0, 1.0, 0.0};
    if (path.count == 2)
        return {0.5, 0.5, 0.0};
    return circumcentreWeights(m_children[path.child[0]].table.pointAt(along),
                               m_children[path.child[1]].table.pointAt(along),
                               m_children[path.child[2]].table.pointAt(along));
}

glm::dvec3 ForkLift::pointAt(const WallPath& path, double along) const
{
    const glm::dvec3 first = m_children[path.child[0]].table.pointAt(along);
    const glm::dvec3 second = m_children[path.child[1]].table.pointAt(along);
    if (path.count == 2)
        return 0.5 * (first + second) + offsetOf(path, second - first, along);
    const glm::dvec3 third = m_children[path.child[2]].table.pointAt(along);
    const auto weight = circumcentreWeights(first, second, third);
    return weight[0] * first + weight[1] * second + weight[2] * third;
}

/// How far the path's point at an arc length is outside the tubes it lies between, margin included, and, if
/// wanted, all others; negative inside.
double ForkLift::room(const WallPath& path, double along, Tubes tubes) const
{
    std::array<AxisTable::Place, 3> places;
    for (std::size_t i = 0; i < path.count; ++i)
        places[i] = m_children[path.child[i]].table.at(along);
    glm::dvec3 point;
    if (path.count == 2) {
        point = 0.5 * (places[0].point + places[1].point) +
                offsetOf(path, places[1].point - places[0].point, along);
    } else {
        const auto weight = circumcentreWeights(places[0].point, places[1].point, places[2].point);
        point = weight[0] * places[0].point + weight[1] * places[1].point + weight[2] * places[2].point;
    }
    // The foot of a point is at most as far as the axis at the same arc length: most points are found inside
    // so.
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < path.count; ++i) {
        const glm::dvec3 away = point - places[i].point;
        least = std::min(least, std::sqrt(square(away)) - (1.0 + margin) * places[i].radius);
    }
    if (least < 0.0)
        return least;
    for (std::size_t i = 0; i < path.count; ++i) {
        const double clear = m_children[path.child[i]].table.clearanceFrom(places[i], point, along);
        least = std::min(least, clear - margin * places[i].radius);
    }
    if (tubes == Tubes::Own)
        return least;
    for (std::size_t j = 0; j < m_children.size() && least >= 0.0; ++j)
        if (j != path.child[0] && j != path.child[1] && j != path.child[2])
            least = std::min(least, m_children[j].table.clearance(point, along));
    return least;
}

/// Goes up along the path until its point leaves the tubes: in growing steps, or from a guess up or down,
/// then by false position between the last place inside and the first one outside. \returns the arc length,
/// or nothing if the point never leaves.
std::optional<double> ForkLift::exitHeight(const WallPath& path, double reach, double guess,
                                           Tubes tubes) const
{
    const double radius = meanRadius(path), enough = closeEnough * radius;
    const double most = reach * searchShares.back();
    const double atStart = std::min(path.out - (1.0 + margin) * radius, -1e-3 * radius);
    Stretch stretch{0.0, atStart, std::min(guess, most), -1.0};
    if (guess > 0.0) {
        stretch.roomOutside = room(path, stretch.outside, tubes);
        const auto fits = [enough](double there) { return there >= -0.1 * enough && there <= enough; };
        if (fits(stretch.roomOutside))
            return stretch.outside;
        // One step as if squared distances grew with the square of the way, which is nearly so.
        const double first = stretch.outside, roomFirst = stretch.roomOutside;
        if (roomFirst > atStart) {
            const double share = std::sqrt((atStart - 0.2 * enough) / (atStart - roomFirst));
            stretch.outside = std::min(most, first * std::clamp(share, 0.7, 1.4));
            stretch.roomOutside = room(path, stretch.outside, tubes);
            if (fits(stretch.roomOutside))
                return stretch.outside;
            stretch.learn(first, roomFirst);
        }
        for (double step = growth; stretch.roomOutside < 0.0 && stretch.outside < most; step *= growth) {
            stretch.rise(std::min(most, stretch.outside * step));
            stretch.roomOutside = room(path, stretch.outside, tubes);
        }
        if (stretch.inside == 0.0 && stretch.roomOutside > enough) { // the guess was too high
            const double lower = stretch.outside / (growth * growth);
            stretch.narrow(lower, room(path, lower, tubes));
        }
    } else {
        for (const double share : searchShares) {
            stretch.outside = reach * share;
            stretch.roomOutside = room(path, stretch.outside, tubes);
            if (stretch.roomOutside >= 0.0)
                break;
            stretch.rise(stretch.outside);
        }
    }
    if (stretch.roomOutside < 0.0)
        return std::nullopt;
    for (int round = 0; round < mostRefinements && stretch.roomOutside > enough; ++round) {
        const double part =
            std::clamp(stretch.roomInside / (stretch.roomInside - stretch.roomOutside), 0.2, 0.8);
        const double middle = stretch.inside + (stretch.outside - stretch.inside) * part;
        stretch.narrow(middle, room(path, middle, tubes));
    }
    return stretch.outside;
}

/// Does a tube that the path does not lie between cover a point?
bool ForkLift::isCovered(const WallPath& path, const glm::dvec3& point, double along) const
{
    for (Index j = 0; j < m_children.size(); ++j)
        if (j != path.child[0] && j != path.child[1] && j != path.child[2] &&
            m_children[j].table.clearance(point, along) < 0.0)
            return true;
    return false;
}

ForkLift::Lifted ForkLift::liftOnLimb(const WallPath& path, double guess) const
{
    const AxisTable &limb = m_children[path.child[0]].table, &stem = m_children[path.child[1]].table;
    const glm::dvec3 base = stem.pointAt(0.0), onwards = stem.at(0.0).tangent;
    const double radius = limb.at(0.0).radius;
    const auto pointAt = [&](double along) {
        const AxisTable::Place place = limb.at(along);
        const glm::dvec3 aside = across(path.aside, place.tangent);
        const glm::dvec3 up = glm::cross(aside, place.tangent);
        const double share = place.radius / (radius * std::sqrt(square(place.tangent)));
        return place.point + (path.out * share) * aside + (path.up * share) * up;
    };
    // How far outside the stem, margin included.
    const auto roomAt = [&](double along) {
        const glm::dvec3 point = pointAt(along);
        const double foot = glm::dot(point - base, onwards);
        return stem.clearance(point, foot) - margin * stem.at(foot).radius;
    };
    const double most = searchShares.back() * limb.length(), enough = closeEnough * radius;
    double at = std::min(guess, most), there = roomAt(at);
    Stretch stretch{0.0, -stem.at(0.0).radius, at, there};
    if (there < 0.0) {
        for (; there < 0.0 && at < most; there = roomAt(at)) {
            stretch.inside = at;
            stretch.roomInside = there;
            at = std::min(most, limbGrowth * at);
        }
        stretch.outside = at;
        stretch.roomOutside = there;
    } else {
        for (at /= limbGrowth; at > leastOfLimb * most; at /= limbGrowth) {
            there = roomAt(at);
            stretch.narrow(at, there);
            if (there < 0.0)
                break;
        }
    }
    for (int round = 0; round < mostRefinements && stretch.roomOutside > enough; ++round) {
        const double part =
            std::clamp(stretch.roomInside / (stretch.roomInside - stretch.roomOutside), 0.1, 0.9);
        const double middle = stretch.inside + (stretch.outside - stretch.inside) * part;
        stretch.narrow(middle, roomAt(middle));
    }
    return {pointAt(stretch.outside), stretch.outside};
}

ForkLift::Lifted ForkLift::lift(const WallPath& path, double guess, double most) const
{
    double reach = m_children[path.child[0]].table.length();
    for (std::size_t i = 1; i < path.count; ++i)
        reach = std::min(reach, m_children[path.child[i]].table.length());
    const std::optional<double> along = exitHeight(path, reach, guess, Tubes::Own);
    double height = along.value_or(reach);
    glm::dvec3 point = pointAt(path, height);
    // Seldom does a third tube cover the place where two come apart: it is asked only there.
    if (along && *along < most && isCovered(path, point, *along)) {
        height = std::min(exitHeight(path, reach, 0.0, Tubes::All).value_or(reach), most);
        point = pointAt(path, height);
    }
    return {point, height};
}

} // namespace ramure
