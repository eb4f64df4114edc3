#include "core/surface/foliage/fruit_shapes.h"

#include "core/math/angle.h"
#include "core/math/reproducible.h"
#include "core/surface/foliage/foliage_shapes.h"
#include "core/surface/mesh/normals.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ramure {
namespace {

/// Lengths in radii of the body, but for the radius.
struct FruitRow
{
    FruitKind kind;
    double radius; ///< of the grammar's length
    double height; ///< half of it
    glm::u8vec3 colour;
    double stalk; ///< length
    double stalkRadius = 0.06;
    glm::u8vec3 stalkColour{0x6B, 0x58, 0x34};
    double topHollow = 0.0; ///< how deep the upper end lies
    double lowHollow = 0.0; ///< and the lower one
    double neck = 0.0;      ///< share by which the upper half is slimmer
    double point = 0.0;     ///< how far both ends are drawn out
    double scales = 0.0;    ///< height of the rims that run around it
    int petals = 0;         ///< lobes around it
    double cap = 2.0;       ///< height from which it wears another colour, in half heights
    glm::u8vec3 capColour{};
    int cluster = 1;
    int sides = 12, rings = 9; ///< of the body: small ones are many, and need few
    int strung = 0;            ///< so many along one stalk, each to a side of its own
};

// clang-format off
constexpr std::array<FruitRow, fruitKindCount - 1> fruits{{
    {.kind = FruitKind::Apple, .radius = 0.20, .height = 0.90, .colour = {0xA8, 0x24, 0x1C}, .stalk = 0.75, .topHollow = 0.42, .lowHollow = 0.22},
    {.kind = FruitKind::Pear, .radius = 0.18, .height = 1.30, .colour = {0xA9, 0xA8, 0x3C}, .stalk = 0.90, .lowHollow = 0.18, .neck = 0.55},
    {.kind = FruitKind::Cherry, .radius = 0.065, .height = 0.95, .colour = {0x8E, 0x0F, 0x1E}, .stalk = 4.00, .stalkRadius = 0.09, .topHollow = 0.30, .cluster = 2, .sides = 6, .rings = 4},
    {.kind = FruitKind::Plum, .radius = 0.10, .height = 1.20, .colour = {0x3B, 0x2A, 0x55}, .stalk = 1.00, .topHollow = 0.15},
    {.kind = FruitKind::Orange, .radius = 0.19, .height = 0.95, .colour = {0xD9, 0x7A, 0x14}, .stalk = 0.35, .topHollow = 0.10},
    {.kind = FruitKind::Lemon, .radius = 0.14, .height = 1.20, .colour = {0xDD, 0xC0, 0x2F}, .stalk = 0.60, .point = 0.22},
    {.kind = FruitKind::Olive, .radius = 0.05, .height = 1.35, .colour = {0x4C, 0x5A, 0x2A}, .stalk = 1.20, .cluster = 2, .sides = 6, .rings = 4},
    {.kind = FruitKind::Acorn, .radius = 0.055, .height = 1.55, .colour = {0x8C, 0x6A, 0x2E}, .stalk = 1.80, .point = 0.12, .cap = 0.30, .capColour = {0x6E, 0x5A, 0x3C}, .cluster = 2, .sides = 6, .rings = 4},
    {.kind = FruitKind::Cone, .radius = 0.13, .height = 2.00, .colour = {0x6A, 0x4A, 0x2C}, .stalk = 0.40, .stalkRadius = 0.10, .neck = -0.35, .scales = 0.16},
    {.kind = FruitKind::Coconut, .radius = 0.55, .height = 1.15, .colour = {0x6F, 0x7A, 0x2E}, .stalk = 0.80, .stalkRadius = 0.12, .cluster = 4},
    {.kind = FruitKind::Dates, .radius = 0.045, .height = 9.00, .colour = {0xC6, 0x84, 0x2C}, .stalk = 5.00, .stalkRadius = 0.14, .stalkColour = {0xC9, 0x7A, 0x1C}, .cluster = 7, .sides = 6, .rings = 4, .strung = 9},
    {.kind = FruitKind::Berries, .radius = 0.04, .height = 1.00, .colour = {0xC4, 0x35, 0x12}, .stalk = 3.00, .stalkRadius = 0.10, .cluster = 9, .sides = 6, .rings = 4},
    {.kind = FruitKind::Blossom, .radius = 0.14, .height = 0.30, .colour = {0xF3, 0xDD, 0xE2}, .stalk = 0.80, .stalkRadius = 0.05, .lowHollow = 0.42, .petals = 5, .capColour = {0xD8, 0xB0, 0x3A}, .cluster = 3},
}};
// clang-format on

constexpr bool fruitsStandInOrder()
{
    for (std::size_t i = 0; i < fruits.size(); ++i)
        if (static_cast<std::size_t>(fruits[i].kind) != i + 1)
            return false;
    return true;
}

const FruitRow& fruitRow(FruitKind kind)
{
    static_assert(fruitsStandInOrder(), "the rows stand in the order of the kinds");
    return fruits[static_cast<std::size_t>(kind) - 1];
}

double power8(double x)
{
    const double squared = x * x;
    return squared * squared * squared * squared;
}

/// The outline of a body at \p s = sine of the latitude, -1..1, and its cosine: distance from the axis,
/// height.
glm::dvec2 outline(const FruitRow& row, double s, double c)
{
    const double up = std::max(s, 0.0), down = std::max(-s, 0.0);
    double radius = c;
    if (row.neck > 0.0)
        radius *= 1.0 - row.neck * up * up * (3.0 - 2.0 * up);
    else
        radius *= 1.0 + row.neck * down * down;
    radius *= 1.0 + row.scales * (0.5 - std::abs(std::remainder(5.0 * s, 1.0)) * 2.0) * c;
    if (row.cap < 1.0 && s > row.cap)
        radius *= 1.12;
    const double hollow = row.topHollow * power8(up) - row.lowHollow * power8(down);
    const double point = row.point * (power8(up) - power8(down));
    return {radius, row.height * s - hollow + point};
}

/// Rings around an axis, from the lower pole to the foot of the stalk.
class Turned
{
public:
    Turned(const FruitRow& row, double stalk)
        : m_row(row)
        , m_sides(row.petals > 0 ? 4 * row.petals : row.sides)
        , m_stalk(stalk)
    {
    }

