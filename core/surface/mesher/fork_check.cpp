#include "core/surface/mesher/fork_check.h"

#include "core/math/box_pairs.h"
#include "core/math/exact_predicates.h"
#include "core/math/triangle_pairs.h"
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ramure {

namespace {

/// Triangles with a common vertex that face about the same way lie beside each other.
constexpr float besideCosine = 0.3F;

bool touch(const glm::uvec3& s, const glm::uvec3& t)
{
    for (int k = 0; k < 3; ++k)
        if (s[k] == t.x || s[k] == t.y || s[k] == t.z)
            return true;
    return false;
}

} // namespace

void ForkCheck::begin()
{
    m_faces.clear();
    m_normals.clear();
    m_isFolded = false;
}

void ForkCheck::add(const StripPatch& strip, const MeshSink& sink, std::size_t first)
{
    m_isFolded = strip.measureNormals(sink, m_normals) || m_isFolded;
    while (m_faces.size() < m_normals.size())
        m_faces.push_back(static_cast<Index>(first++));
}

void ForkCheck::addBands(const MeshSink& sink, std::size_t first)
{
    for (std::size_t face = first; face < sink.triangles.size(); ++face) {
        const glm::uvec3& t = sink.triangles[face];
        const glm::dvec3 a(sink.positions[t.x]);
        const glm::dvec3 normal =
            glm::cross(glm::dvec3(sink.positions[t.y]) - a, glm::dvec3(sink.positions[t.z]) - a);
        const double square = glm::dot(normal, normal);
        m_normals.emplace_back(square > 0.0 ? normal * (1.0 / std::sqrt(square)) : normal);
        m_faces.push_back(static_cast<Index>(face));
        // Triangles of a band that follow each other have an edge in common.
        m_isFolded = m_isFolded || (face > first && glm::dot(m_normals.back(), m_normals.end()[-2]) <
                                                        StripPatch::foldedCosine);
    }
}

bool ForkCheck::meet(const MeshSink& sink, Index i, Index j) const
{
    const glm::uvec3 &s = sink.triangles[m_faces[i]], &t = sink.triangles[m_faces[j]];
    if (glm::dot(m_normals[i], m_normals[j]) > besideCosine && touch(s, t))
        return false;
    return facesMeet(sink.positions, s, t);
}

/// Calls take(i, j) for each pair, until that returns false.
template <class Take> void ForkCheck::visit(const MeshSink& sink, const Take& take) const
{
    std::vector<PrimitiveBounds> boxes;
    boxes.reserve(m_faces.size());
    for (Index i = 0; i < m_faces.size(); ++i) {
        const glm::uvec3& t = sink.triangles[m_faces[i]];
        const glm::vec3 &a = sink.positions[t.x], &b = sink.positions[t.y], &c = sink.positions[t.z];
        if (viewOf(a, b, c) >= 0)
            boxes.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c)), i});
    }
    if (boxes.empty())
        return;
    const BoxPairs pairs(std::move(boxes));
    bool going = true;
    for (std::size_t chunk = 0; chunk < pairs.chunkCount() && going; ++chunk)
        pairs.inChunk(chunk, [&](Index i, Index j) {
            if (going && meet(sink, i, j))
                going = take(i, j);
        });
}

std::size_t ForkCheck::count(const MeshSink& sink, std::size_t most) const
{
    std::size_t found = 0;
    if (most > 0)
        visit(sink, [&](Index, Index) { return ++found < most; });
    return found;
}

void ForkCheck::find(const MeshSink& sink, std::size_t most, std::vector<Index>& faces) const
{
    visit(sink, [&](Index i, Index j) {
        faces.push_back(m_faces[i]);
        faces.push_back(m_faces[j]);
        return --most > 0;
    });
}

} // namespace ramure
