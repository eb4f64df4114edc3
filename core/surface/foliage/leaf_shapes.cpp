#include "core/surface/foliage/leaf_shapes.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include "core/surface/foliage/leaf_blade.h"
#include "core/surface/foliage/leaf_shoot.h"
#include "core/surface/foliage/leaf_table.h"
#include "core/surface/mesh/normals.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

constexpr glm::u8vec3 bladeShade{255, 255, 255}, stalkShade{255, 226, 158};
/// Of petioles; and how far they reach into the bark, whose facets lie below its circle.
constexpr double stalkRadius = 0.016, sunk = 0.03;

/// Where a blade or leaflet stands.
struct Pose
{
    glm::dvec3 origin{0.0}, x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};

    [[nodiscard]] glm::dvec3 at(const glm::dvec3& p) const { return origin + p.x * x + p.y * y + p.z * z; }
    [[nodiscard]] glm::dvec3 along(const glm::dvec3& p) const { return p.x * x + p.y * y + p.z * z; }
};

/// \param upper about where the upper side looks.
Pose poseTowards(const glm::dvec3& origin, const glm::dvec3& towards, const glm::dvec3& upper)
{
    const glm::dvec3 y = glm::normalize(towards), x = glm::normalize(glm::cross(y, upper));
    return {origin, x, y, glm::cross(x, y)};
}

class Builder
{
public:
    explicit Builder(const LeafForm& form)
        : m_form(form)
        , m_row(leafRow(form.shape))
        , m_stations(2 * form.detail - 1)
    {
        if (form.perShoot > 1) { // there are many more of them
            m_stations = form.detail;
            if (m_row.family != LeafFamily::Shoot) // fewer needles would be too broad
                m_form.detail = std::max(1, form.detail - 1);
        }
    }

    TriangleMesh build()
    {
        switch (m_row.family) {
        case LeafFamily::Blade:
            single(bladeOf(m_row, m_form.width, m_stations, m_stations > 2 && m_row.width > 0.3));
            break;
        case LeafFamily::Star:
            single(starOf(m_row, m_form.width, m_form.detail));
            break;
        case LeafFamily::Pinnate:
            pinnate();
            break;
        case LeafFamily::Fingers:
            fingers();
            break;
        case LeafFamily::Tuft:
            tuft();
            break;
        case LeafFamily::Shoot:
            shoot();
            break;
        }
        computeNormals(m_mesh);
        return std::move(m_mesh);
    }

private:
    /// The end of the petiole and the plane of the blade, which nods the more the longer petioles are.
    [[nodiscard]] Pose bladePose() const
    {
        const auto [sine, cosine] = maths::sincos(std::min(0.5, 1.2 * m_row.petiole));
        return {{0.0, petiole(), 0.0}, {1.0, 0.0, 0.0}, {0.0, cosine, -sine}, {0.0, sine, cosine}};
    }
    [[nodiscard]] double petiole() const { return m_row.petiole * m_form.petiole; }

    Index add(const glm::dvec3& place, const glm::dvec2& uv)
    {
        m_mesh.positions.emplace_back(place);
        m_mesh.uv.emplace_back(uv);
        return m_mesh.vertexCount() - 1;
    }
    void face(const glm::uvec3& triangle, const glm::u8vec3& shade)
    {
        m_mesh.triangles.push_back(triangle);
        m_mesh.colours.push_back(shade);
    }
    /// Three sides around each point of the axis but the last, where they meet. Returns that vertex.
    Index stalk(const std::vector<glm::dvec3>& axis, double from, double to)
    {
        const Index first = m_mesh.vertexCount();
        const std::size_t last = axis.size() - 1;
        for (std::size_t i = 0; i < last; ++i) {
            const glm::dvec3 way = glm::normalize(axis[i + 1] - axis[i > 0 ? i - 1 : 0]);
            const glm::dvec3 right(1.0, 0.0, 0.0),
                upper = glm::cross(right, way); // it bends up and down only
            const double radius = from + (to - from) * static_cast<double>(i) / static_cast<double>(last);
            for (int k = 0; k < 3; ++k) {
                const auto [sine, cosine] = maths::sincos(2.0 * pi * k / 3.0 + 0.5 * pi);
                add(axis[i] + radius * (cosine * right + sine * upper), {0.5, 0.0});
            }
        }
        const Index end = add(axis[last], {0.5, 0.0});
        for (Index i = first; i + 3 <= end; i += 3)
            for (Index k = 0; k < 3; ++k) {
                const Index a = i + k, b = i + (k + 1) % 3;
                if (i + 3 == end) {
                    face({a, end, b}, stalkShade);
                } else {
                    face({a, b + 3, b}, stalkShade);
                    face({a, a + 3, b + 3}, stalkShade);
                }
            }
        return end;
    }
    /// From the bark to \p end, where it comes to a point. Nothing where there is no room for it.
    Index petioleTo(const glm::dvec3& end)
    {
        if (petiole() < 2.0 * stalkRadius)
            return noIndex;
        std::vector<glm::dvec3> axis{{0.0, -sunk, 0.0}};
        if (m_form.detail > 1 && petiole() > 6.0 * stalkRadius)
            axis.emplace_back(0.0, petiole() - 4.0 * stalkRadius, 0.0);
        axis.push_back(end);
        return stalk(axis, stalkRadius, 0.6 * stalkRadius);
    }
    /// \param foot a vertex that is there already, or noIndex.
    void blade(const FlatBlade& flat, const BladeBend& bend, const Pose& pose, double length,
               Index foot = noIndex)
    {
        std::vector<Index> vertex(flat.points.size());
        const double low = std::ranges::min(flat.points, {}, &glm::dvec2::y).y;
        for (std::size_t i = 0; i < flat.points.size(); ++i) {
            const glm::dvec2& at = flat.points[i];
            const glm::dvec2 uv(0.5 + 0.5 * at.x / flat.halfWidth, (at.y - low) / (1.0 - low));
            vertex[i] = i == 0 && foot != noIndex ? foot : add(pose.at(length * bend.at(at)), uv);
        }
        if (foot != noIndex)
            m_mesh.uv[foot] = {0.5, -low / (1.0 - low)};
        for (const glm::uvec3& t : flat.triangles)
            face({vertex[t.x], vertex[t.y], vertex[t.z]}, bladeShade);
    }