    TriangleMesh build()
    {
        m_mesh.positions.emplace_back(glm::dvec3(0.0, outline(m_row, -1.0, 0.0).y, 0.0));
        const double top = m_row.strung > 0 ? string() : body();
        if (m_stalk > 0.0) {
            const double foot = outline(m_row, 1.0, 0.0).y;
            ring(m_row.stalkRadius, foot, false, m_row.cap < 1.0 ? m_row.capColour : m_row.colour);
            ring(m_row.stalkRadius, m_row.height + m_stalk, false, m_row.stalkColour);
            close(m_row.height + m_stalk + m_row.stalkRadius, m_row.stalkColour);
        } else {
            close(std::max(outline(m_row, 1.0, 0.0).y, top),
                  m_row.cap < 1.0 ? m_row.capColour : m_row.colour);
        }
        computeNormals(m_mesh);
        return std::move(m_mesh);
    }

private:
    /// Returns the height of its last ring.
    double body()
    {
        const int rings = m_row.scales > 0.0 ? 21 : m_row.rings;
        double top = 0.0;
        for (int i = 1; i <= rings; ++i) {
            // The last ring is the foot of the stalk's neck.
            const double latitude = pi * (static_cast<double>(i) / (rings + 0.5) - 0.5);
            const auto [s, c] = maths::sincos(latitude);
            const glm::dvec2 at = outline(m_row, s, c);
            ring(at.x, at.y, true, colourAt(s));
            top = at.y;
        }
        return top;
    }
    /// Fruit after fruit along the stalk, which shows between them. Returns the height of the last ring.
    double string()
    {
        constexpr double stout = 0.66; // of the string's radius
        const double half = m_row.height / m_row.strung;
        double top = 0.0;
        for (int fruit = 0; fruit < m_row.strung; ++fruit) {
            const double middle = (2 * fruit + 1) * half - m_row.height;
            const auto [sine, cosine] = maths::sincos(goldenAngle * fruit);
            m_aside = (1.0 - stout) * glm::dvec3(sine, 0.0, cosine);
            for (int i = 1; i <= m_row.rings; ++i) {
                const auto [s, c] = maths::sincos(pi * (static_cast<double>(i) / (m_row.rings + 1) - 0.5));
                ring(stout * c, middle + 0.94 * half * s, false, m_row.colour);
            }
            m_aside = {};
            top = middle + 0.97 * half;
            ring(m_row.stalkRadius, top, false, m_row.stalkColour);
        }
        return top;
    }
    /// Of the band that ends at a height. A flower's middle lies at its lower pole.
    [[nodiscard]] glm::u8vec3 colourAt(double s) const
    {
        const bool isMiddle = m_row.petals > 0 && s < -0.92;
        return isMiddle || s > m_row.cap ? m_row.capColour : m_row.colour;
    }
    void ring(double radius, double height, bool lobed, const glm::u8vec3& colour)
    {
        const Index first = m_mesh.vertexCount(), sides = static_cast<Index>(m_sides);
        for (int k = 0; k < m_sides; ++k) {
            const double angle = 2.0 * pi * k / m_sides;
            const auto [sine, cosine] = maths::sincos(angle);
            const double lobe = lobed && m_row.petals > 0
                                    ? 0.35 + 0.65 * std::abs(maths::cos(0.5 * m_row.petals * angle))
                                    : 1.0;
            // Petals lie lower where they are wide: the flower is a cup.
            m_mesh.positions.emplace_back(m_aside +
                                          glm::dvec3(lobe * radius * sine, height, lobe * radius * cosine));
        }
        for (Index k = 0; k < sides; ++k) {
            const Index a = first + k, b = first + (k + 1) % sides;
            if (first == 1)
                face({0, b, a}, colour);
            else {
                face({a - sides, b - sides, b}, colour);
                face({a - sides, b, a}, colour);
            }
        }
    }
    void close(double height, const glm::u8vec3& colour)
    {
        const Index top = m_mesh.vertexCount(), sides = static_cast<Index>(m_sides);
        m_mesh.positions.emplace_back(glm::dvec3(0.0, height, 0.0));
        for (Index k = 0; k < sides; ++k)
            face({top - sides + k, top - sides + (k + 1) % sides, top}, colour);
    }
    void face(const glm::uvec3& triangle, const glm::u8vec3& colour)
    {
        m_mesh.triangles.push_back(triangle);
        m_mesh.colours.push_back(colour);
    }

