#include "core/math/exact_predicates.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace ramure {
namespace {

constexpr double halfUlp = 0x1.0p-53;
/// Shewchuk's bounds for the first stage: the error of the plain determinant against its permanent.
constexpr double spaceBound = (7.0 + 56.0 * halfUlp) * halfUlp;
constexpr double flatBound = (3.0 + 16.0 * halfUlp) * halfUlp;

int signOf(double value)
{
    return (value > 0.0) - (value < 0.0);
}

/// A sum of doubles without any rounding: non-overlapping components in ascending order of size. Products
/// of three floats are far inside the range of doubles, so nothing over- or underflows.
template <std::size_t capacity> class ExactSum
{
public:
    void add(double value)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < m_count; ++i) {
            const double component = m_components[i];
            const double sum = value + component;
            const double from = sum - value;
            const double rest = (value - (sum - from)) + (component - from);
            if (rest != 0.0)
                m_components[kept++] = rest;
            value = sum;
        }
        if (value != 0.0)
            m_components[kept++] = value;
        m_count = kept;
    }
    /// \param product of at most 48 bits, times \p factor of at most 24.
    void addProduct(double product, double factor)
    {
        const double high = product * factor;
        add(std::fma(product, factor, -high));
        add(high);
    }
    [[nodiscard]] int sign() const { return m_count == 0 ? 0 : signOf(m_components[m_count - 1]); }

private:
    std::array<double, capacity> m_components;
    std::size_t m_count = 0;
};

using SpaceSum = ExactSum<49>;

/// Adds, or takes away, dot(p, cross(q, r)).
void addTriple(SpaceSum& sum, double sign, const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r)
{
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum.addProduct(q[j] * r[k], sign * p[i]);
        sum.addProduct(q[k] * r[j], -sign * p[i]);
    }
}

/// The four triple products of the determinant, without a difference that could round.
int exactOrientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
    SpaceSum sum;
    addTriple(sum, 1.0, b, c, d);
    addTriple(sum, -1.0, a, c, d);
    addTriple(sum, 1.0, a, b, d);
    addTriple(sum, -1.0, a, b, c);
    return sum.sign();
}

} // namespace

int orientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d)
{
    const glm::dvec3 from(a);
    const glm::dvec3 u = glm::dvec3(b) - from, v = glm::dvec3(c) - from, w = glm::dvec3(d) - from;
    const double yz = u.y * v.z, zy = u.z * v.y;
    const double zx = u.z * v.x, xz = u.x * v.z;
    const double xy = u.x * v.y, yx = u.y * v.x;
    const double det = (yz - zy) * w.x + (zx - xz) * w.y + (xy - yx) * w.z;
    const double permanent = (std::abs(yz) + std::abs(zy)) * std::abs(w.x) +
                             (std::abs(zx) + std::abs(xz)) * std::abs(w.y) +
                             (std::abs(xy) + std::abs(yx)) * std::abs(w.z);
    if (std::abs(det) > spaceBound * permanent)
        return signOf(det);
    return permanent == 0.0 ? 0 : exactOrientation(from, b, c, d);
}

int orientation(FlatView view, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const int x = (view + 1) % 3, y = (view + 2) % 3;
    const double ax = a[x], ay = a[y], bx = b[x], by = b[y], cx = c[x], cy = c[y];
    const double left = (ax - cx) * (by - cy), right = (ay - cy) * (bx - cx);
    const double det = left - right;
    if (std::abs(det) > flatBound * (std::abs(left) + std::abs(right)))
        return signOf(det);
    if (left == 0.0 && right == 0.0)
        return 0;
    ExactSum<7> sum; // products of two floats are exact
    sum.add(ax * by);
    sum.add(-(ay * bx));
    sum.add(bx * cy);
    sum.add(-(by * cx));
    sum.add(cx * ay);
    sum.add(-(cy * ax));
    return sum.sign();
}

FlatView viewOf(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    for (const FlatView view : {2, 0, 1})
        if (orientation(view, a, b, c) != 0)
            return view;
    return -1;
}

} // namespace ramure