    void single(const FlatBlade& flat)
    {
        const Pose pose = bladePose();
        blade(flat, BladeBend(m_form, flat.halfWidth), pose, 1.0, petioleTo(pose.origin));
    }

    /// A leaflet of a given length that may be so wide.
    void leaflet(const Pose& pose, double length, double room)
    {
        const double width = std::min(m_form.width, room / (length * m_row.width));
        LeafRow row = m_row;
        if (m_form.detail == 1)
            row.lobes = 0;
        const FlatBlade flat =
            bladeOf(row, width, m_form.detail > 2 || row.lobes > 0 ? 3 : 1, m_form.detail > 2);
        blade(flat, BladeBend(m_form, flat.halfWidth, 0.35), pose, length);
    }
    void pinnate()
    {
        const Pose base = bladePose();
        const double rachis = 1.0 - m_row.leaflet * (1.0 - m_row.dwindle), radius = 0.7 * stalkRadius;
        const BladeBend bend(m_form, 1.0, 0.5);
        const int pieces = 1 + m_form.detail;
        std::vector<glm::dvec3> axis{{0.0, -sunk, 0.0}};
        for (int i = petiole() > 2.0 * sunk ? 0 : 1; i <= pieces; ++i)
            axis.push_back(base.at(bend.at({0.0, rachis * i / pieces})));
        stalk(axis, stalkRadius, 0.3 * stalkRadius);

        const double first = 0.12 * rachis, step = (0.96 * rachis - first) / std::max(m_row.leaflets - 1, 1);
        const auto [across, ahead] = maths::sincos(m_row.spread);
        const auto [up, out] = maths::sincos(0.5 * m_form.fold);
        const double curl = 0.5 * m_form.curl;
        for (int k = 0; k < m_row.leaflets; ++k) {
            const double share = m_row.leaflets > 1 ? static_cast<double>(k) / (m_row.leaflets - 1) : 0.0;
            const double y = first + step * k,
                         bulge = m_row.dwindle > 0.4 ? std::min(1.0, 0.6 + 2.0 * share) : 1.0;
            const double length = m_row.leaflet * bulge * (1.0 - m_row.dwindle * share * share);
            const auto [sine, cosine] = maths::sincos(curl * y);
            const glm::dvec3 on = bend.at({0.0, y}), along(0.0, cosine, -sine), upper(0.0, sine, cosine);
            for (const double side : {-1.0, 1.0}) {
                const glm::dvec3 right(side, 0.0, 0.0);
                const glm::dvec3 way = across * (out * right + up * upper) + ahead * along;
                const Pose flat =
                    poseTowards(base.at(on + 1.2 * radius * right), base.along(way), base.along(upper));
                leaflet(flat, length, 0.85 * step * across);
            }
        }
        const auto [sine, cosine] = maths::sincos(curl * rachis);
        const glm::dvec3 along(0.0, cosine, -sine), upper(0.0, sine, cosine);
        leaflet(poseTowards(base.at(bend.at({0.0, rachis}) + 0.004 * along), base.along(along),
                            base.along(upper)),
                m_row.leaflet * (1.0 - m_row.dwindle) - 0.004, 2.0 * m_row.leaflet);
    }