    const FruitRow& m_row;
    int m_sides;
    double m_stalk;
    glm::dvec3 m_aside{0.0}; ///< from the axis to the middle of rings
    TriangleMesh m_mesh;
};

constexpr glm::vec3 unripe(0x86, 0x9B, 0x45);

double stalkOf(const FruitForm& form)
{
    const double length = fruitRow(form.kind).stalk * form.stalk;
    return length < fruitRow(form.kind).stalkRadius ? 0.0 : length;
}

} // namespace

/// Flowers on stalks from one foot: from three metres away nobody counts the triangles of one, and a tree in
/// bloom has very many.
static TriangleMesh umbel(const FruitRow& row, double stalk, int count)
{
    constexpr double low = -0.18, high = 0.12, spread = 0.75; // of the radius; of a right angle
    constexpr int ofPetal = 2;
    const double foot = row.height + stalk;
    TriangleMesh mesh;
    for (int flower = 0; flower < count; ++flower) {
        const double lean = 0.5 * pi * spread * std::sqrt((flower + 0.5) / count);
        const auto leaning = maths::sincos(lean), around = maths::sincos(goldenAngle * flower);
        const Index first = mesh.vertexCount();
        const auto add = [&](double x, double y, double z) { // leaning about the foot
            const double down = y - foot, out = leaning.cos * x - leaning.sin * down;
            mesh.positions.emplace_back(around.cos * out - around.sin * z,
                                        foot + leaning.sin * x + leaning.cos * down,
                                        around.sin * out + around.cos * z);
        };
        add(0.0, low, 0.0);
        add(0.0, high, 0.0);
        const int rim = ofPetal * row.petals;
        for (int k = 0; k < rim; ++k) {
            const bool isNotch = k % ofPetal == 0;
            const auto [sine, cosine] = maths::sincos(2.0 * pi * k / rim);
            const double radius = isNotch ? 0.6 : 1.0;
            add(radius * sine, isNotch ? -0.02 : low - 0.1, radius * cosine);
        }
        const auto face = [&](Index a, Index b, Index c, const glm::u8vec3& colour) {
            mesh.triangles.emplace_back(first + a, first + b, first + c);
            mesh.colours.push_back(colour);
        };
        const auto last = static_cast<Index>(rim);
        for (Index k = 0; k < last; ++k) {
            const Index a = 2 + k, b = 2 + (k + 1) % last;
            face(0, b, a, row.colour);
            face(1, a, b, row.colour);
        }
        const Index tube = mesh.vertexCount() - first;
        for (int k = 0; k < 3; ++k) {
            const auto [sine, cosine] = maths::sincos(2.0 * pi * k / 3);
            add(row.stalkRadius * sine, 0.0, row.stalkRadius * cosine);
        }
        add(0.0, foot - 0.3 * row.stalkRadius, 0.0); // no two at one place
        face(tube, tube + 2, tube + 1, row.capColour);
        for (Index k = 0; k < 3; ++k)
            face(tube + k, tube + (k + 1) % 3, tube + 3, row.stalkColour);
    }
    computeNormals(mesh);
    return mesh;
}

