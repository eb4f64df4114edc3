#include "core/math/triangle_pairs.h"

#include "core/math/exact_predicates.h"
#include <algorithm>
#include <utility>

namespace ramure {
namespace {

using Signs = std::array<int, 3>;

Signs sidesOf(const Corners3& plane, const Corners3& points)
{
    Signs signs{};
    for (std::size_t i = 0; i < 3; ++i)
        signs[i] = orientation(plane[0], plane[1], plane[2], points[i]);
    return signs;
}

/// All strictly on one side.
bool apart(const Signs& s)
{
    return (s[0] > 0 && s[1] > 0 && s[2] > 0) || (s[0] < 0 && s[1] < 0 && s[2] < 0);
}

/// The line through a and b is not in the triangle's plane: does it meet the triangle?
bool lineMeets(const glm::vec3& a, const glm::vec3& b, const Corners3& t)
{
    bool above = false, below = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const int side = orientation(a, b, t[i], t[(i + 1) % 3]);
        above = above || side > 0;
        below = below || side < 0;
        if (above && below)
            return false;
    }
    return true;
}

/// One of three points on one line: does it lie between the two others?
bool isBetween(FlatView view, const glm::vec3& p, const glm::vec3& a, const glm::vec3& b)
{
    for (const int axis : {(view + 1) % 3, (view + 2) % 3}) {
        const auto [low, high] = std::minmax(a[axis], b[axis]);
        if (p[axis] < low || p[axis] > high)
            return false;
    }
    return true;
}

bool flatSegmentsMeet(FlatView view, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                      const glm::vec3& d)
{
    const int ac = orientation(view, a, b, c), ad = orientation(view, a, b, d);
    const int ca = orientation(view, c, d, a), cb = orientation(view, c, d, b);
    if (ac * ad < 0 && ca * cb < 0)
        return true;
    return (ac == 0 && isBetween(view, c, a, b)) || (ad == 0 && isBetween(view, d, a, b)) ||
           (ca == 0 && isBetween(view, a, c, d)) || (cb == 0 && isBetween(view, b, c, d));
}

bool flatContains(FlatView view, const Corners3& t, const glm::vec3& p)
{
    bool left = false, right = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const int side = orientation(view, t[i], t[(i + 1) % 3], p);
        left = left || side > 0;
        right = right || side < 0;
    }
    return !(left && right);
}

/// A segment and a triangle in one plane.
bool flatSegmentMeets(FlatView view, const glm::vec3& a, const glm::vec3& b, const Corners3& t)
{
    if (flatContains(view, t, a) || flatContains(view, t, b))
        return true;
    for (std::size_t i = 0; i < 3; ++i)
        if (flatSegmentsMeet(view, a, b, t[i], t[(i + 1) % 3]))
            return true;
    return false;
}

bool flatTrianglesMeet(FlatView view, const Corners3& s, const Corners3& t)
{
    if (flatContains(view, t, s[0]) || flatContains(view, s, t[0]))
        return true;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (flatSegmentsMeet(view, s[i], s[(i + 1) % 3], t[k], t[(k + 1) % 3]))
                return true;
    return false;
}

/// Where a triangle that is not in the plane of \p t meets that plane, the ends are on sides that are not in
/// the plane themselves: is one of these ends in \p t? \p signs on which side of it the corners lie.
bool aSideMeets(const Corners3& s, const Signs& signs, const Corners3& t)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = (i + 1) % 3;
        const bool crosses = signs[i] * signs[k] <= 0 && (signs[i] != 0 || signs[k] != 0);
        if (crosses && lineMeets(s[i], s[k], t))
            return true;
    }
    return false;
}

} // namespace

bool trianglesMeet(const Corners3& s, const Corners3& t)
{
    const Signs ofS = sidesOf(t, s);
    if (apart(ofS))
        return false;
    const Signs ofT = sidesOf(s, t);
    if (apart(ofT))
        return false;
    if (ofS == Signs{})
        return flatTrianglesMeet(viewOf(s[0], s[1], s[2]), s, t);
    return aSideMeets(s, ofS, t) || aSideMeets(t, ofT, s);
}

bool trianglesMeetBeyondVertex(const Corners3& s, const Corners3& t)
{
    // From a common point the ray away from the vertex leaves one of the two first, through the side opposite
    // to it: that side reaches the other triangle.
    const auto sides = [](const Corners3& plane, const Corners3& of) {
        return std::pair(orientation(plane[0], plane[1], plane[2], of[1]),
                         orientation(plane[0], plane[1], plane[2], of[2]));
    };
    const auto [s1, s2] = sides(t, s);
    if (s1 * s2 > 0)
        return false;
    const auto [t1, t2] = sides(s, t);
    if (t1 * t2 > 0)
        return false;
    if (s1 == 0 && s2 == 0) {
        const FlatView view = viewOf(s[0], s[1], s[2]);
        return flatSegmentMeets(view, s[1], s[2], t) || flatSegmentMeets(view, t[1], t[2], s);
    }
    return lineMeets(s[1], s[2], t) || ((t1 != 0 || t2 != 0) && lineMeets(t[1], t[2], s));
}

bool trianglesMeetBeyondEdge(const glm::vec3& a, const glm::vec3& b, const glm::vec3& p, const glm::vec3& q)
{
    if (orientation(a, b, p, q) != 0)
        return false;
    const FlatView view = viewOf(a, b, p);
    return orientation(view, a, b, p) * orientation(view, a, b, q) > 0;
}

bool facesMeet(std::span<const glm::vec3> positions, const glm::uvec3& s, const glm::uvec3& t)
{
    const auto corners = [positions](const glm::uvec3& face) -> Corners3 {
        return {positions[face.x], positions[face.y], positions[face.z]};
    };
    // The corners of both are turned so that those in common come first.
    const auto turned = [positions](const glm::uvec3& face, Index first) -> Corners3 {
        const int k = face.x == first ? 0 : (face.y == first ? 1 : 2);
        return {positions[face[k]], positions[face[(k + 1) % 3]], positions[face[(k + 2) % 3]]};
    };
    std::array<int, 3> common{};
    int count = 0;
    for (int k = 0; k < 3; ++k)
        if (s[k] == t.x || s[k] == t.y || s[k] == t.z)
            common[std::size_t(count++)] = k;
    if (count == 0)
        return trianglesMeet(corners(s), corners(t));
    if (count == 3)
        return true;
    const Index shared = s[common[0]];
    if (count == 1)
        return trianglesMeetBeyondVertex(turned(s, shared), turned(t, shared));
    const Index other = s[common[1]];
    return trianglesMeetBeyondEdge(positions[shared], positions[other],
                                   positions[s.x ^ s.y ^ s.z ^ shared ^ other],
                                   positions[t.x ^ t.y ^ t.z ^ shared ^ other]);
}

} // namespace ramure
