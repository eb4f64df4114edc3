#include "widgets/view/defect_mark.h"

#include "core/math/angle.h"
#include "core/math/bvh.h"
#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace ramure {
namespace {

constexpr glm::u8vec4 markColour{255, 0, 170, 255};
constexpr float fadedLeft = 0.10f;    ///< opacity of faded leaves and apples
constexpr double branchLengths = 2.5; ///< around a defect
constexpr double shareOfNode = 0.15;  ///< around a defect of a mesh without branches
constexpr double skin = 1e-3;         ///< of the distance: a defect lies on a surface that must not hide it
constexpr double perTurn = 0.6;       ///< what half a turn costs, against one surface that hides a part

/// Leaves and apples hang in front of what is looked for.
bool fades(const MeshItem& item)
{
    const std::string& name = item.material.name;
    return name.starts_with(leavesMaterial().name) || name.starts_with("fruit_") ||
           name == applesMaterial().name;
}

/// The opaque triangles near one point, asked along rays.
class Obstacles
{
public:
    Obstacles(const RenderScene& scene, const glm::dvec3& middle, double reach)
    {
        Box near;
        near.add(middle);
        near = near.grown(reach);
        for (const MeshItem& item : scene.meshes) {
            if (item.isMark || fades(item) || std::abs(glm::determinant(glm::dmat3(item.world))) < 1e-300)
                continue;
            const glm::dmat4 inverse = glm::inverse(item.world);
            const Box local = near.transformed(inverse);
            auto bounds = boundsWithin(*item.mesh, local);
            if (!bounds.empty())
                m_parts.push_back({item.mesh.get(), inverse, Bvh(std::move(bounds))});
        }
    }
    /// Surfaces between two points.
    [[nodiscard]] int between(const glm::dvec3& from, const glm::dvec3& to) const
    {
        int count = 0;
        for (const Part& part : m_parts) {
            const glm::dvec3 origin(part.inverse * glm::dvec4(from, 1.0));
            const Ray ray{origin, glm::dvec3(part.inverse * glm::dvec4(to, 1.0)) - origin};
            part.tree.alongRay(ray, 1.0, [&](Index triangle, double&) {
                const glm::uvec3& t = part.mesh->triangles[triangle];
                const auto hit =
                    intersect(ray, glm::dvec3(part.mesh->positions[t.x]),
                              glm::dvec3(part.mesh->positions[t.y]), glm::dvec3(part.mesh->positions[t.z]));
                if (hit && hit->t > skin && hit->t <= 1.0)
                    ++count;
            });
        }
        return count;
    }

private:
    struct Part
    {
        const TriangleMesh* mesh;
        glm::dmat4 inverse;
        Bvh tree;
    };
    static std::vector<PrimitiveBounds> boundsWithin(const TriangleMesh& mesh, const Box& box)
    {
        const glm::vec3 low(box.min), high(box.max);
        std::vector<PrimitiveBounds> bounds;
        for (Index f = 0; f < mesh.faceCount(); ++f) {
            const glm::uvec3& t = mesh.triangles[f];
            const glm::vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
            const glm::vec3 min = glm::min(a, glm::min(b, c)), max = glm::max(a, glm::max(b, c));
            if (glm::all(glm::lessThanEqual(min, high)) && glm::all(glm::greaterThanEqual(max, low)))
                bounds.push_back({min, max, f});
        }
        return bounds;
    }

    std::vector<Part> m_parts;
};

/// A few points of the defect that should all be seen.
std::vector<glm::dvec3> partsOf(const DefectPlace& place)
{
    constexpr std::size_t most = 6;
    std::vector<glm::dvec3> parts;
    for (const auto& face : place.faces)
        parts.push_back((face[0] + face[1] + face[2]) / 3.0);
    for (const auto& edge : place.edges)
        parts.push_back(0.5 * (edge[0] + edge[1]));
    parts.insert(parts.end(), place.points.begin(), place.points.end());
    if (parts.empty())
        parts.push_back(place.box.centre());
    parts.resize(std::min(parts.size(), most));
    return parts;
}

/// How far two directions lie apart, 0 to 1.
double turn(const Camera& a, const Camera& b)
{
    return std::acos(std::clamp(glm::dot(a.backward(), b.backward()), -1.0, 1.0)) / pi;
}

double distanceTo(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 way = b - a;
    const double square = glm::dot(way, way);
    const double share = square > 0.0 ? std::clamp(glm::dot(point - a, way) / square, 0.0, 1.0) : 0.0;
    return glm::length(a + share * way - point);
}

} // namespace

void DefectMark::show(const DefectPlace& place)
{
    auto lines = std::make_shared<LineSet>();
    auto points = std::make_shared<PointSet>();
    const auto line = [&](const glm::dvec3& a, const glm::dvec3& b) {
        lines->segments.push_back({glm::vec3(a), glm::vec3(b), 4.0f, 4.0f, markColour, noIndex});
        lines->box.add(a);
        lines->box.add(b);
    };
    for (const auto& edge : place.edges)
        line(edge[0], edge[1]);
    for (const auto& face : place.faces)
        for (std::size_t i = 0; i < 3; ++i)
            line(face[i], face[(i + 1) % 3]);
    for (const glm::dvec3& point : place.points) {
        points->points.push_back({glm::vec3(point), 12.0f, markColour, noIndex});
        points->box.add(point);
    }
    m_lines = std::move(lines);
    m_points = std::move(points);
    m_middle = place.box.centre();
    m_label = place.label;
    ++m_revision;
}