/// Of the body. Where fruit ripen it is nowhere darker than any of their colours.
static glm::u8vec3 bodyColour(const FruitForm& form)
{
    const FruitRow& row = fruitRow(form.kind);
    const glm::vec3 ripe(row.colour);
    return form.ripens ? glm::u8vec3(glm::max(ripe, unripe))
                       : glm::u8vec3(glm::mix(unripe, ripe, static_cast<float>(form.ripe)) + 0.5F);
}

glm::vec3 ripenedTint(FruitKind kind, double ripe)
{
    const FruitRow& row = fruitRow(kind);
    const glm::vec3 last(row.colour);
    return glm::min(glm::mix(unripe, last, float(ripe)) / glm::max(last, unripe), 1.0F);
}

FruitForm fruitForm(const FruitParams& params)
{
    return {.kind = params.kind,
            .size = params.size,
            .stalk = params.stalk,
            .diameter = params.diameter,
            .cluster = params.cluster > 0 ? static_cast<int>(params.cluster) : fruitCluster(params.kind),
            .ripens = params.ripeness < 1.0 && hangs(params.kind)};
}

double fruitRadius(const FruitForm& form, double alpha)
{
    if (form.kind == FruitKind::Faithful)
        return 0.5 * alpha;
    return form.diameter > 0.0 ? 0.5 * form.diameter * form.size
                               : alpha * (form.size * fruitRow(form.kind).radius);
}

double fruitReach(const FruitForm& form)
{
    return form.kind == FruitKind::Faithful ? 0.0 : fruitRow(form.kind).height + stalkOf(form);
}

TriangleMesh fruitCube(const FruitForm& form)
{
    TriangleMesh cube = unitCube();
    for (glm::vec3& corner : cube.positions)
        corner *= 2.0f;
    if (form.kind != FruitKind::Faithful)
        cube.colours.assign(cube.triangles.size(), bodyColour(form));
    return cube;
}

int fruitCluster(FruitKind kind)
{
    return kind == FruitKind::Faithful ? 1 : fruitRow(kind).cluster;
}

bool hangs(FruitKind kind)
{
    return kind != FruitKind::Faithful && fruitRow(kind).petals == 0;
}

TriangleMesh fruitMesh(const FruitForm& form)
{
    if (form.kind == FruitKind::Faithful)
        return unitSphere();
    FruitRow row = fruitRow(form.kind);
    row.colour = bodyColour(form);
    return form.head > 1 ? umbel(row, stalkOf(form), form.head) : Turned(row, stalkOf(form)).build();
}

} // namespace ramure