    void fingers()
    {
        const Pose base = bladePose();
        petioleTo(base.origin);
        const double gap = m_row.spread / (m_row.leaflets - 1), middle = 0.5 * (m_row.leaflets - 1);
        const double wedge = 0.94 * maths::tan(0.5 * std::min(gap, 2.8));
        for (int i = 0; i < m_row.leaflets; ++i) {
            const auto [sine, cosine] = maths::sincos((i - middle) * gap);
            const glm::dvec3 way(sine, cosine, 0.0);
            const double length = 1.0 - m_row.dwindle * maths::pow(std::abs(i - middle) / middle, 1.5);
            const FlatBlade flat = bladeOf(m_row, m_form.width, m_form.detail > 2 ? 3 : 1, m_form.detail > 2);
            blade(flat, BladeBend(m_form, flat.halfWidth, 0.5, wedge),
                  poseTowards(base.at(0.01 * way), base.along(way), base.z), length - 0.01);
        }
    }

    /// In two rings of different steepness.
    void tuft()
    {
        const Pose base = bladePose();
        petioleTo(base.origin);
        for (int i = 0; i < m_row.leaflets; ++i) {
            const bool inner = i % 2 == 1;
            const double steep = (inner ? 0.5 : 1.0) * m_row.spread;
            const auto [across, ahead] = maths::sincos(steep);
            const auto [sine, cosine] = maths::sincos(2.0 * pi * i / m_row.leaflets);
            const glm::dvec3 away(sine, 0.0, cosine), way = across * away + glm::dvec3(0.0, ahead, 0.0);
            const double length = 1.0 - 0.15 * (i % 3);
            const FlatBlade flat =
                m_form.detail > 2 ? bladeOf(m_row, m_form.width, 1, false) : needleOf(m_row, m_form.width);
            const double gap = std::min(4.0 * pi * across / m_row.leaflets, 0.5 * m_row.spread);
            blade(flat, BladeBend(m_form, flat.halfWidth, 0.25, 0.45 * gap),
                  poseTowards(base.at(0.03 * way), base.along(way), base.along({-sine, 0.2, -cosine})),
                  length - 0.03);
        }
    }

    /// Two needles that leave the stem at one place to either side of it, with a foot in common.
    /// \param way of the stem. \param out one needle, \param other the other, for a length of 1.
    void needles(const glm::dvec3& foot, const glm::dvec3& way, const glm::dvec3& out,
                 const glm::dvec3& other, double length, double half)
    {
        constexpr float widest = 0.25F; // of the picture: they begin where it is widest
        const Index below = add(foot - half * way, {0.0, widest}),
                    above = add(foot + half * way, {1.0, widest});
        const Index right = add(foot + length * out, {0.5, 1.0}),
                    left = add(foot + length * other, {0.5, 1.0});
        face({below, right, above}, bladeShade);
        face({above, left, below}, bladeShade);
    }

    struct PairPlace
    {
        double share; ///< along the stem, 0..1
        double lean;  ///< how much it leans towards the stem's end, 0..1: the more, the further it stands
    };
    /// \param room that a pair takes, as a share of the stem.
    [[nodiscard]] PairPlace pairPlace(int i, int count, double room) const
    {
        if (m_row.rosettes == 0)
            return {(i + 0.5) / count, (i + 0.5) / count};
        const int each = count / m_row.rosettes, rosette = i / each, rank = i % each;
        return {(rosette + 0.4) / m_row.rosettes + room * rank, std::min(1.0 * rank, 1.5)};
    }