bool DefectMark::clear()
{
    if (!m_lines)
        return false;
    m_lines.reset();
    m_points.reset();
    ++m_revision;
    return true;
}

void DefectMark::addTo(RenderScene& scene) const
{
    if (!m_lines)
        return;
    for (MeshItem& item : scene.meshes)
        if (fades(item)) {
            item.opacity = fadedLeft;
            item.castsShadow = false;
            item.pickable = false;
        }
    LineItem lines{m_lines, glm::dmat4(1.0), noNode, true, false};
    lines.hidden = 1.0f;
    scene.lines.push_back(std::move(lines));
    PointItem points{m_points, glm::dmat4(1.0), noNode, true};
    points.hidden = 1.0f;
    scene.points.push_back(std::move(points));
}

void DefectMark::paintLabel(QPainter& painter, const PickView& view) const
{
    constexpr double away = 34.0, padding = 7.0, margin = 6.0; // logical pixels
    const auto ndc = m_lines ? view.camera.project(m_middle, view.aspect()) : std::nullopt;
    if (!ndc || m_label.isEmpty() || std::abs(ndc->x) > 1.0 || std::abs(ndc->y) > 1.0)
        return;
    const QPointF at(0.5 * (ndc->x + 1.0) * view.size.x, 0.5 * (1.0 - ndc->y) * view.size.y);
    const QFontMetricsF metrics(painter.font());
    const QSizeF text = metrics.size(0, m_label);
    QRectF box(at + QPointF(away, -away - text.height() - 2.0 * padding),
               text + QSizeF(2.0 * padding, 2.0 * padding));
    if (box.right() > view.size.x - margin)
        box.moveRight(at.x() - away);
    if (box.top() < margin)
        box.moveTop(at.y() + away);
    const QPointF corner(box.left() > at.x() ? box.left() : box.right(),
                         box.top() > at.y() ? box.top() : box.bottom());
    const QColor ink(markColour.r, markColour.g, markColour.b);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ink, 1.6));
    painter.drawLine(at, corner);
    painter.setBrush(QColor(20, 24, 22, 215));
    painter.drawRoundedRect(box, 5.0, 5.0);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, m_label);
}

double defectReach(const DefectPlace& place, const SimplifiedSkeleton* tree, const glm::dmat4& world,
                   const Box& node)
{
    const double whole = node.empty() ? 1.0 : node.radius();
    double reach = shareOfNode * whole;
    if (tree && tree->skeleton.size() > 0) {
        const Skeleton& skeleton = tree->skeleton;
        const glm::dvec3 middle(glm::inverse(world) * glm::dvec4(place.box.centre(), 1.0));
        double nearest = std::numeric_limits<double>::infinity();
        Index on = 0;
        for (Index b = 0; b < skeleton.size(); ++b) {
            const double away = distanceTo(middle, skeleton.p0[b], skeleton.p1[b]);
            if (away < nearest) {
                nearest = away;
                on = b;
            }
        }
        reach =
            branchLengths * skeleton.length(on) * std::cbrt(std::abs(glm::determinant(glm::dmat3(world))));
    }
    return std::max(std::min(reach, whole), 1.2 * place.box.radius());
}

Camera defectView(const RenderScene& scene, const DefectPlace& place, double reach, const Camera& from,
                  double aspect, bool ground)
{
    Camera view = from;
    view.target = place.box.centre();
    view.distance = std::max(reach, 1e-4) / std::tan(0.5 * view.fovRad) / std::min(1.0, aspect);
    const Obstacles obstacles(scene, view.target, view.distance);
    const std::vector<glm::dvec3> parts = partsOf(place);
    const double least = scene.ground + 0.02 * view.distance; // of the eye's height
    const bool stayAbove = ground && view.target.y > scene.ground;
    Camera best = view;
    double bestCost = std::numeric_limits<double>::infinity();
    constexpr int yaws = 24;
    for (const double pitch : {view.pitchRad, 0.0, 0.25, 0.5, 0.85, 1.2, -0.3, -0.7}) {
        for (int i = 0; i < yaws; ++i) {
            Camera candidate = view;
            candidate.pitchRad = pitch;
            candidate.orbit(2.0 * pi * i / yaws, 0.0);
            if (stayAbove && candidate.eye().y < least)
                continue;
            double cost = perTurn * turn(candidate, view);
            for (const glm::dvec3& part : parts)
                cost += double(obstacles.between(part, part + candidate.distance * candidate.backward())) /
                        double(parts.size());
            if (cost < bestCost) {
                bestCost = cost;
                best = candidate;
            }
        }
    }
    return best;
}

} // namespace ramure
