/// \file
/// PC2: the places of all points of a mesh at one moment after the other, as Blender, 3ds Max and Houdini
/// play them on a mesh with the same points, which stands beside it as an OBJ.

#include "core/base/file_writer.h"
#include "core/io/formats/file_format.h"
#include <algorithm>
#include <cstring>

namespace ramure {
namespace {

constexpr double framesPerSecond = 24.0;

/// The moments that a scene has, in seconds from its first one: of its frames or of the shapes of its meshes.
std::vector<double> momentsOf(const ExportScene& scene)
{
    std::vector<double> moments;
    for (const ExportMesh& mesh : scene.meshes)
        if (mesh.shapes)
            moments.assign(mesh.shapes->seconds.begin(), mesh.shapes->seconds.end());
    if (moments.empty())
        for (const ExportFrame& frame : scene.frames)
            moments.push_back(frame.seconds - scene.frames.front().seconds);
    return moments;
}

/// Points between the moments, which move in straight lines from one to the next.
class Points
{
public:
    Points(const ExportScene& scene, std::vector<double> moments)
        : m_scene(scene)
        , m_moments(std::move(moments))
        , m_from(pointsAt(0))
        , m_to(m_moments.size() > 1 ? pointsAt(1) : m_from)
    {
    }
    [[nodiscard]] std::size_t size() const { return m_from.size(); }
    /// \param seconds not less than the last time
    void moveTo(double seconds)
    {
        for (; m_before + 2 < m_moments.size() && m_moments[m_before + 1] <= seconds; ++m_before) {
            m_from = std::move(m_to);
            m_to = pointsAt(m_before + 2);
        }
        const double length = m_moments.size() > 1 ? m_moments[m_before + 1] - m_moments[m_before] : 0.0;
        m_part = length > 0.0 ? static_cast<float>((seconds - m_moments[m_before]) / length) : 0.0F;
    }
    [[nodiscard]] glm::vec3 operator[](std::size_t i) const { return glm::mix(m_from[i], m_to[i], m_part); }

private:
    [[nodiscard]] std::vector<glm::vec3> pointsAt(std::size_t moment) const
    {
        std::vector<glm::vec3> points;
        for (const FlatScene::Entry& entry : flattened(m_scene, moment).meshes)
            points.insert(points.end(), entry.mesh->positions.begin(), entry.mesh->positions.end());
        return points;
    }

    const ExportScene& m_scene;
    std::vector<double> m_moments;
    std::size_t m_before = 0;
    std::vector<glm::vec3> m_from, m_to;
    float m_part = 0.0F;
};

template <class Value> void append(FileWriter& out, const Value& value)
{
    out.append({reinterpret_cast<const char*>(&value), sizeof(value)});
}

/// Samples are equally far apart in time, as the format wants it: as many as there are moments.
Expected<void> writePoints(FileWriter& out, const ExportScene& scene, const Progress& progress)
{
    const std::vector<double> moments = momentsOf(scene);
    const std::size_t count = moments.size();
    const double step = count > 1 ? moments.back() / double(count - 1) : 1.0 / framesPerSecond;
    Points points(scene, moments);
    out.append({"POINTCACHE2\0", 12});
    append(out, std::int32_t(1));
    append(out, std::int32_t(points.size()));
    append(out, 0.0F); // frame of the first sample
    append(out, static_cast<float>(step * framesPerSecond));
    append(out, std::int32_t(count));
    for (std::size_t i = 0; i < count; ++i) {
        progress.report(double(i) / double(count));
        if (progress.cancelled())
            return fail(ErrorCode::Cancelled, RAMURE_NOOP("cancelled"));
        points.moveTo(step * double(i));
        for (std::size_t v = 0; v < points.size(); ++v)
            append(out, points[v]);
    }
    return {};
}

/// The mesh is written first: a cache without it is of no use.
Expected<void> exportPointCache(const std::string& path, const ExportScene& scene,
                                const WriteOptions& options, const Progress& progress)
{
    const std::string mesh = path.substr(0, path.size() - std::strlen("pc2")) + "obj";
    // A tree that grows is at last the mesh itself, one that moves at first.
    const bool grows =
        std::ranges::any_of(scene.meshes, [](const ExportMesh& one) { return one.shapes != nullptr; });
    const FlatScene rest = flattened(scene, grows ? momentsOf(scene).size() - 1 : 0);
    RAMURE_TRY(writeObj(mesh, rest.parts(), progress.part(0.0, 0.3), options));
    auto file = FileWriter::open(path);
    RAMURE_TRY(file);
    RAMURE_TRY(writePoints(*file, scene, progress.part(0.3, 1.0)));
    return file->commit();
}

FileRates pointCacheRates(bool /*texture*/, double /*digits*/)
{
    return {12.0, 0.0};
}

} // namespace

extern const FileFormat pointCacheFormat;
const FileFormat pointCacheFormat = {
    .id = "pc2",
    .ending = "pc2",
    .name = RAMURE_NOOP("PC2 point cache"),
    .choice = RAMURE_NOOP("PC2, points in motion, with an OBJ"),
    .help =
        "the places of all points at each of --frames or of --growth, beside an .obj with the mesh and its "
        "materials",
    .holds = holdsObjects | holdsTexture | holdsSpace | holdsClip | holdsShapes,
    .beside = "obj",
    .write = &exportPointCache,
    .rates = &pointCacheRates,
};

} // namespace ramure