    /// Coarser shoots have fewer and wider needles, which cover as much.
    void shoot()
    {
        // Stiffer than blades; straight where a bent stem would cost more triangles.
        const bool straight = m_form.detail < 3;
        const double foot = petiole(), curl = std::clamp(0.4 * m_form.curl, -0.35, 0.35);
        LeafForm stiff = m_form;
        stiff.curl = straight ? 0.0 : curl;
        stiff.fold = stiff.cup = 0.0;
        const BladeBend bend(stiff, 1.0);
        const auto atFoot = maths::sincos(straight ? 0.5 * curl : 0.0);
        const double stem = 1.0 - 0.8 * m_row.leaflet * maths::cos(0.6 * m_row.spread);
        const double thick = 0.55 * stalkRadius;
        const auto onStem = [&](double y) {
            const glm::dvec3 at = bend.at({0.0, y});
            return glm::dvec3(0.0, foot + atFoot.cos * at.y, at.z - atFoot.sin * at.y);
        };
        std::vector<glm::dvec3> axis{onStem(-sunk)};
        const int pieces = straight ? 1 : 3;
        for (int i = 1; i <= pieces; ++i)
            axis.push_back(onStem(stem * i / pieces));
        stalk(axis, thick, 0.5 * thick);

        const double fullness = m_form.detail == 1 ? 0.5 : m_form.detail == 2 ? 1.0 : 1.6;
        const int places = std::max(m_row.rosettes, 1);
        const int pairs = places * std::max(1, static_cast<int>(0.5 * fullness * m_row.leaflets / places));
        const double from = m_row.bareFoot * stem, room = 0.98 * stem - from;
        const double half =
            std::min(0.5 * m_row.leaflet * m_row.width * m_form.width / fullness, 0.45 * room / pairs);
        for (int i = 0; i < pairs; ++i) {
            const auto [share, lean] = pairPlace(i, pairs, 2.3 * half / room);
            const double y = from + room * share;
            const auto [down, onwards] = maths::sincos(straight ? 0.5 * curl : curl * y);
            const glm::dvec3 right(1.0, 0.0, 0.0), along(0.0, onwards, -down), upper(0.0, down, onwards);
            const auto [sine, cosine] = maths::sincos(m_row.flat ? 0.0 : i * goldenAngle);
            const glm::dvec3 out = cosine * right + sine * upper, over = cosine * upper - sine * right;
            const double steep = m_row.spread * (1.0 - 0.4 * lean);
            const auto [across, ahead] = maths::sincos(steep);
            // Every second pair of a flat shoot is raised.
            const auto [up, level] = maths::sincos(m_row.flat ? 0.12 + 0.4 * (i % 2) : 0.0);
            const glm::dvec3 one = across * (level * out + up * over),
                             two = across * (up * over - level * out);
            const double length =
                m_row.leaflet * (1.0 - m_row.dwindle * share * share) * (1.0 - 0.09 * (i % 3));
            needles(onStem(y) + 1.4 * thick * over, along, one + ahead * along, two + ahead * along, length,
                    half);
        }
    }

    LeafForm m_form;
    const LeafRow& m_row;
    int m_stations; ///< of a blade, between its foot and its tip
    TriangleMesh m_mesh;
};

} // namespace

LeafForm leafForm(const LeafParams& params)
{
    LeafForm form{.shape = params.shape,
                  .width = params.width,
                  .petiole = params.petiole,
                  .fold = params.fold,
                  .curl = params.curl,
                  .cup = params.cup,
                  .detail = static_cast<int>(params.detail),
                  .turns = params.season > 0.0,
                  .length = params.length};
    if (params.shape == LeafShape::Faithful || params.perShoot < 2)
        return form;
    form.perShoot = static_cast<int>(params.perShoot);
    form.arrangement = params.arrangement == LeafArrangement::Natural ? leafRow(params.shape).arrangement
                                                                      : params.arrangement;
    form.whorl = static_cast<int>(params.whorl);
    form.angle = params.angle;
    return form;
}

double leafLength(const LeafForm& form, double alpha)
{
    if (form.shape == LeafShape::Faithful)
        return alpha;
    return form.length > 0.0 ? form.length : alpha * leafRow(form.shape).length;
}

TriangleMesh leafMesh(const LeafForm& form)
{
    if (!(form.width > 0.0))
        return {};
    return shootOf(Builder(form).build(), form);
}

TriangleMesh rhombIn(TriangleMesh square)
{
    const auto toMiddles = [](auto& corners) {
        const auto old = corners;
        for (std::size_t i = 0; i < corners.size(); ++i)
            corners[i] = 0.5F * (old[i] + old[(i + 1) % old.size()]);
    };
    toMiddles(square.positions);
    toMiddles(square.uv);
    return square;
}

TriangleMesh leafCard(const LeafForm& form, CardOutline outline)
{
    LeafForm single = form;
    single.perShoot = 1;
    const TriangleMesh leaf = leafMesh(single);
    TriangleMesh card;
    if (leaf.empty())
        return card;
    const auto& p = leaf.positions;
    const auto low = static_cast<float>(leafRow(form.shape).petiole * form.petiole);
    const float half = std::ranges::max(p, {}, &glm::vec3::x).x;
    const glm::vec3 far = std::ranges::max(p, {}, &glm::vec3::y);
    card.positions = {{-half, low, 0.0F}, {half, low, 0.0F}, {half, far.y, far.z}, {-half, far.y, far.z}};
    card.triangles = {{0, 1, 2}, {0, 2, 3}};
    card.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    card.colours.assign(2, bladeShade);
    if (outline == CardOutline::Rhomb)
        card = rhombIn(std::move(card));
    computeNormals(card);
    return shootOf(card, form);
}

} // namespace ramure
